//! Effects of the measurement as a user meets them: listed, added, refused, found, and at work.

use std::path::Path;

use serde_json::{Value as Json, json};

use super::fem::{Place, model, words};

const AXIS: &str = "axis.toml";
const DATA: &str = "measured.csv";

/// The axis of `models/zeros` and its measurements.
fn place() -> Place {
    let place = Place::new();
    place.write(AXIS, model("zeros/axis.toml"));
    place.write(DATA, model("zeros/measured.csv"));
    place
}

fn parsed(text: &str) -> Json {
    serde_json::from_str(text).unwrap()
}

#[test]
fn the_catalogue_has_a_section_of_them() {
    let place = Place::new();
    let section = place.fem(&["effects", "measurement"]).out;
    insta::assert_snapshot!("effects_measurement", section);
    insta::assert_snapshot!("effect_zero_shift", place.fem(&["effects", "zero-shift"]).out);
    let all = place.fem(&["effects"]).out;
    assert!(section.lines().filter(|l| l.starts_with("  ")).all(|line| all.contains(line)), "{all}");
    let json = parsed(&place.fem(&["effects", "--json"]).out);
    let own: Vec<&Json> = json.as_array().unwrap().iter().filter(|e| e["process"] == "measurement").collect();
    assert_eq!(own.len(), fem::noise::effects::ALL.len());
    assert_eq!(parsed(&place.fem(&["effects", "measurement", "--json"]).out), json!(own));
    for effect in own {
        let name = effect["effect"].as_str().unwrap();
        assert_eq!(parsed(&place.fem(&["effects", name, "--json"]).out), json!([effect]));
        let page = place.fem(&["effects", name]).out;
        for key in effect["parameters"].as_array().unwrap() {
            assert!(page.contains(key["about"].as_str().unwrap()), "{page}");
        }
        // What the page shows as a table of a model file is read as one.
        let table = page.split("in a model file\n").nth(1).unwrap();
        place.write("shown.toml", format!("{}\n{table}", model("zeros/axis.toml")));
        assert_eq!(place.fem(&["run", "shown.toml"]).status, 0, "{table}");
    }
    let wrong = place.fem(&["effects", "zero-shfit"]);
    assert!(wrong.status == 2 && wrong.err.contains("did you mean `zero-shift`?"), "{}", wrong.err);
}

#[test]
fn tables_are_added_behind_what_is_there() {
    let place = place();
    let cases: &[(&[&str], &str)] = &[
        (&["zero-shift", "by=run", "size=0.7 um"], "[measurement.zero-shift]\nby = \"run\"\nsize = \"0.7 um\"\n"),
        (&["zero-shift", "by=run, direction"], "[measurement.zero-shift]\nby = \"run, direction\"\nsize = \"? um\"\n"),
        (&["outliers", "rows=12, 40"], "[measurement.outliers]\nrows = \"12, 40\"\n"),
        (&["jump", "from=46", "size=-3 nm"], ""),
        (&["jump", "from=46", "size=300 nm"], "[measurement.jump]\nfrom = \"46\"\nsize = \"300 nm\"\n"),
        (&["correlated-noise", "length=2"], "[measurement.correlated-noise]\nlength = 2.0\n"),
        (&["uncertainty-scale"], "[measurement.uncertainty-scale]\nfactor = \"?\"\n"),
        (&["drift-2"], "[measurement.drift-2]\nsize = \"? um\"\n"),
    ];
    for (words, expected) in cases {
        let answer = place.fem(&[&["add", AXIS], *words, &["-o", "new.toml"]].concat());
        assert_eq!(answer.status, if expected.is_empty() { 2 } else { 0 }, "{}", answer.err);
        if answer.status == 0 {
            let new = place.read("new.toml");
            assert_eq!(new.strip_prefix(&model("zeros/axis.toml")).unwrap(), format!("\n{expected}"));
            assert_eq!(answer.err.contains("unknown (`?`)"), expected.contains('?'), "{}", answer.err);
            // A run predicts the part, and what the instrument does to it is no part of that.
            let [with, without] = ["new.toml", AXIS].map(|name| place.fem(&["run", name]));
            assert_eq!((with.status, with.out.lines().count()), (0, without.out.lines().count()));
        }
    }
}

#[test]
fn an_inline_table_and_one_of_the_process_take_more() {
    let place = Place::new();
    let inline = format!("measurement = {{ drift = {{ size = \"1 um\" }} }} # mine\n{}", model("zeros/axis.toml"));
    for (name, text) in [("inline.toml", inline), ("ring.toml", model("ring.toml"))] {
        place.write(name, &text);
        let answer = place.fem(&["add", name, "zero-shift", "by=run", "-o", "new.toml"]);
        assert_eq!(answer.status, 0, "{}", answer.err);
        assert!(
            place.read("new.toml").contains("zero-shift")
                && place.read("new.toml").contains("# mine") == text.contains("# mine")
        );
        assert_eq!(place.fem(&["run", "new.toml"]).status, 0);
    }
}

#[test]
fn what_cannot_be_added_is_refused() {
    let place = place();
    place.write("shifted.toml", format!("{}\n[measurement.zero-shift]\nby = \"run\"\n", model("zeros/axis.toml")));
    let cases: &[(&str, &[&str], &str, &str)] = &[
        (AXIS, &["zero-shft"], "no effect known", "did you mean `zero-shift`?"),
        (AXIS, &["zero-shift", "sise=1 um"], "`sise` is no parameter", "did you mean `size`?"),
        (AXIS, &["zero-shift", "by=run", "by=run"], "given twice", "give it once"),
        (AXIS, &["zero-shift", "by=rum"], "`rum` is no coordinate", "did you mean \"run\"?"),
        (AXIS, &["zero-shift", "size=1 N"], "measures a force", "um"),
        (AXIS, &["correlated-noise", "length=2 mm"], "measures a length", "the number alone"),
        (AXIS, &["correlated-noise", "by=run"], "`by` is no parameter", "length"),
        (AXIS, &["outliers"], "not listed", "rows = \"12, 40\""),
        (AXIS, &["outliers", "rows=12", "factor=?"], "cannot be estimated", "leave it out"),
        (AXIS, &["jump", "from=0"], "`0` is no row", "counted from 1"),
        ("shifted.toml", &["zero-shift"], "has the effect `zero-shift` already", "`zero-shift-2`"),
    ];
    for (model, words, message, remedy) in cases {
        let answer = place.fem(&[&["add", *model], *words, &["-o", "new.toml"]].concat());
        assert_eq!(answer.status, 2, "{words:?}");
        assert!(answer.err.contains(message) && answer.err.contains(remedy), "{words:?}: {}", answer.err);
    }
}

#[test]
fn wrong_tables_are_told_with_their_place() {
    let place = Place::new();
    let good = format!(
        "{}\n[measurement.zero-shift]\nby = \"run\"\nsize = \"1 um\"\n[measurement.jump]\nfrom = 46\n",
        model("zeros/axis.toml")
    );
    place.write(AXIS, &good);
    assert_eq!(place.fem(&["run", AXIS]).status, 0);
    place.refuses(
        ("run", AXIS),
        &good,
        &[
            (
                "measurement.zero-shift",
                "measurement.zero-sift",
                "no effect of the measurement",
                "did you mean `zero-shift`?",
            ),
            (
                "measurement.zero-shift",
                "effects.zero-shift",
                "is an effect of the measurement",
                "[measurement.zero-shift]",
            ),
            ("by = \"run\"", "by = \"rum\"", "axis.toml:20:6: `rum` is no coordinate", "did you mean \"run\"?"),
            ("by =", "bye =", "`bye` is no key of `measurement.zero-shift`", "did you mean `by`?"),
            ("\"1 um\"", "1", "the unit is missing", "um"),
            ("\"1 um\"", "\"0 um\"", "must be above zero", "leave the table out"),
            ("\"1 um\"", "\"1 um\"\nobservable = \"deviatoin\"", "is not observed", "did you mean \"deviation\"?"),
            ("from = 46", "from = [46]", "expected a text or a number", "from ="),
            ("from = 46", "from = \"46, 50\"", "begins at one row", "from = \"46\""),
            ("from = 46", "", "begins at one row", "from = \"46\""),
        ],
    );
    // Whether rows are there is known with the file.
    place.write(DATA, model("zeros/measured.csv"));
    place.write(AXIS, good.replace("from = 46", "from = 500"));
    let answer = place.fem(&["compare", AXIS, "--with", DATA]);
    assert_eq!(answer.status, 2);
    assert!(answer.err.contains("names row 500") && answer.err.contains(":22:1"), "{}", answer.err);
}

#[test]
fn of_several_observables_one_is_meant() {
    let place = Place::new();
    let base = model("thermal.toml");
    place.write("thermal.toml", &base);
    place.write(DATA, "time [min],elongation [um],temperature [degC],x [mm]\n1,2,20,100\n2,3,21,100\n3,5,22,100\n");
    let compared = |table: &str| {
        place.write("new.toml", format!("{base}\n[measurement.drift]\n{table}\n"));
        place.fem(&["compare", "new.toml", "--with", DATA, "--json"])
    };
    let unsaid = compared("size = \"?\"");
    assert!(unsaid.status == 2 && unsaid.err.contains("add observable = \"elongation\""), "{}", unsaid.err);
    for (table, observable, unit) in [
        ("size = \"2 um\"", "elongation", "um"),
        ("size = \"0.5 K\"", "temperature", "K"),
        ("size = \"?\"\nobservable = \"temperature\"", "temperature", "K"),
    ] {
        let answer = compared(table);
        assert_eq!(answer.status, 0, "{table}: {}", answer.err);
        let own = parsed(&answer.out)["measurement"][0].clone();
        assert_eq!((own["observable"].as_str(), own["unit"].as_str()), (Some(observable), Some(unit)), "{table}");
    }
}

#[test]
fn the_schema_has_the_tables() {
    let schema = parsed(&Place::new().fem(&["schema"]).out);
    for process in schema["oneOf"].as_array().unwrap() {
        let tables = &process["properties"]["measurement"]["properties"];
        for effect in fem::noise::effects::ALL {
            assert!(tables[effect.name]["properties"][effect.size.key()].is_object(), "{}: {tables}", effect.name);
        }
    }
}

/// Each trouble is named, written into the model, and leaves nothing to be found. The rows are those of a part
/// in a fixture with nothing missing, spoilt by other code as the name of the file says.
#[test]
fn what_is_found_is_added_and_nothing_is_left() {
    let place = Place::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/trouble");
    place.write("model.toml", std::fs::read(folder.join("model.toml")).unwrap());
    for effect in ["zero-shift", "outliers", "jump", "correlated-noise", "uncertainty-scale"] {
        place.write(DATA, std::fs::read(folder.join(format!("{effect}.csv"))).unwrap());
        let answer = place.fem(&["diagnose", "model.toml", "--with", DATA, "--json", "--add-to", "better.toml"]);
        assert_eq!(answer.status, 0, "{effect}: {}", answer.err);
        let found = parsed(&answer.out);
        let missing = &found["missing"];
        assert_eq!(missing.as_array().unwrap().len(), 1, "{effect}: {missing}");
        assert_eq!((&missing[0]["effect"], &missing[0]["kind"]), (&json!(effect), &json!("measurement")));
        assert_eq!((&found["verdict"], &found["after"]["verdict"]), (&json!("missing-effect"), &json!("adequate")));
        let compared = parsed(&place.fem(&["compare", "better.toml", "--with", DATA, "--json"]).out);
        assert_eq!(compared["models"][0]["adequate"], json!(true), "{effect}");
        let at_work = &compared["measurement"][0];
        assert_eq!((&at_work["effect"], &at_work["by"]), (&json!(effect), &missing[0]["by"]));
        assert_eq!(at_work["rows"], missing[0]["rows"]);
        let key = at_work["parameter"].as_str().unwrap();
        let (written, told) = (at_work["size"].as_f64().unwrap(), missing[0]["parameters"][key]["value"].as_f64());
        assert!((written / told.unwrap() - 1.0).abs() < 1e-4, "{effect}: {at_work}");
        let again = parsed(&place.fem(&["diagnose", "better.toml", "--with", DATA, "--json"]).out);
        assert_eq!((&again["verdict"], &again["missing"]), (&json!("adequate"), &json!([])), "{effect}");
    }
}

#[test]
fn the_commands_that_are_shown_do_the_same() {
    let place = place();
    let told = place.fem(&["diagnose", AXIS, "--with", DATA]).out;
    for said in ["zero-shift by run, ", "  line 41 ", "  line 74 ", "measure a master between the groups"] {
        assert!(told.contains(said), "{told}");
    }
    let commands: Vec<&str> = told.lines().filter(|l| l.trim_start().starts_with("fem add")).collect();
    assert_eq!(commands.len(), 3, "{told}");
    for command in commands {
        let words = words(command);
        let args: Vec<&str> = words[1..].iter().map(String::as_str).collect();
        assert_eq!(place.fem(&args).status, 0, "{command}");
    }
    let last = "axis-zero-shift-outliers-backlash.toml";
    let compared = place.fem(&["compare", last, "--with", DATA]).out;
    assert!(compared.contains("adequate") && compared.contains("zero-shift by run, size 1.0"), "{compared}");
    let again = place.fem(&["diagnose", last, "--with", DATA]).out;
    assert!(again.contains("nothing is missing"), "{again}");
    // A fit weighs the rows by the same covariance, and says so.
    let fitted = place.fem(&["fit", last, "--with", DATA]).out;
    assert!(fitted.contains("; outliers, 2 rows"), "{fitted}");
}
