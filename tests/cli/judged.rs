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
        assert!(told.contains("not judged: too few rows at different places") && !told.contains("certain"), "{told}");
    }
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
