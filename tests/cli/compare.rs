//! `fem compare` and `fem fit` as a user meets them.

use super::fem::{Place, model};

const GOOD: &str = "# three rows\npart,x [mm],diameter_error [um],u [um]\n1,100,70,1\n1,300,105,1\n2,500,80,1\n";

/// (in the good file, replaced by, place, part of the message)
const CASES: &[(&str, &str, &str, &str)] = &[
    ("x [mm]", "x", ":2:", "the unit is missing"),
    ("x [mm]", "x [kg]", ":2:", "not a length"),
    ("x [mm]", "y [mm]", ":2:", "the column `x` is missing"),
    ("diameter_error [um]", "diamter_err [um]", ":2:", "is `diamter_err` meant?"),
    ("x [mm]", "XX [mm]", ":2:", "the column `x` is missing"),
    ("u [um]", "u [N]", ":2:", "the unit of `u`"),
    ("1,300,105,1", "1,300,nan,1", ":4:", "no finite number"),
    ("1,300,105,1", "1,300,1e999,1", ":4:", "no finite number"),
    ("1,300,105,1", "1,,105,1", ":4:", "is empty"),
    ("1,300,105,1", "1,300,105,", ":4:", "is empty"),
    ("1,300,105,1", "1,300,105", ":4:", "3 cells, the header 4"),
    ("1,300,105,1", "1,300,105,0", ":4:", "`u` is 0"),
    ("1,300,105,1", "1,300,105,-1", ":4:", "`u` is -1"),
    ("1,300,105,1", "1.5,300,105,1", ":4:", "`part` is 1.5"),
    ("1,300,105,1", "0,300,105,1", ":4:", "`part` is 0"),
    ("1,300,105,1", "1,700,105,1", "line 4", "is not on the shaft"),
    ("1,300,105,1", "99,300,105,1", "line 4", "beyond the batch of 12"),
    ("part,x", "x [mm],x", ":2:", "stands twice"),
    ("1,100,70,1\n1,300,105,1\n2,500,80,1\n", "", "", "no rows"),
];

#[test]
fn bad_measurements_are_refused_at_their_line() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    for (given, wrong, line, message) in CASES {
        assert!(GOOD.contains(given), "{given}");
        place.write("measured.csv", GOOD.replacen(given, wrong, 1));
        let answer = place.fem(&["compare", "lathe.toml", "--with", "measured.csv"]);
        let page = answer.err.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(answer.status, 2, "{wrong}: {}", answer.err);
        assert!(page.contains(message) && page.contains(line), "{wrong}: {}", answer.err);
    }
}

/// A machine that cannot be is told of wherever it predicts, not by a run alone.
#[test]
fn a_support_that_would_pull_is_told_beside_measurements() {
    let place = Place::new();
    let rest = "steady_rests = [{ at = \"300 mm\", stiffness = \"20 N/um\", offset = \"200 um\" }]";
    let text = model("lathe.toml").replacen("[workholding]", &format!("[workholding]\n{rest}"), 1);
    place.write("lathe.toml", &text);
    place.write("measured.csv", GOOD);
    let warned = place.fem(&["run", "lathe.toml"]).err;
    assert!(warned.contains("the steady rest at 300.0 mm would have to pull"), "{warned}");
    for command in ["compare", "fit", "diagnose"] {
        let answer = place.fem(&[command, "lathe.toml", "--with", "measured.csv", "--json"]);
        let told: serde_json::Value = serde_json::from_str(&answer.out).unwrap();
        let cautions = if command == "compare" { &told["models"][0]["cautions"] } else { &told["cautions"] };
        assert!(cautions.to_string().contains("the steady rest at 300.0 mm would have to pull"), "{command}: {told}");
    }
}

/// A screen shows two thousand places at most, and a file of a million rows made 800 MB of shapes.
#[test]
fn shapes_mark_some_of_many_rows_and_the_table_has_all() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    let rows = |part: i32, count: i32| {
        let x = move |row: i32| 600.0 * f64::from(row) / f64::from(count);
        (0..count).map(move |row| format!("{part},{},70,1\n", x(row))).collect::<String>()
    };
    place.write("measured.csv", format!("part,x [mm],diameter_error [um],u [um]\n{}{}", rows(1, 5000), rows(2, 300)));
    let answer = place.fem(&["compare", "lathe.toml", "--with", "measured.csv", "-o", "there"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    // A mark for what was measured, and one for what is predicted: every third of 5000 rows, all of 300.
    for (frame, marked) in [(0, 1667), (1, 300)] {
        let bytes = std::fs::read(place.path(&format!("there/compared/compared_{frame:04}.vtu"))).unwrap();
        let points =
            String::from_utf8_lossy(&bytes).split("NumberOfPoints=\"").nth(1).map(|rest| rest[..6].to_string());
        let count = points.as_deref().and_then(|points| points.split('"').next());
        assert_eq!(count, Some(format!("{}", 2 * marked).as_str()), "frame {frame}");
    }
    assert_eq!(std::fs::read_to_string(place.path("there/residuals.csv")).unwrap().lines().count(), 5301);
}

#[test]
fn residuals_are_the_measured_rows_and_what_is_left() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    let noted = GOOD.replace("u [um]\n", "u [um],operator\n").replace(",1\n", ",1,me\n");
    place.write("measured.csv", noted);
    let answer = place.fem(&["compare", "lathe.toml", "--with", "measured.csv", "-o", "there", "--json"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert!(answer.err.contains("the column `operator` is not used: it is me in every row"), "{}", answer.err);
    let json: serde_json::Value = serde_json::from_str(&answer.out).unwrap();
    assert_eq!((json["schema"].as_str(), json["observations"].as_u64()), (Some("fem-comparison/1"), Some(3)));
    assert_eq!(json["noise"], serde_json::json!({ "sigma": 1.0, "unit": "um", "source": "column u" }));
    let found = &json["models"][0];
    for key in ["rms", "bias", "chi2_per_dof", "p_value"] {
        assert!(found[key].is_number(), "{key}");
    }
    assert_eq!(found["worst"]["line"].as_u64(), found["worst"]["row"].as_u64().map(|row| row + 2));
    let mut reader = csv::Reader::from_path(place.path("there/residuals.csv")).unwrap();
    let headers: Vec<String> = reader.headers().unwrap().iter().map(str::to_string).collect();
    assert_eq!(headers[4..], ["operator", "predicted [um]", "residual [um]"]);
    for row in reader.records() {
        let row = row.unwrap();
        let number = |i: usize| row[i].parse::<f64>().unwrap();
        assert!((number(2) - number(5) - number(6)).abs() < 1e-9);
    }
    // Two models: one folder each.
    place.write("other.toml", model("lathe.toml"));
    assert_eq!(place.fem(&["compare", "lathe.toml", "other.toml", "--with", "measured.csv", "-o", "both"]).status, 0);
    assert!(place.path("both/other/residuals.csv").exists() && place.path("both/lathe/residuals.csv").exists());
}

#[test]
fn the_profile_of_a_run_is_a_measurement_file() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    assert_eq!(place.fem(&["run", "lathe.toml"]).status, 0);
    let answer = place.fem(&["compare", "lathe.toml", "--with", "out/lathe/profile.csv", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&answer.out).unwrap();
    assert!(json["models"][0]["rms"].as_f64().unwrap() < 1e-9, "{}", json["models"][0]);
}

#[test]
fn a_fit_writes_a_new_model_and_never_the_old() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    assert_eq!(place.fem(&["run", "lathe.toml"]).status, 0);
    let data = "out/lathe/profile.csv";
    let same = place.fem(&["fit", "lathe.toml", "--with", data, "--add-to", "lathe.toml"]);
    assert_eq!(same.status, 2);
    assert_eq!(place.read("lathe.toml"), model("lathe.toml"));
    let fitted = place.fem(&["fit", "lathe.toml", "--with", data, "--add-to", "fitted.toml", "--json"]);
    assert_eq!(fitted.status, 0, "{}", fitted.err);
    let json: serde_json::Value = serde_json::from_str(&fitted.out).unwrap();
    // The data are the model's own prediction: the stiffnesses come back.
    for (i, expected) in [60.0, 40.0, 50.0].into_iter().enumerate() {
        let value = json["parameters"][i]["value"].as_f64().unwrap();
        assert!((value - expected).abs() < 1e-3 * expected, "{}", json["parameters"][i]);
    }
    assert_eq!(place.fem(&["run", "fitted.toml"]).status, 0);
    let nothing = model("lathe.toml").replace(" +- 10", "").replace(" +- 8", "");
    place.write("known.toml", nothing);
    let answer = place.fem(&["fit", "known.toml", "--with", data]);
    assert_eq!(answer.status, 2);
    assert!(answer.err.contains("nothing to fit"), "{}", answer.err);
}

#[test]
fn fewer_rows_than_free_parameters_are_refused() {
    let place = Place::new();
    place.write("measured.csv", "x [mm],diameter_error [um]\n100,5\n200,6\n");
    let free = model("lathe.toml").replace("\"60 +- 10", "\"?").replace("\"40 +- 8", "\"?").replace("\"50 +- 8", "\"?");
    place.write("free.toml", free);
    let answer = place.fem(&["fit", "free.toml", "--with", "measured.csv"]);
    assert_eq!(answer.status, 1);
    assert!(answer.err.contains("cannot fix 3 free parameters"), "{}", answer.err);
}

#[test]
fn a_few_rows_are_not_judged() {
    let place = Place::new();
    place.write("rigid.toml", model("story/rigid.toml"));
    place.write("two.csv", "x [mm],diameter_error [um]\n10,1\n200,1.5\n");
    let answer = place.fem(&["compare", "rigid.toml", "--with", "two.csv"]);
    assert!(answer.out.contains("not judged: too few rows"), "{}", answer.out);
    let json = place.fem(&["compare", "rigid.toml", "--with", "two.csv", "--json"]).out;
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert!(json["models"][0]["adequate"].is_null(), "{json}");
}

#[test]
fn absurd_uncertainties_are_refused() {
    let place = Place::new();
    place.write("rigid.toml", model("story/rigid.toml"));
    for (u, why) in [("1e-300", "is the unit right?"), ("1e300", "is too large to be measured")] {
        place.write("u.csv", format!("x [mm],diameter_error [um],u [um]\n10,1,{u}\n200,1.5,1\n"));
        let answer = place.fem(&["compare", "rigid.toml", "--with", "u.csv"]);
        assert!(answer.status == 2 && answer.err.contains(why), "{}", answer.err);
    }
}
