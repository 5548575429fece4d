//! Refinement of the blank's error by the passes, one after the other, and what it says of allowance and
//! stiffness.
//!
//! Refinement goes by two names that are each other's reciprocal: K = after/before [seed 000], q =
//! before/after [seed 002 (28), whose divisor is the error of the part]. Errors are the whole spread of the
//! diameter along the pass. Of what is inherited, apart from what each pass bends anew, a system of
//! stiffness j leaves C/(j + C), C the force per depth [seed 002 (27)].

use super::elastic::{Cutting, Elastic, condense};
use super::history::History;
use super::machine::Machine;
use super::rows::{COORDINATES, X};
use crate::process::{Column, Datum, Failure, Figure, Table, spread};
use crate::units::{FORCE, LENGTH, MICRO};

/// An inherited error is followed down to this part of it.
const NOTHING: f64 = 1e-9;

/// A pass and what it makes of the error that it meets.
struct Report {
    /// Set depth, m.
    depth: f64,
    /// Smallest and largest radial force along it, N.
    force: (f64, f64),
    /// Diameter errors before and after along the pass, m.
    before: Vec<f64>,
    after: Vec<f64>,
}

/// The passes of a lathe along positions.
pub struct Refinement {
    passes: Vec<Report>,
    /// Part of the blank's error, or of any other, that is left after all passes.
    pub inherited: f64,
}

impl Refinement {
    /// Follows the error through all passes. `None` where there is one pass and a true blank, or where
    /// nothing is copied.
    ///
    /// # Errors
    /// No equilibrium at some position.
    pub fn of(machine: &Machine, positions: &[f64]) -> Result<Option<Self>, Failure> {
        let setup = &machine.setup;
        let single = setup.passes.is_empty() && setup.blank.is_true();
        if single || !machine.feeds_back() {
            return Ok(None);
        }
        let shaft = condense(machine, positions)?;
        let (elastic, history) = (Elastic::new(machine, &shaft), History::on_part(machine, 1, None)?);
        let length = setup.length();
        let mut passes: Vec<Report> = Vec::new();
        let mut errors: Vec<f64> = positions.iter().map(|x| setup.blank.error(*x, length)).collect();
        // A small error more, which each pass copies smaller: by its ratio, what is inherited.
        let nudge = 1e-4 * setup.cut.depth;
        let mut nudged: Vec<f64> = errors.iter().map(|e| e + nudge).collect();
        for number in 0..=setup.passes.len() {
            let pass = |i: usize, error: f64| {
                let x = positions[i];
                elastic.pass(number, (i, x), error, &Cutting::on_part(machine, 1, x), history.at(x))
            };
            let mut report = Report {
                depth: setup.passes.get(number).map_or(setup.cut.depth, |pass| pass.depth),
                force: (f64::INFINITY, 0.0),
                before: errors.clone(),
                after: Vec::new(),
            };
            for i in 0..positions.len() {
                let cut = pass(i, errors[i])?;
                report.force = (report.force.0.min(cut.force), report.force.1.max(cut.force));
                nudged[i] = pass(i, nudged[i])?.error;
                errors[i] = cut.error;
            }
            report.after.clone_from(&errors);
            passes.push(report);
        }
        let inherited = nudged.iter().zip(&errors).map(|(n, e)| (n - e) / nudge).fold(0.0, f64::max);
        Ok(Some(Self { passes, inherited }))
    }

    /// One figure for all passes.
    pub fn figure(&self) -> Figure {
        let mut lines =
            vec!["   depth mm    force N   before um    after um   K = after/before   q = before/after".to_string()];
        let mut list = Vec::new();
        for (number, pass) in self.passes.iter().enumerate() {
            let (before, after) = (spread(&pass.before), spread(&pass.after));
            let force = 0.5 * (pass.force.0 + pass.force.1);
            lines.push(format!(
                "{:>2} {:>8.4} {force:>10.1} {:>11.3} {:>11.3} {:>18} {:>18}",
                number + 1,
                LENGTH.from_si(pass.depth),
                MICRO.from_si(before),
                MICRO.from_si(after),
                shown(ratio(after, before)),
                shown(ratio(before, after))
            ));
            // Each pass tells its own units.
            list.push(Datum::record([
                ("pass", (number + 1).into()),
                ("depth", LENGTH.from_si(pass.depth).into()),
                ("depth_unit", LENGTH.unit.into()),
                ("force", Datum::List(vec![pass.force.0.into(), pass.force.1.into()])),
                ("force_unit", FORCE.unit.into()),
                ("before", MICRO.from_si(before).into()),
                ("after", MICRO.from_si(after).into()),
                ("unit", MICRO.unit.into()),
                ("K", ratio(after, before).into()),
                ("q", ratio(before, after).into()),
            ]));
        }
        let (before, after) = (self.first(), self.last());
        let (k, q) = (ratio(after, before), ratio(before, after));
        lines.push(format!(
            "all                    {:>11.3} {:>11.3} {:>18} {:>18}",
            MICRO.from_si(before),
            MICRO.from_si(after),
            shown(k),
            shown(q)
        ));
        lines.push(format!("of an error that is only inherited {:.4} % is left", 100.0 * self.inherited));
        lines.extend(self.advice());
        Figure::new("passes", "passes")
            .lines(lines)
            .entry("list", Datum::List(list))
            .entry("K", k)
            .entry("q", q)
            .entry("inherited", self.inherited)
            .entry("stiffer", self.stiffer())
    }

    /// Smaller allowances in later passes, and fewer passes of a stiffer system [seed 000].
    fn advice(&self) -> Vec<String> {
        let mut advice = Vec::new();
        if let Some(number) = (1..self.passes.len()).find(|i| self.passes[*i].depth > self.passes[i - 1].depth) {
            advice.push(format!(
                "pass {} takes more than the one before it: the smaller the later allowances, the less each bends anew",
                number + 1
            ));
        }
        let own = self.last() - self.inherited * self.first();
        if own > self.inherited * self.first() {
            advice.push(format!(
                "most of what is left, {:.3}, the last pass bends anew: another pass as deep would leave as much, a \
                 shallower one less",
                MICRO.shown(own)
            ));
        }
        if let Some(passes) = self.stiffer() {
            let given = self.passes.len();
            advice.push(match passes < given {
                true => format!(
                    "at twice the stiffness {passes} passes of {given} would leave no more of what is inherited"
                ),
                false => format!(
                    "even at twice the stiffness no fewer than {given} passes would leave as little of what is \
                     inherited"
                ),
            });
        }
        advice
    }

    /// How many passes at twice the stiffness leave no more of an inherited error. With K = C/(j + C) for
    /// each, K/(2 − K) is that of 2j.
    fn stiffer(&self) -> Option<usize> {
        let each = self.inherited.max(NOTHING).powf(1.0 / self.passes.len() as f64);
        let stiff = each / (2.0 - each);
        let needed = (self.inherited.max(NOTHING).ln() / stiff.ln() - 1e-9).ceil();
        (self.passes.len() > 1 && needed.is_finite()).then_some(needed.max(1.0) as usize)
    }

    fn first(&self) -> f64 {
        self.passes.first().map_or(0.0, |p| spread(&p.before))
    }

    fn last(&self) -> f64 {
        self.passes.last().map_or(0.0, |p| spread(&p.after))
    }

    /// The errors before and after each pass, position by position.
    pub fn table(&self, positions: &[f64]) -> Table {
        let numbers = (1..=self.passes.len()).flat_map(|number| vec![number as f64; positions.len()]);
        let x = positions.repeat(self.passes.len()).into();
        let errors = |name, of: fn(&Report) -> &Vec<f64>| {
            Column::quantities(name, MICRO, &self.passes.iter().flat_map(of).copied().collect::<Vec<_>>())
        };
        Table {
            columns: vec![
                Column::numbers("pass", None, numbers.collect()),
                Column::coordinate(&COORDINATES[X], &x),
                errors("before", |pass| &pass.before),
                errors("after", |pass| &pass.after),
            ],
        }
    }
}

/// `None` where there is nothing to divide by.
fn ratio(a: f64, b: f64) -> Option<f64> {
    // Below a picometre a spread is round-off.
    (b > 1e-12).then(|| a / b)
}

fn shown(ratio: Option<f64>) -> String {
    ratio.map_or("-".into(), |r| format!("{r:.4}"))
}
