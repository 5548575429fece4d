//! Files of instruments and spreadsheets, and several files at once, as a user meets them.

use serde_json::Value as Json;

use super::fem::{Place, model};

/// What cannot be told is asked: (process, the file, options).
const ASKED: &[(&str, &str, &[&str])] = &[
    ("axis", "position [mm];direction;deviation [um]\n10;+;1,5\n20;+;2.5\n", &[]),
    ("axis", "position [mm];direction;deviation [um]\n10;+;1.500,5\n", &[]),
    ("axis", "position [mm];direction;deviation [um]\n10;+;1.5\n", &["--decimal", "comma"]),
    ("axis", "position [mm],direction,deviation [um]\n10,+,1,5\n", &[]),
    ("turning", "x [mm],diameter_error [um],U [um]\n10,1,2\n", &[]),
    ("axis", "Punkt;Gang;Abw\n10;+;1\n", &[]),
    ("axis", "Punkt;Gang;Abw\n10;+;1\n", &["--columns", "Punkt=position [mm],Gang=directoin,Abw=deviation [um]"]),
    ("axis", "Punkt;Gang;Abw\n10;+;1\n", &["--columns", "Platz=position [mm]"]),
    ("axis", "Punkt [um];Gang;Abw\n10;+;1\n", &["--columns", "Punkt=position [mm]"]),
    ("axis", "Punkt;Gang;Abw\n10;+;1\n", &["--columns", "Punkt"]),
    ("axis", "position;direction;deviation [um]\nmm;;mm\n10;+;1\n", &[]),
    ("axis", "position [mm],direction,deviation [um]\n10,sideways,1\n", &[]),
    ("axis", "position [mm],direction,deviation [um],u [um]\n10,+,1,0.5\n,+,1,0.5\n20,+,2,\n", &[]),
    ("axis", "position [mm],direction,deviation [um]\n10,+,\n", &[]),
    ("axis", "position [mm],direction,actual\n10,+,10.001\n", &[]),
    ("thermal", "time,x [m],temperature [degC]\n23:59:00,0,1\n00:01:00,0,1\n", &[]),
    (
        "thermal",
        "time,x [m],temperature [degC]\n2026-03-01T10:00:00,0,1\n2026-03-01T10:00:00Z,0,1\n01.03.2026,0,2\n",
        &[],
    ),
    // The third of January, or the first of March.
    ("thermal", "time,x [m],temperature [degC]\n01/03/2026 10:00,0,1\n", &[]),
    ("axis", "10;+;1.5\n20;+;2.5\n", &[]),
    // Thousands, or a few newtons and a fraction.
    ("stiffness", "force [N];displacement [um]\n800;40\n1.000;52\n1.200;66\n1.400;79\n", &[]),
    // A deviation that counts the other way round.
    ("axis", "position [mm],direction,-deviation [um]\n0,+,1\n50,+,2\n", &[]),
    // A pound is a force or a mass, and other numbers stand behind another unit.
    ("stiffness", "force [lb],displacement [um]\n1,2\n2,3\n", &[]),
    ("stiffness", "force [N],displacement [furlong]\n1,2\n2,3\n", &[]),
    ("contour", "angle [Gdeg],deviation [um]\n0,1\n10,2\n", &[]),
    ("contour", "angle [rad],deviation [um]\n0,1\n10000000,2\n", &[]),
    ("turning", "x [mm],diameter_error [um]\n20,vor\n40,vor\n60,vor\n80,1\n", &[]),
    ("thermal", "time [s],temperature@x=0.1 [degC]\n0,1\n", &[]),
    ("thermal", "time [s],temperature@z=0.1 m [degC]\n0,1\n", &[]),
    ("thermal", "time [s],x [m],temperature@x=0.1 m [degC]\n0,0,1\n", &[]),
    ("thermal", "time [s],temperature@x=1 m [degC],temperature@x=2 m [K]\n0,0,1\n", &[]),
];

#[test]
fn what_cannot_be_told_is_asked() {
    let place = Place::new();
    let mut page = String::new();
    for (process, text, options) in ASKED {
        place.write("data.csv", text);
        let said = ["import", "data.csv", "--process", process, "-o", "own.csv"];
        let answer = place.fem(&[&said[..], options].concat());
        assert_eq!((answer.status, answer.out.as_str()), (2, ""), "{text}: {}", answer.err);
        page.push_str(&format!("{text}{}\n{}\n", options.join(" "), answer.err));
    }
    assert_eq!(place.files(), ["data.csv"]);
    insta::assert_snapshot!("asked", page);
}

/// Forms of shops that are read without a question: (process, the file, what the program's own form begins with).
const READ: &[(&str, &str, &str)] = &[
    // Whatever a column is called, words of a label are that label.
    (
        "stiffness",
        "F [N];s [um];Verlauf\n0;0;Belastung\n500;5;Belastung\n250;3;Entlastung\n",
        "force [N],displacement [um],branch\n0,0,load\n500,5,load\n250,3,unload\n",
    ),
    (
        "axis",
        "Position;Weg;Abweichung\nmm;;µm\n0;positiv;1\n50;positiv;2\n50;negativ;-1\n",
        "position [mm],direction,deviation [µm]\n0,+,1\n50,+,2\n50,-,-1\n",
    ),
    // Units of shops over there, and lines below that sum up.
    (
        "turning",
        "Location (in),Part #,Dia. error (mil)\n1,1,0.5\n2,1,0.6\n1,2,0.7\n2,2,0.4\nMean,,0.55\nStd. Dev.,,0.1\n",
        "x [in],part,diameter_error [in/1000]\n1,1,0.5\n2,1,0.6\n1,2,0.7\n2,2,0.4\n",
    ),
    ("ring", "Nr;RONt [um]\n1;2,5\n2;2,7\n3;2,6\n4;2,4\n5;2,8\n;2,6\n;0,2\n", "RONt [um]\n2.5\n2.7\n2.6\n2.4\n2.8\n"),
    (
        "axis",
        "Messung\tAchse X\nposition [mm]\tdirection\tdeviation [um]\n0\t+\t0,5\n10\t+\t1,5\n20\t-\t2,5\n",
        "position [mm],direction,deviation [um]\n0,+,0.5\n10,+,1.5\n20,-,2.5\n",
    ),
    // Loggers write the date beside the time; a remark is no zone of it.
    (
        "thermal",
        "Datum;Zeit;x [mm];temperature [degC];Urteil\n01.03.2026;23:59:00;10;20;\u{5408}\n02.03.2026;00:01:00;10;21;+\u{5408}\n",
        "time [s],x [mm],temperature [degC]\n0,10,20\n120,10,21\n",
    ),
    (
        "rotary",
        "angle [deg],direction,actual_angle [deg]\n0,+,359.999\n90,+,90.001\n",
        "angle [deg],direction,deviation [deg]\n0,+,-0.001\n90,+,0.001\n",
    ),
    (
        "thermal",
        "time,x [mm],temperature [degC]\n23:30:00,10,20\n24:30:00,10,21\n",
        "time [s],x [mm],temperature [degC]\n0,10,20\n3600,10,21\n",
    ),
];

#[test]
fn forms_of_shops_are_read() {
    let place = Place::new();
    for (process, text, own) in READ {
        place.write("data.csv", text);
        let columns: &[&str] = match *process {
            "stiffness" => &["--columns", "F=force,s=displacement"],
            "turning" => &["--columns", "Dia. error=diameter_error"],
            _ => &[],
        };
        let answer = place
            .fem(&[&["import", "data.csv", "--process", process, "-o", "own.csv", "--force"][..], columns].concat());
        assert_eq!(answer.status, 0, "{text}: {}", answer.err);
        assert!(place.read("own.csv").contains(own), "{text}{}{}", answer.out, place.read("own.csv"));
    }
}

/// A part that was measured in inches among others in millimetres is no shift of its zero.
#[test]
fn a_part_in_other_units_is_asked_about() {
    let place = Place::new();
    place.write("shaft.toml", model("lathe.toml"));
    let diameter = |part: u32| if part == 2 { 50.0 / 25.4 } else { 50.0 };
    let rows = (1..4).flat_map(|part| [200, 300, 400].map(|x| format!("{x},{part},{:.4}\n", diameter(part))));
    place.write("m.csv", format!("x [mm],part,diameter [mm]\n{}", rows.collect::<String>()));
    let answer = place.fem(&["compare", "shaft.toml", "--with", "m.csv"]);
    assert!(answer.status == 2 && answer.err.contains("as if they are in inches"), "{}", answer.err);
}

/// Where an axis stands is no deviation of it.
#[test]
fn actual_values_that_are_taken_for_differences_are_asked_about() {
    let place = Place::new();
    place.write("axis.toml", model("axis.toml"));
    let rows = [0, 100, 200].map(|at| format!("{at},+,{at}.004\n{at},-,{at}.012\n"));
    place.write("m.csv", format!("position [mm],direction,deviation [mm]\n{}", rows.concat()));
    let answer = place.fem(&["compare", "axis.toml", "--with", "m.csv"]);
    assert!(answer.status == 2 && answer.err.contains("they are actual values"), "{}", answer.err);
}

/// A file as it is read, before anything is done with it: understood, half understood and not at all.
#[test]
fn a_file_is_looked_at_first() {
    let place = Place::new();
    place.write(
        "known.csv",
        "Bericht 12\nDatum;2026-03-01\n\nWinkel [Grad];Abweichung [µm];Prüfer\n0;1,5;M\u{fc}ller\n10;-2,5;Klein\n",
    );
    place.write("half.csv", "Punkt;Richtung;Wert\n10;vor;1.5\n20;vor;2.5\n30;vor;1.0\n");
    place.write("numbers.csv", "10;20.5\n20;21.5\n30;22\n");
    let look = |args: &[&str]| {
        let answer = place.fem(&[&["import"], args].concat());
        assert_eq!((answer.status, answer.err.as_str()), (0, ""));
        format!("$ fem import {}\n{}\n", args.join(" "), answer.out)
    };
    let page = [
        look(&["known.csv"]),
        look(&["half.csv", "--process", "axis"]),
        look(&["half.csv", "--process", "axis", "--columns", "Punkt=position [mm],Wert=deviation [um]"]),
        look(&["numbers.csv"]),
        look(&["half.csv", "--process", "axis", "--json"]),
    ];
    insta::assert_snapshot!("looked_at", page.concat());
    assert_eq!(place.files(), ["half.csv", "known.csv", "numbers.csv"]);
}

/// What was said once stands in the model, and every command reads it; a file in the program's own form is read as ever.
#[test]
fn a_model_keeps_how_its_files_are_read() {
    let place = Place::new();
    place.write("axis.toml", model("zeros/axis.toml"));
    place.write("raw.csv", "Ort;Weg;Wert\n0;vor;0,5\n250;vor;1,5\n250;zur\u{fc}ck;-1,5\n0;zur\u{fc}ck;1,0\n");
    let columns = ["--columns", "Ort=position [mm],Weg=direction,Wert=deviation [um]"];
    let keep = ["import", "raw.csv", "--model", "axis.toml", "--keep", "kept.toml"];
    let kept = place.fem(&[&keep[..], &columns].concat());
    assert_eq!(kept.status, 0, "{}", kept.err);
    let said = place.fem(&["compare", "axis.toml", "--with", "raw.csv", columns[0], columns[1]]);
    let silent = place.fem(&["compare", "kept.toml", "--with", "raw.csv"]);
    assert_eq!(silent.out.replace("kept", "axis"), said.out, "{}", silent.err);
    // A workbook's mark and a header line are for files that need them.
    place.write("own.csv", "position [mm],direction,deviation [um]\n0,+,0.5\n250,+,1.5\n250,-,-1.5\n0,-,1.0\n");
    let own = place.fem(&["compare", "kept.toml", "--with", "own.csv"]);
    assert_eq!(own.out.replace("own.csv", "raw.csv"), silent.out, "{}", own.err);
    assert!(place.read("kept.toml").contains("[data]\ncolumns = \"Ort=position [mm]"), "{}", place.read("kept.toml"));
    let wrong = place.read("kept.toml").replace("columns", "colums");
    place.write("wrong.toml", wrong);
    let wrong = place.fem(&["compare", "wrong.toml", "--with", "raw.csv"]);
    assert!(wrong.status == 2 && wrong.err.contains("wrong.toml"), "{}", wrong.err);
}

/// What is imported is read as the file itself was.
#[test]
fn an_import_is_the_same_in_the_programs_own_form() {
    let place = Place::new();
    let text = "\u{feff}Position;Richtung;Run;Deviation;Bemerkung\nmm;;;um;\n0;forward;1;0,5;ja\n250;forward;1;;\n\
                250;backward;1;-1,5;\n0;backward;1;1,0;\n";
    place.write("axis.toml", model("zeros/axis.toml"));
    place.write("raw.csv", text);
    let columns = ["--columns", "Richtung=direction"];
    let answer = place.fem(&[&["import", "raw.csv", "--process", "axis", "-o", "own.csv"][..], &columns].concat());
    assert_eq!(answer.status, 0, "{}", answer.err);
    insta::assert_snapshot!("imported", format!("{}\n{}\n{}", answer.out, answer.err, place.read("own.csv")));
    let compare = |data: &[&str]| {
        let answer = place.fem(&[&["compare", "axis.toml", "--json"], data].concat());
        let mut json: Json = serde_json::from_str(&answer.out).unwrap();
        // Names, notes and lines are those of the file, and so is what was left out of it.
        for key in ["data", "files", "notes"] {
            json[key] = Json::Null;
        }
        json["models"][0]["worst"] = Json::Null;
        json
    };
    assert_eq!(compare(&["--with", "raw.csv", columns[0], columns[1]]), compare(&["--with", "own.csv"]));
    let onto = place.fem(&[&["import", "raw.csv", "--process", "axis", "-o", "raw.csv"][..], &columns].concat());
    assert_eq!(onto.status, 2, "{}", onto.err);
    let unknown = place.fem(&["import", "raw.csv", "--process", "axes", "-o", "own.csv"]);
    assert!(unknown.status == 2 && unknown.err.contains("did you mean `axis`?"), "{}", unknown.err);
}

/// A positioning test in two files, of which the second was zeroed 8 um higher.
fn two_files(place: &Place) {
    place.write("axis.toml", model("zeros/axis.toml"));
    let row = |i: i32| (f64::from(i % 10) * 40.0, if i % 20 < 10 { '+' } else { '-' }, 0.3 * f64::from(i * 7 % 11 - 5));
    let mut first = String::from("position [mm],direction,deviation [um],u [um]\n");
    let mut second = String::from("# the second\nu [nm];position [m];deviation [um];direction\n");
    for i in 0..40 {
        let (position, direction, deviation) = row(i);
        first.push_str(&format!("{position},{direction},{deviation:.2},1\n"));
        second.push_str(&format!("1000;{};{:.2};{direction}\n", position / 1000.0, deviation + 8.0));
    }
    place.write("a.csv", first);
    place.write("b.csv", second.replace("8.0", "8,0").replace('.', ","));
}

const BOTH: [&str; 4] = ["--with", "a.csv", "--with", "b.csv"];

#[test]
fn files_stand_together_and_each_row_knows_its_own() {
    let place = Place::new();
    two_files(&place);
    let answer = place.fem(&[&["compare", "axis.toml", "--json", "-o", "out"][..], &BOTH].concat());
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert!(answer.err.contains("note: b.csv: how it was read: columns parted by semicolons"), "{}", answer.err);
    let json: Json = serde_json::from_str(&answer.out).unwrap();
    assert_eq!((json["observations"].as_u64(), json["data"].as_str()), (Some(80), Some("a.csv, b.csv")));
    assert_eq!(json["files"], serde_json::json!(["a.csv", "b.csv"]));
    let worst = &json["models"][0]["worst"];
    assert_eq!(worst["file"], "b.csv");
    // A comment and the header stand above the rows of the second file, and forty rows before them.
    assert_eq!(worst["line"].as_u64().unwrap() + 40, worst["row"].as_u64().unwrap() + 2);
    assert!(place.fem(&[&["compare", "axis.toml"][..], &BOTH].concat()).out.contains(" of b.csv ("));
    let residuals = place.read("out/residuals.csv");
    let lines: Vec<&str> = residuals.lines().collect();
    let header = "file,position [mm],direction,deviation [um],u [um],predicted [um],residual [um]";
    assert_eq!((lines.len(), lines[0]), (81, header));
    assert!(lines[1].starts_with("a.csv,0,+,-1.5") && lines[42].starts_with("b.csv,40,+,8.60,1,"), "{residuals}");
}

#[test]
fn a_zero_of_each_file_is_named() {
    let place = Place::new();
    two_files(&place);
    let with = [&["diagnose", "axis.toml", "--json", "--add-to", "better.toml"][..], &BOTH].concat();
    let answer = place.fem(&with);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let json: Json = serde_json::from_str(&answer.out).unwrap();
    let missing = json["missing"].as_array().unwrap();
    let names: Vec<(&Json, &Json)> = missing.iter().map(|m| (&m["effect"], &m["by"])).collect();
    assert_eq!(names, [(&Json::from("zero-shift"), &serde_json::json!(["file"]))], "{}", answer.out);
    assert!(place.read("better.toml").contains("[measurement.zero-shift]\nby = \"file\"\n"));
    let compared = place.fem(&[&["compare", "better.toml"][..], &BOTH].concat());
    assert!(compared.out.contains("zero-shift by file"), "{}", compared.out);
}

#[test]
fn rows_are_counted_through_all_files_or_in_one() {
    let place = Place::new();
    two_files(&place);
    let rows = |table: &str| {
        place.write("with.toml", format!("{}\n[measurement.outliers]\n{table}\n", model("zeros/axis.toml")));
        let answer = place.fem(&[&["compare", "with.toml", "--json"][..], &BOTH].concat());
        serde_json::from_str::<Json>(&answer.out)
            .map(|json| json["measurement"][0]["rows"].clone())
            .map_err(|_| answer.err)
    };
    assert_eq!(rows("rows = \"43, 45\""), Ok(serde_json::json!([43, 45])));
    assert_eq!(rows("rows = \"3, 5\"\nfile = \"b.csv\""), Ok(serde_json::json!([43, 45])));
    assert_eq!(rows("rows = \"3, 5\"\nfile = \"a.csv\""), Ok(serde_json::json!([3, 5])));
    assert!(rows("rows = \"43\"\nfile = \"a.csv\"").unwrap_err().contains("a.csv has no such row"));
    assert!(rows("rows = \"43\"\nfile = \"c.csv\"").unwrap_err().contains("no file has this name"));
    assert!(rows("rows = \"81\"").unwrap_err().contains("names row 81"));
}

#[test]
fn files_that_cannot_stand_together_are_refused() {
    let place = Place::new();
    two_files(&place);
    place.write("lathe.toml", model("lathe.toml"));
    place.write("bare.csv", "position [mm],direction,deviation [um]\n0,+,1\n");
    place.write("beyond.csv", "position [mm],direction,deviation [um],u [um]\n0,+,1,1\n9000,+,1,1\n");
    place.write("error.csv", "x [mm],diameter_error [um]\n10,1\n");
    place.write("diameter.csv", "x [mm],diameter [mm]\n10,40\n");
    for (model, files, told) in [
        ("axis.toml", ["a.csv", "a.csv"], "a.csv is named twice"),
        ("axis.toml", ["a.csv", "./a.csv"], "./a.csv is named twice"),
        ("axis.toml", ["a.csv", "bare.csv"], "a.csv has a column u, and bare.csv has none"),
        ("axis.toml", ["a.csv", "beyond.csv"], "line 3 of beyond.csv: the axis travels"),
        (
            "lathe.toml",
            ["error.csv", "diameter.csv"],
            "error.csv holds `diameter_error`, and diameter.csv holds `diameter`",
        ),
        ("axis.toml", ["a.csv", "gone.csv"], "gone.csv"),
    ] {
        let answer = place.fem(&["compare", model, "--with", files[0], "--with", files[1]]);
        let page = answer.err.split_whitespace().filter(|word| *word != "│").collect::<Vec<_>>().join(" ");
        assert!(answer.status == 2 && page.contains(told), "{files:?}: {}", answer.err);
    }
    let mistyped = [&["compare", "axis.toml", "--columns", "Ort=position"][..], &BOTH].concat();
    assert!(place.fem(&mistyped).err.contains("no file has a column `Ort`"));
}

/// Uncertainties that not all files have are left out of those that have them, and each file keeps the columns
/// that it has.
#[test]
fn files_may_differ_in_their_columns() {
    let place = Place::new();
    place.write("axis.toml", model("zeros/axis.toml"));
    place.write("bare.csv", "position [mm],direction,deviation [um]\n0,+,1\n");
    place.write("full.csv", "run,position [mm],direction,deviation [um],u [um],by\n2,0,+,1,1,me\n");
    let with = ["compare", "axis.toml", "--with", "bare.csv", "--with", "full.csv", "--columns", "u=-", "-o", "out"];
    let answer = place.fem(&with);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let header = "file,position [mm],direction,deviation [um],run,by,predicted [um],residual [um]";
    let rows = format!("{header}\nbare.csv,0,+,1,,,-0,1\nfull.csv,0,+,1,2,me,-0,1\n");
    assert_eq!(place.read("out/residuals.csv").replace(",0,1\n", ",-0,1\n"), rows);
}

#[test]
fn processes_name_the_columns_of_their_files() {
    let place = Place::new();
    for process in fem::processes::ALL {
        let name = process.name();
        let started = place.fem(&["new", name]).out;
        let listed = place.fem(&["effects", name]).out;
        let columns = listed.split("columns of its measurement files").nth(1).unwrap();
        let coordinates = process.coordinates().iter().map(|c| &c.name);
        for column in coordinates.chain(process.observables().iter().map(|o| &o.name)) {
            assert!(columns.contains(&format!("\n  {column} ")), "{name}: {column}\n{columns}");
        }
        for line in columns.lines().skip(1) {
            assert!(started.contains(&format!("# {line}\n")), "{name}: {line}\n{started}");
        }
    }
    let columns = |name: &str| place.fem(&["effects", name]).out.split("\n\ncolumns").nth(1).unwrap().to_string();
    insta::assert_snapshot!("columns", ["axis", "thermal", "turning"].map(columns).join("\n"));
}

/// What a report by ISO 230-2 holds is written in the program's own form, with what was taken and what was left.
#[test]
fn a_report_is_imported() {
    let place = Place::new();
    let table = "i |tgt_pos(i) [mm]|ref_pos(i,1) [mm]|\n--- |--- |--- |\n1|0.0|0.0012|\n2|250.0|250.0035|\n";
    let report = |count: usize| {
        format!("# ISO 230-2 motion test\n\nPosition count | {count}\n\n### Data forward direction\n\n{table}")
    };
    place.write("report.md", report(2));
    let command = ["import", "report.md", "--process", "axis", "-o", "own.csv"];
    let answer = place.fem(&command);
    assert_eq!(
        (answer.status, answer.out.as_str()),
        (0, "written own.csv: 2 observations of deviation from report.md\n")
    );
    assert!(answer.err.contains("a report by ISO 230-2") && answer.err.contains("no table backward"), "{}", answer.err);
    let rows = "run,position [mm],direction,deviation [mm]\n1,0.0,+,0.0012\n1,250.0,+,0.0035\n";
    assert_eq!(place.read("own.csv"), format!("# Taken from report.md.\n{rows}"));
    place.write("report.md", report(3));
    let answer = place.fem(&["import", "report.md", "--process", "axis", "-o", "again.csv"]);
    for words in ["report.md:7", "the table has 2 targets, and the report says 3", "has the file been cut off?"] {
        assert!(answer.status == 2 && answer.err.contains(words), "{words}: {}", answer.err);
    }
}

/// A shop's own heading of a diameter that was measured, beside the one that was asked for.
#[test]
fn a_measured_diameter_is_known_by_its_sign() {
    let place = Place::new();
    place.write("messung.csv", "Prüfprotokoll;Drehmaschine 4\n;\nTeil Nr.;x [mm];Ist-Ø [mm];Soll-Ø [mm]\n1;10,0;50,012;50,000\n1;99,5;50,016;50,000\n");
    let answer = place.fem(&["import", "messung.csv", "--process", "turning", "-o", "taken.csv"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert!(place.read("taken.csv").contains("1,99.5,50.016"), "{}", place.read("taken.csv"));
}

#[test]
fn columns_that_are_not_written_are_told() {
    let place = Place::new();
    let rows: String = [20.1, 22.3, 19.7, 21.1, 23.9, 20.2]
        .iter()
        .enumerate()
        .map(|(i, coolant)| format!("1,{},300,3{i},1,{coolant}\n", 40 * (i + 1)))
        .collect();
    place.write("m.csv", format!("part,x [mm],radial_force [N],diameter_error [um],u [um],coolant [degC]\n{rows}"));
    let written = place.fem(&["import", "m.csv", "-o", "own.csv"]);
    assert!(written.status == 0 && written.err.contains("the column `coolant` not written"), "{}", written.err);
    assert!(!place.read("own.csv").contains("coolant"));
}

#[test]
fn headings_beyond_the_end_of_a_file_are_refused() {
    let place = Place::new();
    place.write("m.csv", "part,x [mm],diameter_error [um]\n1,20,3\n1,40,4\n");
    let args = ["import", "m.csv", "--process", "turning", "--header", "99", "-o", "own.csv"];
    place.is_refused(&args, "line 99", ("cannot stand in line 99: there are 3 lines", "--header 0 where none has"));
}

#[test]
fn a_minus_may_stand_behind_its_number() {
    let place = Place::new();
    place.write(
        "m.csv",
        "part;x [mm];diameter_error [um]\n1;20;5,1-\n1;60;7,2\n1;100;3,3-\n1;140;2,1\n1;180;0,5-\n1;220;9,9\n",
    );
    let written = place.fem(&["import", "m.csv", "--process", "turning", "-o", "own.csv"]);
    assert!(written.status == 0 && written.err.contains("the minus of `5,1-`"), "{}", written.err);
    assert_eq!(place.column("own.csv", "diameter_error"), [-5.1, 7.2, -3.3, 2.1, -0.5, 9.9]);
}

#[test]
fn angles_may_have_minutes_and_seconds() {
    let place = Place::new();
    let rows = "0°0'0\",1,+,1\n30°15'36\",2,+,1\n60°30',3,+,1\n90°0'18\",2,+,1\n";
    place.write("m.csv", format!("angle,deviation [arcsec],direction,run\n{rows}"));
    let written = place.fem(&["import", "m.csv", "--process", "rotary", "-o", "own.csv"]);
    assert!(written.status == 0 && written.err.contains("`angle` in degrees, minutes and seconds"), "{}", written.err);
    assert_eq!(place.column("own.csv", "angle"), [0.0, 30.26, 60.5, 90.005]);
}
