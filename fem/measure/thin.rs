//! A choice of rows that stands for all of them.

use super::{Measurements, Repeats};

/// Fewest groups of repeats in a stratum: where they would be fewer, a coordinate does not part the rows.
const LEAST: usize = 8;

impl Measurements {
    /// Whether each row belongs to a choice of about one in `every`: whole groups of repeats, taken evenly from
    /// every level of every coordinate that has few, so that no sensor, target or direction is left out. The
    /// choice begins elsewhere in each level, so that coordinates of many levels, such as a time, keep theirs
    /// too.
    #[doc(hidden)]
    pub fn one_in(&self, every: usize, repeats: &Repeats) -> Vec<bool> {
        let stratum = self.strata(repeats);
        let mut next: Vec<usize> = (0..).take(stratum.iter().max().map_or(0, |m| m + 1)).collect();
        let mut of_group: Vec<Option<bool>> = vec![None; repeats.groups];
        let mut keeps = |row: usize, group: usize| {
            *of_group[group].get_or_insert_with(|| {
                let place = &mut next[stratum[row]];
                *place += 1;
                (*place - 1).is_multiple_of(every)
            })
        };
        repeats.group.iter().enumerate().map(|(row, group)| keeps(row, group)).collect()
    }

    /// Stratum of each row: its levels by as many coordinates together, those of fewest levels first, as leave
    /// enough groups in each.
    fn strata(&self, repeats: &Repeats) -> Vec<usize> {
        let count = |levels: &[usize]| levels.iter().max().map_or(0, |m| m + 1);
        let mut own: Vec<(usize, usize)> = self.given.iter().map(|i| (count(&self.levels(&[*i])), *i)).collect();
        own.sort_unstable();
        let mut chosen = Vec::new();
        let mut stratum = self.rows.observable.to_vec();
        for (_, coordinate) in own {
            let by: Vec<usize> = chosen.iter().copied().chain([coordinate]).collect();
            let levels = self.levels_of_observables(&by);
            if count(&levels) * LEAST <= repeats.groups {
                (chosen, stratum) = (by, levels);
            }
        }
        stratum
    }
}

#[cfg(test)]
mod tests {
    use crate::measure::{Measurements, repeats};
    use crate::process::{Process, Rows};

    /// Six sensors read in turn, 3000 times.
    fn sensors() -> (&'static dyn Process, Measurements) {
        let process =
            *crate::processes::ALL.iter().find(|p| p.observables().iter().any(|o| o.name == "temperature")).unwrap();
        let mut columns = vec![Vec::new(); process.coordinates().len()];
        for row in 0..18_000 {
            for (coordinate, column) in process.coordinates().iter().zip(&mut columns) {
                column.push(match &*coordinate.name {
                    "x" => 0.1 * (row % 6) as f64,
                    "time" => (row / 6) as f64,
                    _ => f64::NAN,
                });
            }
        }
        let observable = process.observables().iter().position(|o| o.name == "temperature").unwrap();
        (process, Measurements::planned(process, "sensors", Rows::new(columns, vec![observable; 18_000])))
    }

    #[test]
    fn every_sensor_stays_from_the_first_reading_to_the_last() {
        let (process, all) = sensors();
        let keep = all.one_in(18, &repeats(&all, process.coordinates()));
        let some = all.some(|row| keep[row]);
        let column = |name: &str| process.coordinates().iter().position(|c| c.name == name).unwrap();
        let (x, time) = (&some.rows.columns[column("x")], &some.rows.columns[column("time")]);
        for sensor in 0..6 {
            let own: Vec<f64> =
                x.iter().zip(time.iter()).filter(|(x, _)| **x == 0.1 * f64::from(sensor)).map(|p| *p.1).collect();
            assert!(own.len().abs_diff(3000 / 18) <= 1, "sensor {sensor}: {} readings", own.len());
            assert!(own[0] < 18.0 && own[own.len() - 1] >= 3000.0 - 18.0, "sensor {sensor}");
        }
        let mut times = time.to_vec();
        times.dedup();
        assert_eq!(times.len(), some.len(), "readings at times of their own");
    }
}
