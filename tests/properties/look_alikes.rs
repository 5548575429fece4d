//! Look-alikes are said on both sides.

use fem::processes::ALL;

/// Whoever comes upon either of two effects that look alike learns of the other, and what separates them.
#[test]
fn every_look_alike_knows_its_counterpart() {
    let mut count = 0;
    for process in ALL {
        let effects = process.effects();
        for effect in &effects {
            for (name, separates) in effect.look_alikes {
                let other = effects.iter().find(|e| e.name == *name);
                let other = other.unwrap_or_else(|| panic!("{} looks like {name}, which is not known", effect.name));
                let knows = other.look_alikes.iter().any(|(back, _)| *back == effect.name);
                assert!(knows && !separates.is_empty(), "{name} does not know that {} looks like it", effect.name);
                count += 1;
            }
        }
    }
    assert!(count > 100, "{count}");
}
