//! Events between parts: lists and logs say the same, and a wrong log is told of by its line.

use super::fem::Place;

const MODEL: &str = r#"process = "turning"
[workpiece]
material = "steel"
segments = [{ length = "500 mm", diameter = "40 mm" }]
[workholding]
type = "centres"
[cut]
depth = "0.5 mm"
feed = "0.2 mm/rev"
spindle_speed = "500 rpm"
radial_force = "400 N"
[sweep]
positions = 5
[batch]
parts = 9
cycle_time = "8 min"
EVENTS
[effects.tool-wear]
rate = "10 um/km"
[effects.tool-thermal-growth]
elongation = "10 um"
time_constant = "10 min"
"#;

const LISTS: &str = r#"
pauses = [{ after = 4, duration = "30 min" }]
corrections = [{ after = 4, diameter = "-10 um" }, { after = 6, diameter = "4 um" }]
inserts = [{ after = 7, diameter = "3 um" }]
"#;

/// The profile of the model with these events, and with a log in a folder beside it.
fn profile(events: &str, log: &str) -> String {
    let place = Place::new();
    std::fs::create_dir_all(place.path("shop")).unwrap();
    place.write("shop/log.csv", log);
    place.write("model.toml", MODEL.replace("EVENTS", events));
    let answer = place.fem(&["run", "model.toml", "-o", "out"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    place.read("out/profile.csv")
}

#[test]
fn a_log_says_what_lists_say() {
    let by_lists = profile(LISTS, "");
    let log = "log = \"shop/log.csv\"";
    let by_part =
        "# the shop's own\npart,event,value\n4,pause,30 min\n7,insert,3 um\n6,correction,4 um\n4,correction,-10 um\n";
    assert_eq!(profile(log, by_part), by_lists);
    // Part 4 is in work from 24 to 32 min; part 5 begins at 62 min, part 7 at 78.
    let by_time =
        "event,time [min],value\npause,31,0.5 h\ncorrection,40,-10 um\ncorrection,77.9,4 um\ninsert,78,3 um\n";
    assert_eq!(profile(log, by_time), by_lists);
    let both = "corrections = [{ after = 6, diameter = \"4 um\" }]\nlog = \"shop/log.csv\"";
    assert_eq!(profile(both, "part,event,value\n4,pause,30 min\n4,correction,-10 um\n7,insert,3 um\n"), by_lists);
    assert_ne!(profile("", ""), by_lists);
}

/// (log, part of the message, part of the remedy)
const WRONG: &[(&str, &str, &str)] = &[
    (
        "part,event,value\n4,pause,30 min\n5,corection,-10 um\n",
        "line 3: `corection` is no event",
        "did you mean `correction`?",
    ),
    ("part,event,value\n10,correction,-10 um\n", "line 2: `part` is 10", "from 1 to 9"),
    ("part,event,value\n-1,correction,-10 um\n", "line 2: `part` is -1", "from 1 to 9"),
    ("part,event,value\n4,correction,\n", "line 2: `correction` needs a value", "-10 um"),
    ("part,event,value\n4,correction,-10\n", "line 2: the unit is missing", "write it in um"),
    ("part,event,value\n4,correction,30 min\n", "line 2: `min` measures a time", "write it in um"),
    ("part,event,value\n4,correction,-10 +- 2 um\n", "line 2: `-10 +- 2 um` is not known exactly", "list of [batch]"),
    ("part,event,value\n4,pause,-3 min\n", "line 2: a pause lasts no time", "above zero"),
    ("part,event,value\n4,insert,\n4,insert,1 um\n", "line 3: two of `inserts` stand after part 4", "keep one"),
    ("part,event\n4,insert,3 um\n", "line 2: the row has 3 cells, the header 2", "one cell per column"),
    ("time [min],event\n500,insert\n", "line 2: the event is at 500 min", "from 0 to 72 min"),
    ("time,event\n5,insert\n", "`time`: the unit is missing", "time [min]"),
    ("event,value\ninsert,\n", "does not tell when", "`time [min]`"),
    ("part,value\n1,\n", "no column `event`", "pause, correction, insert"),
    ("part,event,value [um]\n1,correction,3\n", "has a unit in the header", "behind each number"),
    ("part;event;value\n1;insert;\n", "parted by semicolons", "commas"),
    ("part,evnt\n1,insert\n", "`evnt` is no column of a log", "did you mean `event`?"),
];

#[test]
fn a_wrong_log_is_told_of_by_its_line() {
    for (log, message, help) in WRONG {
        let place = Place::new();
        place.write("log.csv", *log);
        place.write("model.toml", MODEL.replace("EVENTS", "log = \"log.csv\""));
        let answer = place.fem(&["run", "model.toml"]);
        assert_eq!(answer.status, 2, "{log}: {}", answer.err);
        // The place in the model is that of the key, the line that of the log.
        assert!(answer.err.contains("model.toml:17:7"), "{log}: {}", answer.err);
        assert!(answer.err.contains(message) && answer.err.contains(help), "{log}: {}", answer.err);
    }
}

/// An uncertain correction is a parameter of a fit.
#[test]
fn a_correction_that_is_roughly_known_is_fitted() {
    let place = Place::new();
    let events = |diameter: &str| format!("corrections = [{{ after = 4, diameter = \"{diameter}\" }}]");
    place.write("true.toml", MODEL.replace("EVENTS", &events("-12 um")));
    assert_eq!(place.fem(&["run", "true.toml", "-o", "out"]).status, 0);
    place.write("model.toml", MODEL.replace("EVENTS", &events("-10 +- 3 um")));
    let answer = place.fem(&["fit", "model.toml", "--with", "out/profile.csv"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert!(answer.out.contains("batch.corrections[0].diameter") && answer.out.contains("-12.0"), "{}", answer.out);
}

/// What nobody wrote down: its part and its size are found by a fit, the part as a whole number with an interval of such.
#[test]
fn a_fit_places_a_correction_between_two_parts() {
    let place = Place::new();
    let with = |after: &str, diameter: &str| {
        let effect = format!("[effects.offset-correction]\nafter = {after}\ndiameter = \"{diameter}\"\n");
        MODEL.replace("EVENTS", "") + &effect
    };
    place.write("true.toml", with("6", "-8 um"));
    assert_eq!(place.fem(&["run", "true.toml", "-o", "out"]).status, 0);
    // Every second part was measured: 1, 3, 5, 7, 9. After 5 or 6 is the same to them.
    let profile = place.read("out/profile.csv");
    let is_measured = |line: &&str| line.starts_with(['p', '1', '3', '5', '7', '9']);
    let rows: Vec<&str> = profile.lines().filter(is_measured).collect();
    let column = |line: &str, i: usize| line.split(',').nth(i).unwrap().to_string();
    let kept = |(i, line): (usize, &&str)| {
        let u = if i == 0 { "u [um]" } else { "0.5" };
        format!("{},{},{},{u}\n", column(line, 0), column(line, 1), column(line, 4))
    };
    place.write("data.csv", rows.iter().enumerate().map(kept).collect::<String>());
    place.write("model.toml", with("\"?\"", "? um"));
    let answer = place.fem(&["fit", "model.toml", "--with", "data.csv", "--json"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let json: serde_json::Value = serde_json::from_str(&answer.out).unwrap();
    let parameters = json["parameters"].as_array().unwrap();
    let after = parameters.iter().find(|p| p["parameter"] == "effects.offset-correction.after").unwrap();
    assert_eq!(after["value"], 5.0, "{after}");
    assert_eq!(after["interval95"], serde_json::json!([5.0, 6.0]), "{after}");
}

/// A lathe of which the headstock gives way, with a table more.
fn yielding(stiffness: &str, more: &str) -> String {
    let yields = format!("[effects.headstock-compliance]\nstiffness = \"{stiffness}\"\n{more}");
    MODEL.replace("EVENTS", "") + &yields
}

/// The rows of a profile with their parts.
fn rows(profile: &str) -> Vec<(usize, String)> {
    let mut lines = profile.lines().filter(|line| !line.starts_with('#'));
    let part = lines.next().unwrap().split(',').position(|name| name == "part").unwrap();
    lines.map(|line| (line.split(',').nth(part).unwrap().parse().unwrap(), line.to_string())).collect()
}

#[test]
fn rows_beyond_a_change_are_those_of_the_other_machine() {
    let place = Place::new();
    let profile = |name: &str, model: String| {
        place.write(&format!("{name}.toml"), model);
        let answer = place.fem(&["run", &format!("{name}.toml"), "-o", name]);
        assert_eq!(answer.status, 0, "{}", answer.err);
        (rows(&place.read(&format!("{name}/profile.csv"))), answer.out)
    };
    let (before, _) = profile("before", yielding("60 N/um", ""));
    let (behind, _) = profile("behind", yielding("45 N/um", ""));
    let change = "[effects.headstock-compliance.changed]\nafter = 4\nstiffness = \"45 N/um\"\n";
    let (changed, told) = profile("changed", yielding("60 N/um", change));
    let spliced: Vec<_> =
        before.iter().zip(&behind).map(|(a, b)| if a.0 > 4 { b.clone() } else { a.clone() }).collect();
    assert_eq!(changed, spliced);
    assert_ne!(changed, before);
    assert!(told.contains("headstock-compliance.changed"), "{told}");
}

#[test]
fn a_change_is_added_set_and_left_out() {
    let place = Place::new();
    place.write("model.toml", yielding("60 N/um", "# the last word\n"));
    let add =
        ["add", "model.toml", "headstock-compliance.changed", "after=4", "stiffness=45 +- 3 N/um", "-o", "a.toml"];
    assert_eq!(place.fem(&add).status, 0);
    let added = place.read("a.toml");
    let table = "[effects.headstock-compliance.changed]\nafter = 4.0\nstiffness = \"45 +- 3 N/um\"\n";
    assert!(added.contains(table) && added.contains("# the last word"), "{added}");
    let set = ["set", "a.toml", "effects.headstock-compliance.changed.stiffness=50 N/um", "-o", "b.toml"];
    assert_eq!(place.fem(&set).status, 0);
    assert!(place.read("b.toml").contains("stiffness = \"50 N/um\""));
    let leave = ["set", "a.toml", "--without", "headstock-compliance.changed", "-o", "c.toml"];
    assert_eq!(place.fem(&leave).status, 0);
    assert!(!place.read("c.toml").contains("changed"));
}

/// (table of the change, part of the message, part of the remedy)
const WRONG_CHANGES: &[(&str, &str, &str)] = &[
    ("[effects.tool-wear.changed]\nafter = 4\nrate = \"3 um/km\"", "wears on from part to part", "remove this table"),
    ("[effects.headstock-compliance.changed]\nafter = 4", "changes nothing", "stiffness"),
    ("[effects.headstock-compliance.changed]\nstiffness = \"45 N/um\"", "`after` is missing", "after = "),
    (
        "[effects.headstock-compliance.changed]\nafter = 4\nstifness = \"45 N/um\"",
        "`stifness` is no key",
        "`stiffness`",
    ),
    ("[effects.headstock-compliance.changed]\nafter = 4\nstiffness = \"45 um\"", "`um` measures a length", "N/um"),
];

#[test]
fn a_wrong_change_is_told_of() {
    for (table, message, remedy) in WRONG_CHANGES {
        let place = Place::new();
        place.write("model.toml", format!("{}{table}\n", yielding("60 N/um", "")));
        let answer = place.fem(&["run", "model.toml"]);
        assert_eq!(answer.status, 2, "{table}: {}", answer.err);
        assert!(answer.err.contains(message) && answer.err.contains(remedy), "{table}: {}", answer.err);
    }
}
