//! Pieces of a page: figures, tables, lists. Every text of a user is escaped here.

use std::borrow::Cow;

use serde_json::json;

use crate::output::block::{Block, Cell, Table};
use crate::output::chart::{Mark, Svg, escaped};
use crate::output::json::finite;

/// A part of the page, with a place in its table of contents.
pub struct Section {
    /// Name by which links lead to it.
    pub id: Cow<'static, str>,
    /// Heading.
    pub title: Cow<'static, str>,
    /// Pieces of HTML.
    pub blocks: Vec<String>,
}

/// A block of an answer. Lines laid out for a terminal have no place here.
pub fn block(block: &Block) -> String {
    match block {
        Block::Lines(_) | Block::Curve(_) => String::new(),
        Block::Caution(text) => paragraph("caution", &format!("Caution: {text}")),
        Block::Heading(text) => heading(&capital(text)),
        Block::Sentence(text) | Block::Paragraph(text) => paragraph("", &sentence(text)),
        Block::List(items) => list(items),
        Block::Labelled(items) | Block::Entries(items) => {
            // One without a label belongs to the label before.
            let told = |(label, item): &(String, String)| match label.trim() {
                "" => item.clone(),
                label => format!("{label}: {item}"),
            };
            list(&items.iter().map(told).collect::<Vec<_>>())
        }
        Block::Table(all) => table(all),
        Block::Commands(lines) => commands(lines),
    }
}

/// Words as a sentence, with its capital and its full stop.
pub fn sentence(text: &str) -> String {
    capital(text.trim_end_matches('.')) + "."
}

/// Words that begin with a capital.
pub fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().collect::<String>() + letters.as_str())
}

/// A figure with its values.
pub fn figure(name: &str, svg: &Svg) -> String {
    let number = |v: f64| finite(format!("{v:.4e}").parse().unwrap_or(v));
    let mark = |m: &Mark| {
        let values = m.values.iter().map(|v| number(*v));
        [json!(m.at[0].round() as i64), json!(m.at[1].round() as i64), json!(m.series)]
            .into_iter()
            .chain(values)
            .collect::<serde_json::Value>()
    };
    let axes: Vec<_> = svg.axes.iter().map(|a| json!({ "name": a.name, "unit": a.unit, "words": a.words })).collect();
    let (drawn, all) = (svg.marks.len(), svg.marks.len() + svg.unmarked);
    let few = match drawn < all {
        true => paragraph(
            "",
            &format!("{drawn} of {all} points tell their values; lines and dots show all, pixel by pixel."),
        ),
        false => String::new(),
    };
    let marks: Vec<_> = svg.marks.iter().map(mark).collect();
    let data = json!({ "name": name, "axes": axes, "series": svg.series, "marks": marks });
    // A script ends at its closing tag, wherever that stands.
    let data = data.to_string().replace('<', "\\u003c");
    let label = escaped(&svg.title).replace('"', "&quot;");
    format!(
        "<figure><div class=\"view\" tabindex=\"0\" role=\"group\" aria-label=\"{label}: arrow keys tell values, + and \u{2212} zoom\">\
         {}</div><figcaption></figcaption>{few}<script type=\"application/json\">{data}</script></figure>",
        svg.inline()
    )
}

/// Figures side by side.
pub fn figures(all: impl IntoIterator<Item = (String, Svg)>) -> String {
    let all: Vec<String> = all.into_iter().map(|(name, svg)| figure(&name, &svg)).collect();
    let class = if all.len() == 1 { "figures one" } else { "figures" };
    if all.is_empty() { String::new() } else { format!("<div class=\"{class}\">{}</div>", all.join("\n")) }
}

/// A table.
pub fn table(table: &Table) -> String {
    let Table { caption, columns, rows, is_sortable } = table;
    let is_number = |i: usize| rows.iter().any(|r| matches!(r.get(i), Some(Cell::Number(..))));
    let class = |i: usize| if is_number(i) { " class=\"num\"" } else { "" };
    let heading = |(i, name): (usize, &String)| {
        format!("<th scope=\"col\"{}>{}</th>", class(i), escaped(&name.replace("chi2", "\u{3c7}\u{b2}")))
    };
    let head: String = columns.iter().map(|column| &column.name).enumerate().map(heading).collect();
    let cell = |(i, cell): (usize, &Cell)| match cell {
        Cell::Text(text) => format!("<td{}>{}</td>", class(i), escaped(text)),
        Cell::Number(text, value) => format!("<td class=\"num\" data-value=\"{value}\">{}</td>", escaped(text)),
        Cell::Missing => format!("<td{}>\u{2013}</td>", class(i)),
    };
    let row = |row: &Vec<Cell>| format!("<tr>{}</tr>", row.iter().enumerate().map(cell).collect::<String>());
    let body: String = rows.iter().map(row).collect();
    let class = if *is_sortable { " class=\"sortable\"" } else { "" };
    let label = escaped(caption).replace('"', "&quot;");
    format!(
        "<div class=\"tablebox\" tabindex=\"0\" role=\"group\" aria-label=\"{label}\"><table{class}><caption>{}</caption><thead><tr>{head}</tr></thead>\
         <tbody>{body}</tbody></table></div>",
        escaped(caption)
    )
}

/// A paragraph of a class.
pub fn paragraph(class: &str, text: &str) -> String {
    let class = if class.is_empty() { String::new() } else { format!(" class=\"{class}\"") };
    format!("<p{class}>{}</p>", escaped(text))
}

/// A list.
pub fn list(items: &[String]) -> String {
    if items.is_empty() {
        return String::new();
    }
    format!("<ul>{}</ul>", items.iter().map(|i| format!("<li>{}</li>", escaped(i))).collect::<String>())
}

/// A heading within a section.
pub fn heading(text: &str) -> String {
    format!("<h3>{}</h3>", escaped(text))
}

/// Commands, to be copied.
pub fn commands(lines: &[String]) -> String {
    let lines: Vec<String> = lines.iter().map(|l| escaped(l)).collect();
    format!("<pre tabindex=\"0\" role=\"group\" aria-label=\"commands\"><code>{}</code></pre>", lines.join("\n"))
}

/// Blocks of which a slider shows one at a time: each a label and what it holds.
pub fn steps(all: &[(String, String)]) -> String {
    let step = |(label, block): &(String, String)| {
        let label = escaped(label).replace('"', "&quot;");
        format!("<div class=\"step\" data-label=\"{label}\"><h3>{label}</h3>{block}</div>")
    };
    format!(
        "<div class=\"steps\"><div class=\"slide\" hidden><label>Step <input type=\"range\" min=\"0\" max=\"{}\" value=\"0\" step=\"1\"></label> \
         <output></output></div>{}</div>",
        all.len().saturating_sub(1),
        all.iter().map(step).collect::<String>()
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::block::Column;

    #[test]
    fn what_users_write_is_text() {
        let evil = "</script><script>alert(1)</script>";
        let mut svg = Svg::new([10.0, 10.0], evil, evil);
        svg.mark([1.0, 1.0], evil, &[1.0]);
        let cells = Table { caption: evil.into(), ..Table::new([Column::wide(evil)], [vec![Cell::Text(evil.into())]]) };
        for html in [
            figure(evil, &svg),
            table(&cells),
            paragraph("", evil),
            list(&[evil.into()]),
            steps(&[(evil.into(), String::new())]),
            commands(&[evil.into()]),
        ] {
            assert!(!html.contains("<script>alert"), "{html}");
        }
    }
}
