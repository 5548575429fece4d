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
        place.write("covariance.csv", "4, 1\n1, 9\n");
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
        (&["zero-shift", "by=run", "size=free"], "[measurement.zero-shift]\nby = \"run\"\nsize = \"free\"\n"),
        (&["resolution"], "[measurement.resolution]\nstep = \"? um\"\n"),
        (&["gain"], "[measurement.gain]\nfactor = \"?\"\n"),
        (&["gain", "factor=1.02"], "[measurement.gain]\nfactor = 1.02\n"),
        (&["calibration"], "[measurement.calibration]\noffset = \"? um\"\nscale = \"?\"\n"),
        (
            &["calibration", "bow=-0.4 +- 0.1 um", "low=-10 um", "high=10 um"],
            "[measurement.calibration]\nlow = \"-10 um\"\nhigh = \"10 um\"\nbow = \"-0.4 +- 0.1 um\"\n",
        ),
        (&["clock", "delay=-2 +- 1 min"], "[measurement.clock]\ndelay = \"-2 +- 1 min\"\n"),
        (
            &["alignment", "by=run", "along=position", "offset=0 um"],
            "[measurement.alignment]\nby = \"run\"\nalong = \"position\"\noffset = \"0 um\"\nslope = \"? um\"\n",
        ),
        (
            &["covariance", "file=covariance.csv", "unit=um"],
            "[measurement.covariance]\nfile = \"covariance.csv\"\nunit = \"um\"\n",
        ),
    ];
    place.write("covariance.csv", "row,column,covariance\n1,1,4\n2,2,9\n1,2,1\n");
    let without = place.fem(&["run", AXIS]).out;
    for (words, expected) in cases {
        let answer = place.fem(&[&["add", AXIS], *words, &["-o", "new.toml", "--force"]].concat());
        assert_eq!(answer.status, if expected.is_empty() { 2 } else { 0 }, "{}", answer.err);
        if answer.status == 0 {
            let new = place.read("new.toml");
            assert_eq!(new.strip_prefix(&model("zeros/axis.toml")).unwrap(), format!("\n{expected}"));
            assert_eq!(answer.err.contains("unknown (`?`)"), expected.contains('?'), "{}", answer.err);
            // A run predicts the part, and what the instrument does to it is no part of that; it says so.
            let with = place.fem(&["run", "new.toml"]);
            assert_eq!((with.status, with.out.lines().count()), (0, without.lines().count() + 3), "{}", with.out);
            assert!(with.out.contains("new.toml has, of the measurement: "), "{}", with.out);
        }
    }
}

#[test]
fn an_inline_table_and_one_of_the_process_take_more() {
    let place = Place::new();
    let inline = format!("measurement = {{ drift = {{ size = \"1 um\" }} }} # mine\n{}", model("zeros/axis.toml"));
    for (name, text) in [("inline.toml", inline), ("ring.toml", model("ring.toml"))] {
        place.write(name, &text);
        let answer = place.fem(&["add", name, "zero-shift", "by=run", "-o", "new.toml", "--force"]);
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
        (AXIS, &["zero-shift", "size=1 +- 0.1 um"], "has no `+-`", "have it estimated"),
        (AXIS, &["gain", "factor=0"], "must be above zero", "leave the table out"),
        (AXIS, &["calibration", "bow=1 um"], "between two values", "where the sensor's range ends"),
        (AXIS, &["calibration", "bow=1 um", "low=3 um", "high=2 um"], "`high` is not above `low`", "a range"),
        (AXIS, &["calibration", "scale=0"], "`scale` is 0", "above zero"),
        (AXIS, &["gain", "factor=2 um"], "measures a length", "the number alone"),
        (AXIS, &["outliers", "rows=12", "factor=-1"], "must be above zero", "it is 10"),
        (AXIS, &["correlated-noise", "length=0"], "must be above zero", "leave the table out"),
        (AXIS, &["resolution", "step=0 um"], "must be above zero", "leave the table out"),
        (AXIS, &["clock", "delay=3 um"], "measures a length", "s"),
        (AXIS, &["alignment", "by=run"], "not said along what", "add along"),
        (AXIS, &["alignment", "along=direction"], "is no length, angle or time", "position"),
        (AXIS, &["alignment", "along=positon"], "`positon` is no coordinate", "did you mean \"position\"?"),
        (AXIS, &["alignment", "along=position", "offset=0 um", "slope=0 um"], "neither `offset` nor `slope`", "leave"),
        (AXIS, &["covariance", "unit=um"], "`file` is missing", "add file ="),
        (AXIS, &["covariance", "file=none.csv", "unit=um"], "none.csv", "relative to the folder"),
        ("shifted.toml", &["zero-shift"], "has the effect `zero-shift` already", "`zero-shift-2`"),
    ];
    for (model, words, message, remedy) in cases {
        let answer = place.fem(&[&["add", *model], *words, &["-o", "new.toml", "--force"]].concat());
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

/// Every run has a mean of its own taken out, and costs a degree of freedom; the squares are added up here.
#[test]
fn free_zeros_are_taken_out_exactly() {
    let place = place();
    let rows: Vec<Vec<f64>> = model("zeros/measured.csv")
        .lines()
        .filter(|line| !line.starts_with('#'))
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap_or(0.0)).collect())
        .collect();
    let mut square = 0.0;
    for run in 1..=5 {
        let own: Vec<f64> = rows.iter().filter(|row| row[0] == f64::from(run)).map(|row| row[4]).collect();
        let mean = own.iter().sum::<f64>() / own.len() as f64;
        square += own.iter().map(|y| ((y - mean) / 0.5).powi(2)).sum::<f64>();
    }
    for size in ["free", "1 m"] {
        assert_eq!(
            place
                .fem(&["add", AXIS, "zero-shift", "by=run", &format!("size={size}"), "-o", "new.toml", "--force"])
                .status,
            0
        );
        let compared = parsed(&place.fem(&["compare", "new.toml", "--with", DATA, "--json"]).out);
        let freedom = if size == "free" { 85.0 } else { 90.0 };
        let found = compared["models"][0]["chi2_per_dof"].as_f64().unwrap();
        assert!((found * freedom / square - 1.0).abs() < 1e-6, "{size}: {found}");
    }
}

#[test]
fn a_fit_writes_the_sizes_that_it_finds() {
    let place = place();
    let tables = "[measurement.zero-shift]\nby = \"run\"\nsize = \"? nm\" # of the datum\n[measurement.outliers]\nrows = \"38, 71\"\n";
    let left_out = "[measurement.zero-shift-2]\nby = \"direction\"\n";
    place.write("open.toml", format!("{}\n{tables}{left_out}", model("zeros/axis.toml")));
    let answer = place.fem(&["fit", "open.toml", "--with", DATA, "--json", "--add-to", "fitted.toml"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let sizes = parsed(&answer.out)["sizes"].clone();
    let names: Vec<&str> = sizes.as_array().unwrap().iter().map(|s| s["parameter"].as_str().unwrap()).collect();
    assert_eq!(names, ["measurement.zero-shift.size", "measurement.zero-shift-2.size"]);
    let value = |i: usize| sizes[i]["value"].as_f64().unwrap();
    let fitted = place.read("fitted.toml");
    assert!(fitted.contains(&format!("size = \"{:.1} nm\" # of the datum", 1e3 * value(0))), "{fitted}");
    assert!(
        fitted.contains(&format!("[measurement.zero-shift-2]\nby = \"direction\"\nsize = \"{:.4} um\"\n", value(1))),
        "{fitted}"
    );
    // What was written is what a second look finds, and nothing is left to fit.
    let again = parsed(&place.fem(&["compare", "fitted.toml", "--with", DATA, "--json"]).out);
    let first = parsed(&place.fem(&["compare", "open.toml", "--with", DATA, "--json"]).out);
    let [again, first] = [again, first].map(|c| c["models"][0]["chi2_per_dof"].as_f64().unwrap());
    assert!((again / first - 1.0).abs() < 1e-3, "{again} {first}");
    let nothing = place.fem(&["fit", "fitted.toml", "--with", DATA]);
    assert!(nothing.status == 2 && nothing.err.contains("nothing to fit"), "{}", nothing.err);
    let told = place.fem(&["fit", "open.toml", "--with", DATA]).out;
    assert!(told.contains("measurement.zero-shift.size "), "{told}");
}

/// The readings are those of the model itself, 3 % too large and half a minute late.
#[test]
fn gain_and_clock_are_fitted_as_parameters() {
    let place = Place::new();
    let rod = "process = \"thermal\"\nbody = { material = \"steel\", segments = [{ length = \"200 mm\", diameter = \"20 mm\" }] }\n\
        source = [{ at = \"200 mm\", power = \"15 W\", on = [[\"0 min\", \"90 min\"]] }]\nenvironment = { temperature = \"20 degC\" }\ntime = { end = \"60 min\", step = \"30 s\" }\n";
    place.write("true.toml", format!("{rod}measurement.gain.factor = 1.03\nmeasurement.clock.delay = \"30 s\"\n"));
    place.write("open.toml", format!("{rod}measurement.gain.factor = \"?\"\nmeasurement.clock.delay = \"? s\"\n"));
    let rows = |shown: &[f64]| -> String {
        let row = |(i, y): (usize, &f64)| format!("{},150,{y:.6},0.01\n", 2 * i + 2);
        "time [min],x [mm],temperature [degC],u [K]\n".to_string()
            + &shown.iter().enumerate().map(row).collect::<String>()
    };
    place.write(DATA, rows(&[0.0; 25]));
    place.fem(&["compare", "true.toml", "--with", DATA, "-o", "out"]);
    let residuals = place.read("out/residuals.csv");
    let predicted: Vec<f64> =
        residuals.lines().skip(1).map(|line| line.split(',').nth(4).unwrap().parse().unwrap()).collect();
    place.write(DATA, rows(&predicted));
    let answer = place.fem(&["fit", "open.toml", "--with", DATA, "--json", "--add-to", "fitted.toml"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let found = parsed(&answer.out)["parameters"].clone();
    assert!((found[0]["value"].as_f64().unwrap() - 1.03).abs() < 1e-4, "{found}");
    assert!((found[1]["value"].as_f64().unwrap() - 30.0).abs() < 0.1, "{found}");
    assert!(place.read("fitted.toml").contains("measurement.gain.factor = \"1.0"), "{}", place.read("fitted.toml"));
    let unsaid = place.fem(&["compare", "open.toml", "--with", DATA]);
    assert!(unsaid.status == 2 && unsaid.err.contains("`measurement.gain.factor` is unknown"), "{}", unsaid.err);
    // A shaft in a fixture has no time that could be late.
    place.write("part.toml", format!("{}\n[measurement.clock]\ndelay = \"1 s\"\n", model("stiffness.toml")));
    let refused = place.fem(&["run", "part.toml"]);
    assert!(refused.status == 2 && refused.err.contains("has a time"), "{}", refused.err);
}

#[test]
fn a_covariance_takes_the_place_of_the_uncertainties() {
    let place = Place::new();
    let base = model("stiffness.toml");
    place.write("plain.toml", &base);
    let rows = "force [N],displacement [um],u [um]\n100,1.5,2\n200,2,2\n300,5,2\n";
    place.write(DATA, rows);
    place.write("new.toml", format!("{base}\n[measurement.covariance]\nfile = \"v.csv\"\nunit = \"um\"\n"));
    let chi2 = |model: &str| {
        let answer = place.fem(&["compare", model, "--with", DATA, "--json"]);
        assert_eq!(answer.status, 0, "{}", answer.err);
        let compared = parsed(&answer.out);
        (compared["models"][0]["chi2_per_dof"].as_f64().unwrap(), compared["noise"]["source"].clone())
    };
    // The same as the column u; four times it in 0.5 um; the pairs alone.
    let (plain, _) = chi2("plain.toml");
    for (v, factor) in [
        ("# mine\n4,0,0\n0,4,0\n0,0,4\n", 1.0),
        ("16,0,0\n0,16,0\n0,0,16\n", 0.25),
        ("row,column,covariance\n1,1,4\n2,2,4\n3,3,4\n", 1.0),
    ] {
        place.write("v.csv", v);
        let (found, source) = chi2("new.toml");
        assert!((found / plain - factor).abs() < 1e-9, "{v}: {found} {plain}");
        assert_eq!(source, json!("covariance"));
    }
    for (v, message, remedy) in [
        ("4,1,0\n0,4,0\n0,0,4\n", "not symmetric: 0 of rows 2 and 1, 1 of 1 and 2", "the same number"),
        ("1,2,0\n2,1,0\n0,0,1\n", "not positive definite", "check signs"),
        ("4,0\n0,4\n", "covariance of 2 rows, and measured.csv has 3", "one row and one column"),
        ("4,0,0\n0,4\n0,0,4\n", "line 2 has 2 numbers", "square"),
        ("4,0,0\n0,x,0\n0,0,4\n", "line 2: `x`", "number"),
        ("row,column,covariance\n1,1,4\n0,2,4\n", "line 3: `0` is no row", "counted from 1"),
        ("row,column,covariance\n1,1,4\n1,1,4\n", "line 3: the entry of rows 1 and 1 stands twice", "keep one"),
    ] {
        place.write("v.csv", v);
        let answer = place.fem(&["compare", "new.toml", "--with", DATA]);
        let told = answer.err.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(answer.status == 2 && told.contains(message) && told.contains(remedy), "{v}: {}", answer.err);
    }
}

#[test]
fn what_cannot_be_meant_in_a_file_is_cautioned() {
    let place = place();
    let plain =
        "run,position [mm],direction,deviation [um]\n1,10,+,1\n1,20,+,2\n1,30,+,1\n1,40,+,0\n1,50,+,2\n1,60,+,1\n";
    place.write("plain.csv", plain);
    for (table, file, caution) in [
        ("outliers]\nrows = \"1, 2\"", "plain.csv", "weighs down 2 of 6 rows: more than a fifth"),
        ("zero-shift]\nby = \"run\"\nsize = \"1 um\"", "plain.csv", "one zero: they are all of one group"),
        ("zero-shift]\nby = \"time\"\nsize = \"1 um\"", "plain.csv", "one zero: plain.csv has no column `time`"),
        ("correlated-noise]\nlength = 500", DATA, "has a length beyond the 90 rows"),
        ("uncertainty-scale]\nfactor = 2", "plain.csv", "has no effect: plain.csv has no column u"),
        ("clock]\ndelay = \"1 min\"", "plain.csv", "has no effect: plain.csv has no column of times"),
        ("jump]\nfrom = 1\nsize = \"1 um\"", "plain.csv", "gives all rows one zero"),
        (
            "alignment]\nalong = \"time\"\noffset = \"0 um\"\nslope = \"1 um\"",
            "plain.csv",
            "nothing in plain.csv differs",
        ),
    ] {
        place.write("new.toml", format!("{}\n[measurement.{table}\n", model("zeros/axis.toml")));
        for command in ["compare", "diagnose"] {
            let answer = place.fem(&[command, "new.toml", "--with", file]);
            assert!(answer.status == 0 && answer.out.contains(caution), "{table}: {}{}", answer.out, answer.err);
            let json = parsed(&place.fem(&[command, "new.toml", "--with", file, "--json"]).out);
            let own = if command == "compare" { &json["models"][0]["cautions"] } else { &json["cautions"] };
            assert!(own[0].as_str().unwrap().contains(caution), "{own}");
        }
    }
}

#[test]
fn plans_and_compensations_say_what_is_at_work() {
    let place = place();
    let tables = "[measurement.zero-shift]\nby = \"run\"\nsize = \"1 um\"\n[measurement.drift]\n[measurement.outliers]\nrows = \"38, 71\"\n";
    place.write("new.toml", format!("{}\n{tables}", model("zeros/axis.toml")));
    let planned = place.fem(&["plan", "new.toml"]).out;
    assert!(planned.contains("new.toml has, of the measurement: zero-shift by run, size 1.000 um\n"), "{planned}");
    assert!(!planned.contains("drift left aside") && !planned.contains("outliers"), "{planned}");
    let compensated = place.fem(&["compensate", "new.toml", "--with", DATA]).out;
    for said in [
        "zero-shift by run, size 1.000 um; drift, size estimated; outliers, 2 rows",
        "line 41 ",
        "the model weighs it down",
    ] {
        assert!(compensated.contains(said), "{compensated}");
    }
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
        for effect in fem::noise::effects::all() {
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
        let answer =
            place.fem(&["diagnose", "model.toml", "--with", DATA, "--json", "--add-to", "better.toml", "--force"]);
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
    let short = place.fem(&["diagnose", AXIS, "--with", DATA, "-o", "out"]).out;
    let short = short.split("\nwritten").next().unwrap();
    assert!(short.contains("outliers: lines 41, 74;") && short.lines().count() <= 25, "{short}");
    let told = place.fem(&["diagnose", AXIS, "--with", DATA, "--verbose"]).out;
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
    a_finding_tells_what_it_does_to_the_rows(&parsed(&place.read("out/diagnosis.json")));
}

/// Play moves the rows by its gap; rows that are wrong by themselves move no other.
fn a_finding_tells_what_it_does_to_the_rows(found: &Json) {
    let missing = |name: &str| found["missing"].as_array().unwrap().iter().find(|m| m["effect"] == name).unwrap();
    let change = |name: &str| missing(name)["largest_change"]["value"].as_f64();
    let gap = missing("backlash")["parameters"]["gap"]["value"].as_f64().unwrap();
    assert!((change("backlash").unwrap() / gap - 1.0).abs() < 1e-9, "{found}");
    assert!(change("zero-shift").is_some_and(|by| by > 0.0) && change("outliers").is_none(), "{found}");
}

/// Every part is 0.6 um larger than the one before it, and the rows stand in the order in which they were taken:
/// the tool wears, or the zero of the instrument drifts.
#[test]
fn a_trend_over_the_parts_is_a_wear_or_a_drift() {
    let place = Place::new();
    let shaft = "process = \"turning\"\nworkpiece = { material = \"steel\", segments = [{ length = \"200 mm\", diameter = \"60 mm\" }] }\n\
        workholding = { type = \"centres\" }\ncut = { depth = \"0.5 mm\", feed = \"0.2 mm/rev\", spindle_speed = \"600 rpm\", radial_force = \"1 N\" }\nbatch = { parts = 40 }\n\
        effects.setting-error.offset = \"? um\"\n";
    place.write("shaft.toml", shaft);
    let mut rows = "part,x [mm],diameter_error [um],u [um]\n".to_string();
    let mut state = 1u32;
    for part in 1..=40 {
        // Twelve even numbers of a congruential generator (Numerical Recipes), less their mean, are nearly normal.
        let mut even = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(state) / f64::from(u32::MAX)
        };
        let noise = (0..12).map(|_| even()).sum::<f64>() - 6.0;
        rows.push_str(&format!("{part},100,{:.3},0.3\n", 0.3 * f64::from(part) + 0.3 * noise));
    }
    place.write(DATA, rows);
    let found = parsed(&place.fem(&["diagnose", "shaft.toml", "--with", DATA, "--json"]).out);
    let cause = &found["missing"][0];
    let others = cause["indistinguishable_from"].as_array().unwrap().iter().map(|o| o.as_str().unwrap());
    let class: Vec<&str> = others.chain([cause["effect"].as_str().unwrap()]).collect();
    assert!(class.contains(&"drift") && class.contains(&"tool-wear"), "{cause}");
    assert!(!found["next_measurement"].is_null(), "{found}");
    let separated = found["separated_by"].as_array().unwrap();
    assert!(separated.iter().any(|s| s["text"].as_str().unwrap().contains("master")), "{separated:?}");
    let told = place.fem(&["diagnose", "shaft.toml", "--with", DATA, "--verbose"]).out;
    assert!(told.contains("these data cannot tell; in general: ") && told.contains("measure next"), "{told}");
}

/// Steps of 2.5 um are coarse beside the 0.2 um that the column u says.
#[test]
fn a_coarse_step_is_read_off_the_values() {
    let place = Place::new();
    let shaft = "process = \"turning\"\nworkpiece = { material = \"steel\", segments = [{ length = \"600 mm\", diameter = \"30 mm\" }] }\n\
        workholding = { type = \"centres\" }\ncut = { depth = \"0.5 mm\", feed = \"0.2 mm/rev\", spindle_speed = \"600 rpm\", radial_force = \"200 N\" }\n";
    place.write("shaft.toml", shaft);
    let rows = |shown: &dyn Fn(usize) -> f64| -> String {
        // Places that are no multiples of each other, so that the rounding follows nothing.
        let row = |i: usize| format!("1,{:.1},{:.1},0.2\n", 5.0 + (i * 7919 % 5900) as f64 / 10.0, shown(i));
        "part,x [mm],diameter_error [um],u [um]\n".to_string() + &(0..80).map(row).collect::<String>()
    };
    place.write(DATA, rows(&|_| 0.0));
    place.fem(&["compare", "shaft.toml", "--with", DATA, "-o", "out"]);
    let residuals = place.read("out/residuals.csv");
    let predicted: Vec<f64> =
        residuals.lines().skip(1).map(|line| line.split(',').nth(4).unwrap().parse().unwrap()).collect();
    place.write(DATA, rows(&|i| 2.5 * (predicted[i] / 2.5).round()));
    let answer = place.fem(&["diagnose", "shaft.toml", "--with", DATA, "--json", "--add-to", "better.toml"]);
    let found = parsed(&answer.out);
    assert_eq!(found["missing"].as_array().unwrap().len(), 1, "{}", found["missing"]);
    assert_eq!(found["missing"][0]["effect"], json!("resolution"));
    assert!((found["missing"][0]["parameters"]["step"]["value"].as_f64().unwrap() - 2.5).abs() < 1e-9);
    assert!(place.read("better.toml").contains("[measurement.resolution]\nstep = \"2.5000 um\""));
    assert!(place.fem(&["compare", "better.toml", "--with", DATA]).out.contains("adequate"));
    // A fit reads it off too, and writes it.
    place.fem(&["add", "shaft.toml", "resolution", "-o", "open.toml"]);
    place.fem(&["fit", "open.toml", "--with", DATA, "--add-to", "fitted.toml"]);
    assert!(place.read("fitted.toml").contains("step = \"2.5000 um\""), "{}", place.read("fitted.toml"));
}
