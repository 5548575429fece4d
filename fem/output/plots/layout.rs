//! How rows are laid out in figures: what the abscissa is, what tells curves apart, which pairs make a map.

use std::collections::HashSet;

use crate::output::chart::{Axis, Form, Point, Series, number};
use crate::process::{Absent, Coordinate, Holds, Process, Rows, Values};
use crate::units::{ANGLE, FORCE, Kind, LENGTH};

/// Most levels of a coordinate that tells curves apart.
const MOST_LEVELS: usize = 40;
/// Most curves that are told apart by colours.
const MOST_CURVES: usize = 4;
/// Colour of curves in the background.
const GREY: usize = 5;

/// A coordinate that varies over some rows.
pub struct Variable {
    /// Its axis.
    pub axis: Axis,
    /// Kind of the quantity, where it is one.
    pub kind: Option<Kind>,
    /// Value of each row in the unit of the axis; the number of a word.
    pub values: Vec<f64>,
    /// Distinct values, rising.
    pub levels: Vec<f64>,
}

/// The rows of one observable, laid out.
pub struct Layout {
    /// The observable.
    pub observable: usize,
    /// End of the names of its figures: empty of the only one.
    pub end: String,
    /// Coordinates that vary, the abscissa first.
    pub variables: Vec<Variable>,
    /// Group of each row, from 0: rows of a group are a curve.
    pub group: Vec<usize>,
    /// Label of each group: the levels that its rows have in common.
    pub labels: Vec<String>,
    /// Those of the variables that tell groups apart.
    pub telling: Vec<usize>,
    /// The rows, by their numbers.
    pub rows: Vec<usize>,
    /// Axis of the observable.
    pub value: Axis,
}

impl Layout {
    /// Lays out the rows of each of some observables by the coordinates that `given` names; rows of which none of them
    /// varies are left out.
    pub fn each(process: &dyn Process, rows: &Rows, given: &[usize], observables: &[usize]) -> Vec<Self> {
        let end = |observable: usize| match observables {
            [_] => String::new(),
            _ => format!("-{}", process.observables()[observable].name),
        };
        let one =
            |observable: &usize| Some(Self { end: end(*observable), ..Self::of(process, rows, given, *observable)? });
        observables.iter().filter_map(one).collect()
    }

    fn of(process: &dyn Process, rows: &Rows, given: &[usize], observable: usize) -> Option<Self> {
        let own: Vec<usize> = (0..rows.len()).filter(|row| rows.observable[*row] == observable).collect();
        let coordinates = process.coordinates();
        let mut found: Vec<(usize, Variable)> = given
            .iter()
            .filter_map(|i| Some((*i, Variable::of(&coordinates[*i], rows.columns.get(*i)?, &own)?)))
            .filter(|(_, variable)| variable.levels.len() > 1)
            .collect();
        // The abscissa is what every row must say; the others stay in the order of the process.
        let needed = |i: usize| match coordinates[i].absent {
            Absent::Refused | Absent::NeededBut(_) if !is_word(&coordinates[i]) => 0,
            Absent::NeededBy(..) => 1,
            _ => 2,
        };
        let first = (0..found.len()).min_by_key(|at| (needed(found[*at].0), found[*at].0))?;
        found[..=first].rotate_right(1);
        let repeats: Vec<bool> = found.iter().map(|(i, _)| coordinates[*i].repeats).collect();
        let variables: Vec<Variable> = found.into_iter().map(|(_, variable)| variable).collect();
        let kind = process.observables()[observable].kind;
        let value = Axis::new(process.observables()[observable].name.replace('_', " "), kind.unit);
        let mut layout = Self {
            observable,
            end: String::new(),
            variables,
            group: vec![0; own.len()],
            labels: vec![String::new()],
            telling: Vec::new(),
            rows: own,
            value,
        };
        for at in (1..layout.variables.len()).filter(|at| !repeats[*at]) {
            layout.split(at);
        }
        Some(layout)
    }

    /// Tells groups apart by a variable, unless the others do so already, or it is a quantity that follows from the
    /// abscissa.
    fn split(&mut self, at: usize) {
        let variable = &self.variables[at];
        if variable.levels.len() > MOST_LEVELS {
            return;
        }
        let levels: Vec<usize> = (0..self.rows.len()).map(|row| variable.level(row)).collect();
        let key = |row: usize| (self.group[row], levels[row]);
        let mut keys: Vec<(usize, usize)> = (0..self.rows.len()).map(key).collect::<HashSet<_>>().into_iter().collect();
        let is_told = keys.len() <= self.labels.len();
        let place = |row: usize| (self.group[row], self.x().values[row].to_bits());
        let count = |more: &dyn Fn(usize) -> usize| {
            (0..self.rows.len()).map(|row| (place(row), more(row))).collect::<HashSet<_>>().len()
        };
        if is_told || (variable.kind.is_some() && count(&|row| levels[row]) == count(&|_| 0)) {
            return;
        }
        keys.sort_unstable();
        let group = (0..self.rows.len()).map(|row| keys.iter().position(|k| *k == key(row)).unwrap_or(0)).collect();
        let label = |(old, level): &(usize, usize)| {
            let before = &self.labels[*old];
            let own = variable.label(variable.levels.get(*level).copied().unwrap_or(f64::NAN));
            if before.is_empty() { own } else { format!("{before}, {own}") }
        };
        let labels = keys.iter().map(label).collect();
        self.telling.push(at);
        (self.group, self.labels) = (group, labels);
    }

    /// The abscissa.
    pub fn x(&self) -> &Variable {
        &self.variables[0]
    }

    /// Whether the abscissa is an angle around something.
    pub fn is_around(&self) -> bool {
        self.x().kind == Some(ANGLE)
    }

    /// Whether a joint is loaded: then the force is drawn upwards, and rows follow one another as they were taken.
    pub fn is_loop(&self) -> bool {
        self.x().kind == Some(FORCE) && self.variables.iter().skip(1).any(|v| !v.axis.words.is_empty())
    }

    /// Numbers of the groups that are told apart by colours, evenly chosen.
    pub fn chosen(&self) -> Vec<usize> {
        let (all, most) = (self.labels.len(), MOST_CURVES.min(self.labels.len()));
        let mut chosen: Vec<usize> = (0..most).map(|i| if most < 2 { 0 } else { i * (all - 1) / (most - 1) }).collect();
        chosen.dedup();
        chosen
    }

    /// The points of a group in the order of a curve; `value` and `bar` of rows by their places in the layout, in the
    /// unit of the ordinate.
    pub fn points(&self, group: usize, value: &dyn Fn(usize) -> f64, bar: &dyn Fn(usize) -> f64) -> Vec<Point> {
        let own = (0..self.rows.len()).filter(|row| self.group[*row] == group);
        let point = |row: usize| match self.is_loop() {
            true => Point { x: value(row), y: self.x().values[row], u: f64::NAN },
            false => Point { x: self.x().values[row], y: value(row), u: bar(row) },
        };
        let mut points: Vec<Point> = own.map(point).collect();
        if !self.is_loop() {
            points.sort_by(|a, b| a.x.total_cmp(&b.x));
        }
        points
    }

    /// Axes of curves: abscissa and ordinate.
    pub fn axes(&self) -> (Axis, Axis) {
        let (x, y) = (self.x().axis.clone(), self.value.clone());
        if self.is_loop() { (y, x) } else { (x, y) }
    }

    /// All groups as lines, those in the background first.
    pub fn lines(&self, value: &dyn Fn(usize) -> f64) -> Vec<Series> {
        let chosen = self.chosen();
        let none = |_| f64::NAN;
        let first = self.points(0, value, &none);
        let size = first.iter().map(|p| p.y.abs()).fold(0.0, f64::max);
        let is_first = |group: usize| {
            let own = self.points(group, value, &none);
            let is_near = |(a, b): (&Point, &Point)| a.x == b.x && (a.y - b.y).abs() <= 1e-6 * size;
            own.len() == first.len() && own.iter().zip(&first).all(is_near)
        };
        // Curves that are one and the same are drawn once.
        if self.labels.len() > 1 && !self.is_loop() && (1..self.labels.len()).all(is_first) {
            return vec![Series::new("", 0, Form::Line, first)];
        }
        let line = |group: usize, colour: usize, form: Form| {
            let label = if colour == GREY { "" } else { &self.labels[group] };
            Series::new(label, colour, form, self.points(group, value, &none))
        };
        let others = (0..self.labels.len()).filter(|g| !chosen.contains(g)).map(|g| line(g, GREY, Form::Faint));
        let others: Vec<Series> = others.collect();
        others.into_iter().chain(chosen.iter().enumerate().map(|(i, g)| line(*g, i, Form::Line))).collect()
    }

    /// Pairs of variables over which a map shows something, the abscissa first where it is in it.
    pub fn pairs(&self) -> Vec<(usize, usize)> {
        let is_wide = |at: &usize| {
            let variable = &self.variables[*at];
            variable.levels.len() > 2 || !variable.axis.words.is_empty()
        };
        let all: Vec<usize> = (0..self.variables.len()).filter(is_wide).collect();
        let pairs = all.iter().enumerate().flat_map(|(i, a)| all[i + 1..].iter().map(move |b| (*a, *b)));
        // Where one follows from the other there is nothing beside a line.
        let is_plane = |(a, b): &(usize, usize)| {
            let [a, b] = [&self.variables[*a], &self.variables[*b]];
            let both = (0..self.rows.len()).map(|row| (a.values[row].to_bits(), b.values[row].to_bits()));
            both.collect::<HashSet<_>>().len() > a.levels.len().max(b.levels.len())
        };
        pairs.filter(is_plane).collect()
    }

    /// Pair of lengths beside the abscissa: a plane.
    pub fn plane(&self) -> Option<(usize, usize)> {
        let is_length = |at: &usize| self.variables[*at].kind == Some(LENGTH) && self.variables[*at].levels.len() > 2;
        let mut lengths = (1..self.variables.len()).filter(is_length);
        lengths.next().zip(lengths.next())
    }
}

fn is_word(coordinate: &Coordinate) -> bool {
    matches!(coordinate.holds, Holds::Word(_))
}

impl Variable {
    fn of(coordinate: &Coordinate, column: &Values, rows: &[usize]) -> Option<Self> {
        let kind = coordinate.holds.kind();
        let told = |si: f64| kind.map_or(si, |kind| kind.from_si(si));
        let values: Vec<f64> = rows.iter().map(|row| told(column[*row])).collect();
        let mut levels: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
        levels.sort_unstable_by(f64::total_cmp);
        let size = levels.last()?.abs().max(levels.first()?.abs());
        // Digits that conversion leaves make no level.
        levels.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * size);
        let words = match &coordinate.holds {
            Holds::Word(words) => words.iter().map(str::to_string).collect(),
            Holds::Quantity(_) | Holds::Number(_) => Vec::new(),
        };
        let axis =
            Axis { words, ..Axis::new(coordinate.name.replace('_', " "), kind.map(|k| k.unit).unwrap_or_default()) };
        Some(Self { axis, kind, values, levels })
    }

    /// Number of the level of a row.
    fn level(&self, row: usize) -> usize {
        let value = self.values[row];
        let near = |a: &&f64| (**a - value).abs();
        let nearest = self.levels.iter().min_by(|a, b| near(a).total_cmp(&near(b)));
        nearest.and_then(|n| self.levels.iter().position(|l| l == n)).unwrap_or(0)
    }

    /// Label of a value: `part 3`, `450 N`, `+`.
    pub fn label(&self, value: f64) -> String {
        match (&self.axis.words[..], self.kind) {
            ([], None) => format!("{} {}", self.axis.name, number(value)),
            ([], Some(LENGTH)) => format!("{} = {}", self.axis.name, self.axis.format(value)),
            _ => self.axis.format(value),
        }
    }
}
