//! Candidates of which these rows see no more than a curve, which many laws make: a small part of a turn, a piece of a wave,
//! and times that only rise with a place. They are not sought.

use std::f64::consts::{PI, TAU};

use nalgebra::DVector;
use rayon::prelude::*;

use super::sensitivity::{self, CandidateEffect, LinearParameter, Variant};
use crate::fit::{Objective, Solution};
use crate::model::Data;
use crate::noise::time_of;
use crate::process::{Absent, Description, Holds, Parameter, Rows, Values};
use crate::units::{LENGTH, PERIOD};

/// Sensitivities of all `effects` about a solution of the model without them, without those that are like any curve.
pub fn candidates(objective: &Objective, base: &Solution, effects: &[Description]) -> Vec<CandidateEffect> {
    let mut all = sensitivity::candidates(objective, base, effects);
    let untimed = without_times(objective.data);
    let span = objective.only_span();
    all.par_iter_mut().for_each(|candidate| {
        let Some(first) = candidate.variants.first() else { return };
        let seen = Seen { trial: &objective.with(&candidate.effect), base, variant: first };
        let is_longer = |own: &Parameter| own.kind == PERIOD && span.is_some_and(|s| s < own.kind.to_si(own.range.0));
        let is_curve = candidate.effect.parameters.iter().any(is_longer)
            || untimed.as_ref().is_some_and(|rows| seen.acts_through_times(rows))
            || candidate.is_of_one_shape() && seen.turn().is_some_and(|turn| turn < PI);
        if is_curve {
            candidate.variants.clear();
        }
    });
    all
}

/// An effect in one of its shapes, as rows see it.
struct Seen<'a, 'm> {
    trial: &'a Objective<'m>,
    base: &'a Solution,
    variant: &'a Variant,
}

impl Seen<'_, '_> {
    /// What each linear parameter changes in some rows, SI per unit of its search variable; `None` where the model cannot
    /// be computed there.
    fn columns(&self, rows: &Rows) -> Option<Vec<DVector<f64>>> {
        let predict = |own: Vec<f64>| {
            let all = self.base.position.iter().copied().chain(own);
            self.trial.predict_rows(&DVector::from_vec(all.collect()), rows)
        };
        let here = predict(self.variant.position.clone())?;
        let column = |parameter: &LinearParameter| {
            let mut moved = parameter.beside(&self.variant.position);
            moved[parameter.parameter] += parameter.size;
            let there = predict(moved)?;
            let changes = there.iter().zip(&here).map(|(there, here)| (there - here) / parameter.size);
            Some(DVector::from_vec(changes.collect()))
        };
        self.variant.linear.iter().map(column).collect()
    }

    /// Whether it makes something else of the rows when nobody has read a clock.
    fn acts_through_times(&self, untimed: &Rows) -> bool {
        /// Part of what an effect makes that it makes through times, from which it acts through them.
        const THROUGH: f64 = 0.01;
        let Some(columns) = self.columns(untimed) else { return false };
        let mut own = columns.iter().zip(self.variant.raw.column_iter());
        own.any(|(untimed, column)| (untimed - column).norm() > THROUGH * column.norm())
    }

    /// How far a wave turns from one end of the rows to the other, along the coordinate along which it turns most, rad.
    fn turn(&self) -> Option<f64> {
        /// Part of the range of a coordinate by which rows are moved to see how fast a wave turns there.
        const STEP: f64 = 1e-5;
        let data = self.trial.data;
        let zero = self.variant.wave()?;
        let phases = |columns: &[DVector<f64>]| {
            let both = columns[zero].iter().zip(columns[zero + 1].iter());
            both.map(|(sine, cosine)| sine.atan2(*cosine)).collect::<Vec<f64>>()
        };
        let here = phases(&self.columns(&data.rows)?);
        let coordinates = data.model.process.coordinates();
        let is_quantity = |i: &usize| matches!(coordinates[*i].holds, Holds::Quantity(_));
        let along = |coordinate: usize| {
            let values = data.rows.columns[coordinate].to_vec();
            let own = || values.iter().copied().filter(|v| v.is_finite());
            let range = own().fold(f64::NEG_INFINITY, f64::max) - own().fold(f64::INFINITY, f64::min);
            if range <= 0.0 || !range.is_finite() {
                return Some(0.0);
            }
            let mut rows = data.rows.clone();
            rows.columns[coordinate] = values.iter().map(|v| v + STEP * range).collect();
            let there = phases(&self.columns(&rows)?);
            let turned = here.iter().zip(there).map(|(here, there)| {
                let turned = (there - here).rem_euclid(TAU);
                turned.min(TAU - turned) / STEP
            });
            Some(turned.fold(0.0, f64::max))
        };
        let turns: Option<Vec<f64>> = data.given.iter().copied().filter(is_quantity).map(along).collect();
        turns.map(|turns| turns.into_iter().fold(0.0, f64::max))
    }
}

/// The rows as if nobody had read a clock, where times of their own, not the model's, rise or fall with a place from the
/// first row to the last: the places come but once, and say all that the times do.
fn without_times(data: &Data) -> Option<Rows> {
    let coordinates = data.model.process.coordinates();
    let time = time_of(&*data.model.process).filter(|time| data.given.contains(time))?;
    let Absent::Value(unread) = coordinates[time].absent else { return None };
    let times = &data.rows.columns[time];
    let mut order: Vec<usize> = (0..times.len()).collect();
    order.sort_by(|a, b| times[*a].total_cmp(&times[*b]));
    let goes_with = |place: usize| {
        let places = &data.rows.columns[place];
        let steps = || order.windows(2).map(|two| places[two[1]] - places[two[0]]);
        times.len() > 1 && (steps().all(|step| step > 0.0) || steps().all(|step| step < 0.0))
    };
    let is_place = |i: &usize| coordinates[*i].holds.kind() == Some(LENGTH);
    data.given.iter().copied().filter(is_place).any(goes_with).then(|| {
        let mut rows = data.rows.clone();
        rows.columns[time] = Values::shared(unread, times.len());
        rows
    })
}

#[cfg(test)]
mod tests {
    use super::candidates;
    use crate::fit::{Objective, best};
    use crate::input::Source;
    use crate::measure::Measurements;
    use crate::model::{Data, Model};

    /// One series: of a minute nothing is seen of a room that swings within half an hour or a day, of three hours it is.
    #[test]
    fn a_wave_is_sought_where_the_series_is_as_long_as_its_shortest_usual_period() {
        for (span, is_sought) in [("60", false), ("1200", false), ("10800", true)] {
            let text = format!(
                "process = \"thermal\"\nbody = {{ material = \"steel\", segments = [{{ length = \"200 mm\", diameter = \"20 mm\" }}] }}\n\
                 environment = {{ temperature = \"20 degC\" }}\n\
                 source = [{{ at = \"0 mm\", power = \"5 W\" }}]\ntime = {{ end = \"{span} s\", step = \"10 s\" }}\n\
                 measurement = {{ places = [\"100 mm\"], interval = \"10 s\" }}\n\
                 effects.convection = {{ coefficient = \"10 W/m^2/K\" }}\n"
            );
            let model = Model::parse(Source::new("model.toml", text)).unwrap();
            let span: f64 = span.parse().unwrap();
            let row = |part: f64| format!("{},100,{},0.1\n", part * span, 20.0 + part);
            let rows: String = [0.2, 0.4, 0.6, 0.8, 1.0].map(row).concat();
            let rows =
                Source::new("rows.csv", format!("time [s],x [mm],temperature [degC],u [K]\n0,100,20,0.1\n{rows}"));
            let data = Data::of(&model, Measurements::parse(rows, &*model.process).unwrap()).unwrap();
            let mut objective = Objective::new(&data).unwrap();
            let base = best(&mut objective).unwrap();
            let drift = model.process.effects().into_iter().find(|own| own.name == *"ambient-drift").unwrap();
            let found = candidates(&objective, &base, &[drift]).pop().unwrap();
            assert_eq!(!found.variants.is_empty(), is_sought, "{span} s");
        }
    }
}
