//! What is not believed though the rows ask for it: a place at the end of where it may be, causes that do not foresee what is
//! held out, and several values of one set that are all unusual. Something that is in no catalogue is as likely then.

use super::candidate_model::CandidateModel;
use super::laplace;
use super::posterior::Posterior;
use crate::input::Name;
use crate::process::{Description, Neutral, Parameter};

/// Standard deviations of what is usual beyond which a value is unusual: one in four hundred is.
const UNUSUAL: f64 = 3.0;
/// Unusual values of one set from which the set is not believed: of ten normal values two are so by chance once in three thousand times.
const SEVERAL: usize = 2;
/// Probability that is left to what is in no catalogue.
const SHARE: f64 = 0.5;

/// What speaks against a set though it explains the rows.
pub struct Strain {
    /// Its effects that stand at the end of where they may be.
    at_an_end: Vec<Name>,
    /// What speaks against all of it, a sentence each.
    pub cautions: Vec<String>,
}

impl Strain {
    /// What speaks against a fitted set; `doubts` are what does already.
    pub fn of(set: &CandidateModel, doubts: impl IntoIterator<Item = String>) -> Self {
        let own = || own_values(set);
        let mut at_an_end: Vec<Name> =
            own().filter(|(_, i)| is_at_an_end(set, *i)).map(|(e, _)| e.name.clone()).collect();
        at_an_end.dedup();
        let deviations = laplace::deviations(set);
        let unusual = own().map(|(_, i)| i).filter(|i| deviations[*i].abs() > UNUSUAL);
        let unusual: Vec<String> = unusual.map(|i| format!("`{}`", set.objective.parameters[i].path)).collect();
        let caution = (unusual.len() >= SEVERAL).then(|| {
            format!(
                "the causes come so near only by values of which each is unusual, {}: something that is in no catalogue is as likely",
                unusual.join(", ")
            )
        });
        Self { at_an_end, cautions: doubts.into_iter().chain(caution).collect() }
    }

    /// Whether it speaks against the whole set.
    pub fn is_of_the_set(&self) -> bool {
        !self.cautions.is_empty()
    }

    /// Leaves what it takes of the probability to what is in no catalogue.
    pub fn weaken(&self, posterior: &mut Posterior) {
        if self.is_of_the_set() {
            posterior.share(SHARE, &Posterior::default());
        }
        self.at_an_end.iter().for_each(|name| posterior.doubt(name, SHARE));
    }

    /// Why an effect is in doubt, if it is.
    pub fn doubt(&self, effect: &Description) -> Option<String> {
        self.at_an_end.contains(&effect.name).then(|| {
            "its place stands at the end of where it may be: what makes it may act at that end, or beyond".into()
        })
    }
}

/// The effects of a set with the numbers of their values among its parameters.
fn own_values<'s>(set: &'s CandidateModel) -> impl Iterator<Item = (&'s Description, usize)> {
    let values = set.objective.added.iter().flat_map(|effect| effect.parameters.iter().map(move |_| effect));
    values.zip(set.objective.data.model.parameters.len()..)
}

/// Whether a value is a place that a fit has brought to the end of where it may be.
fn is_at_an_end(set: &CandidateModel, i: usize) -> bool {
    let is_place = |entry: &Parameter| entry.along.is_some() && !entry.is_step && entry.neutral == Neutral::Shape;
    set.objective.catalogue(i).is_some_and(is_place) && set.objective.variables[i].is_at_bound(set.solution.position[i])
}

#[cfg(test)]
mod tests {
    use nalgebra::DVector;

    use super::Strain;
    use crate::diagnose::candidate_model::CandidateModel;
    use crate::diagnose::laplace;
    use crate::fit::Objective;
    use crate::input::Source;
    use crate::measure::Measurements;
    use crate::model::{Data, Model};

    /// Of a source at a place (mm) with a power (W), and of what its base conducts (W/K).
    #[test]
    fn a_place_at_an_end_is_in_doubt_and_so_are_two_unusual_values_but_not_one() {
        let text = "process = \"thermal\"\nbody = { material = \"steel\", segments = [{ length = \"200 mm\", diameter = \"20 mm\" }] }\n\
                    environment = { temperature = \"20 degC\" }\n\
                    source = [{ at = \"0 mm\", power = \"5 W\" }]\ntime = { end = \"600 s\", step = \"60 s\" }\n\
                    measurement = { places = [\"100 mm\"], interval = \"60 s\" }\n";
        let model = Model::parse(Source::new("model.toml", text)).unwrap();
        let rows = "time [s],x [mm],temperature [degC],u [K]\n60,100,20,1\n120,100,20,1\n300,150,21,1\n600,50,25,1\n";
        let rows = Measurements::parse(Source::new("rows.csv", rows), &*model.process).unwrap();
        let data = Data::of(&model, rows).unwrap();
        let effect = |name: &str| model.process.effects().into_iter().find(|own| own.name == *name).unwrap();
        let objective = Objective::new(&data).unwrap();
        let objective = objective.with(&effect("extra-source")).with(&effect("base-conductance"));
        let first = model.parameters.len();
        let set = |[at, power, conductance]: [f64; 3]| {
            let mut position = DVector::zeros(first + 3);
            position.rows_mut(first, 3).copy_from_slice(&[1e-3 * at, power, conductance]);
            let solution = objective.evaluate(position).unwrap();
            CandidateModel { members: vec![0, 1], objective: objective.clone(), solution }
        };
        let cases = [
            ([100.0, 10.0, 1.0], [false, false]),
            ([200.0, 10.0, 1.0], [true, false]),
            ([0.0, 10.0, 1.0], [true, false]),
            ([100.0, 5e3, 1.0], [false, false]),
            ([100.0, 5e3, 1e3], [false, true]),
            ([200.0, 5e3, 1e3], [true, true]),
        ];
        for (values, [at_an_end, unusual]) in cases {
            let strain = Strain::of(&set(values), None);
            let doubts = ["extra-source", "base-conductance"].map(|name| strain.doubt(&effect(name)).is_some());
            assert_eq!((doubts, strain.is_of_the_set()), ([at_an_end, false], unusual), "{values:?}");
        }
        let doubted = Strain::of(&set(cases[0].0), Some("held out".into()));
        assert_eq!((doubted.is_of_the_set(), doubted.cautions.len()), (true, 1));
        for (power, has_weight) in [(10.0, true), (5e3, true), (3e4, false)] {
            assert_eq!(laplace::criterion(&set([100.0, power, 1.0])).is_some(), has_weight, "{power} W");
        }
    }
}
