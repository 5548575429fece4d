//! The compliance of a machine as it was measured, or as another program condensed it: a file of pairs, in the place of a
//! structure or beside it.
//!
//! ```text
//! push,push_x [mm],read,read_x [mm],compliance [um/kN],u [um/kN]
//! headstock,,headstock,,14.2,0.3
//! tool,100,headstock,,3.1,0.3
//! ```
//!
//! A force along y on `push` moves `read` along y by the compliance. What is pushed at the tool stands at `push_x`; between
//! such places the tool rests on its neighbours, as on a beam of two pieces, and beyond them on the last.

use nalgebra::{DMatrix, DVector, SymmetricEigen};

use crate::input::{ListedRow, Listing, Problem, Reader, did_you_mean, name_and_unit, number};
use crate::process::{Figure, estimates};
use crate::solve::{Foundation, Seats};
use crate::units::{COMPLIANCE, LENGTH, NUMBER, Unit};

/// How far two readings of one pair may differ, in standard uncertainties, and where there are none, of their places' own.
const ASYMMETRY: (f64, f64) = (4.0, 0.1);
/// What rounding leaves of a compliance that is zero, as a part of the largest.
const ROUNDED: f64 = 1e-6;
/// A cut that ends so near to where the tool was pushed ends there, m.
const NEAR: f64 = 1e-6;
/// More places than anybody pushes at.
const MOST: usize = 200;

/// Distance below which two places are one, m.
const APART: f64 = 1e-6;

/// A place that was pushed or watched.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Place {
    Headstock,
    Tailstock,
    /// The tool, at x (m).
    Tool(f64),
}

impl Place {
    const WORDS: [&'static str; 3] = ["headstock", "tailstock", "tool"];

    fn told(self) -> String {
        match self {
            Self::Headstock => "the headstock".into(),
            Self::Tailstock => "the tailstock".into(),
            Self::Tool(x) => format!("the tool at {}", LENGTH.format(x)),
        }
    }
}

/// Compliances between places.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// Among headstock, tailstock and the places of the tool, in this order, m/N.
    compliance: DMatrix<f64>,
    /// Places of the tool, rising, m.
    tools: Vec<f64>,
}

impl Imported {
    /// Reads the table `[compliance]`, if there is one, of a machine with a tailstock or without.
    pub fn read(model: &Reader, tailstock: bool) -> Option<Self> {
        let about = "the machine's compliance at headstock, tailstock and tool, measured or condensed";
        model.optional_table("compliance", about, |t| Self::read_own(t, tailstock)).flatten()
    }

    fn read_own(t: &Reader, tailstock: bool) -> Option<Self> {
        let about = "a file with push, push_x, read, read_x, compliance and u";
        let scale =
            t.quantity("scale", NUMBER, "factor to all of them").estimated(estimates::COMPLIANCE).positive().or(1.0);
        let Some(listing) = t.listing("file", about) else {
            if !t.has("file") {
                t.problem("", format!("`file` is missing: {about}"), "add file = \"compliance.csv\"");
            }
            return None;
        };
        let told = |problem: Problem| {
            let message = format!("{}: {}", listing.path.display(), problem.message);
            t.problem("file", message, problem.help.unwrap_or_default());
        };
        let columns = Columns::of(&listing).map_err(&told).ok()?;
        let mut pairs = Vec::new();
        for row in &listing.rows {
            match columns.pair(row) {
                Ok(pair) => pairs.push(pair),
                Err(problem) => {
                    t.problem_on_line("file", &listing, row.line, &problem);
                    return None;
                }
            }
        }
        let own = Self::of(&pairs, tailstock).map_err(&told).ok()?;
        Some(Self { compliance: own.compliance * scale, ..own })
    }

    fn of(pairs: &[Pair], tailstock: bool) -> Result<Self, Problem> {
        let mut tools: Vec<f64> = pairs.iter().flat_map(|pair| pair.between).filter_map(tool).collect();
        tools.sort_by(f64::total_cmp);
        tools.dedup();
        if tools.is_empty() || tools.len() > MOST {
            let message = format!("the tool was pushed at {} places", tools.len());
            return Err(Problem::new(message).help(format!("push it at 1 to {MOST} places along the shaft")));
        }
        if let Some(pair) = tools.windows(2).find(|pair| pair[1] - pair[0] < APART) {
            let [one, other] = [pair[0], pair[1]].map(|x| LENGTH.format(x));
            let message = format!("the tool at {one} and at {other} is at one place");
            return Err(Problem::new(message).help("write both alike, or push it further away"));
        }
        let supports = [Place::Headstock, Place::Tailstock];
        let places: Vec<Place> = supports.into_iter().chain(tools.iter().map(|x| Place::Tool(*x))).collect();
        let is_there = |place: Place| tailstock || place != Place::Tailstock;
        // Each pair of places is looked up, for there are as many readings as pairs.
        let number = |place: &Place| match place {
            Place::Headstock => 0,
            Place::Tailstock => 1,
            Place::Tool(x) => 2 + tools.partition_point(|own| own < x),
        };
        let mut readings: Vec<Vec<&Pair>> = vec![Vec::new(); places.len() * places.len()];
        for pair in pairs {
            let [one, other] = [0, 1].map(|end| number(&pair.between[end]));
            readings[one * places.len() + other].push(pair);
        }
        let mut compliance = DMatrix::zeros(places.len(), places.len());
        let mut doubt: f64 = 0.0;
        for i in 0..places.len() {
            for j in 0..=i {
                if !is_there(places[i]) || !is_there(places[j]) {
                    continue;
                }
                let of = |one: usize, other: usize| readings[one * places.len() + other].iter().copied();
                let (a, b) = (places[i], places[j]);
                let both: Vec<&Pair> = of(i, j).chain(of(j, i).filter(|_| i != j)).collect();
                let Some(first) = both.first() else {
                    let message = format!("nothing says how {} moves where {} is pushed", a.told(), b.told());
                    return Err(
                        Problem::new(message).help("every pair of places has a line, in the one order or the other")
                    );
                };
                let mean = both.iter().map(|pair| pair.compliance).sum::<f64>() / both.len() as f64;
                if let Some(other) = both.iter().find(|pair| !agree(first, pair, mean)) {
                    let [one, other] = [first, other].map(|pair| COMPLIANCE.format(pair.compliance));
                    let message =
                        format!("{} and {}: {one} and {other}, where both ways are one compliance", a.told(), b.told());
                    return Err(Problem::new(message).help("measure both again; `u` says how far they may differ"));
                }
                compliance[(i, j)] = mean;
                compliance[(j, i)] = mean;
                doubt = doubt.max(first.u.unwrap_or(0.0));
            }
        }
        Ok(Self { compliance: possible(compliance, doubt, &places)?, tools })
    }

    /// How far the tool was pushed along the shaft, where it also cuts beyond, m.
    pub fn figure(&self, positions: &[f64]) -> Option<Figure> {
        let [first, last] = [*self.tools.first()?, *self.tools.last()?];
        positions.iter().any(|x| *x < first - NEAR || *x > last + NEAR).then(|| {
            let reach = match first == last {
                true => format!("at {}", LENGTH.format(first)),
                false => format!("from {} to {}", LENGTH.format(first), LENGTH.format(last)),
            };
            Figure::new("pushed", "[compliance] of the tool")
                .quantity("from", LENGTH, first)
                .quantity("to", LENGTH, last)
                .line(format!("{reach}; beyond it is taken to yield as there"))
        })
    }

    /// What a shaft with so many rests sees of it with the tool at each of the positions (m).
    pub fn foundation(&self, positions: &[f64], rests: usize) -> Foundation {
        let count = 3 + rests;
        let own = |i: usize, j: usize| if i < 2 && j < 2 { self.compliance[(i, j)] } else { 0.0 };
        let weights = |x: f64| {
            let mut weights = DVector::zeros(2 + self.tools.len());
            let after = self.tools.partition_point(|tool| *tool < x);
            match (after.checked_sub(1), self.tools.get(after)) {
                (Some(before), Some(next)) => {
                    let share = (x - self.tools[before]) / (next - self.tools[before]);
                    (weights[2 + before], weights[2 + after]) = (1.0 - share, share);
                }
                (Some(last), None) => weights[2 + last] = 1.0,
                (None, _) => weights[2] = 1.0,
            }
            weights
        };
        let seen = |x: &f64| {
            let weights = weights(*x);
            let moved = &self.compliance * &weights;
            let cross = (0..count).map(|k| if k < 2 { moved[k] } else { 0.0 }).collect();
            (cross, weights.dot(&moved))
        };
        let (cross, tool) = positions.iter().map(seen).unzip();
        Foundation { supports: DMatrix::from_fn(count, count, own), cross, tool, seats: Seats::default() }
    }
}

fn tool(place: Place) -> Option<f64> {
    match place {
        Place::Tool(x) => Some(x),
        Place::Headstock | Place::Tailstock => None,
    }
}

/// A reading: what is pushed and what is watched.
struct Pair {
    between: [Place; 2],
    /// m/N.
    compliance: f64,
    /// Its standard uncertainty, m/N.
    u: Option<f64>,
}

/// Whether two readings of one pair of places agree.
fn agree(one: &Pair, other: &Pair, mean: f64) -> bool {
    let apart = (one.compliance - other.compliance).abs();
    match (one.u, other.u) {
        (Some(a), Some(b)) => apart <= ASYMMETRY.0 * a.hypot(b),
        _ => apart <= ASYMMETRY.1 * mean.abs(),
    }
}

/// The compliance as some machine has it: no forces get work out of it. What a negative one owes to its uncertainty is zero.
fn possible(compliance: DMatrix<f64>, doubt: f64, places: &[Place]) -> Result<DMatrix<f64>, Problem> {
    let SymmetricEigen { mut eigenvalues, eigenvectors } = compliance.symmetric_eigen();
    let (least, value) = eigenvalues.argmin();
    let allowed = (ASYMMETRY.0 * doubt * (places.len() as f64).sqrt()).max(ROUNDED * eigenvalues.max());
    if value < -allowed {
        let mut pushed: Vec<(f64, Place)> =
            eigenvectors.column(least).iter().map(|part| part.abs()).zip(places.iter().copied()).collect();
        pushed.sort_by(|a, b| b.0.total_cmp(&a.0));
        let [one, other] = [pushed[0].1.told(), pushed[1].1.told()];
        let message =
            format!("no machine has these compliances: pushed together, {one} and {other} would give work away");
        let help = "a compliance between two places is no larger than the root of the product of their own; look at its sign too";
        return Err(Problem::new(message).help(help));
    }
    eigenvalues.iter_mut().for_each(|own| *own = own.max(0.0));
    Ok(&eigenvectors * DMatrix::from_diagonal(&eigenvalues) * eigenvectors.transpose())
}

/// The columns of the file, by their positions, with the units of the compliance and its uncertainty in m/N.
struct Columns {
    push: usize,
    push_x: Option<(usize, Unit)>,
    read: usize,
    read_x: Option<(usize, Unit)>,
    compliance: (usize, f64),
    u: Option<(usize, f64)>,
}

const KNOWN: [&str; 6] = ["push", "push_x", "read", "read_x", "compliance", "u"];

impl Columns {
    fn of(listing: &Listing) -> Result<Self, Problem> {
        let cells: Vec<(&str, &str)> = listing.header.iter().map(|cell| name_and_unit(cell)).collect();
        if let Some((name, _)) = cells.iter().find(|(name, _)| !KNOWN.contains(name)) {
            let help = format!("{}its columns are {}", did_you_mean(name, KNOWN, '`'), KNOWN.join(", "));
            return Err(Problem::new(format!("`{name}` is no column of compliances")).help(help));
        }
        let find = |wanted: &str| cells.iter().position(|(name, _)| *name == wanted);
        let needed = |wanted: &'static str| {
            find(wanted).ok_or_else(|| {
                Problem::new(format!("there is no column `{wanted}`"))
                    .help(format!("its columns are {}", KNOWN.join(", ")))
            })
        };
        let place = |wanted: &str| {
            let Some(column) = find(wanted) else { return Ok(None) };
            let unit = LENGTH.unit_of(cells[column].1);
            unit.map(|unit| Some((column, unit))).map_err(|e| {
                Problem::new(format!("`{wanted}`: {}", e.message)).help(format!("write {wanted} [mm] in its header"))
            })
        };
        let per_force = |column: usize| {
            let (name, unit) = cells[column];
            let unit = COMPLIANCE.unit_of(unit).map_err(|e| Problem::new(format!("`{name}`: {}", e.message)));
            unit.map(|unit| unit.factor).map_err(|e| e.help(format!("write {name} [um/kN] in its header")))
        };
        let compliance = needed("compliance")?;
        Ok(Self {
            push: needed("push")?,
            push_x: place("push_x")?,
            read: needed("read")?,
            read_x: place("read_x")?,
            compliance: (compliance, per_force(compliance)?),
            u: find("u").map(|column| Ok::<_, Problem>((column, per_force(column)?))).transpose()?,
        })
    }

    fn pair(&self, row: &ListedRow) -> Result<Pair, Problem> {
        let value =
            |(column, unit): (usize, f64), name: &str| Ok::<f64, Problem>(number(&row.cells[column], name)? * unit);
        let compliance = value(self.compliance, "compliance")?;
        let between =
            [self.place(row, self.push, self.push_x, "push_x")?, self.place(row, self.read, self.read_x, "read_x")?];
        if between[0] == between[1] && compliance <= 0.0 {
            let message = format!("{} does not give way where it is pushed", between[0].told());
            return Err(Problem::new(message).help("a place's own compliance is above zero"));
        }
        let u = self.u.filter(|(column, _)| !row.cells[*column].is_empty());
        let u = u.map(|u| value(u, "u")).transpose()?;
        if let Some(u) = u.filter(|u| *u <= 0.0) {
            let message = format!("`u` is {}, and an uncertainty is above zero", COMPLIANCE.format(u));
            return Err(Problem::new(message).help("leave the cell empty where it is not known"));
        }
        Ok(Pair { between, compliance, u })
    }

    fn place(&self, row: &ListedRow, word: usize, x: Option<(usize, Unit)>, name: &str) -> Result<Place, Problem> {
        match row.cells[word].as_str() {
            "headstock" => Ok(Place::Headstock),
            "tailstock" => Ok(Place::Tailstock),
            "tool" => {
                let cell =
                    x.map(|(column, unit)| (row.cells[column].as_str(), unit)).filter(|(cell, _)| !cell.is_empty());
                let missing = || Problem::new(format!("the tool stands nowhere: `{name}` is empty"));
                let (cell, unit) = cell.ok_or_else(|| missing().help("say at which x it was"))?;
                let x = number(cell, name)? * unit.factor + unit.offset;
                match x >= 0.0 {
                    true => Ok(Place::Tool(x)),
                    false => {
                        let message = format!("`{name}` is {}, and the shaft begins at 0", LENGTH.format(x));
                        Err(Problem::new(message).help("count x from the headstock's end of the shaft"))
                    }
                }
            }
            word => {
                let meant = did_you_mean(word, Place::WORDS, '`');
                let help = format!("{meant}places are {}", Place::WORDS.join(", "));
                Err(Problem::new(format!("`{word}` is no place")).help(help))
            }
        }
    }
}
