//! Other sets of effects that explain the measurements of a model as well as its own: whoever predicts where nothing was measured
//! has to reckon with them.

use toml_edit::Value;

use super::{Edit, Entry};
use crate::input::{ParameterId, Raw, Reader};
use crate::units::NUMBER;

/// Key of their list in the table of what is known together.
pub(super) const INSTEAD: &str = "instead";

/// One of them.
#[derive(Clone, Debug, PartialEq)]
pub struct OtherSet {
    /// Its probability beside the model and the others.
    pub probability: f64,
    /// Names of effects of the model that it does not have.
    pub without: Vec<String>,
    /// Its values, with their units, by the keys of a model.
    pub values: Vec<(ParameterId, String)>,
}

impl OtherSet {
    /// Reads all of them.
    pub(super) fn all(together: &Reader) -> Vec<Self> {
        let about = "other sets of effects that explain the measurements as well";
        let own = |t: &Reader, _| {
            let probability = t.quantity("probability", NUMBER, "beside the model and the others");
            let probability = probability.chosen().within(0.0, 1.0).required();
            let without = t.text("without", "effects of the model that it does not have").unwrap_or_default();
            let values = t.text("values", "its values: `effects.tool-wear.rate = 3.1 um/km; …`").unwrap_or_default();
            let value = |own: &str| {
                let (path, value) = own.split_once('=')?;
                Some((ParameterId::from(path.trim()), value.trim().to_string()))
            };
            let all: Vec<Option<(ParameterId, String)>> = parted(&values, ';').map(value).collect();
            if all.contains(&None) {
                t.problem(
                    "values",
                    "`values` has an entry without `=`",
                    "write `effects.tool-wear.rate = 3.1 um/km; …`",
                );
            }
            let without = parted(&without, ',').map(str::to_string).collect();
            Self { probability, without, values: all.into_iter().flatten().collect() }
        };
        together.list(INSTEAD, about, own)
    }

    /// The edits that make of the model one with this set.
    pub(super) fn edits(&self) -> impl Iterator<Item = Edit> {
        let without = self.without.iter().map(|name| Edit::Erase(format!("effects.{name}").as_str().into()));
        let values = self.values.iter().map(|(path, value)| {
            let value = Raw::of(Value::from(value.as_str()), None);
            Edit::Write { path: path.clone(), value }
        });
        without.chain(values)
    }

    /// Its keys as a model has them.
    pub(super) fn entry(&self) -> Vec<(String, Entry)> {
        let values: Vec<String> = self.values.iter().map(|(path, value)| format!("{path} = {value}")).collect();
        let probability = Entry::Number((1e3 * self.probability).round() / 1e3);
        let without = (!self.without.is_empty()).then(|| ("without".into(), Entry::Text(self.without.join(", "))));
        let values = ("values".to_string(), Entry::Text(values.join("; ")));
        [("probability".to_string(), probability)].into_iter().chain(without).chain([values]).collect()
    }
}

/// Entries of a list in a text.
fn parted(text: &str, by: char) -> impl Iterator<Item = &str> {
    text.split(by).map(str::trim).filter(|own| !own.is_empty())
}
