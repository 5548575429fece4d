//! Bad input: each exits with 2, points at its place and says what to do; nothing is written.

use super::fem::{Place, model};

/// A model in which everything is right.
const GOOD: &str = r#"process = "turning"
[workpiece]
material = "steel"
segments = [
  { length = "300 mm", diameter = "40 mm" },
  { length = "200 mm", diameter = "50 mm", bore = "20 mm" },
]
[workholding]
type = "centres"
steady_rests = [{ at = "250 mm", stiffness = "40 N/um" }]
[cut]
depth = "0.5 mm"
feed = "0.2 mm/rev"
spindle_speed = "600 rpm"
radial_force = "450 N"
[sweep]
positions = 11
[batch]
parts = 2
cycle_time = "5 min"
[mesh]
element_size = "5 mm"
[effects.tailstock-contact]
c = "0.2 um/N^n"
n = 0.5
"#;

/// (in the good model, replaced by, line of the error, part of the message, part of the remedy)
const CASES: &[(&str, &str, usize, &str, &str)] = &[
    ("depth =", "dept =", 12, "`dept` is no key of `cut`", "did you mean `depth`?"),
    ("[sweep]", "[sweeep]", 16, "`sweeep` is no key of this file", "did you mean `sweep`?"),
    ("length = \"300 mm\"", "length = \"300 kg\"", 5, "not a length", "write it in mm"),
    ("length = \"300 mm\"", "length = \"300 mmm\"", 5, "`mmm` is no unit", "did you mean `mm`?"),
    ("length = \"300 mm\"", "length = \"300\"", 5, "the unit is missing", "write it in mm"),
    ("length = \"300 mm\"", "length = 300", 5, "has no unit", "write length = \"40 mm\""),
    ("length = \"300 mm\"", "length = \"-300 mm\"", 5, "`length` is -300 mm", "above zero"),
    ("length = \"300 mm\"", "length = \"3OO mm\"", 5, "no unit", "SI prefixes"),
    ("length = \"300 mm\"", "length = \"0,3 m\"", 5, "the decimal mark is a comma", "decimal point"),
    ("length = \"300 mm\"", "length = \"NaN mm\"", 5, "does not begin with a number", "40 mm"),
    ("length = \"300 mm\"", "length = \"inf mm\"", 5, "does not begin with a number", "40 mm"),
    ("length = \"300 mm\"", "length = \"1e400 mm\"", 5, "too large", "beyond 1e40"),
    ("length = \"300 mm\"", "length = \"300 +- -2 mm\"", 5, "standard uncertainty", "above zero"),
    ("diameter = \"40 mm\"", "diameter = \"0 mm\"", 5, "`diameter` is 0 mm", "above zero"),
    ("diameter = \"40 mm\"", "", 5, "`diameter` is missing in `workpiece.segments[0]`", "add diameter"),
    ("bore = \"20 mm\"", "bore = \"50 mm\"", 6, "the bore is as wide as the segment", "below the diameter"),
    ("stiffness = \"40 N/um\"", "stiffness = \"-40 N/um\"", 10, "`stiffness` is -40 N/um", "above zero"),
    ("at = \"250 mm\"", "at = \"700 mm\"", 10, "stands beyond the shaft", "500 mm long"),
    ("feed = \"0.2 mm/rev\"", "feed = \"0.2 mm\"", 13, "not a feed per revolution", "mm/rev"),
    ("spindle_speed = \"600 rpm\"", "spindle_speed = \"600 Hz\"", 14, "not a spindle speed", "rpm"),
    ("spindle_speed = \"600 rpm\"", "", 11, "`spindle_speed` is missing in `cut`", "add spindle_speed"),
    ("radial_force = \"450 N\"", "", 11, "the force of the cut is missing", "radial_force"),
    (
        "radial_force = \"450 N\"",
        "radial_force = \"450 N\"\nforce = { C = 1250.0, x = 0.9, y = 0.75 }",
        16,
        "the force is given twice",
        "either",
    ),
    ("radial_force = \"450 N\"", "force = { C = 1250.0, x = 1.9, y = 0.75 }", 15, "`x` is 1.9", "at most 1"),
    ("radial_force = \"450 N\"", "force = { C = 9.0, x = 0.9, y = 0.7, n = 0.5 }", 15, "`HB` is missing", "add HB"),
    (
        "depth = \"0.5 mm\"",
        "depth = \"0.5 mm\"\nfrom = \"600 mm\"",
        13,
        "the tool would stand outside the shaft",
        "from 0 mm to 500 mm",
    ),
    ("depth = \"0.5 mm\"", "depth = \"0.5 mm\"\nfrom = \"100 mm\"\nto = \"100 mm\"", 14, "the pass is empty", "differ"),
    ("positions = 11", "positions = 1", 17, "`positions` is 1", "whole number from 2"),
    ("positions = 11", "positions = 1.5", 17, "`positions` is 1.5", "whole number"),
    ("positions = 11", "positions = \"11\"", 17, "`positions` is \"11\"", "whole number"),
    ("positions = 11", "positions = 1000000", 18, "", ""),
    ("parts = 2", "parts = 0", 19, "`parts` is 0", "whole number from 1"),
    ("parts = 2", "parts = -2", 19, "`parts` is -2", "whole number from 1"),
    ("cycle_time = \"5 min\"", "cycle_time = \"10 s\"", 20, "shorter than the cut", "lengthen the cycle"),
    (
        "cycle_time = \"5 min\"",
        "cycle_time = \"5 min\"\npauses = [{ after = 9, duration = \"3 min\" }]",
        21,
        "`after` is 9",
        "from 1 to 2",
    ),
    (
        "cycle_time = \"5 min\"",
        "cycle_time = \"5 min\"\ncorrections = [{ after = 3, diameter = \"-10 um\" }]",
        21,
        "`after` is 3",
        "from 1 to 2",
    ),
    (
        "cycle_time = \"5 min\"",
        "cycle_time = \"5 min\"\ncorrections = [{ after = -1, diameter = \"-10 um\" }]",
        21,
        "`after` is -1",
        "whole number from 1",
    ),
    (
        "cycle_time = \"5 min\"",
        "cycle_time = \"5 min\"\ncorrections = [{ after = 1 }]",
        21,
        "`diameter` is missing in `batch.corrections[0]`",
        "add diameter",
    ),
    (
        "cycle_time = \"5 min\"",
        "cycle_time = \"5 min\"\ninserts = [{ after = 1 }, { after = 1, diameter = \"2 um\" }]",
        21,
        "two of `inserts` stand after part 1",
        "keep one of them",
    ),
    ("element_size = \"5 mm\"", "element_size = \"1 nm\"", 22, "elements", "a few millimetres"),
    (
        "element_size = \"5 mm\"",
        "beam = \"bernoulli\"",
        22,
        "`beam` is \"bernoulli\"",
        "did you mean \"euler-bernoulli\"?",
    ),
    ("material = \"steel\"", "material = \"stel\"", 3, "`stel` is no material", "did you mean \"steel\"?"),
    (
        "material = \"steel\"",
        "material = { youngs_modulus = \"210 GPa\" }",
        3,
        "`poisson_ratio` is missing",
        "add poisson_ratio",
    ),
    (
        "material = \"steel\"",
        "material = { base = \"steel\", youngs_modulus = \"210 Pa\" }",
        3,
        "`youngs_modulus` is 0.00000021 GPa",
        "above 0.001 GPa",
    ),
    (
        "material = \"steel\"",
        "material = { base = \"steel\", poisson_ratio = 0.7 }",
        3,
        "`poisson_ratio` is 0.7",
        "at most 0.5",
    ),
    ("material = \"steel\"", "material = 7", 3, "`material` is no table", "a name or a table"),
    ("type = \"centres\"", "type = \"centers\"", 9, "`type` is \"centers\"", "did you mean \"centres\"?"),
    ("type = \"centres\"", "type = \"chuck\"", 23, "needs a tailstock", "remove the effect"),
    ("[workholding]\ntype = \"centres\"", "[workholding]", 8, "`type` is missing in `workholding`", "add type"),
    (
        "[effects.tailstock-contact]",
        "[effects.tailstock-contct]",
        23,
        "no effect known here",
        "did you mean `tailstock-contact`?",
    ),
    (
        "[effects.tailstock-contact]",
        "[effects.chuck-tilt]\nstiffness = \"9 kN*m/rad\"\n[effects.tailstock-contact]",
        23,
        "needs a chuck",
        "remove the effect",
    ),
    ("c = \"0.2 um/N^n\"", "c = \"0.2 um/N\"", 24, "not a contact coefficient", "um/N^n"),
    ("c = \"0.2 um/N^n\"", "c = \"0.2 um/kN^n\"", 24, "prefixed unit to the power n", "force of a contact law in N"),
    ("n = 0.5", "n = 1.5", 25, "`n` is 1.5", "above 0 and at most 1"),
    ("n = 0.5", "n = 0", 25, "`n` is 0", "above 0 and at most 1"),
    ("n = 0.5", "n = nan", 25, "not a finite number", "n = 0.5"),
    ("n = 0.5", "n = inf", 25, "not a finite number", "n = 0.5"),
    ("n = 0.5", "n = \"0.5 mm\"", 25, "not a pure number", "the number alone"),
    ("n = 0.5", "n = \"?\"", 25, "`effects.tailstock-contact.n` is unknown", "fem fit"),
    ("n = 0.5", "n = [1]", 25, "`n` is no pure number", "n = 0.5"),
    ("n = 0.5", "", 23, "`n` is missing in `effects.tailstock-contact`", "add n"),
    ("[sweep]", "[cut]", 16, "duplicate key", "TOML"),
    ("process = \"turning\"", "process = \"turnig\"", 1, "no process known", "did you mean \"turning\"?"),
    ("process = \"turning\"", "", 1, "does not say which process", "add process"),
    ("process = \"turning\"", "process = \"turning", 1, "", "TOML"),
    ("[workpiece]", "workpiece = 3\n[x]", 2, "`workpiece` is no table", "it must be a table"),
];

#[test]
fn each_case_is_refused_at_its_line_with_a_remedy() {
    let place = Place::new();
    let mut failures = Vec::new();
    for (given, wrong, line, message, remedy) in CASES {
        assert!(GOOD.contains(given), "{given}");
        if message.is_empty() && remedy.is_empty() {
            continue;
        }
        place.write("model.toml", GOOD.replacen(given, wrong, 1));
        let answer = place.fem(&["run", "model.toml"]);
        // The page breaks long lines; what is expected may stand across a break.
        let page = answer.err.split_whitespace().collect::<Vec<_>>().join(" ");
        let squeeze = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let right = answer.status == 2
            && answer.out.is_empty()
            && page.contains(&format!("model.toml:{line}:"))
            && page.contains(&squeeze(message))
            && page.contains(&squeeze(remedy));
        if !right {
            failures.push(format!("{wrong}: line {line}, {message}, {remedy}\nexit {}\n{}", answer.status, answer.err));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert_eq!(place.files(), ["model.toml"], "a refused model leaves nothing behind");
}

#[test]
fn a_misspelt_key_is_told_of_once() {
    let place = Place::new();
    place.write("model.toml", GOOD.replace("spindle_speed", "spindel_speed"));
    let answer = place.fem(&["run", "model.toml"]);
    assert!(answer.err.contains("did you mean `spindle_speed`?"), "{}", answer.err);
    assert!(!answer.err.contains("missing"), "{}", answer.err);
}

#[test]
fn the_model_of_the_cases_is_right() {
    let place = Place::new();
    place.write("model.toml", GOOD);
    let answer = place.fem(&["run", "model.toml"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
}

#[test]
fn several_problems_are_told_at_once() {
    let place = Place::new();
    let wrong = GOOD.replace("300 mm", "300").replace("\"0.2 mm/rev\"", "0.2").replace("n = 0.5", "n = 2");
    place.write("model.toml", wrong);
    insta::assert_snapshot!(place.fem(&["run", "model.toml"]).err);
}

#[test]
fn files_that_are_no_models() {
    let place = Place::new();
    place.write("latin.toml", b"process = \"turning\"\n# \xfcber\n");
    place.write("empty.toml", "");
    place.write("large.toml", vec![b'#'; 5_000_000]);
    std::fs::create_dir(place.path("directory.toml")).unwrap();
    for (name, message) in [
        ("latin.toml", "line 2 holds a byte that is not"),
        ("empty.toml", "does not say which process"),
        ("large.toml", "at most 4 MB are read"),
        ("directory.toml", "this is a directory"),
        ("missing.toml", "cannot be read"),
    ] {
        let answer = place.fem(&["run", name]);
        assert_eq!(answer.status, 2, "{name}");
        assert!(answer.err.contains(message), "{name}: {}", answer.err);
    }
}

#[test]
fn too_many_points_are_refused_before_memory_is_taken() {
    let place = Place::new();
    place.write(
        "model.toml",
        GOOD.replace("positions = 11", "positions = 1000000").replace("parts = 2", "parts = 1000"),
    );
    let answer = place.fem(&["run", "model.toml"]);
    assert_eq!(answer.status, 2);
    assert!(answer.err.contains("more than 500000 points"), "{}", answer.err);
}

#[test]
fn a_shaft_that_is_too_soft_to_be_computed_is_a_failure_and_no_number() {
    let place = Place::new();
    let soft = GOOD.replace("\"40 mm\"", "\"1e-90 mm\"").replace("\"250 mm\"", "\"100 mm\"");
    place.write("model.toml", soft);
    let answer = place.fem(&["run", "model.toml"]);
    assert_eq!(answer.status, 1, "{}", answer.err);
    assert!(answer.err.contains("loose"), "{}", answer.err);
    assert_eq!(place.files(), ["model.toml"]);
}

#[test]
fn unknown_names_on_the_command_line() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    for (args, message) in [
        (vec!["effects", "tool-ware"], "did you mean `tool-wear`?"),
        (vec!["new", "turing"], "did you mean `turning`?"),
        (vec!["add", "lathe.toml", "tool-wear", "-o", "new.toml"], "has the effect `tool-wear` already"),
        (vec!["add", "lathe.toml", "chuck-tilt", "-o", "new.toml"], "needs a chuck"),
        (vec!["add", "lathe.toml", "guideway-taper", "slop=3 um/m", "-o", "new.toml"], "did you mean `slope`?"),
        (vec!["add", "lathe.toml", "guideway-taper", "slope=3 um", "-o", "new.toml"], "not a slope"),
        (vec!["add", "lathe.toml", "guideway-taper", "slope", "-o", "new.toml"], "KEY=VALUE"),
        (vec!["add", "lathe.toml", "guideway-taper", "slope=3 um/m", "-o", "lathe.toml"], "is itself what is read"),
        (vec!["add", "lathe.toml", "guideway-taper", "slope=3 um/m", "-o", "./lathe.toml"], "is itself what is read"),
        (vec!["nonsense"], "nonsense"),
    ] {
        let answer = place.fem(&args);
        assert_eq!(answer.status, 2, "{args:?}: {}", answer.err);
        assert!(answer.err.contains(message), "{args:?}: {}", answer.err);
    }
    assert_eq!(place.files(), ["lathe.toml"]);
    assert_eq!(place.read("lathe.toml"), model("lathe.toml"));
}

#[test]
fn a_prediction_that_no_diameter_can_have_is_a_failure() {
    let place = Place::new();
    for effect in ["[effects.setting-error]\noffset = \"1e40 um\"", "[effects.guideway-height]\nslope = \"1e30 mm/m\""]
    {
        place.write("model.toml", format!("{GOOD}{effect}\n"));
        let answer = place.fem(&["run", "model.toml"]);
        assert_eq!(answer.status, 1, "{}", answer.out);
        assert!(answer.err.contains("far too large"), "{}", answer.err);
    }
    assert_eq!(place.files(), ["model.toml"]);
}

#[test]
fn a_run_is_not_written_over_the_model_that_it_reads() {
    let place = Place::new();
    std::fs::create_dir_all(place.path("there")).unwrap();
    place.write("there/summary.json", model("story/rigid.toml"));
    let answer = place.fem(&["run", "there/summary.json", "-o", "there"]);
    assert!(answer.status == 2 && answer.err.contains("is itself what is read"), "{}", answer.err);
    assert_eq!(place.read("there/summary.json"), model("story/rigid.toml"));
    assert!(!place.path("there/profile.csv").exists(), "nothing is half written");
}

#[test]
fn a_plan_needs_to_know_where_it_looks() {
    let place = Place::new();
    place.write("free.toml", model("story/rigid.toml").replace("length = \"500 mm\"", "length = \"? mm\""));
    let answer = place.fem(&["plan", "free.toml"]);
    assert!(answer.status == 2 && answer.err.contains("along x is unknown"), "{}", answer.err);
}
