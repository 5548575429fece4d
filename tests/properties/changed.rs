//! Effects that change at a border: rows up to it are those of one machine, rows beyond it those of the other.

use fem::process::{Active, CHANGED, Process, change_of, is_size};
use fem::processes::ALL;

use super::{beside, host, models};

/// The same effect at another size.
fn other(effect: &Active) -> Active {
    let mut other = effect.clone();
    let sizes = other.description.parameters.iter().zip(&mut other.values).filter(|(p, _)| is_size(p));
    sizes.for_each(|(_, value)| *value *= 0.6);
    other
}

#[test]
fn beyond_a_border_rows_are_those_of_the_changed_machine() {
    for process in ALL {
        let Some(along) = process.in_order() else { continue };
        let column = process.coordinates().iter().position(|c| c.name == along).unwrap();
        let models = models(*process);
        for effect in process.effects().iter().filter(|e| process.carried_over(&e.name).is_none()) {
            let model = host(&models, effect);
            let own = model.system.programme();
            // The same rows under two numbers, of which the border parts them.
            let mut later = own.clone();
            (0..later.len()).for_each(|row| later.columns[column].set(row, own.columns[column][row] + 1.0));
            let rows = own.and(&later);
            let border = own.columns[column].iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let observed = |effects: Vec<Active>| {
                let all = [beside(*process, effect), effects].concat();
                model.system.with_effects(&all).observe(&rows).unwrap()
            };
            let (before, behind) = (effect.typical(), other(&effect.typical()));
            let change = change_of(effect, along, |_| true);
            assert_eq!(*change.name, format!("{}.{CHANGED}", effect.name));
            let values = [&[border], &behind.values[..]].concat();
            let changed = observed(vec![before.clone(), change.with(values)]);
            let [before, behind] = [before, behind].map(|one| observed(vec![one]));
            let is_beyond = |row: usize| rows.columns[column][row] > border;
            for row in 0..rows.len() {
                let expected = if is_beyond(row) { behind[row] } else { before[row] };
                let most = 1e-9 * expected.abs().max(1e-6);
                assert!((changed[row] - expected).abs() <= most, "{}: {} and {expected}", effect.name, changed[row]);
            }
            assert!((0..rows.len()).any(|row| (before[row] - behind[row]).abs() > 1e-9), "{}", effect.name);
        }
    }
}

/// Effects of each process that are not to change: a reason under a name that is in no catalogue would refuse nothing.
#[test]
fn what_carries_something_over_does_not_change() {
    let refused = |process: &&dyn Process| {
        process.in_order()?;
        let names = process.effects().into_iter().filter(|e| process.carried_over(&e.name).is_some());
        Some((process.name(), names.count()))
    };
    let all: Vec<(&str, usize)> = ALL.iter().filter_map(refused).collect();
    assert_eq!(all, [("turning", 7), ("ring", 0), ("fixture", 1), ("axis", 1), ("rotary", 1)]);
}
