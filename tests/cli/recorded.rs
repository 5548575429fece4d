//! Columns that a file has beside those of its process: they are looked at, formulas may name them, and what is of no use
//! is said.

use serde_json::Value as Json;

use super::fem::{Place, model};

/// An axis without any error of its own.
fn ideal() -> String {
    model("axis.toml").split("[effects").next().unwrap_or_default().to_string()
}

/// Five runs to and fro, measured to 0.5 um while the room was now warmer, now colder, by somebody who writes down what he
/// sees; the laser reads 2.75 um more for each kelvin.
fn measured() -> String {
    let mut text = "run,direction,position [mm],room [degC],humidity [%],operator,gauge,remark,deviation [um],u [um]\n"
        .to_string();
    let mut seed = 7_u64;
    let mut noise = || {
        let mut one = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as f64 / f64::from(1_u32 << 31)
        };
        (0..12).map(|_| one()).sum::<f64>() - 6.0
    };
    for run in 1..=5 {
        for (direction, back) in [("+", 0), ("-", 1)] {
            for k in 0..11 {
                let row = 22 * (run - 1) + 11 * back + k;
                let room = 21.0 + (0.37 * row as f64).sin();
                let humidity = 45.0 + 9.0 * (1.1 * row as f64).cos();
                let deviation = 2.75 * (room - 20.0) + 0.5 * noise();
                let place = 60 * if back == 0 { k } else { 10 - k };
                let operator = ["Ann", "Bo"][usize::from(run > 2)];
                text += &format!(
                    "{run},{direction},{place},{room:.3},{humidity:.1},{operator},7,word{row},{deviation:.4},0.5\n"
                );
            }
        }
    }
    text
}

const LAW: &str = "[effects.reading]\nformula = \"a*(room - t0)\"\na = \"? um/K\"\nt0 = \"20 degC\"\n";

fn json(text: &str) -> Json {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// The shape of the error along the room's temperature, if it is told.
fn along_room(compared: &str) -> Option<String> {
    let compared = json(compared);
    let features = compared["models"][0]["features"].as_array()?;
    let own = features.iter().find(|feature| feature["coordinate"] == "room")?;
    own["shape"].as_str().map(str::to_string)
}

#[test]
fn a_column_that_the_process_does_not_know_is_looked_at() {
    let place = Place::new();
    place.write("axis.toml", ideal());
    place.write("measured.csv", measured());
    let answer = place.fem(&["compare", "axis.toml", "--with", "measured.csv", "--json"]);
    assert_eq!(along_room(&answer.out), Some("linear".into()), "{}", answer.out);
    for note in [
        "the column `gauge` is not used: it is 7 in every row",
        "the column `remark` is not used: its 110 words are as good as different in every row",
    ] {
        assert!(answer.err.contains(note), "{}", answer.err);
    }
    assert!(!answer.err.contains("humidity") && !answer.err.contains("operator"), "{}", answer.err);
}

#[test]
fn a_formula_may_name_it() {
    let place = Place::new();
    place.write("axis.toml", ideal() + LAW);
    place.write("measured.csv", measured());
    let fitted =
        json(&place.fem(&["fit", "axis.toml", "--with", "measured.csv", "--add-to", "fitted.toml", "--json"]).out);
    let slope = &fitted["parameters"][0];
    let [value, std] = ["value", "std"].map(|key| slope[key].as_f64().unwrap_or(f64::NAN));
    assert!((value - 2.75).abs() < 4.0 * std && std < 0.05, "{slope}");
    assert!(fitted["chi2_per_dof"].as_f64().is_some_and(|chi2| (0.7..1.3).contains(&chi2)), "{fitted}");
    let compared = json(&place.fem(&["compare", "fitted.toml", "--with", "measured.csv", "--json"]).out);
    assert!(compared["models"][0]["rms"].as_f64().is_some_and(|rms| rms < 0.6), "{compared}");
}

#[test]
fn a_model_that_is_written_runs() {
    let place = Place::new();
    place.write("axis.toml", ideal() + LAW);
    place.write("measured.csv", measured());
    let fitted = place.fem(&["fit", "axis.toml", "--with", "measured.csv", "--add-to", "fitted.toml"]);
    assert!(fitted.err.contains("note: [recorded] has room = \"21"), "{}", fitted.err);
    assert!(place.read("fitted.toml").contains("[recorded]\nroom = \"21"), "{}", place.read("fitted.toml"));
    let run = place.fem(&["run", "fitted.toml"]);
    assert_eq!(run.status, 0, "{}", run.err);
    // What the model says itself stays.
    place.write("axis.toml", ideal() + LAW + "[recorded]\nroom = \"24 degC\"\n");
    let fitted = place.fem(&["fit", "axis.toml", "--with", "measured.csv", "--add-to", "own.toml"]);
    assert!(!fitted.err.contains("[recorded]") && place.read("own.toml").contains("room = \"24 degC\""));
    place.write("axis.toml", ideal());
    let law = ["formula=a*(room - t0)", "a=? um/K", "t0=20 degC", "--with", "measured.csv", "-o", "added.toml"];
    let added = place.fem(&[&["add", "axis.toml", "reading"], &law[..]].concat());
    assert!(added.status == 0 && added.err.contains("note: [recorded] has room = \"21"), "{}", added.err);
}

#[test]
fn where_rows_do_not_have_it_the_model_says_what_it_is() {
    let place = Place::new();
    let known = LAW.replace("\"? um/K\"", "\"2.75 um/K\"");
    place.write("axis.toml", ideal() + &known);
    let refused = place.fem(&["run", "axis.toml"]);
    assert!(refused.status != 0 && refused.err.contains("`room` is neither a coordinate of axis nor a parameter"));
    assert!(refused.err.contains("[recorded]"), "{}", refused.err);
    // 2.75 um/K at 24 degC, everywhere.
    place.write("axis.toml", ideal() + &known + "[recorded]\nroom = \"24 degC\"\n");
    assert_eq!(place.fem(&["run", "axis.toml", "-o", "out"]).status, 0);
    let profile = place.read("out/profile.csv");
    let last = |line: &str| line.rsplit(',').next().and_then(|cell| cell.parse::<f64>().ok());
    assert!(profile.lines().skip(1).all(|line| last(line).is_some_and(|y| (y - 11.0).abs() < 1e-9)), "{profile}");
}

#[test]
fn a_formula_may_name_the_prediction() {
    let place = Place::new();
    let scale = "[effects.scale-error]\nslope = \"100 um/m\"\n";
    let more = "[effects.more]\nformula = \"k*prediction\"\nk = \"0.5\"\n";
    place.write("one.toml", ideal() + scale);
    place.write("two.toml", ideal() + more + scale);
    let [one, two] = ["one", "two"].map(|name| {
        let answer = place.fem(&["run", &format!("{name}.toml"), "-o", name]);
        assert_eq!(answer.status, 0, "{}", answer.err);
        let profile = place.read(&format!("{name}/profile.csv"));
        profile.lines().skip(1).filter_map(|line| line.rsplit(',').next()?.parse::<f64>().ok()).collect::<Vec<_>>()
    });
    assert!(one.iter().any(|y| y.abs() > 1.0));
    assert!(one.iter().zip(&two).all(|(one, two)| (1.5 * one - two).abs() < 1e-9), "{one:?} {two:?}");
}

#[test]
fn of_several_files_a_column_counts_that_all_have() {
    let place = Place::new();
    place.write("axis.toml", ideal());
    let all = measured();
    let head = all.lines().next().unwrap_or_default();
    let of_run = |run: usize| all.lines().filter(move |line| line.starts_with(&format!("{run},")));
    let file = |runs: [usize; 2]| {
        std::iter::once(head)
            .chain(runs.into_iter().flat_map(of_run))
            .map(|line| line.to_string() + "\n")
            .collect::<String>()
    };
    place.write("one.csv", file([1, 2]));
    // Another unit, another order of the words, and no humidity.
    let other = file([3, 4]).replace("humidity [%]", "wetness [%]");
    place.write("two.csv", other);
    let answer = place.fem(&["compare", "axis.toml", "--with", "one.csv", "--with", "two.csv", "--json"]);
    assert_eq!(along_room(&answer.out), Some("linear".into()), "{}", answer.out);
    for lost in ["humidity", "wetness"] {
        assert!(
            answer.err.contains(&format!("the column `{lost}` is not used: not every file has it")),
            "{}",
            answer.err
        );
    }
}

#[test]
fn what_a_column_lacks_is_said() {
    let head = "run,direction,position [mm],deviation [um],u [um],extra";
    let file = |extra: &dyn Fn(usize) -> String, unit: &str| {
        let row = |k: usize| format!("1,+,{},{},0.5,{}\n", 20 * k, [0.1, -0.2, 0.3][k % 3], extra(k));
        format!("{head}{unit}\n") + &(0..24).map(row).collect::<String>()
    };
    type Written<'c> = (&'c dyn Fn(usize) -> String, &'c str, &'c str);
    let cases: [Written; 6] = [
        (&|k| if k == 4 { "abc".into() } else { format!("{}", k * k) }, "", "`abc` in line 6 is no number"),
        (&|k| if k == 4 { String::new() } else { format!("{}", k * k) }, "", "1 of its 24 cells are empty"),
        (&|k| format!("{}", k + 1), "", "it numbers the rows"),
        (&|k| format!("{}", 20 * k), " [mm]", "it says the same as another column"),
        (
            &|k| format!("{}", k * k),
            " [blob]",
            "the unit `blob` of `extra` is not known, and it counts as a pure number",
        ),
        (&|k| format!("{}", k * k), "", "the column `extra` has no unit, and counts as a pure number"),
    ];
    let place = Place::new();
    place.write("axis.toml", ideal());
    for (extra, unit, note) in cases {
        place.write("measured.csv", file(extra, unit));
        let answer = place.fem(&["compare", "axis.toml", "--with", "measured.csv"]);
        assert!(answer.status == 0 && answer.err.contains(note), "{note}: {}", answer.err);
    }
}
