//! A measurement effect and the term of the covariance that it makes.

use std::fmt;
use std::sync::Arc;

use super::given::GivenCovariance;
use super::key::{Key, UNIT};
use crate::measure::Measurements;
use crate::process::Parameter;
use crate::units::{Kind, NUMBER};

/// Entries of a column: rows with their weights.
pub type Column = Vec<(usize, f64)>;

/// Effect of instrument, datum or surroundings on data: all of it but how the residuals ask for it.
pub struct MeasurementEffect {
    /// The word in `[measurement.NAME]`.
    pub name: &'static str,
    /// The phenomenon, in one sentence.
    pub about: &'static str,
    /// The equation.
    pub law: &'static str,
    /// Where the law comes from.
    pub source: &'static str,
    /// Feature of the data that separates it from effects of the machine.
    pub separates: &'static str,
    /// Keys of its table beside those of sizes.
    pub keys: &'static [Key],
    /// Its parameter.
    pub size: Size,
    /// How the size is written, without quotes.
    pub example: &'static str,
    /// The size where its key is left out; not a number where it is then estimated.
    pub usual: f64,
    /// Effects whose sizes stand in the same table; any may be zero then, and is left out.
    pub beside: &'static [&'static MeasurementEffect],
    /// Way in which it enters the covariance.
    pub acts: Acts,
    /// Its price in −2 ln L as a number of parameters, each of which costs ln n; the odds against a row that it names
    /// are added.
    pub parameters: f64,
    /// Prior odds against every row that it names, in −2 ln L.
    pub odds: f64,
    /// The shape that it describes, where no law here has it: it explains nothing.
    pub shape: Option<Shape>,
    /// Whether a hand that sets a zero anew makes it.
    pub sets_zero: bool,
}

impl MeasurementEffect {
    /// Defaults, which an entry of the catalogue overrides where it differs.
    pub const USUAL: Self = Self {
        name: "",
        about: "",
        law: "",
        source: "",
        separates: "",
        keys: &[],
        size: Size::Number("", ""),
        example: "",
        usual: f64::NAN,
        beside: &[],
        acts: Acts::Scales,
        parameters: 1.0,
        odds: 0.0,
        shape: None,
        sets_zero: false,
    };

    /// The keys of its table, those of sizes last but for what says of what the size is.
    pub fn all_keys(&self) -> Vec<Key> {
        let (before, after): (Vec<Key>, Vec<Key>) = self.keys.iter().partition(|key| **key != UNIT);
        let sizes = self.sizes().map(Self::size_key);
        before.into_iter().chain(sizes).chain(after).collect()
    }

    /// The key of its size.
    pub fn size_key(&self) -> Key {
        Key { name: self.size.key(), about: self.size.about(), example: self.example }
    }

    /// The keys of its table that hold a size.
    pub fn size_keys(&self) -> Vec<&'static str> {
        self.sizes().map(|effect| effect.size.key()).collect()
    }

    /// The effects whose sizes stand in its table, its own last.
    pub fn sizes(&self) -> impl Iterator<Item = &Self> {
        self.beside.iter().copied().chain([self])
    }

    /// Whether it only describes what no law here has.
    pub fn describes(&self) -> bool {
        self.shape.is_some()
    }

    /// Whether its table has a key.
    pub fn has(&self, key: Key) -> bool {
        self.keys.contains(&key)
    }
}

/// Shape of an effect without a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A wave; several of them make any curve.
    Wave,
    /// Any curve.
    Curve,
}

/// Its name and its size: effects of one table know one another.
impl fmt::Debug for MeasurementEffect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("MeasurementEffect").field("name", &self.name).field("size", &self.size.key()).finish()
    }
}

impl PartialEq for MeasurementEffect {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name && self.size.key() == other.size.key()
    }
}

/// The parameter of a measurement effect: its key and what it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Size {
    /// In the unit of what is observed.
    OfObservable(&'static str, &'static str),
    /// A plain number.
    Number(&'static str, &'static str),
    /// A quantity of a kind of its own, which a model may know roughly (`+-`) and a search may look for.
    Quantity(&'static Parameter),
    /// The same in the unit of what is observed, whatever that of the parameter is.
    OfReading(&'static Parameter),
    /// None, but a file.
    File(&'static str, &'static str),
}

impl Size {
    /// The key.
    pub fn key(self) -> &'static str {
        match self {
            Self::OfObservable(key, _) | Self::Number(key, _) | Self::File(key, _) => key,
            Self::Quantity(parameter) | Self::OfReading(parameter) => &parameter.name,
        }
    }

    /// Its description.
    pub fn about(self) -> &'static str {
        match self {
            Self::OfObservable(_, about) | Self::Number(_, about) | Self::File(_, about) => about,
            Self::Quantity(parameter) | Self::OfReading(parameter) => parameter.about,
        }
    }
}

/// How a measurement effect enters the covariance of the rows, or their prediction.
#[derive(Clone, Copy, Debug)]
pub enum Acts {
    /// Columns, each with an amplitude of its own from N(0, size²): adds size²·Z·Zᵀ. An infinite size is a
    /// flat prior: the amplitudes are free.
    Shared(fn(&Term, &Measurements) -> Vec<Column>),
    /// Correlates a row with the one before it: exp(−1/size).
    Neighbours,
    /// Multiplies the standard uncertainty of every row.
    Scales,
    /// Multiplies the standard uncertainty of the term's rows.
    Weighs,
    /// Adds size²/12 to the variance of every row where it is stated, and is a floor of it where it is not.
    Rounds,
    /// Adds to what the instrument shows: by its size, the value above the zero of its scale and that value's place in the
    /// term's range, -1 at its lower end and 1 at its upper one; it is no noise.
    Shows(fn(f64, f64, f64) -> f64),
    /// Changes the time at which a row was taken, by its size; it is no noise.
    Times(fn(f64, f64) -> f64),
    /// Takes the place of the standard uncertainties: the covariance is known.
    Given,
}

impl Acts {
    /// Whether its size follows from the likelihood of the residuals.
    pub fn is_estimated(self) -> bool {
        matches!(self, Self::Shared(_) | Self::Neighbours | Self::Scales)
    }

    /// Whether it changes what is read, and is no noise.
    pub fn is_reading(self) -> bool {
        matches!(self, Self::Shows(_) | Self::Times(_))
    }
}

/// The coordinate along which a term changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Along {
    /// Position in the process's list of coordinates.
    pub coordinate: usize,
    /// Whether it is an angle, around which a part is off its centre rather than askew.
    pub is_angle: bool,
}

/// A measurement effect at work in a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// The effect.
    pub effect: &'static MeasurementEffect,
    /// Name of its table in the model's file; empty where it stands in none.
    pub table: String,
    /// Coordinates whose levels group the rows, by their positions in the process's list, or
    /// [`FILE`](crate::measure::FILE).
    pub by: Vec<usize>,
    /// The coordinate along which it changes, if it does.
    pub along: Option<Along>,
    /// Values of what is observed between which a shape of the instrument's scale is told, SI.
    pub range: Option<[f64; 2]>,
    /// Period of a wave along that coordinate, SI.
    pub period: Option<f64>,
    /// The observable on which it acts, by its position in the process's list; `None` for all.
    pub observable: Option<usize>,
    /// The observables of which its size has the unit, where that leaves several of more; empty elsewhere.
    pub among: Vec<usize>,
    /// Rows, from 0: those that are outlying, or the first after a step.
    pub rows: Vec<usize>,
    /// The file in which the rows were counted before they were found in the measurements; `None` for all.
    pub file: Option<String>,
    /// Value of its parameter, SI; not a number where it is unknown, infinite where its amplitudes are free.
    pub size: f64,
    /// Covariance of the rows, where it is known.
    pub covariance: Option<Arc<GivenCovariance>>,
}

impl Term {
    /// Term of an effect on all rows, without a size yet.
    pub fn new(effect: &'static MeasurementEffect) -> Self {
        Self {
            effect,
            table: String::new(),
            by: Vec::new(),
            along: None,
            range: None,
            period: None,
            observable: None,
            among: Vec::new(),
            rows: Vec::new(),
            file: None,
            size: 0.0,
            covariance: None,
        }
    }

    /// Its price in −2 ln L among so many rows.
    pub fn price(&self, rows: usize) -> f64 {
        self.effect.parameters * (rows as f64).ln() + self.effect.odds * self.rows.len() as f64
    }

    /// Whether it acts on a row.
    pub fn is_of(&self, measurements: &Measurements, row: usize) -> bool {
        let seen = measurements.rows.observable[row];
        self.observable.map_or_else(|| self.among.is_empty() || self.among.contains(&seen), |own| own == seen)
    }

    /// Name of its table in a model's file, or that of its effect where it stands in none.
    pub fn name(&self) -> &str {
        if self.table.is_empty() { self.effect.name } else { &self.table }
    }

    /// Kind of its size in a file.
    pub fn kind(&self, measurements: &Measurements) -> Kind {
        let own = || measurements.observables.iter().find(|s| Some(s.position) == self.observable);
        match self.effect.size {
            Size::OfObservable(..) | Size::OfReading(_) => own().unwrap_or(&measurements.observables[0]).kind,
            Size::Number(..) | Size::File(..) => NUMBER,
            Size::Quantity(parameter) => parameter.kind,
        }
    }

    /// Whether its amplitudes are free: a flat prior.
    pub fn is_flat(&self) -> bool {
        matches!(self.effect.acts, Acts::Shared(_)) && self.size.is_infinite()
    }

    /// Level of each row by the groups that the term sets apart, if it does.
    pub fn levels(&self, measurements: &Measurements) -> Option<Vec<usize>> {
        match self.effect.acts {
            Acts::Shared(_) if !self.by.is_empty() => Some(measurements.levels(&self.by)),
            Acts::Shared(_) => {
                let first = self.rows.first()?;
                Some((0..measurements.len()).map(|row| usize::from(row >= *first)).collect())
            }
            _ => None,
        }
    }

    /// Whether it is the same term, whatever its size and its table.
    pub fn is_like(&self, other: &Self) -> bool {
        let bare = |term: &Self| Self { size: 0.0, table: String::new(), ..term.clone() };
        bare(self) == bare(other)
    }

    /// Whether the same term stands among others, whatever its size and its table.
    pub fn is_among(&self, others: &[Self]) -> bool {
        others.iter().any(|other| other.is_like(self))
    }
}
