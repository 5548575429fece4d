//! A model with other values for what it does not know exactly.

use std::sync::Arc;

use super::{Model, Place, place_among, places, read, recorded};
use crate::input::{Cache, Instead, ParameterId, Reader};
use crate::noise::{self, MEASUREMENT, Term};
use crate::process::{Active, Command, Failure, ForwardModel, ON_TRIAL, System};

/// What a model is read as with other values: the machine, its effects and those of the measurement.
type Parts = (Arc<dyn System>, Vec<Active>, Vec<Term>);

/// The last few of them: derivatives by the values of effects that are on trial ask for the same machine.
type Readings = Cache<Instead, Parts, 4>;

impl Model {
    /// The model with values (SI) entered for quantities, by their paths: known, whatever the file says of them. The
    /// values must lie within the bounds of their quantities.
    ///
    /// # Errors
    /// The values make no model.
    pub fn with_values(&self, values: &[(&str, f64)]) -> Result<Self, Failure> {
        let mut model = self.clone();
        model.parameters.retain(|p| values.iter().all(|(path, _)| &*p.path != *path));
        model.places = places(&model.parameters, &model.effects, &model.measurement);
        model.entered.extend(values.iter().map(|(path, value)| (ParameterId::from(*path), *value)));
        let places = values.iter().map(|(path, value)| Some((self.place(path)?, *value)));
        match places.collect::<Option<Vec<_>>>() {
            // The system need not be read again.
            Some(places) => {
                for ((effect, parameter), value) in places {
                    model.effects[effect].values[parameter] = value;
                }
            }
            None => {
                let entered = model.entered.clone();
                (model.system, model.effects, model.measurement) =
                    self.read_instead(Instead { entered, ..Instead::default() })?;
            }
        }
        Ok(model)
    }

    /// Forward model with the parameters at these values (SI, in the order of `parameters`).
    ///
    /// # Errors
    /// The values make no model: a search went where there is none.
    #[doc(hidden)]
    pub fn forward_at(&self, values: &[f64]) -> Result<Box<dyn ForwardModel>, Failure> {
        self.forward_with(values, &[])
    }

    /// Forward model with the parameters at these values and further effects that the file does not have.
    ///
    /// # Errors
    /// The values make no model.
    #[doc(hidden)]
    pub fn forward_with(&self, values: &[f64], added: &[Active]) -> Result<Box<dyn ForwardModel>, Failure> {
        if let Some(campaign) = self.campaign() {
            let effects = [self.whatever_else_at(values).0, added.to_vec()].concat();
            return campaign.forward(values, &effects);
        }
        let is_value = |active: &&Active| active.description.table == ON_TRIAL;
        let on_trial: Vec<(&str, f64)> = added
            .iter()
            .filter(is_value)
            .filter_map(|active| Some((&*active.description.name, *active.values.first()?)))
            .collect();
        if on_trial.iter().any(|(path, _)| self.place(path).is_none()) {
            let others: Vec<Active> = added.iter().filter(|active| !is_value(active)).cloned().collect();
            return self.with_values(&on_trial)?.forward_with(values, &others);
        }
        self.forward_of(values, |mut effects| {
            for (path, value) in on_trial {
                if let Some((effect, parameter)) = place_among(&effects, path) {
                    effects[effect].values[parameter] = value;
                }
            }
            effects.extend(added.iter().filter(|active| !is_value(active)).cloned());
            effects
        })
    }

    /// Forward model with the parameters at these values and without one of its effects, by its name.
    ///
    /// # Errors
    /// The values make no model.
    #[doc(hidden)]
    pub fn forward_without(&self, values: &[f64], effect: &str) -> Result<Box<dyn ForwardModel>, Failure> {
        self.forward_of(values, |mut effects| {
            effects.retain(|e| e.description.name != effect && !e.description.is_change_of(effect));
            effects
        })
    }

    /// Forward model with the parameters at these values, and of its effects what `choose` makes of them.
    pub(super) fn forward_of(
        &self,
        values: &[f64],
        choose: impl FnOnce(Vec<Active>) -> Vec<Active>,
    ) -> Result<Box<dyn ForwardModel>, Failure> {
        if let Some(campaign) = self.campaign() {
            return campaign.forward(values, &choose(self.whatever_else_at(values).0));
        }
        if let Some((effects, terms)) = self.effects_at(values) {
            return Ok(self.assembled(&*self.system, choose(effects), terms));
        }
        let (system, effects, terms) = self.read_at(values)?;
        Ok(self.assembled(&*system, choose(effects), terms))
    }

    /// The machine with effects, behind the instrument with the terms of the file and those among the effects.
    fn assembled(&self, system: &dyn System, effects: Vec<Active>, mut terms: Vec<Term>) -> Box<dyn ForwardModel> {
        let (readings, effects): (Vec<_>, Vec<_>) =
            effects.into_iter().partition(|e| e.description.table == MEASUREMENT);
        terms.extend(readings.iter().filter_map(|reading| noise::reading(reading, &*self.process)));
        self.behind(system.with_effects(&effects), &terms)
    }

    /// What makes the part, with the parameters at these values (SI, in the order of `parameters`) and a correction of its
    /// command: no instrument stands before it.
    ///
    /// # Errors
    /// The values make no model.
    #[doc(hidden)]
    pub fn commanded_at(&self, values: &[f64], command: &Arc<Command>) -> Result<Box<dyn ForwardModel>, Failure> {
        let (system, mut effects) = match self.effects_at(values) {
            Some((effects, _)) => (self.system.clone(), effects),
            None => self.read_at(values).map(|(system, effects, _)| (system, effects))?,
        };
        effects.retain(|effect| effect.description.table != MEASUREMENT);
        Ok(system.with_command(&effects, command))
    }

    /// System with the parameters at these values (SI, in the order of `parameters`).
    ///
    /// # Errors
    /// The values make no model.
    #[doc(hidden)]
    pub fn system_at(&self, values: &[f64]) -> Result<Arc<dyn System>, Failure> {
        if self.campaign().is_some() {
            return Ok(self.system.clone());
        }
        match self.effects_at(values) {
            Some(_) => Ok(self.system.clone()),
            None => self.read_at(values).map(|(system, ..)| system),
        }
    }

    /// Reads the file again with other values.
    fn read_at(&self, values: &[f64]) -> Result<Parts, Failure> {
        let tried = self.parameters.iter().map(|p| p.path.clone()).zip(values.iter().copied()).collect();
        self.read_instead(Instead { tried, entered: self.entered.clone() })
    }

    fn read_instead(&self, instead: Instead) -> Result<Parts, Failure> {
        let known = self.kept.of_tables::<Readings>();
        let parts = known.get_or(instead, |instead| {
            let ((_, _, system, effects, terms, _), found) =
                Reader::of_file(self.tables.now(), self.source.folder(), &self.kept, instead.clone(), |model| {
                    recorded::read(model, &*self.process, &[]);
                    read(model, &*self.process)
                });
            match (system, found.problems.first()) {
                (Some(system), None) => Ok((system, effects, terms)),
                (_, problem) => Err(Failure {
                    message: problem.map_or("the values make no model".into(), |p| p.message.clone()),
                    help: problem.and_then(|p| p.help.clone()).unwrap_or_default(),
                }),
            }
        })?;
        Ok((*parts).clone())
    }

    /// Effects, of the machine and of the measurement, with other values, if nothing else is unknown; the
    /// system then need not be read again.
    fn effects_at(&self, values: &[f64]) -> Option<(Vec<Active>, Vec<Term>)> {
        (!self.places.contains(&Place::Table)).then(|| self.whatever_else_at(values))
    }

    /// The same, whatever else is unknown.
    fn whatever_else_at(&self, values: &[f64]) -> (Vec<Active>, Vec<Term>) {
        let (mut effects, mut terms) = (self.effects.clone(), self.measurement.clone());
        for (place, value) in self.places.iter().zip(values) {
            match *place {
                Place::Effect(effect, own) => effects[effect].values[own] = *value,
                Place::Size(term) => terms[term].size = *value,
                Place::Table => {}
            }
        }
        (effects, terms)
    }
}

#[cfg(test)]
mod tests {
    use crate::input::{Parameter, Source};
    use crate::model::Model;

    fn parsed(text: &str) -> Model {
        Model::parse(Source::new("model.toml", text)).unwrap()
    }

    /// Tables without a value on trial are not read again, those that depend on others are: a trial predicts what the file
    /// with its values does.
    #[test]
    fn a_trial_of_a_structure_is_its_file_with_other_values() {
        let cases = [
            ("effects.carriage-compliance.stiffness", "80 +- 20 N/um", "70 N/um", 70e6),
            ("structure.tailstock-tilt.stiffness", "1500 +- 400 kN*m/rad", "900 kN*m/rad", 9e5),
            ("structure.bed-a.height", "220 +- 5 mm", "200 mm", 0.2),
            ("structure.nodes.tailstock-foot[1]", "-340 +- 10 mm", "-320 mm", -0.32),
            ("structure.material.youngs_modulus", "110 +- 5 GPa", "90 GPa", 90e9),
        ];
        let text = include_str!("../../models/lathe-on-bed.toml")
            .replacen("\"220 mm\"", "\"220 +- 5 mm\"", 1)
            .replace("\"cast-iron\"", "{ base = \"cast-iron\", youngs_modulus = \"110 +- 5 GPa\" }")
            .replace("tailstock-foot = [\"720 mm\", \"-350 mm\"]", "tailstock-foot = [\"720 mm\", \"-340 +- 10 mm\"]");
        let model = parsed(&text);
        let rows = model.system.programme();
        for (path, doubted, written, value) in cases {
            let own = |parameter: &Parameter| if *parameter.path == *path { value } else { parameter.quantity.value };
            let values: Vec<f64> = model.parameters.iter().map(own).collect();
            let tried = model.forward_at(&values).unwrap().observe(&rows).unwrap();
            let expected = parsed(&text.replace(doubted, written)).forward().observe(&rows).unwrap();
            let first = model.forward().observe(&rows).unwrap();
            assert_ne!(tried, first, "{path}");
            for (tried, expected) in tried.iter().zip(&expected) {
                assert!((tried - expected).abs() <= 1e-12 * expected.abs(), "{path}: {tried} {expected}");
            }
        }
    }
}
