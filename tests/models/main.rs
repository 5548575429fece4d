//! Every model that comes with the program runs and gives the number that its header states.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::path::Path;

use fem::model::Model;
use fem::progress::Progress;

/// `# Largest diameter error: +173.587 um`, in the first lines of the file.
fn stated(text: &str) -> Option<(String, f64)> {
    let line = text.lines().take(5).find_map(|l| l.strip_prefix("# Largest "))?;
    let (what, value) = line.split_once(": ")?;
    Some((what.to_string(), value.split(' ').next()?.parse().ok()?))
}

#[test]
fn every_model_gives_the_number_of_its_header() {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("models");
    let mut models = 0;
    for entry in std::fs::read_dir(directory).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|e| e != "toml") {
            continue;
        }
        let stem = path.file_stem().unwrap().to_str().unwrap();
        if stem.starts_with("budget") || stem.starts_with("study") {
            continue;
        }
        let model = Model::load(&path).unwrap_or_else(|e| panic!("{e}"));
        let (what, value) = stated(&model.source.text).unwrap_or_else(|| panic!("{} states no number", path.display()));
        let run = model.run(&Progress::default()).unwrap();
        let largest = run.report.figures.iter().find(|f| f.key == "largest").unwrap();
        let computed = largest.value_at("value").unwrap();
        assert!((computed - value).abs() < 6e-4, "{}: {what} is {computed}, stated {value}", path.display());
        models += 1;
    }
    assert!(models >= 3);
}

/// `# Total by the handbook: 30.761 um`, and a Monte Carlo that is the same on every machine.
#[test]
fn every_budget_gives_the_number_of_its_header() {
    for name in ["budget.toml", "budget-lathe.toml", "budget-part.toml"] {
        let budget =
            fem::budget::Budget::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(name)).unwrap();
        let line = budget.file.text.lines().take(5).find_map(|l| l.strip_prefix("# Total by the handbook: ")).unwrap();
        let stated: f64 = line.split(' ').next().unwrap().parse().unwrap();
        let estimate = budget.estimate(&Progress::default()).unwrap().unwrap();
        assert!((1e6 * estimate.handbook.total - stated).abs() < 6e-4, "{name}: {}", estimate.handbook.total);
    }
}

#[test]
fn every_study_gives_the_number_of_its_header() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/study-lathe.toml");
    let plan = fem::study::StudyPlan::load(&path).unwrap();
    let line = plan.file.text.lines().take(5).find_map(|l| l.strip_prefix("# Yield: ")).unwrap();
    let stated: f64 = line.trim_end_matches(" %").parse().unwrap();
    let layout = plan.layout();
    let mut summing = fem::study::Summing::new(&layout);
    let add = |row| {
        summing.add(&row);
        Ok::<(), ()>(())
    };
    fem::study::in_order(0..layout.jobs, &Progress::default(), |job| plan.job(job), add).unwrap();
    let fem::study::Found::Numbers(numbers) = &summing.finish().results[0] else { panic!("no numbers") };
    let share = 100.0 * numbers.acceptance.unwrap().share();
    assert!((share - stated).abs() < 0.0006, "{share} for {stated}");
}

#[test]
fn tests_of_a_machine_are_the_same_whenever_they_are_read() {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/tailstock");
    let read = || {
        let each = ["shafts.toml", "tailstock.toml"].map(|name| Model::load(&directory.join(name)).unwrap());
        Model::of_tests(each.into()).unwrap()
    };
    let (one, other) = (read(), read());
    assert_eq!(one.process.observables(), other.process.observables());
    assert_eq!(one.process.coordinates(), other.process.coordinates());
    assert_eq!(one.process.effects(), other.process.effects());
    assert_eq!(one.parameters, other.parameters);
    let observables: Vec<&str> = one.process.observables().iter().map(|o| &*o.name).collect();
    assert!(observables.contains(&"displacement of tailstock"), "{observables:?}");
    // The process outlives the model that it was made with as long as somebody holds it.
    let process = one.process.clone();
    drop(one);
    assert_eq!(process.effects(), other.process.effects());
}

/// What two tests draw of their machine under one name is one quantity, and what one of them writes otherwise is told.
#[test]
fn tests_share_what_they_draw() {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/slant-bed");
    let at = |name: &str| directory.join(name).display().to_string();
    let own = |name: &str, more: &str| {
        let text = std::fs::read_to_string(directory.join(name)).unwrap();
        Model::parse(fem::Source::new(at(name), format!("{text}{more}")))
    };
    let together = |of_shaft: &str, of_pushed: &str| {
        let models = [own("shaft.toml", of_shaft).unwrap(), own("pushed.toml", of_pushed).unwrap()];
        Model::of_tests(models.into())
    };
    let joint = |value: &str| format!("\n[structure.tailstock-tilt]\nstiffness = \"{value}\"\n");
    let paths = |model: &Model| -> Vec<String> { model.parameters.iter().map(|p| p.path.to_string()).collect() };
    let rough = joint("1500 +- 400 kN*m/rad");
    let shared = together(&rough, &rough).unwrap();
    let tilt = "structure.tailstock-tilt.stiffness".to_string();
    assert_eq!(paths(&shared).iter().filter(|path| path.ends_with(&tilt)).collect::<Vec<_>>(), [&tilt]);
    // Who knows it exactly counts before who does not.
    assert!(!paths(&together(&rough, "").unwrap()).contains(&tilt));
    let error = together(&rough, &joint("1200 +- 400 kN*m/rad")).err().unwrap();
    assert!(error.message.contains(&tilt) && error.message.contains("1200"), "{}", error.message);
}
