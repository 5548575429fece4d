//! The parser from text to expression, by precedence.

use std::ops::Range;

use super::expression::{Expression, FUNCTIONS, Formula, FormulaError, Name, Node, Operator};

/// Nested deeper than this no formula is written by hand.
const DEEPEST: usize = 100;

pub fn parse(text: &str) -> Result<Formula, FormulaError> {
    let mut parser = Parser { text, at: 0, names: Vec::new(), depth: 0 };
    let root = parser.expression(0)?;
    parser.skip_space();
    if parser.at < text.len() {
        let span = parser.word();
        let what = &text[span.clone()];
        return Err(match what {
            ")" => error("a parenthesis closes that was not opened", "remove it", span),
            _ => error(format!("`{what}` stands where an operator should"), "write + - * / or ^ before it", span),
        });
    }
    Ok(Formula { names: parser.names, root })
}

fn error(message: impl Into<String>, help: impl Into<String>, span: Range<usize>) -> FormulaError {
    FormulaError { message: message.into(), help: help.into(), span }
}

struct Parser<'a> {
    text: &'a str,
    at: usize,
    names: Vec<Name>,
    depth: usize,
}

impl Parser<'_> {
    fn skip_space(&mut self) {
        self.at += self.text[self.at..].len() - self.text[self.at..].trim_start().len();
    }

    fn next(&mut self) -> Option<char> {
        self.skip_space();
        self.text[self.at..].chars().next()
    }

    /// The name, number or single sign that stands here.
    fn word(&self) -> Range<usize> {
        let rest = &self.text[self.at..];
        let part = |c: char| c.is_alphanumeric() || c == '_' || c == '.';
        let end = rest.find(|c| !part(c)).unwrap_or(rest.len());
        let end = if end == 0 { rest.chars().next().map_or(0, char::len_utf8) } else { end };
        self.at..self.at + end
    }

    /// An operator that binds at least as closely as `least`, with how closely what follows it must bind.
    fn operator(&mut self, least: u8) -> Option<(Operator, u8)> {
        let (operator, binds, right) = match self.next()? {
            '+' => (Operator::Add, 1, 2),
            '-' => (Operator::Subtract, 1, 2),
            '*' => (Operator::Multiply, 3, 4),
            '/' => (Operator::Divide, 3, 4),
            // Powers bind from the right: 2^3^2 = 2^9.
            '^' => (Operator::Power, 7, 6),
            _ => return None,
        };
        (binds >= least).then_some((operator, right))
    }

    fn expression(&mut self, least: u8) -> Result<Expression, FormulaError> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(error("the formula is nested too deeply", "write it in fewer parentheses", self.word()));
        }
        let mut left = self.operand()?;
        while let Some((operator, right)) = self.operator(least) {
            self.at += 1;
            let other = self.expression(right)?;
            let span = left.span.start..other.span.end;
            left = Expression { node: Node::Binary(operator, Box::new(left), Box::new(other)), span };
        }
        self.depth -= 1;
        Ok(left)
    }

    fn operand(&mut self) -> Result<Expression, FormulaError> {
        let Some(first) = self.next() else {
            return Err(error("the formula ends where a quantity should stand", "complete it", self.at..self.at));
        };
        let start = self.at;
        match first {
            '-' | '+' => {
                self.at += 1;
                // Closer than a product, less close than a power.
                let of = self.expression(5)?;
                let span = start..of.span.end;
                let node = if first == '-' { Node::Negative(Box::new(of)) } else { of.node };
                Ok(Expression { node, span })
            }
            '(' => {
                self.at += 1;
                let inner = self.expression(0)?;
                self.close(start)?;
                Ok(Expression { span: start..self.at, ..inner })
            }
            c if c.is_ascii_digit() || c == '.' => self.number(),
            c if c.is_alphabetic() || c == '_' => self.name(),
            c => Err(error(
                format!("`{c}` stands where a quantity should"),
                "write a number, a name or a parenthesis",
                self.word(),
            )),
        }
    }

    fn close(&mut self, opened: usize) -> Result<(), FormulaError> {
        if self.next() == Some(')') {
            self.at += 1;
            return Ok(());
        }
        match self.next() {
            None => Err(error("a parenthesis is not closed", "add `)`", opened..opened + 1)),
            Some(_) => {
                let span = self.word();
                let what = &self.text[span.clone()];
                Err(error(
                    format!("`{what}` stands where an operator or `)` should"),
                    "check what stands before it",
                    span,
                ))
            }
        }
    }

    fn number(&mut self) -> Result<Expression, FormulaError> {
        let mut span = self.word();
        // 1e-3: the sign belongs to the number.
        if self.text[span.clone()].ends_with(['e', 'E']) && self.text[span.end..].starts_with(['+', '-']) {
            let digits = self.text[span.end + 1..].bytes().take_while(u8::is_ascii_digit).count();
            span.end += 1 + digits;
        }
        let text = &self.text[span.clone()];
        let value = text.parse::<f64>().ok().filter(|v| v.is_finite());
        let value = value.ok_or_else(|| {
            error(format!("expected a number, found `{text}`"), "a product is written with `*`: 2*x", span.clone())
        })?;
        self.at = span.end;
        Ok(Expression { node: Node::Number(value), span })
    }

    fn name(&mut self) -> Result<Expression, FormulaError> {
        let span = self.word();
        let text = &self.text[span.clone()];
        self.at = span.end;
        if self.next() == Some('(') {
            return self.call(text, span);
        }
        if text == "pi" {
            return Ok(Expression { node: Node::Number(std::f64::consts::PI), span });
        }
        if FUNCTIONS.iter().any(|f| f.name == text) {
            let help = format!("write {text}(…)");
            return Err(error(format!("`{text}` is a function and stands without its argument"), help, span));
        }
        let known = self.names.iter().position(|n| n.text == text).unwrap_or_else(|| {
            self.names.push(Name { text: text.into(), span: span.clone() });
            self.names.len() - 1
        });
        Ok(Expression { node: Node::Name(known), span })
    }

    fn call(&mut self, name: &str, at: Range<usize>) -> Result<Expression, FormulaError> {
        let Some(function) = FUNCTIONS.iter().find(|f| f.name == name) else {
            let all = FUNCTIONS.iter().map(|f| f.name).collect::<Vec<_>>().join(", ");
            return Err(error(format!("`{name}` is not a known function"), format!("known are {all}"), at));
        };
        let opened = self.at;
        self.at += 1;
        let mut arguments = vec![self.expression(0)?];
        while self.next() == Some(',') {
            self.at += 1;
            arguments.push(self.expression(0)?);
        }
        self.close(opened)?;
        let span = at.start..self.at;
        if arguments.len() != function.arguments {
            let message = format!("`{name}` takes {} arguments, not {}", function.arguments, arguments.len());
            return Err(error(message, "give it as many", span));
        }
        Ok(Expression { node: Node::Call(*function, arguments), span })
    }
}
