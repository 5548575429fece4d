//! Real measurements: what an engineer says of them, and no cause that they cannot tell.

use std::path::Path;

use fem::compare::compare;
use fem::compensate::compensate;
use fem::diagnose::{Cause, Diagnosis, MOST_EFFECTS, Verdict};
use fem::discover::diagnose;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use fem::progress::Progress;

fn with<T>(name: &str, tell: impl FnOnce(&Data) -> T) -> T {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/real").join(name);
    let model = Model::load(&folder.join("model.toml")).unwrap();
    let measurements = Measurements::load(&folder.join("measured.csv"), &*model.process).unwrap();
    tell(&Data::of(&model, measurements).unwrap())
}

fn diagnosed(name: &str) -> Diagnosis {
    with(name, |data| diagnose(data, MOST_EFFECTS, &Progress::default()).unwrap())
}

fn physical(diagnosis: &Diagnosis) -> Vec<&str> {
    diagnosis.missing.iter().filter(|m| m.cause == Cause::Physical).map(|m| &*m.effect.name).collect()
}

fn of_measurement(diagnosis: &Diagnosis) -> Vec<&str> {
    diagnosis.missing.iter().filter(|m| m.cause != Cause::Physical).map(|m| &*m.effect.name).collect()
}

/// The means of the runs fall from +26.6 to -17.0 um, equally at all positions: the zero or the sensor
/// drifts, not the screw. What varies between runs is no noise, and no command takes it for such.
#[test]
fn a_zero_that_wanders_from_run_to_run_is_no_noise() {
    let comparison = with("axis-muts-y", |data| compare(data).unwrap());
    assert!(!comparison.adequate());
    assert!(comparison.suspects.iter().any(|t| t.effect.name == "zero-shift"), "{:?}", comparison.suspects);
    let diagnosis = diagnosed("axis-muts-y");
    assert_eq!(physical(&diagnosis), Vec::<&str>::new());
    assert!(of_measurement(&diagnosis).contains(&"zero-shift"));
    assert_ne!(diagnosis.verdict, Verdict::Adequate);
    // The repeatability within a run is 2.8 um, not the 17.7 um of all runs together.
    assert!((1e6 * diagnosis.noise.together() - 2.8).abs() < 0.1, "{}", 1e6 * diagnosis.noise.together());
}

/// Two readings of the first run, coming back, contradict the four other runs by 114 and 48 um; the reversal
/// changes its sign along the travel, which no single play makes.
#[test]
fn readings_that_contradict_their_repeats_are_told_and_blame_nobody() {
    let diagnosis = diagnosed("axis-mcu1025");
    assert_eq!(diagnosis.outliers.iter().map(|o| o.line).collect::<Vec<_>>(), [10, 11]);
    assert_eq!(physical(&diagnosis), Vec::<&str>::new());
    // A drift that was promising before the curve stood is not worth its price beside it.
    assert_eq!(of_measurement(&diagnosis), ["outliers", "discrepancy"]);
    assert!(matches!(diagnosis.verdict, Verdict::PartlyExplained | Verdict::Unexplained));
}

/// A pitch profile of 60 um, a zero that falls by 9 um over the test, and a reversal of 25 um which differs by 5 um
/// (standard deviation) from target to target: play, over-compensated or with the sensor's sign, beside a curve.
#[test]
fn play_is_named_beside_a_profile_that_differs_by_direction() {
    let diagnosis = diagnosed("axis-b02");
    // A zero that falls is a screw that grows or an instrument that drifts.
    let falls = |m: &&fem::diagnose::Missing| {
        let class = m.indistinguishable_from.iter().map(|d| &*d.name).chain([&*m.effect.name]);
        class.collect::<Vec<_>>().contains(&"drift")
    };
    let rest: Vec<&fem::diagnose::Missing> = diagnosis.missing.iter().filter(|m| !falls(m)).collect();
    assert!(rest.len() < diagnosis.missing.len());
    let causes: Vec<&str> = rest.iter().filter(|m| m.cause == Cause::Physical).map(|m| &*m.effect.name).collect();
    assert_eq!(causes, ["backlash"]);
    let play = diagnosis.missing.iter().find(|m| m.effect.name == "backlash").unwrap();
    // Mean of the nine reversals, by hand: -25.4 um, with a standard error of 5.6/3 um.
    let gap = 1e6 * play.estimates[0].value;
    assert!((gap + 25.4).abs() < 2.0 * 5.6 / 3.0, "{gap}");
    assert!(of_measurement(&diagnosis).contains(&"discrepancy"));
    assert_eq!(diagnosis.verdict, Verdict::PartlyExplained);
}

/// Those two readings alone make R 204.8 um instead of 58.3, and would corrupt the table where they stand.
#[test]
fn a_table_is_made_without_readings_that_contradict_their_repeats() {
    let found = with("axis-mcu1025", |data| compensate(data, data.model.system.positioning().unwrap()).unwrap());
    assert_eq!(
        found.wrong_readings.iter().map(|w| (w.line, w.is_stated)).collect::<Vec<_>>(),
        [(10, false), (11, false)]
    );
    let quantities = found.evaluation.quantities();
    let r = quantities.iter().find(|q| q.symbol == "R").and_then(|q| q.value).unwrap();
    assert!((1e6 * r - 58.3).abs() < 0.05, "{r}");
}

/// The first weights straighten the wire, much at first and little later: a contact in form, far softer than contacts are,
/// which is said. A slack and a spring, or a gauge that was not at zero, leave more than twice as much. Unloading reads some
/// tens of um more than loading: the wire has settled, or one of those that do the same.
#[test]
fn a_wire_that_straightens() {
    let diagnosis = diagnosed("wire-steel");
    assert_eq!(physical(&diagnosis), ["contact-joint", "settling"]);
    let settled = diagnosis.missing.iter().find(|m| m.effect.name == "settling").unwrap();
    for other in ["dry-friction", "jump", "drift"] {
        assert!(settled.indistinguishable_from.iter().any(|d| *d.name == *other), "{other}");
    }
    let contact = diagnosis.missing.iter().find(|m| m.effect.name == "contact-joint").unwrap();
    let warns = |of: &str| contact.estimates.iter().any(|e| e.warnings.iter().any(|w| w.contains(of)));
    assert!(warns("outside what is plausible") && !warns("bound"));
}

/// One sensor sees less than a period: any bow is a piece of some wave, and whether the room swings, the body was
/// warmer than the room or the power changed is not to be seen.
#[test]
#[ignore = "a minute"]
fn a_piece_of_a_wave_is_no_wave_of_the_room() {
    let diagnosis = diagnosed("motor");
    assert_eq!(physical(&diagnosis), Vec::<&str>::new());
    assert_eq!(diagnosis.verdict, Verdict::Unexplained);
}

/// The published coefficient of the convection is 19.1 W/(m² K); the power, which the book folds into another constant,
/// follows with it.
#[test]
fn a_steady_rod_has_the_published_convection() {
    let diagnosis = diagnosed("rod-smith");
    // So few places without a noise of their own show no more than that nothing is wrong.
    assert_eq!((diagnosis.verdict, diagnosis.missing.len()), (Verdict::NotJudged, 0));
    let film = diagnosis.fit.estimates.iter().find(|e| e.parameter.path.ends_with("coefficient")).unwrap();
    assert!((film.value - 19.1).abs() < film.std, "{} +- {}", film.value, film.std);
}

/// Run-in, steady wear, and a third period in which the edge breaks down; that the diameter begins off is one constant, of
/// which a single place cannot tell the cause.
#[test]
fn a_cutter_wears_in_three_periods() {
    let diagnosis = diagnosed("wear-phm-c1");
    let [wear, offset, breakdown] = &physical(&diagnosis)[..] else { panic!("{:?}", physical(&diagnosis)) };
    assert_eq!((*wear, *breakdown), ("tool-wear", "tool-breakdown"));
    let offset = diagnosis.missing.iter().find(|m| m.effect.name == *offset).unwrap();
    let class = offset.indistinguishable_from.iter().map(|d| &*d.name).chain([&*offset.effect.name]);
    assert!(class.collect::<Vec<_>>().contains(&"setting-error"));
}

/// Zeros of the sensors, and heat that comes late: a heater that stores some, or a joint beside it, or late sensors. The
/// model does not come down to the noise, for the third pulse is weaker, and no room that swings is made up for it.
#[test]
#[ignore = "half a minute"]
fn a_bar_whose_heater_is_late() {
    let diagnosis = diagnosed("bar-albar");
    assert_eq!(diagnosis.verdict, Verdict::PartlyExplained);
    assert!(of_measurement(&diagnosis).contains(&"zero-shift"));
    assert!(!physical(&diagnosis).contains(&"ambient-drift"));
    let late = |m: &fem::diagnose::Missing| {
        m.effect.name == "heater-capacity" || m.indistinguishable_from.iter().any(|d| d.name == "heater-capacity")
    };
    assert!(diagnosis.missing.iter().any(late), "{:?}", physical(&diagnosis));
}
