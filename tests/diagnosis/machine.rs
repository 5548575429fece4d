//! Two tests of one lathe: whether shafts that leave a class of causes and a tailstock under load name one cause
//! together, and whether nothing is shared that is not there.

use std::path::Path;

use fem::diagnose::{Diagnosis, MOST_EFFECTS};
use fem::discover::diagnose;
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use fem::progress::Progress;
use generator::machine::{LATHE, Tailstock, Tests, drawn};
use generator::random::{Random, figures};

/// What is hidden in a tailstock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Hidden {
    /// Nothing: the models know its spring.
    Nothing,
    /// A contact; the models know the spring.
    Contact,
    /// A spring.
    Spring,
    /// A spring and a contact.
    Both,
}

impl Hidden {
    const ALL: [Self; 4] = [Self::Nothing, Self::Contact, Self::Spring, Self::Both];

    /// The effects that a diagnosis should name, sorted.
    fn names(self) -> Vec<&'static str> {
        match self {
            Self::Nothing => Vec::new(),
            Self::Contact => vec!["tailstock-contact"],
            Self::Spring => vec!["tailstock-compliance"],
            Self::Both => vec!["tailstock-compliance", "tailstock-contact"],
        }
    }

    /// A tailstock that hides it.
    fn tailstock(self, seed: u64) -> Tailstock {
        let mut random = Random::new("a tailstock", seed);
        let stiffness = figures(random.uniform(30.0, 120.0), 3);
        let contact = (figures(random.log_uniform(0.15, 0.6), 3), figures(random.uniform(0.4, 0.7), 2));
        let has_contact = [Self::Contact, Self::Both].contains(&self);
        let is_known = [Self::Nothing, Self::Contact].contains(&self);
        Tailstock { stiffness, contact: has_contact.then_some(contact), is_known }
    }
}

/// What a diagnosis said: the effects that it names, sorted, and how many others stand beside them.
struct Said {
    named: Vec<String>,
    beside: usize,
    /// Whether every hidden effect is named or stands in a class.
    has_truth: bool,
}

impl Said {
    fn of(diagnosis: &Diagnosis, truth: &[&str]) -> Self {
        let mut named: Vec<String> = diagnosis.missing.iter().map(|m| m.effect.name.to_string()).collect();
        named.sort();
        let others = || diagnosis.missing.iter().flat_map(|m| m.indistinguishable_from.iter().map(|d| d.name.clone()));
        let has_truth = truth.iter().all(|t| named.iter().any(|n| n == t) || others().any(|n| n == *t));
        // Members of a group stand for each other.
        let grouped = diagnosis.posterior.groups.iter().flat_map(|group| &group.effects);
        let beside = others().count() + grouped.filter(|name| !named.contains(&name.to_string())).count();
        Self { beside, named, has_truth }
    }

    fn is_exactly(&self, truth: &[&str]) -> bool {
        self.named == truth && self.beside == 0
    }
}

/// The diagnoses of the shafts alone, and of both tests.
fn diagnoses(tests: &Tests, truth: &[&str]) -> (Said, Said) {
    let place = tempfile::tempdir().unwrap();
    std::fs::write(place.path().join("lathe.toml"), LATHE).unwrap();
    let model = |name: &str, text: &str| {
        let path = place.path().join(Path::new(name));
        Model::parse(Source::new(path.display().to_string(), text.to_string())).unwrap_or_else(|e| panic!("{e}"))
    };
    let read = |name: &str, text: &str, model: &Model| {
        Measurements::parse(Source::new(name, text.to_string()), &*model.process).unwrap()
    };
    let (shafts, tailstock) = (model("shafts.toml", &tests.shafts), model("tailstock.toml", &tests.tailstock));
    let measured = vec![read("shafts.csv", &tests.turned, &shafts), read("tailstock.csv", &tests.loaded, &tailstock)];
    let said = |data: &Data| Said::of(&diagnose(data, MOST_EFFECTS, &Progress::default()).unwrap(), truth);
    let alone = said(&Data::of(&shafts, measured[0].clone()).unwrap());
    let both = Model::of_tests(vec![shafts, tailstock]).unwrap();
    (alone, said(&Data::of_tests(&both, measured).unwrap()))
}

/// How often something was so, of how many.
#[derive(Default)]
struct Counts {
    cases: usize,
    alone_exact: usize,
    alone_class: usize,
    exact: usize,
    has_truth: usize,
    /// Named though it is not hidden.
    false_names: usize,
}

fn count(hidden: Hidden, seeds: impl Iterator<Item = u64>) -> Counts {
    let mut counts = Counts::default();
    let truth = hidden.names();
    for seed in seeds {
        let (alone, both) = diagnoses(&drawn(hidden.tailstock(seed), seed), &truth);
        counts.cases += 1;
        counts.alone_exact += usize::from(alone.is_exactly(&truth));
        counts.alone_class += usize::from(alone.beside > 0);
        counts.exact += usize::from(both.is_exactly(&truth));
        counts.has_truth += usize::from(both.has_truth);
        counts.false_names += usize::from(both.named.iter().any(|name| !truth.contains(&&**name)));
        if !both.is_exactly(&truth) {
            println!("{hidden:?} {seed}: {:?} and {} beside", both.named, both.beside);
        }
    }
    counts
}

/// A contact is named alone by both tests, which the shafts name or leave in a class; nothing is shared that is not there.
#[test]
fn two_tests_name_what_one_leaves_in_a_class() {
    let contact = count(Hidden::Contact, 1..=4);
    let alone = contact.alone_exact + contact.alone_class;
    assert!(alone >= 3 && contact.exact >= 3, "{alone} {}", contact.exact);
    let nothing = count(Hidden::Nothing, 1..=4);
    assert!(nothing.exact >= 3, "{}", nothing.exact);
}

#[test]
#[ignore = "minutes long; prints the table of README.md"]
fn the_whole_of_two_tests() {
    println!(
        "{:<8} {:>6} {:>11} {:>11} {:>11} {:>9} {:>7}",
        "hidden", "cases", "alone: one", "alone: class", "both: one", "told", "false"
    );
    for hidden in Hidden::ALL {
        let c = count(hidden, 1..=50);
        println!(
            "{:<8} {:>6} {:>11} {:>11} {:>11} {:>9} {:>7}",
            format!("{hidden:?}"),
            c.cases,
            c.alone_exact,
            c.alone_class,
            c.exact,
            c.has_truth,
            c.false_names
        );
    }
}
