//! `fem next`: the log of a machine, and the part that comes next.

use std::fs::OpenOptions;

use fem::ask::Log;
use serde_json::Value as Json;

use super::fem::{Answer, Place};

const LATHE: &str = r#"
process = "turning"
workpiece = { material = "steel", segments = [{ length = "300 mm", diameter = "40 mm" }] }
workholding = { type = "centres" }
cut = { depth = "0.4 mm", feed = "0.15 mm/rev", spindle_speed = "900 rpm", radial_force = "180 N" }
tolerance = { diameter = "h7" }
[batch]
cycle_time = "4 min"
[effects.tailstock-compliance]
stiffness = "40 +- 10 N/um"
[effects.tool-wear]
run_in = "0 um"
rate = "5 +- 2 um/km"
"#;
const LOG: &str = "title = \"Lathe 4\"\nmodel = \"lathe.toml\"\n";

/// What parts measure that grow by `growth` from one to the next, from `first` on, at two places.
fn measured(numbers: std::ops::RangeInclusive<usize>, first: f64, growth: f64) -> String {
    let rows = numbers.enumerate().flat_map(|(i, part)| {
        // As uneven as readings are, the same every time.
        let uneven = |k: usize| ((7 * part + 3 * k) % 5) as f64 * 0.3 - 0.6;
        [(60, 0), (240, 1)].map(|(x, k)| format!("{part},{x},{:.1}\n", first + growth * i as f64 + uneven(k)))
    });
    format!("part,x [mm],diameter_error [um]\n{}", rows.collect::<String>())
}

fn place() -> Place {
    let place = Place::new();
    place.write("lathe.toml", LATHE);
    place.write("log.toml", LOG);
    place
}

fn parsed(text: &str) -> Json {
    serde_json::from_str(text).unwrap()
}

#[test]
fn the_next_part_is_told_and_what_was_measured_counts_once() {
    let place = place();
    place.write("today.csv", measured(1..=6, 14.0, 3.0));
    let ask = ["next", "log.toml", "--with", "today.csv", "--json"];
    let first = place.fem(&ask);
    assert_eq!(first.status, 0, "{}", first.err);
    assert!(first.err.contains("taken as 0, the programme as it stands"), "{}", first.err);
    let found = parsed(&first.out);
    assert_eq!(
        (&found["schema"], &found["part"], &found["measured_parts"]),
        (&"fem-next/1".into(), &7.into(), &6.into())
    );
    // Part 7 would measure 32; the middle of h7 is -12.5, and an offset counts a little less than twice.
    let offset = 1e6 * found["offset"]["radius_change"].as_f64().unwrap();
    assert!((-24.5..-20.0).contains(&offset), "{offset}");
    let [low, high] = [0, 1].map(|end| 1e6 * found["expected"]["interval95"][end].as_f64().unwrap());
    assert!(low < -12.5 && -12.5 < high && high - low < 12.0, "{low} {high}");
    assert!(found["probability_in"].as_f64().unwrap() > 0.9, "{found}");
    assert_eq!(found["record"]["others"].as_array().unwrap().len(), 3);
    let log = place.read("log.toml");
    assert!(log.starts_with(LOG) && log.contains("number = 6") && log.contains("[[advised]]\npart = 7"), "{log}");
    // Again: nothing is new, neither in the answer nor in the log.
    let again = place.fem(&ask);
    assert_eq!((&again.out, place.read("log.toml")), (&first.out, log.clone()));
    assert!(again.err.contains("12 readings of today.csv stood in the log already"), "{}", again.err);
    // In other units they are the same readings.
    let um = measured(1..=6, 14.0, 3.0);
    let mm = um.lines().skip(1).map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        format!("{},{},{:.4}\n", cells[0], cells[1], 1e-3 * cells[2].parse::<f64>().unwrap())
    });
    place.write("mm.csv", format!("part,x [mm],diameter_error [mm]\n{}", mm.collect::<String>()));
    assert_eq!(place.fem(&["next", "log.toml", "--with", "mm.csv", "--json"]).out, first.out);
    assert_eq!(place.read("log.toml"), log);
    // The next part is made as advised, unless another offset was applied.
    place.write("later.csv", measured(7..=7, -11.0, 0.0));
    let dry = place.fem(&["next", "log.toml", "--with", "later.csv", "--applied", "-20 um", "--dry-run", "--json"]);
    let before = |run: &Answer| 1e6 * parsed(&run.out)["offset"]["before"].as_f64().unwrap();
    assert!((before(&dry) + 20.0).abs() < 1e-6, "{}", before(&dry));
    assert_eq!(place.read("log.toml"), log);
    let then = place.fem(&["next", "log.toml", "--with", "later.csv", "--json"]);
    assert!((before(&then) - offset).abs() < 1e-6, "{}", before(&then));
    assert!(place.read("log.toml").starts_with(&log));
}

#[test]
fn what_happens_before_the_next_part_widens_what_is_known() {
    let place = place();
    place.write("today.csv", measured(1..=6, 14.0, 3.0));
    let as_it_is = parsed(&place.fem(&["next", "log.toml", "--with", "today.csv", "--json"]).out);
    let change = ["next", "log.toml", "--new-insert", "--pause", "45 min", "--json"];
    let first = place.fem(&change);
    let changed = parsed(&first.out);
    assert_eq!((&changed["insert"], &changed["pause"]), (&2.into(), &2700.0.into()), "{}", first.err);
    let half = |found: &Json| {
        let [low, high] = [0, 1].map(|end| found["expected"]["interval95"][end].as_f64().unwrap());
        0.5 * (high - low)
    };
    assert!(half(&changed) > 1.5 * half(&as_it_is), "{} {}", half(&changed), half(&as_it_is));
    // A sharp edge does not leave what the blunt one did: six parts of the wear go.
    let by = |found: &Json| found["offset"]["radius_change"].as_f64().unwrap();
    assert!(by(&changed) - by(&as_it_is) > 4e-6, "{} {}", by(&changed), by(&as_it_is));
    // It is said twice, and stays one change.
    let log = place.read("log.toml");
    assert_eq!((place.fem(&change).out, place.read("log.toml")), (first.out, log));
}

#[test]
fn a_part_that_stands_far_off_is_told() {
    let place = place();
    let good = measured(1..=8, 14.0, 0.5);
    place.write("today.csv", format!("{good}9,60,48\n9,240,47.6\n"));
    let open = place.fem(&["next", "log.toml", "--with", "today.csv", "--dry-run"]);
    assert!(
        open.status == 0 && open.out.contains("part 9 measures +") && open.out.contains("measure it again"),
        "{}",
        open.out
    );
    let chip = measured(10..=11, 18.5, 0.5);
    let chip: String = chip.lines().skip(1).map(|line| format!("{line}\n")).collect();
    place.write("today.csv", format!("{good}9,60,48\n9,240,47.6\n{chip}"));
    let told = parsed(&place.fem(&["next", "log.toml", "--with", "today.csv", "--dry-run", "--json"]).out);
    assert_eq!((&told["far_off"][0]["part"], &told["far_off"][0]["machine_changed"]), (&9.into(), &false.into()));
    let moved = chip.replace(",18", ",48").replace(",19", ",49").replace(",17", ",47");
    place.write("today.csv", format!("{good}9,60,48\n9,240,47.6\n{moved}"));
    let told = parsed(&place.fem(&["next", "log.toml", "--with", "today.csv", "--dry-run", "--json"]).out);
    assert_eq!(told["far_off"][0]["machine_changed"], true, "{told}");
}

#[test]
fn a_log_that_was_cut_anywhere_in_its_last_entry_is_the_one_before_it() {
    let place = place();
    for (name, numbers) in [("a.csv", 1..=2), ("b.csv", 3..=3)] {
        place.write(name, measured(numbers, 14.0, 3.0));
    }
    place.fem(&["next", "log.toml", "--with", "a.csv"]);
    let before = place.read("log.toml");
    place.fem(&["next", "log.toml", "--with", "b.csv"]);
    let whole = place.read("log.toml");
    let path = place.path("log.toml");
    let read = |text: &str| Log::read(&path.display().to_string(), text.as_bytes()).unwrap();
    for end in before.len()..whole.len() {
        let log = read(&whole[..end]);
        assert_eq!(log.history.last(), 2, "{}", &whole[before.len()..end]);
    }
    assert_eq!(read(&whole).history.last(), 3);
    // And it goes on from there: what was whole stays to the byte.
    for end in [before.len() + 5, before.len() + 60, whole.len() - 4] {
        place.write("log.toml", &whole[..end]);
        let run = place.fem(&["next", "log.toml", "--with", "b.csv"]);
        let is_cut = end > before.len() + 40;
        assert!(run.status == 0 && run.err.contains("was not written to its end") == is_cut, "{}", run.err);
        let log = place.read("log.toml");
        assert!(log.starts_with(&before) && log.ends_with(whole.trim_start_matches(&before[..]).trim_start()), "{log}");
        assert_eq!(read(&log).history.last(), 3);
    }
}

#[test]
fn two_runs_do_not_write_one_log() {
    let place = place();
    let held = OpenOptions::new().read(true).open(place.path("log.toml")).unwrap();
    held.lock().unwrap();
    let run = place.fem(&["next", "log.toml"]);
    assert!(run.status == 2 && run.err.contains("held by another run") && run.err.contains("wait"), "{}", run.err);
    drop(held);
    assert_eq!(place.fem(&["next", "log.toml"]).status, 0);
}

#[test]
fn what_is_wrong_is_told_with_its_place() {
    let place = place();
    place.write("today.csv", measured(1..=2, 14.0, 3.0));
    place.write("nowhere.csv", "part,x [mm],diameter_error [um]\n1,900,3\n");
    place.write("no-part.csv", "x [mm],diameter_error [um]\n60,3\n");
    place.write("open.toml", LATHE.replace("40 +- 10", "?"));
    place.write("plain.toml", LATHE.replace("[batch]\ncycle_time = \"4 min\"", ""));
    let jobs = "[[job]]\nname = \"shaft\"\nmodel = \"lathe.toml\"\n[[job]]\nname = \"pin\"\nmodel = \"lathe.toml\"\n";
    for (log, more, wrong) in [
        (LOG, &["--with", "nowhere.csv"][..], "line 2: x = 900 mm is not on the shaft"),
        (LOG, &["--with", "no-part.csv"], "does not tell which part was measured"),
        (LOG, &["--with", "today.csv", "--applied", "3 +- 1 um"], "it is known what was done"),
        (LOG, &["--next-job", "pin"], "no job `pin`"),
        ("model = \"open.toml\"\n", &[], "is unknown (`?`)"),
        ("model = \"plain.toml\"\n", &[], "does not say how parts follow one another"),
        ("model = \"lathe.toml\"\n[[part]]\nnumber = 4\n[[part]]\nnumber = 4\n", &[], "behind a later one, or twice"),
        ("model = \"lathe.toml\"\n[[part]]\nnumber = 4\nofset = \"1 um\"\n", &[], "ofset"),
        ("model = \"lathe.toml\"\n[[part]]\nnumber = 4\njob = \"pin\"\n", &[], "there is no job `pin`"),
        (
            "model = \"lathe.toml\"\n[[measured]]\nrows = \"\"\"\npart,x [mm],diameter_error [um]\n1,6o,3\n\"\"\"\n",
            &[],
            "6o",
        ),
        (
            &format!("{jobs}[[part]]\nnumber = 1\njob = \"pin\"\n"),
            &["--job", "shaft", "--with", "today.csv"],
            "part 1 is one of the job `pin`",
        ),
    ] {
        place.write("log.toml", log);
        let run = place.fem(&[&["next", "log.toml"], more].concat());
        assert!(run.status == 2 && run.err.contains(wrong), "{wrong}: {}", run.err);
        assert_eq!(place.read("log.toml"), log);
    }
    place.write("ring.toml", super::fem::model("ring.toml"));
    place.write("log.toml", "model = \"ring.toml\"\n");
    let ring = place.fem(&["next", "log.toml"]);
    assert!(ring.status == 2 && ring.err.contains("the next part is known of turned contours"), "{}", ring.err);
}

#[test]
fn a_job_that_follows_another_is_a_new_set_up() {
    let place = place();
    let pin = LATHE.replace("300 mm", "80 mm").replace("40 mm\" }]", "20 mm\" }]");
    place.write("pin.toml", pin);
    place.write(
        "log.toml",
        "[[job]]\nname = \"shaft\"\nmodel = \"lathe.toml\"\n[[job]]\nname = \"pin\"\nmodel = \"pin.toml\"\n",
    );
    place.write("shafts.csv", measured(1..=5, 14.0, 3.0));
    assert_eq!(place.fem(&["next", "log.toml", "--with", "shafts.csv"]).status, 0);
    let run = place.fem(&["next", "log.toml", "--next-job", "pin", "--json"]);
    let next = parsed(&run.out);
    assert_eq!((&next["job"], &next["part"]), (&"pin".into(), &6.into()), "{}", run.err);
    // The middle of h7 at 20 mm is -10.5 um; what the shafts tell of the zero hardly helps.
    assert!((next["expected"]["mean"].as_f64().unwrap() + 10.5e-6).abs() < 0.2e-6, "{next}");
    place.write("pins.csv", "part,x [mm],diameter_error [um]\n6,20,-8\n6,60,-9\n");
    let run = place.fem(&["next", "log.toml", "--with", "pins.csv", "--json"]);
    assert_eq!((run.status, &parsed(&run.out)["job"]), (0, &"pin".into()), "{}", run.err);
    assert!(place.read("log.toml").contains("number = 6\njob = \"pin\""));
}
