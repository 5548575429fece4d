//! `diagnose` on practice cases that another program made; `truth.json` says what is hidden in each.

use fem::diagnose::{Diagnosis, MOST_EFFECTS, Verdict, diagnose};
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use fem::progress::Progress;

use super::{case, truths};

fn of(model: &Model, measurements: Measurements) -> Diagnosis {
    diagnose(&Data::of(model, measurements).unwrap(), MOST_EFFECTS, &Progress::default()).unwrap()
}

#[test]
fn what_is_hidden_is_named_or_stands_in_the_class_of_what_is() {
    let mut to_the_noise = 0;
    for (name, truth) in truths() {
        let (model, measurements) = case(&name);
        let diagnosis = of(&model, measurements);
        let classes: Vec<Vec<&str>> = diagnosis
            .missing
            .iter()
            .map(|m| std::iter::once(&m.effect).chain(&m.indistinguishable_from).map(|e| e.name).collect())
            .collect();
        let hidden: Vec<&String> = truth["hidden"].as_object().unwrap().keys().collect();
        assert_eq!(classes.len(), hidden.len(), "{name}: {classes:?} for {hidden:?}");
        for effect in hidden {
            assert!(classes.iter().any(|c| c.contains(&effect.as_str())), "{name}: {effect} is not in {classes:?}");
        }
        to_the_noise += usize::from(diagnosis.verdict == Verdict::MissingEffect);
    }
    // Each is called explained to the noise in 99 of 100 draws of the noise; of thirty, three would be
    // missed in one set of three hundred.
    let all = truths().len();
    assert!(to_the_noise + 1 + all / 25 >= all, "{to_the_noise} of {all}");
}

/// Diameters of the story's first part, so many rows of them.
fn rows(text: &str) -> (Model, Measurements) {
    let model = include_str!("../../models/story/rigid.toml");
    let model = Model::parse(Source::new("rigid.toml", model.to_string())).unwrap();
    let measurements = Measurements::parse(Source::new("rows.csv", text.to_string()), model.process).unwrap();
    (model, measurements)
}

#[test]
fn data_that_cannot_tell_are_told_so() {
    // One row at one place: nothing is named, for any effect would fit.
    let (model, one) = rows("x [mm],diameter_error [um],u [um]\n20,29.7,1\n");
    let diagnosis = of(&model, one);
    assert_eq!((diagnosis.verdict, diagnosis.missing.len()), (Verdict::Unexplained, 0));
    assert_eq!(diagnosis.cautions.len(), 2, "{:?}", diagnosis.cautions);
    // Eight rows at one place: something shifts the diameter, and most effects could.
    let (model, same) = rows(&format!("x [mm],diameter_error [um],u [um]\n{}", "20,29.7,1\n".repeat(8)));
    let diagnosis = of(&model, same);
    assert_eq!(diagnosis.cautions.len(), 1);
    assert!(diagnosis.missing[0].indistinguishable_from.len() >= 8);
}

#[test]
fn exact_data_without_a_noise_are_no_error() {
    let (model, _) = rows("x [mm],diameter_error [um]\n20,0\n");
    let rows_of = |errors: &[f64]| {
        let line = |(i, e): (usize, &f64)| format!("{},{}\n", 20 + 40 * i, 1e6 * e);
        format!("x [mm],diameter_error [um]\n{}", errors.iter().enumerate().map(line).collect::<String>())
    };
    let (_, blank) = rows(&rows_of(&[0.0; 12]));
    let exact = model.forward().observe(&blank.rows).unwrap();
    let (model, measured) = rows(&rows_of(&exact));
    let diagnosis = of(&model, measured);
    assert_eq!((diagnosis.verdict, diagnosis.missing.len()), (Verdict::Adequate, 0));
}
