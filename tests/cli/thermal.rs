//! Heated bodies as a user meets them: summary, two observables in one file, plates, meshes from files, bad
//! input.

use super::fem::{Mistake, Place, model};

#[test]
fn the_summary_of_the_rod_and_of_the_plate() {
    let place = Place::new();
    for name in ["thermal", "ground-plate"] {
        place.write("model.toml", model(&format!("{name}.toml")));
        let answer = place.fem(&["run", "model.toml"]);
        assert_eq!((answer.status, answer.err.as_str()), (0, ""));
        insta::assert_snapshot!(format!("summary_of_{name}"), answer.out);
    }
    insta::assert_snapshot!("effects_thermal", place.fem(&["effects", "thermal"]).out);
    // What came in is lost or stored, but for rounding.
    let summary: serde_json::Value = serde_json::from_str(&place.read("out/model/summary.json")).unwrap();
    assert!(summary["findings"]["energy"]["imbalance"].as_f64().unwrap().abs() < 1e-11);
}

#[test]
fn a_profile_is_a_measurement_of_its_own_model() {
    let place = Place::new();
    for name in ["thermal", "ground-plate"] {
        place.write("model.toml", model(&format!("{name}.toml")));
        assert_eq!(place.fem(&["run", "model.toml", "-o", "out"]).status, 0);
        let compared = place.fem(&["compare", "model.toml", "--with", "out/profile.csv", "--json", "-o", "c"]);
        let json: serde_json::Value = serde_json::from_str(&compared.out).unwrap();
        for seen in json["models"][0]["observables"].as_array().unwrap() {
            assert!(seen["rms"].as_f64().unwrap() < 1e-9, "{name}: {seen}");
        }
        assert_eq!(json["noise"]["unit"], "sigma");
        let header = place.read("c/residuals.csv").lines().next().unwrap().to_string();
        assert!(header.ends_with(
            "predicted_temperature [degC],residual_temperature [K],predicted_elongation [um],residual_elongation [um]"
        ) || header.ends_with("predicted_elongation [um],residual_elongation [um]"), "{header}");
    }
}

const PLATE: &str = "process = \"thermal\"\n[body]\n\
    material = { youngs_modulus = \"210 GPa\", poisson_ratio = 0.3, density = \"7850 kg/m^3\", \
    expansion = \"11.5e-6 /K\", conductivity = \"50 W/m/K\", specific_heat = \"470 J/kg/K\" }\n\
    rectangle = { length = \"80 mm\", height = \"36 mm\", width = \"12 mm\" }\n\
    [environment]\ntemperature = \"20 degC\"\n[mesh]\nelement_size = \"5 mm\"\n\
    [effects.base-conductance]\nconductance = \"0.3 W/K\"\n";

/// Predictions of some rows of the plate with these tables besides, degC.
fn plate(tables: &str, rows: &[&str]) -> Vec<f64> {
    let place = Place::new();
    place.write("plate.toml", format!("{PLATE}{tables}"));
    let lines: String = rows.iter().map(|row| format!("{row},30\n")).collect();
    place.write("m.csv", format!("time [min],x [mm],y [mm],temperature [degC]\n{lines}"));
    let answer = place.fem(&["compare", "plate.toml", "--with", "m.csv", "-o", "c"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let predicted = |line: &str| line.split(',').nth(4).unwrap().parse().unwrap();
    place.read("c/residuals.csv").lines().skip(1).map(predicted).collect()
}

/// In the long run T = 20 degC + P/G + P·min(x, at)/(k·A): straight up to the section where the heat comes in, wherever
/// elements would end.
#[test]
fn a_plate_has_a_border_of_elements_where_heat_comes_in() {
    let tables =
        "[effects.extra-source]\nat = \"52.5 mm\"\npower = \"2 W\"\n[time]\nend = \"400 min\"\nstep = \"60 s\"\n";
    let rows = ["400,40,15", "400,51,15", "400,52.5,15", "400,60,15"];
    for (temperature, x) in plate(tables, &rows).into_iter().zip([40.0, 51.0, 52.5, 52.5]) {
        let expected = 20.0 + 2.0 / 0.3 + 2.0 * 1e-3 * x / (50.0 * 36e-3 * 12e-3);
        assert!((temperature - expected).abs() < 1e-6, "x = {x} mm: {temperature}, not {expected}");
    }
}

/// Six seconds after a flux stops, at the edge that it heated, the programme of the model does not look.
#[test]
fn chosen_steps_keep_their_tolerance_at_the_rows_that_are_measured() {
    for lag in ["", "[effects.sensor-lag]\ntime_constant = \"20 s\"\n"] {
        let heated = |time: &str| {
            let flux = "[[boundary]]\nedge = \"top\"\nflux = \"6 kW/m^2\"\non = [[\"0 min\", \"12.5 min\"]]\n";
            let rows = ["0.5,30,36", "12.6,30,36", "13,30,36"];
            plate(&format!("{flux}{lag}[time]\nend = \"40 min\"\n{time}\n"), &rows)
        };
        let (chosen, fine) = (heated("tolerance = \"0.01 K\""), heated("step = \"0.12 s\""));
        for (chosen, fine) in chosen.iter().zip(&fine) {
            assert!((chosen - fine).abs() < 0.01, "{chosen} and {fine}");
        }
    }
}

#[test]
fn conditions_that_cannot_hold_on_one_edge_are_refused() {
    let held = "[[boundary]]\nedge = \"top\"\ntemperature = \"30 degC\"\n";
    let covered = "[[boundary]]\nedge = \"top\"\nflux = \"6 kW/m^2\"\ncovered = true\n";
    let film = "[[boundary]]\nedge = \"top\"\nconvection = \"10 W/m^2/K\"\n";
    for (edges, wrong, message) in [
        ([held, held], 1, "edge `top` is held at two temperatures"),
        ([covered, film], 0, "edge `top` is covered, and loses"),
        ([film, covered], 1, "edge `top` is covered, and loses"),
    ] {
        let place = Place::new();
        let before = format!("{PLATE}[time]\nend = \"1 min\"\n{}", edges[..wrong].concat());
        let line = 1 + before.lines().count();
        place.write("plate.toml", format!("{before}{}", edges[wrong..].concat()));
        let answer = place.fem(&["run", "plate.toml"]);
        assert!(answer.status == 2 && answer.err.contains(message), "{}", answer.err);
        assert!(answer.err.contains(&format!("plate.toml:{line}:")), "{}", answer.err);
    }
}

/// Temperatures half a kelvin too high with u = 0.25 K, elongations 3 um too low with u = 1 um.
#[test]
fn two_observables_are_judged_each_by_its_own_noise_and_told_together() {
    let place = Place::new();
    place.write("model.toml", model("thermal.toml"));
    assert_eq!(place.fem(&["run", "model.toml", "-o", "out"]).status, 0);
    let mut text =
        String::from("time [min],x [mm],temperature [degC],elongation [um],u_temperature [K],u_elongation [um]\n");
    for line in place.read("out/profile.csv").lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let off = |cell: &str, by: f64| cell.parse::<f64>().map_or(String::new(), |v| (v + by).to_string());
        let (warm, grown) = (off(cells[2], 0.5), off(cells[3], -3.0));
        let u = |cell: &str, u: &'static str| if cell.is_empty() { "" } else { u };
        let (warm_u, grown_u) = (u(&warm, "0.25"), u(&grown, "1"));
        text.push_str(&format!("{},{},{warm},{grown},{warm_u},{grown_u}\n", cells[0], cells[1]));
    }
    place.write("m.csv", text);
    let answer = place.fem(&["compare", "model.toml", "--with", "m.csv", "--json", "-o", "c"]);
    let json: serde_json::Value = serde_json::from_str(&answer.out).unwrap();
    let (one, number) = (&json["models"][0], |v: &serde_json::Value| v.as_f64().unwrap());
    assert_eq!((json["noise"]["unit"].as_str(), number(&json["noise"]["sigma"])), (Some("sigma"), 1.0));
    // 270 temperatures off by two sigma, 90 elongations by three.
    assert!((number(&one["rms"]) - ((270.0f64 * 4.0 + 90.0 * 9.0) / 360.0).sqrt()).abs() < 1e-6, "{one}");
    assert!((number(&one["chi2_per_dof"]) - 5.25).abs() < 1e-5);
    assert!((number(&one["observables"][0]["rms"]) - 0.5).abs() < 1e-6);
    assert!((number(&one["observables"][1]["rms"]) - 3.0).abs() < 1e-6);
    let texts: Vec<&str> = one["features"].as_array().unwrap().iter().map(|f| f["text"].as_str().unwrap()).collect();
    for expected in
        ["temperature: the error is off by the same amount", "elongation: the error is off by the same amount"]
    {
        assert!(texts.iter().any(|t| t.starts_with(expected)), "{texts:?}");
    }
    let first = place.read("c/residuals.csv").lines().nth(1).unwrap().to_string();
    assert!(first.contains(",,,"), "what was not observed is empty: {first}");
}

#[test]
fn a_plate_may_come_from_a_file() {
    let place = Place::new();
    std::fs::create_dir(place.path("meshes")).unwrap();
    let mesh = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("meshes/plate.msh");
    std::fs::copy(mesh, place.path("meshes/plate.msh")).unwrap();
    let tables = |body: &str| {
        format!(
            r#"process = "thermal"
            body = {{ material = "steel", {body} }}
            environment = {{ temperature = "20 degC" }}
            time = {{ end = "10 min", step = "10 s" }}
            [[boundary]]
            edge = "top"
            flux = "10 kW/m^2"
            [[boundary]]
            edge = "bottom"
            convection = "200 W/m^2/K"
            "#
        )
    };
    place.write("file.toml", tables("file = \"meshes/plate.msh\", width = \"30 mm\""));
    place.write("own.toml", tables("rectangle = { length = \"200 mm\", height = \"50 mm\", width = \"30 mm\" }"));
    assert_eq!(place.fem(&["run", "own.toml", "-o", "out"]).status, 0);
    let compared = place.fem(&["compare", "file.toml", "--with", "out/profile.csv", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&compared.out).unwrap();
    // Of 30 K and some 40 um: what 6-node triangles of 3 to 8 mm and quadrilaterals of 5 x 12 mm differ by.
    let rms = |i: usize| json["models"][0]["observables"][i]["rms"].as_f64().unwrap();
    assert!(rms(0) < 0.05 && rms(1) < 0.05, "{}", json["models"][0]["observables"]);
}

/// (in the model, replaced by, part of the message, part of the remedy)
const CASES: &[Mistake] = &[
    ("power = \"15 W\"", "power = \"15 mm\"", "not a power", "write it in W"),
    ("at = \"200 mm\"", "at = \"210 mm\"", "the source stands at 210 mm, beyond the body", "the body ends at 200 mm"),
    ("[[\"0 min\", \"90 min\"]]", "[[\"90 min\", \"0 min\"]]", "ends before it begins", "the earlier end first"),
    ("[[\"0 min\", \"90 min\"]]", "[\"0 min\", \"90 min\"]", "an entry of `on` is no interval", "write on = [["),
    (
        "[[\"0 min\", \"90 min\"]]",
        "[[\"0 min\", \"9 min\"], [\"5 min\", \"20 min\"]]",
        "intervals overlap",
        "join them",
    ),
    ("\"20 degC\"", "\"20 mm\"", "not a temperature", "degC"),
    (
        "\"20 degC\"",
        "\"20 degC\"\nsection = [{ from = \"50 mm\", temperature = \"5 degC\", to = \"20 mm\" }]",
        "ends where it begins",
        "give it a length",
    ),
    ("\"20 degC\"", "\"20 degC\"\nsection = [{ from = \"50 mm\" }]", "is not said", "add temperature"),
    (
        "\"20 degC\"",
        "\"20 degC\"\nsection = [{ to = \"300 mm\", temperature = \"5 degC\" }]",
        "300 mm is not on the body",
        "from 0 to 200 mm",
    ),
    (
        "\"20 degC\"",
        "\"20 degC\"\nsection = [{ temperature = \"5 degC\" }, { from = \"50 mm\", temperature = \"9 degC\" }]",
        "sections 1 and 2 are around the same length",
        "where the other begins",
    ),
    (
        "\"20 degC\"",
        "\"20 degC\"\nsection = [{ side = \"bore\", temperature = \"5 degC\", coefficient = \"90 W/m^2/K\" }]",
        "has no bore",
        "give the segment a `bore`",
    ),
    (
        "\"20 degC\"",
        "\"20 degC\"\nsection = [{ side = \"bore\", temperature = \"5 degC\" }]",
        "the film in a bore",
        "add coefficient",
    ),
    ("step = \"30 s\"", "step = \"1 us\"", "more than 200000 steps", "longer steps"),
    ("step = \"30 s\"", "stepp = \"30 s\"", "`stepp` is no key of `time`", "did you mean `step`?"),
    ("\"200 mm\"] #", "\"300 mm\"] #", "300 mm is not on the body", "from 0 to 200 mm"),
    ("diameter = \"20 mm\"", "diameter = \"20 mm\", bore = \"20 mm\"", "as wide as the segment", "below the diameter"),
    (
        "[environment]",
        "[[boundary]]\nedge = \"top\"\nflux = \"1 kW/m^2\"\n[environment]",
        "`top` is no edge",
        "a rod has no edges",
    ),
    (
        "segments = [",
        "rectangle = { length = \"1 m\", height = \"1 m\", width = \"1 m\" }\nsegments = [",
        "a body has one shape",
        "give one of",
    ),
    (
        "[[source]]\nat = \"200 mm\"\npower = \"15 W\"\non = [[\"0 min\", \"90 min\"]]",
        "",
        "nothing heats or cools",
        "add [[source]]",
    ),
    (
        "[effects.convection]\ncoefficient",
        "[effects.convection]\ncoeficient",
        "`coeficient`",
        "did you mean `coefficient`?",
    ),
];

#[test]
fn bad_input_is_told_with_its_remedy() {
    let good = model("thermal.toml");
    let place = Place::new();
    place.refuses(("run", "model.toml"), &good, CASES);
    assert!(!place.files().iter().any(|f| f.starts_with("out")));
}

/// (file, part of the message)
const FILES: &[(&str, &str)] = &[
    ("time [min],x [mm],temperature [degC],elongation [um]\n5,100,,\n", "the file has a header and no rows"),
    ("time [min],x [mm],temperature [degC],elongation [um]\n5,,30,\n", "the cell of `x [mm]` is empty"),
    ("time [min],temperature [degC]\n5,30\n", "the column `x` is missing"),
    (
        "time [min],x [mm],temperature [degC],elongation [um],u [K]\n5,100,30,,0.1\n",
        "`u` does not say of which observable",
    ),
    (
        "time [min],x [mm],temperature [degC],elongation [um],u_temperature [K]\n5,100,30,,0.1\n",
        "`elongation` has no uncertainty",
    ),
    (
        "time [min],elongation [um],u_temperature [K]\n5,3,0.1\n",
        "`u_temperature` is there, but no column `temperature`",
    ),
    ("time [min],x [mm],temperature [degC],u_temperature [K]\n5,100,30,\n", "the cell of `u_temperature [K]` is empty"),
    ("time [min],x [mm],temperature [degC]\n5,300,30\n", "the body reaches from 0 to 200 mm"),
    ("time [min],x [mm],temperature [degC]\n-5,100,30\n", "before the start of the run"),
    ("time [min],x [mm],y [mm],temperature [degC]\n5,100,3,30\n", "it has no y"),
];

#[test]
fn measurements_that_cannot_be_are_refused() {
    let place = Place::new();
    place.write("model.toml", model("thermal.toml"));
    for (file, message) in FILES {
        place.write("m.csv", file);
        let answer = place.fem(&["compare", "model.toml", "--with", "m.csv"]);
        let told = answer.err.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(answer.status, 2, "{file}: {told}");
        assert!(told.contains(message), "{file}: {told}");
    }
    // Elongations alone need no x, and may have one.
    for file in ["time [min],elongation [um]\n5,40\n9,60\n", "time [min],x [mm],elongation [um]\n5,,40\n9,100,60\n"] {
        place.write("m.csv", file);
        assert_eq!(place.fem(&["compare", "model.toml", "--with", "m.csv"]).status, 0, "{file}");
    }
}

#[test]
fn a_step_is_chosen_where_none_is_given() {
    let place = Place::new();
    let text = model("thermal.toml");
    let given = text.lines().filter(|l| !l.starts_with("step =")).collect::<Vec<_>>().join("\n");
    place.write("chosen.toml", &given);
    place.write("fine.toml", text.replace("step = \"30 s\"", "step = \"1 s\""));
    assert_eq!(place.fem(&["run", "fine.toml", "-o", "out"]).status, 0);
    let compared = place.fem(&["compare", "chosen.toml", "--with", "out/profile.csv", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&compared.out).unwrap();
    // What was asked for is 0.01 K, of temperatures.
    let temperatures = json["models"][0]["observables"].as_array().unwrap().iter().find(|o| o["name"] == "temperature");
    assert!(temperatures.unwrap()["rms"].as_f64().unwrap() < 0.01, "{json}");
}

fn findings(place: &Place, text: &str) -> serde_json::Value {
    place.write("m.toml", text);
    let answer = place.fem(&["run", "m.toml", "-o", "o"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let summary: serde_json::Value = serde_json::from_str(&place.read("o/summary.json")).unwrap();
    summary["findings"].clone()
}

/// What is hottest, and when the body is longest, do not depend on where and how often one looks.
#[test]
fn extremes_are_those_of_the_whole_run() {
    let place = Place::new();
    let body = "process = \"thermal\"\nbody = { material = \"steel\", segments = [{ length = \"200 mm\", diameter = \"20 mm\" }] }\n\
                source = [{ at = \"200 mm\", power = \"15 W\", on = [[\"0 min\", \"90 min\"]] }]\n\
                environment = { temperature = \"20 degC\" }\ntime = { end = \"180 min\", step = \"30 s\" }\n\
                effects = { convection = { coefficient = \"12 W/m^2/K\" } }\n";
    let often = findings(&place, &format!("{body}measurement = {{ interval = \"30 s\" }}\n"));
    let once = findings(&place, &format!("{body}measurement = {{ interval = \"180 min\", places = [\"0 mm\"] }}\n"));
    for key in ["largest", "reached", "hottest"] {
        let [a, b] = [&often, &once].map(|f| f[key]["value"].as_f64().unwrap());
        assert!((a - b).abs() <= 1e-9 * a, "{key}: {a} and {b}");
    }
    assert!((once["largest"]["at"].as_f64().unwrap() - 90.0).abs() < 1e-9);
}

/// The error that chosen steps leave, by steps that are ten times shorter and of second order.
#[test]
fn chosen_steps_keep_their_tolerance_of_the_body_as_it_is() {
    let place = Place::new();
    let run = |time: &str| {
        let text = format!(
            "process = \"thermal\"\nbody = {{ material = \"aluminium\", segments = [{{ length = \"100 mm\", diameter = \"20 mm\" }}] }}\n\
             source = [{{ at = \"50 mm\", power = \"5 W\", on = [[\"0 min\", \"30 min\"]] }}]\n\
             environment = {{ temperature = \"20 degC\" }}\ntime = {{ end = \"60 min\", {time} }}\n\
             measurement = {{ places = [\"0 mm\", \"100 mm\"], interval = \"5 min\" }}\n\
             effects = {{ convection = {{ coefficient = \"60 W/m^2/K\" }} }}\n"
        );
        let steps = findings(&place, &text)["steps"]["longest"].as_f64().unwrap();
        let column = |line: &str| line.split(',').nth(2).and_then(|cell| cell.parse::<f64>().ok());
        (steps, place.read("o/profile.csv").lines().filter_map(column).collect::<Vec<f64>>())
    };
    let (_, exact) = run("step = \"0.5 s\"");
    for scheme in ["backward-euler", "sdirk2", "crank-nicolson"] {
        let mut longest = f64::INFINITY;
        for tolerance in [0.1, 0.01] {
            let (step, found) = run(&format!("tolerance = \"{tolerance} K\", scheme = \"{scheme}\""));
            let worst = exact.iter().zip(&found).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            // The error is extrapolated from two steps; half as much again may lie beyond.
            assert!(worst <= 1.5 * tolerance, "{scheme}, {tolerance} K: {worst} K");
            assert!(step <= longest);
            longest = step;
        }
    }
}

/// A room that is recorded and a source whose power is.
const RECORDED: &str = r#"process = "thermal"
body = { material = "steel", segments = [{ length = "200 mm", diameter = "20 mm" }] }
time = { end = "60 min", step = "30 s" }
measurement = { interval = "5 min" }
effects = { convection = { coefficient = "20 W/m^2/K" } }
[environment]
temperature = { file = "room.csv", time = "time", value = "temperature" }
[[source]]
at = "200 mm"
power = { file = "logs/power.csv", time = "clock", value = "heater" }
"#;
const ROOM: &str = "# by the door\ntime [min],temperature [degC]\n0,20\n25,23\n60,22\n";
const POWER: &str = "clock [s],heater [W],note\n0,0,\n600,15,on\n3600,12,\n";

/// A place with the records and their model.
fn recorded() -> Place {
    let place = Place::new();
    std::fs::create_dir(place.path("logs")).unwrap();
    place.write("room.csv", ROOM);
    place.write("logs/power.csv", POWER);
    place.write("m.toml", RECORDED);
    place
}

#[test]
fn a_record_that_never_changes_is_the_constant() {
    let place = recorded();
    place.write("room.csv", "time [h],temperature [K]\n0,295.15\n2,295.15\n");
    place.write("logs/power.csv", "clock [min],heater [kW]\n0,0.015\n1,0.015\n60,0.015\n");
    let constant = RECORDED
        .replace(r#"{ file = "room.csv", time = "time", value = "temperature" }"#, "\"22 degC\"")
        .replace(r#"{ file = "logs/power.csv", time = "clock", value = "heater" }"#, "\"15 W\"");
    place.write("constant.toml", constant);
    assert_eq!(place.fem(&["run", "constant.toml", "-o", "out"]).status, 0);
    let compared = place.fem(&["compare", "m.toml", "--with", "out/profile.csv", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&compared.out).unwrap();
    for seen in json["models"][0]["observables"].as_array().unwrap() {
        assert!(seen["rms"].as_f64().unwrap() < 1e-9, "{seen}");
    }
}

#[test]
fn a_model_written_into_another_folder_finds_its_records() {
    let place = recorded();
    std::fs::create_dir(place.path("new")).unwrap();
    let added = place.fem(&["add", "m.toml", "sensor-lag", "time_constant=20 s", "-o", "new/lag.toml"]);
    assert_eq!(added.status, 0, "{}", added.err);
    let text = place.read("new/lag.toml");
    for path in ["file = \"../room.csv\", time", "file = \"../logs/power.csv\", time"] {
        assert!(text.contains(path), "{text}");
    }
    assert_eq!(place.fem(&["run", "new/lag.toml"]).status, 0);
}

#[test]
fn nothing_is_predicted_beyond_a_record() {
    let place = recorded();
    place.write("m.csv", "time [min],elongation [um]\n50,40\n61,60\n");
    let answer = place.fem(&["compare", "m.toml", "--with", "m.csv"]);
    assert_eq!(answer.status, 2, "{}", answer.err);
    assert!(answer.err.contains("a record that the model names ends at 60 min"), "{}", answer.err);
}

/// (in the model, replaced by, part of the message, part of the remedy)
const RECORDS: &[Mistake] = &[
    ("room.csv", "rooms.csv", "rooms.csv: the file cannot be read", "relative to the folder of the model file"),
    ("file = \"room.csv\", ", "", "`file` is missing in `environment.temperature`", "add file ="),
    (
        "file = \"room.csv\"",
        "fil = \"room.csv\"",
        "`fil` is no key of `environment.temperature`",
        "did you mean `file`?",
    ),
    (
        "\"temperature\" }",
        "\"temprature\" }",
        "room.csv: there is no column `temprature`",
        "did you mean `temperature`?",
    ),
    ("\"clock\"", "\"note\"", "power.csv: `note`: the unit is missing", "write note [min] in its header"),
    ("\"heater\"", "\"clock\"", "`s` measures a time, not a power", "write clock [W]"),
    (
        "end = \"60 min\"",
        "end = \"61 min\"",
        "reaches from 0 min to 60 min, and is needed from 0 min to 61 min",
        "record it",
    ),
    ("value = \"heater\"", "valu = \"heater\"", "`valu` is no key of `source[0].power`", "did you mean `value`?"),
    ("power = {", "power = 15 #{", "`power` has no unit", "write power ="),
];

/// (room.csv, part of the message)
const ROOMS: &[(&str, &str)] = &[
    ("time [min],temperature [degC]\n0,20\n30,21\n30,22\n60,20\n", "line 4: `time` does not rise: 30 min after 30 min"),
    (
        "# a\ntime [min],temperature [degC]\n\n0,20\n# b\n30,NaN\n",
        "line 6: `NaN` in `temperature [degC]` is no finite number",
    ),
    ("time [min],temperature [degC]\n0,20\n30,\n60,20\n", "line 3: the cell of `temperature [degC]` is empty"),
    ("time [min],temperature [degC]\n0,20\n30\n60,20\n", "line 3: the row has 1 cells, the header 2"),
    ("time [min],temperature [degC]\n", "a header and no rows"),
    ("time [min];temperature [degC]\n0;20\n", "parted by semicolons"),
    ("time [min],temperature [degC],temperature [K]\n0,20,293\n", "the column `temperature` stands twice"),
    ("time [min],temperature [degC]\n0,20\n60,-300\n", "nothing is that cold"),
    ("time [min],temperature [degC]\n5,20\n60,20\n", "reaches from 5 min to 60 min"),
];

#[test]
fn records_that_cannot_be_are_told_with_their_remedy() {
    let place = recorded();
    place.refuses(("run", "m.toml"), RECORDED, RECORDS);
    place.write("m.toml", RECORDED);
    for (room, message) in ROOMS {
        place.write("room.csv", room);
        let answer = place.fem(&["run", "m.toml"]);
        let told = answer.err.split_whitespace().collect::<Vec<_>>().join(" ").replace(" │ ", " ");
        assert_eq!(answer.status, 2, "{room}: {told}");
        assert!(told.contains(message), "{room}: {told}");
    }
    place.write("room.csv", ROOM.replace("\n25,23", "\n25,23\n24,23"));
    insta::assert_snapshot!("a_record_that_does_not_rise", place.fem(&["run", "m.toml"]).err);
}

/// A plate whose edges are recorded: a bath below, air above, and a heater on its end.
const EDGES: &str = r#"process = "thermal"
body = { material = "steel", rectangle = { length = "100 mm", height = "20 mm", width = "30 mm" } }
environment = { temperature = "20 degC" }
time = { end = "60 min", step = "60 s" }
mesh = { element_size = "10 mm" }
measurement = { interval = "10 min" }
[[boundary]]
edge = "bottom"
temperature = { file = "bath.csv", value = "bath" }
[[boundary]]
edge = "top"
convection = "50 W/m^2/K"
ambient = { file = "bath.csv", value = "air" }
[[boundary]]
edge = "right"
flux = { file = "heater.csv" }
on = [["0 min", "30 min"]]
"#;
const BATH: &str = "time [min],bath [degC],air [degC]\n0,20,20\n30,26,21\n60,24,23\n";
const HEATER: &str = "time [min],flux [kW/m^2]\n0,10\n60,12\n";

/// A plate with the records of its edges.
fn edged() -> Place {
    let place = Place::new();
    place.write("bath.csv", BATH);
    place.write("heater.csv", HEATER);
    place.write("m.toml", EDGES);
    place
}

#[test]
fn edges_follow_their_records() {
    let place = edged();
    let ran = |model: &str| {
        let answer = place.fem(&["run", model, "-o", "out"]);
        assert_eq!((answer.status, answer.err.as_str()), (0, ""));
        place.read("out/profile.csv")
    };
    let varying = ran("m.toml");
    // Records that never change are the constants.
    place.write("bath.csv", "time [min],bath [degC],air [degC]\n0,26,21\n60,26,21\n");
    place.write("heater.csv", "time [min],flux [kW/m^2]\n0,10\n60,10\n");
    let still = ran("m.toml");
    let constant = EDGES
        .replace("{ file = \"bath.csv\", value = \"bath\" }", "\"26 degC\"")
        .replace("{ file = \"bath.csv\", value = \"air\" }", "\"21 degC\"")
        .replace("{ file = \"heater.csv\" }", "\"10 kW/m^2\"");
    place.write("constant.toml", constant);
    assert_ne!(varying, still);
    assert_eq!(place.fem(&["run", "constant.toml", "-o", "constant"]).status, 0);
    let compared = place.fem(&["compare", "m.toml", "--with", "constant/profile.csv", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&compared.out).unwrap();
    for seen in json["models"][0]["observables"].as_array().unwrap() {
        assert!(seen["rms"].as_f64().unwrap() < 1e-9, "{seen}");
    }
}

/// (in the model, replaced by, part of the message, part of the remedy)
const EDGE_RECORDS: &[Mistake] = &[
    (
        "end = \"60 min\"",
        "end = \"90 min\"",
        "the record of `temperature` reaches from 0 min to 60 min, and is needed from 0 min to 90 min",
        "record it as far as that",
    ),
    ("end = \"60 min\"", "end = \"90 min\"", "the record of `ambient` reaches from 0 min to 60 min", "record it"),
    ("end = \"60 min\"", "end = \"90 min\"", "the record of `flux` reaches from 0 min to 60 min", "record it"),
    ("value = \"air\"", "value = \"heir\"", "there is no column `heir`", "did you mean `air`?"),
    (
        "\"50 W/m^2/K\"",
        "{ file = \"bath.csv\" }",
        "bath.csv: there is no column `convection`",
        "its columns are time, bath, air",
    ),
];

#[test]
fn records_of_edges_that_cannot_be_are_told() {
    let place = edged();
    place.refuses(("run", "m.toml"), EDGES, EDGE_RECORDS);
    place.write("m.toml", EDGES);
    place.write("bath.csv", BATH.replace("30,26", "30,-300"));
    let answer = place.fem(&["run", "m.toml"]);
    assert!(answer.status == 2 && answer.err.contains("nothing is that cold"), "{}", answer.err);
    place.write("bath.csv", BATH);
    place.write("late.csv", "time [min],elongation [um]\n61,4\n");
    let answer = place.fem(&["compare", "m.toml", "--with", "late.csv"]);
    assert!(answer.err.contains("a record that the model names ends at 60 min"), "{}", answer.err);
}

/// What a source's own heater, factors and a start of its own must be.
const INPUTS: &[Mistake] = &[
    (
        "[[\"0 min\", \"90 min\"]]",
        "[[\"0 min\", \"90 min\"]]\npulses = [1, 0.9]",
        "`pulses` has 2 factors, and `on` 1",
        "one factor for each",
    ),
    (
        "[[\"0 min\", \"90 min\"]]",
        "[[\"0 min\", \"90 min\"]]\npulses = [\"1 W\"]",
        "not a factor",
        "write the number alone",
    ),
    ("power = \"15 W\"", "power = \"15 W\"\nheat_capacity = \"20 J/K\"", "a heat capacity and a contact", "give both"),
    ("power = \"15 W\"", "power = \"15 W\"\ncontact = \"0 W/K\"", "`contact` is 0 W/K", "above zero"),
    ("material = \"steel\"", "temperature = \"-300 degC\"\nmaterial = \"steel\"", "nothing is that cold", "-273.15"),
    (
        "segments = [                          # from the base at x = 0; bore = \"10 mm\" for hollow\n  { length = \"200 mm\", diameter = \"20 mm\" },\n]\n",
        "rectangle = { length = \"200 mm\", height = \"20 mm\", width = \"20 mm\" }\n[[source]]\nat = \"0 mm\"\npower = \"1 W\"\nheat_capacity = \"9 J/K\"\ncontact = \"1 W/K\"\n",
        "known of rods, not of plane bodies",
        "leave `heat_capacity` and `contact` out",
    ),
];

#[test]
fn pulses_heaters_and_starts_that_cannot_be_are_told() {
    Place::new().refuses(("run", "model.toml"), &model("thermal.toml"), INPUTS);
}

/// Without a source; as warm as the room nothing would happen.
#[test]
fn a_body_cools_from_a_temperature_of_its_own() {
    let place = Place::new();
    let source = "[[source]]\nat = \"200 mm\"\npower = \"15 W\"\non = [[\"0 min\", \"90 min\"]]";
    let still = model("thermal.toml").replace(source, "");
    let at = |start: &str| still.replace("material =", &format!("temperature = \"{start}\"\nmaterial ="));
    place.write("model.toml", at("77 degC"));
    let answer = place.fem(&["run", "model.toml", "-o", "out"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    place.write("model.toml", at("20 degC"));
    assert!(place.fem(&["run", "model.toml"]).err.contains("nothing heats or cools the body"));
    // A search may pass what is no experiment.
    place.write("model.toml", at("? near 20 degC"));
    let fit = place.fem(&["fit", "model.toml", "--with", "out/profile.csv", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&fit.out).unwrap();
    assert!((json["parameters"][0]["value"].as_f64().unwrap() - 77.0).abs() < 1e-6, "{json}");
}

/// Two pulses of which the second is weaker, by a heater that holds heat back: found again from the profile.
#[test]
fn pulses_and_heaters_are_found_again() {
    let place = Place::new();
    let text = model("thermal.toml").replace(
        "on = [[\"0 min\", \"90 min\"]]",
        "on = [[\"0 min\", \"30 min\"], [\"60 min\", \"100 min\"]]\npulses = [1, \"0.94\"]\nheat_capacity = \"30 J/K\"\ncontact = \"0.4 W/K\"",
    );
    place.write("model.toml", &text);
    assert_eq!(place.fem(&["run", "model.toml", "-o", "out"]).status, 0);
    let free = text.replace("\"0.94\"", "\"?\"").replace("\"30 J/K\"", "\"? J/K\"").replace("\"15 W\"", "\"? W\"");
    place.write("model.toml", free);
    let fit = place.fem(&["fit", "model.toml", "--with", "out/profile.csv", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&fit.out).unwrap();
    let found = |name: &str| {
        let all = json["parameters"].as_array().unwrap();
        all.iter().find(|p| p["parameter"] == name).unwrap_or_else(|| panic!("{json}"))["value"].as_f64().unwrap()
    };
    for (name, value) in [("source[0].power", 15.0), ("source[0].pulses[1]", 0.94), ("source[0].heat_capacity", 30.0)] {
        assert!((found(name) / value - 1.0).abs() < 1e-4, "{name}: {}", found(name));
    }
}
