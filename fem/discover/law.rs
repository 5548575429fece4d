//! Laws as formulas: what is written into a model, with names and units.

use nalgebra::DMatrix;

use super::scales;
use super::search::Term;
use super::shape::Shape;
use super::variable::{Factor, Variable};
use crate::model::{Entry, Model, Setting};
use crate::units::{ANGLE, Kind, TEMPERATURE, TEMPERATURE_RISE};

/// A formula with its parameters, each with its value as it is written.
#[derive(Clone, Debug, PartialEq)]
pub struct Written {
    /// The formula.
    pub formula: String,
    /// Names of the amplitudes of its terms, where it was made of terms.
    pub amplitudes: Vec<String>,
    /// What it is, for people, where somebody says so.
    pub about: Option<String>,
    /// Names and values of the parameters that are to be fitted and of the scales that are known.
    pub settings: Vec<(String, String)>,
}

impl Written {
    /// The settings of an effect with it, its values open.
    pub fn open(&self) -> Vec<Setting> {
        let setting = |key: &str, value: &String| Setting { key: key.into(), value: Entry::Text(value.clone()) };
        let about = self.about.iter().map(|about| setting("about", about));
        let values = self.settings.iter().map(|(key, value)| setting(key, value));
        std::iter::once(setting("formula", &self.formula)).chain(about).chain(values).collect()
    }
}

/// Names and values of parameters in the making, beside those of a model.
struct Names<'m> {
    settings: Vec<(String, String)>,
    model: &'m Model,
}

impl Names<'_> {
    /// A name that begins so and is free, with its value.
    fn add(&mut self, stem: &str, value: String) -> String {
        let is_free = |name: &String| self.settings.iter().all(|(other, _)| other != name);
        let numbered = (2..).map(|number| format!("{stem}{number}"));
        let name = std::iter::once(stem.to_string()).chain(numbered).find(is_free).unwrap_or_default();
        self.settings.push((name.clone(), value));
        name
    }

    /// A known scale.
    fn scale(&mut self, own: &Variable) -> String {
        self.add(
            &format!("{}_0", short(&own.name)),
            quantity(own.scale / own.kind.canonical().factor, difference(own.kind)),
        )
    }
}

/// Writes terms with their amplitudes, in units of the error `kind` of the observable; known scales by their names in the model.
pub fn written(terms: &[(&Term, Vec<f64>)], variables: &[Variable], (model, kind): (&Model, Kind)) -> Written {
    let mut names = Names { settings: Vec::new(), model };
    let (mut parts, mut all) = (Vec::new(), Vec::new());
    for (term, amplitudes) in terms {
        let sizes = separated(term, amplitudes);
        let product: Vec<(f64, String)> =
            term.factors.iter().zip(&sizes).map(|(own, sizes)| expression(own, sizes, variables, &mut names)).collect();
        let size = amplitude(term, amplitudes, &sizes) * product.iter().map(|own| own.0).product::<f64>();
        let a = names.add("a", near(size, kind));
        let rest: Vec<String> = product.into_iter().map(|own| own.1).filter(|text| !text.is_empty()).collect();
        all.push(a.clone());
        parts.push(std::iter::once(a).chain(rest).collect::<Vec<_>>().join("*"));
    }
    Written { formula: parts.join(" + "), amplitudes: all, about: None, settings: names.settings }
}

/// The amplitudes of the functions of each factor, as those of a product: the leading vector of each unfolding.
fn separated(term: &Term, amplitudes: &[f64]) -> Vec<Vec<f64>> {
    let counts: Vec<usize> = term.factors.iter().map(|own| own.shape.functions()).collect();
    let mut all = Vec::new();
    for (f, count) in counts.iter().enumerate() {
        let inner: usize = counts[f + 1..].iter().product();
        let matrix = DMatrix::from_fn(*count, amplitudes.len() / count, |own, other| {
            let (outer, rest) = (other / inner, other % inner);
            amplitudes[(outer * count + own) * inner + rest]
        });
        let svd = matrix.svd(true, false);
        let leading = svd.singular_values.imax();
        all.push(svd.u.map_or(vec![1.0; *count], |u| u.column(leading).iter().copied().collect()));
    }
    all
}

/// The size of the product.
fn amplitude(term: &Term, amplitudes: &[f64], sizes: &[Vec<f64>]) -> f64 {
    let counts: Vec<usize> = term.factors.iter().map(|own| own.shape.functions()).collect();
    let along = |index: usize| {
        let (mut left, mut product) = (index, 1.0);
        for (f, count) in counts.iter().enumerate().rev() {
            product *= sizes[f][left % count];
            left /= count;
        }
        product
    };
    amplitudes.iter().enumerate().map(|(i, own)| own * along(i)).sum()
}

/// A factor as text, and by what the amplitude is larger for it.
fn expression(factor: &Factor, sizes: &[f64], variables: &[Variable], names: &mut Names<'_>) -> (f64, String) {
    let own = &variables[factor.variable];
    let v = own.name.to_string();
    let short = short(&own.name);
    let (kind, width) = (own.kind, difference(own.kind));
    let (c, w) = (factor.constants.first().copied().unwrap_or(1.0), factor.constants.get(1).copied().unwrap_or(1.0));
    let place = |names: &mut Names, si: f64| names.add(&format!("{short}_c"), near(kind.from_si(si), kind));
    let size = |names: &mut Names, si: f64| names.add(&format!("{short}_w"), near(si / kind.canonical().factor, width));
    let one = sizes[0];
    match factor.shape {
        Shape::Proportional => (one, format!("{v}/{}", names.scale(own))),
        Shape::Line => {
            let c = place(names, -own.scale * sizes[1] / sizes[0]);
            (one, format!("({v} - {c})/{}", names.scale(own)))
        }
        Shape::Power(p) if p < 0.0 => (one, format!("({v}/{})^({p})", names.scale(own))),
        Shape::Power(p) => (one, format!("({v}/{})^{p}", names.scale(own))),
        Shape::Exponent => {
            let s = names.scale(own);
            let n = names.add(&format!("{short}_n"), format!("? near {}", digits(c)));
            (one, format!("({v}/{s})^{n}"))
        }
        Shape::Parabola => {
            let ratio = sizes[1] / sizes[0];
            let rest = sizes[2] / sizes[0] - 0.25 * ratio * ratio;
            let c = place(names, -0.5 * own.scale * ratio);
            let s = names.scale(own);
            let d = names.add("d", format!("? near {}", digits(rest)));
            (one, format!("((({v} - {c})/{s})^2 + {d})"))
        }
        Shape::Fourth => {
            let c = place(names, c);
            (one, format!("(({v} - {c})/{})^4", names.scale(own)))
        }
        Shape::Decay => (one, format!("exp(-{v}/{})", size(names, c))),
        Shape::Relaxation => {
            let w = size(names, c);
            let d = names.add("d", format!("? near {}", digits(-sizes[1] / sizes[0])));
            (-one, format!("({d} - exp(-{v}/{w}))"))
        }
        Shape::Logarithm => (one, format!("ln(1 + {v}/{})", size(names, c))),
        Shape::Saturation => (one, format!("1/(1 + {v}/{})", size(names, c))),
        Shape::Hump => {
            let w = size(names, c);
            (one, format!("{v}/{w}*exp(-{v}/{w})"))
        }
        Shape::Transition => {
            let (c, w) = (place(names, c), size(names, w));
            let d = names.add("d", format!("? near {}", digits(sizes[1] / sizes[0])));
            (one, format!("({d} + tanh(({v} - {c})/{w}))"))
        }
        Shape::Bell => match factor.constants[0] {
            0.0 => (one, format!("exp(-({v}/{})^2)", size(names, w))),
            _ => {
                let (c, w) = (place(names, c), size(names, w));
                (one, format!("exp(-(({v} - {c})/{w})^2)"))
            }
        },
        Shape::Excess => {
            let other = factor.other.map(|other| variables[other].name.to_string()).unwrap_or_default();
            let m = names.add("m", format!("? near {}", digits(c)));
            (one, format!("max(0, {v} - {m}*{other})/{}", names.scale(own)))
        }
        Shape::Hinge => {
            let c = place(names, c);
            (one, format!("max(0, {v} - {c})/{}", names.scale(own)))
        }
        Shape::Fall => {
            let c = place(names, c);
            (one, format!("max(0, {c} - {v})/{}", names.scale(own)))
        }
        Shape::Step => {
            let c = place(names, c);
            (one, format!("step({v} - {c})"))
        }
        Shape::Tent => {
            let (c, w) = (place(names, c), size(names, w));
            (one, format!("max(0, 1 - abs({v} - {c})/{w})"))
        }
        Shape::Bowl => {
            let (c, w) = (place(names, c), size(names, w));
            (one, format!("sqrt(1 + (({v} - {c})/{w})^2)"))
        }
        Shape::Resonance => {
            let c = place(names, c);
            let z = names.add("z", format!("? near {}", digits(w)));
            (one, format!("1/sqrt((1 - ({v}/{c})^2)^2 + (2*{z}*{v}/{c})^2)"))
        }
        Shape::Pole => (one, format!("1/(1 - ({v}/{})^2)", place(names, c))),
        Shape::Softening => {
            let c = place(names, c);
            (one, format!("({v}/{c})/(1 - {v}/{c})"))
        }
        Shape::Wave | Shape::Ringing | Shape::Harmonic(_) => {
            let (length, phase) = (sizes[0].hypot(sizes[1]), sizes[1].atan2(sizes[0]));
            let phase = |names: &mut Names| names.add("phi", near(phase / ANGLE.canonical().factor, ANGLE));
            match factor.shape {
                Shape::Harmonic(k) => {
                    let turns = if k == 1.0 { v } else { format!("{k}*{v}") };
                    (length, format!("sin({turns} + {})", phase(names)))
                }
                Shape::Ringing => {
                    let p = names.add(&format!("{short}_p"), near(c / kind.canonical().factor, width));
                    let w = size(names, w);
                    (length, format!("exp(-{v}/{w})*sin(2*pi*{v}/{p} + {})", phase(names)))
                }
                _ => {
                    let period = c / kind.canonical().factor;
                    let stem = format!("{short}_p");
                    let p = match factor.is_known.then(|| scales::name(names.model, width, c)) {
                        None => names.add(&stem, near(period, width)),
                        Some(None) => names.add(&stem, quantity(period, width)),
                        Some(Some(path)) => path.to_string(),
                    };
                    (length, format!("sin(2*pi*{v}/{p} + {})", phase(names)))
                }
            }
        }
        Shape::Arch => {
            let p = names.add(&format!("{short}_p"), near(c / kind.canonical().factor, width));
            (one, format!("abs(sin(pi*{v}/{p}))"))
        }
        Shape::Lobe(k) => (one, if k == 1.0 { format!("abs(cos({v}))") } else { format!("abs(cos({k}*{v}))") }),
        Shape::Sign => (one, format!("(2*{v} - 1)")),
        Shape::Word => (one, format!("max(0, 1 - abs({v} - {c}))")),
    }
}

/// Kind of differences of a kind.
fn difference(kind: Kind) -> Kind {
    if kind == TEMPERATURE || kind.unit == TEMPERATURE.unit { TEMPERATURE_RISE } else { kind }
}

/// The letters by which parameters of a variable are named.
fn short(name: &str) -> String {
    name.split(|c: char| !c.is_alphanumeric()).filter_map(|word| word.chars().next()).collect()
}

/// A number in a unit from which a search begins.
pub fn near(value: f64, kind: Kind) -> String {
    format!("? near {} {}", digits(value), kind.unit).trim_end().to_string()
}

/// A known quantity.
pub fn quantity(value: f64, kind: Kind) -> String {
    format!("{} {}", digits(value), kind.unit).trim_end().to_string()
}

fn digits(value: f64) -> String {
    format!("{value:.6e}").parse::<f64>().unwrap_or(value).to_string()
}
