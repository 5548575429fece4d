//! Rows that cannot tell a verdict give none, in every command alike; and verdicts say no more than was tried.

use serde_json::Value;

use super::fem::{Place, model};

/// An answer as JSON.
fn json(place: &Place, args: &[&str]) -> Value {
    let answer = place.fem(&[args, &["--json"]].concat());
    assert_eq!(answer.status, 0, "{args:?}: {}", answer.err);
    serde_json::from_str(&answer.out).unwrap()
}

/// Rows 30 um off, or on what the model predicts, of which nothing tells the noise.
fn rows(count: usize, place: impl Fn(usize) -> usize) -> String {
    let scatter = [0.01, 0.12, -0.09, 0.05, -0.18, 0.15, 0.0];
    let row = |i: usize| format!("{},{},300,{}\n", 1 + i / 5, place(i), 30.0 + scatter[i % 7]);
    format!("part,x [mm],radial_force [N],diameter_error [um]\n{}", (0..count).map(row).collect::<String>())
}

#[test]
fn rows_that_are_too_few_or_too_equal_give_no_verdict() {
    let place = Place::new();
    place.write("rigid.toml", model("story/rigid.toml"));
    let same = format!("part,x [mm],radial_force [N],diameter_error [um]\n{}", "1,100,300,5\n".repeat(60));
    let spread = |i: usize| 20 + 97 * (i % 5);
    for (name, text) in
        [("same", same), ("three", rows(3, spread)), ("five", rows(5, spread)), ("six", rows(6, spread))]
    {
        place.write("m.csv", text);
        let compared = json(&place, &["compare", "rigid.toml", "--with", "m.csv"]);
        assert_eq!(compared["models"][0]["adequate"], Value::Null, "{name}: {compared:#}");
        // A noise that is the round-off of the readings is no yardstick.
        assert_eq!(compared["models"][0]["chi2_per_dof"].is_null(), name == "same", "{compared:#}");
        for command in ["diagnose", "discover"] {
            let found = json(&place, &[command, "rigid.toml", "--with", "m.csv"]);
            assert_eq!(found["verdict"], "not-judged", "{name}, {command}: {found:#}");
        }
        let told = place.fem(&["diagnose", "rigid.toml", "--with", "m.csv"]).out;
        let reason = if name == "same" { "all readings are one number" } else { "too few rows at different places" };
        assert!(told.contains(&format!("not judged: {reason}")) && !told.contains("certain"), "{told}");
    }
}

/// A case with a hidden effect, its readings replaced.
fn hidden(place: &Place, case: &str, observable: &str, reading: impl Fn(usize, f64) -> String) {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/hidden").join(case);
    place.write("model.toml", std::fs::read(folder.join("model.toml")).unwrap());
    let rows = std::fs::read_to_string(folder.join("measured.csv")).unwrap();
    let column = rows.lines().next().unwrap().split(',').position(|cell| cell.starts_with(observable)).unwrap();
    let line = |(number, line): (usize, &str)| {
        let mut cells: Vec<String> = line.split(',').map(String::from).collect();
        if number > 0 && !cells[column].is_empty() {
            cells[column] = reading(number, cells[column].parse().unwrap());
        }
        cells.join(",") + "\n"
    };
    place.write("m.csv", rows.lines().enumerate().map(line).collect::<String>());
}

/// A channel that does not answer, or a gauge that is too coarse: 0 in every row, with repeats, a column u, or neither.
#[test]
fn readings_that_are_all_one_number_tell_nothing() {
    let place = Place::new();
    let cases = [
        ("stiffness-001", "displacement", "fit"),
        ("ring-010", "deviation", "compare"),
        ("ring-013", "deviation", "compare"),
        ("axis-002", "deviation", "fit"),
        ("turning-001", "diameter_error", "fit"),
        ("fixture-000", "height_error", "compare"),
    ];
    for (case, observable, other) in cases {
        for reading in ["0", "5"] {
            hidden(&place, case, observable, |_, _| reading.into());
            let found = json(&place, &["diagnose", "model.toml", "--with", "m.csv"]);
            assert_eq!(found["verdict"], "not-judged", "{case}: {found:#}");
            assert!(found["missing"].as_array().unwrap().is_empty(), "{case}: {found:#}");
            let cautions = found["cautions"].to_string();
            assert!(cautions.contains("all readings are one number") && !cautions.contains("ask for"), "{cautions}");
            let other = json(&place, &[other, "model.toml", "--with", "m.csv"]);
            let adequate = if other["models"].is_null() { &other["adequate"] } else { &other["models"][0]["adequate"] };
            assert!(
                adequate.is_null() && other.to_string().contains("all readings are one number"),
                "{case}: {other:#}"
            );
        }
    }
}

/// No process takes a reading that none of its predictions could be.
#[test]
fn a_reading_beyond_all_that_is_predicted_is_refused() {
    let place = Place::new();
    let cases = [
        ("stiffness-001", "displacement", "that is no joint any more"),
        ("axis-002", "deviation", "as large as the travel"),
        ("axis-000", "deviation", "as large as the travel"),
        ("thermal-000", "temperature", "no body stands that"),
        ("thermal-000", "elongation", "no body grows by its own length"),
        ("turning-002", "diameter_error", "from what the drawing says"),
        ("fixture-000", "height_error", "from what the drawing says"),
    ];
    for (case, observable, why) in cases {
        for wild in ["1e30", "-1e6"] {
            let first = std::cell::Cell::new(true);
            let own = |_: usize, value: f64| if first.replace(false) { wild.to_string() } else { value.to_string() };
            hidden(&place, case, observable, own);
            let refused = place.fem(&["diagnose", "model.toml", "--with", "m.csv"]);
            let is_told = refused.err.contains(why) && refused.err.contains("in line ");
            assert!(refused.status == 2 && is_told, "{case}, {wild}: {}", refused.err);
        }
    }
}

/// Uncertainties of a billionth of what is left, or of a billion times as much, are told, and are no reason for a certain cause to
/// be hidden.
#[test]
fn uncertainties_that_cannot_be_meant_are_told() {
    let place = Place::new();
    for (case, u) in [("fixture-000", "1e-9"), ("axis-002", "1e-9"), ("turning-001", "1e9")] {
        hidden(&place, case, "u ", |_, _| u.into());
        let found = json(&place, &["diagnose", "model.toml", "--with", "m.csv"]);
        let caution = "times their standard uncertainties: are those meant, and in the right unit?";
        assert!(found["cautions"].to_string().contains(caution), "{case}: {found:#}");
    }
}

/// One reading a hundred to ten thousand standard deviations off: no law is found for it, and what is missing is named beside.
#[test]
fn a_reading_far_off_is_outlying_and_hides_no_cause() {
    let place = Place::new();
    for far in ["50", "5000"] {
        hidden(&place, "axis-000", "deviation", |row, value| if row == 6 { far.into() } else { value.to_string() });
        let found = json(&place, &["diagnose", "model.toml", "--with", "m.csv"]);
        let names: Vec<&str> =
            found["missing"].as_array().unwrap().iter().map(|own| own["effect"].as_str().unwrap()).collect();
        assert_eq!(names, ["outliers", "periodic-error"], "{far}: {found:#}");
        assert_eq!(found["outliers"][0]["line"], 7, "{found:#}");
    }
}

/// Readings of the other sign bring values to where the jaws let go: there is a side beside them all the same.
#[test]
fn a_model_on_the_edge_of_what_can_be_computed_has_a_diagnosis() {
    let place = Place::new();
    hidden(&place, "ring-010", "deviation", |_, value| (-value).to_string());
    let found = json(&place, &["diagnose", "model.toml", "--with", "m.csv"]);
    assert_ne!(found["verdict"], "adequate", "{found:#}");
}

#[test]
fn a_row_or_two_tell_no_cause_however_well_they_are_known() {
    let place = Place::new();
    place.write("rigid.toml", model("story/rigid.toml"));
    let head = "part,x [mm],radial_force [N],diameter_error [um],u [um]\n";
    for (rows, said) in
        [("1,200,300,90,1\n", "one row tells no cause"), ("1,200,300,90,1\n1,50,300,9,1\n", "2 rows tell")]
    {
        place.write("m.csv", format!("{head}{rows}"));
        let found = json(&place, &["diagnose", "rigid.toml", "--with", "m.csv"]);
        assert_eq!(found["verdict"], "not-judged", "{found:#}");
        let told = place.fem(&["diagnose", "rigid.toml", "--with", "m.csv"]).out;
        assert!(told.contains(said) && !told.contains("unexplained") && !told.contains("ruled out"), "{told}");
    }
}

#[test]
fn rows_that_are_left_out_for_their_first_cell_are_told() {
    let place = Place::new();
    place.write("rigid.toml", model("story/rigid.toml"));
    let row = |i: usize| format!("1,{},300,{},1\n", 40 * i, 30 + i);
    let rows: String = (1..9).map(row).collect();
    place.write(
        "m.csv",
        format!("part,x [mm],radial_force [N],diameter_error [um],u [um]\n{rows},340,300,40,1\n,350,300,5,1\n"),
    );
    let told = place.fem(&["compare", "rigid.toml", "--with", "m.csv"]).err;
    assert!(told.contains("the last 2 rows left out, from line 10 on: their first cell is empty"), "{told}");
}

#[test]
fn effects_that_were_not_tried_are_not_said_to_be_none() {
    let place = Place::new();
    place.write("rigid.toml", model("story/rigid.toml"));
    place.write("m.csv", model("story/measured.csv"));
    let args = ["diagnose", "rigid.toml", "--with", "m.csv", "--time-limit", "1 ms"];
    let told = place.fem(&args).out.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(told.contains("no cause was found in the time"), "{told}");
    assert!(!told.contains("no effect known here"), "{told}");
}
