//! What once made the program panic, abort, run without end or print nonsense.

use serde_json::Value;

use super::fem::{Place, model};

/// An answer that is told in a page, whatever the input was.
fn refused(place: &Place, args: &[&str], message: &str) {
    let answer = place.fem(args);
    assert_eq!(answer.status, 2, "{}", answer.err.chars().take(2000).collect::<String>());
    let told = answer.err.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(told.contains(message), "{}", told.chars().take(2000).collect::<String>());
    assert!(answer.err.len() < 40_000, "{} bytes are told", answer.err.len());
    assert!(answer.err.lines().all(|line| line.chars().count() < 500), "a line is too long to be read");
}

fn json(place: &Place, args: &[&str]) -> Value {
    let answer = place.fem(&[args, &["--json"]].concat());
    assert_eq!(answer.status, 0, "{args:?}: {}", answer.err);
    serde_json::from_str(&answer.out).unwrap()
}

#[test]
fn an_observable_without_a_value_is_none() {
    let place = Place::new();
    place.write("rod.toml", model("thermal.toml"));
    let rows: String = (1..=9).map(|i| format!("{},{},{},\n", 10 * i, 20 * i, 25 + i)).collect();
    place.write("m.csv", format!("time [min],x [mm],temperature [degC],elongation [um]\n{rows}"));
    let found = json(&place, &["compare", "rod.toml", "--with", "m.csv"]);
    assert!(found["models"][0]["rms"].as_f64().is_some_and(|rms| rms > 0.1), "{found}");
}

#[test]
fn an_unknown_side_of_a_rectangle_is_fitted() {
    let place = Place::new();
    place.write("made.toml", model("rectangle.toml"));
    assert_eq!(place.fem(&["run", "made.toml", "-o", "out"]).status, 0);
    let text = model("rectangle.toml");
    let height = text.lines().find(|l| l.starts_with("height")).unwrap();
    place.write("free.toml", text.replace(height, "height = \"? mm\""));
    let answer = place.fem(&["fit", "free.toml", "--with", "out/profile.csv", "--time-limit", "100 ms"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
}

#[test]
fn long_lines_are_told_in_part() {
    let place = Place::new();
    let long = format!("title = \"{}\"; bad\n", "x".repeat(80_000));
    place.write("title.toml", long + &model("stiffness.toml"));
    refused(&place, &["run", "title.toml"], "title.toml:1:80");
    place.write("shaft.toml", model("lathe.toml"));
    let lines = "part,x [mm],diameter_error [um]\n".to_string() + &"1,100,2\n".repeat(9000);
    place.write("joined.csv", lines.replace('\n', ""));
    refused(&place, &["compare", "shaft.toml", "--with", "joined.csv"], "has the file lost its line ends?");
    place.write("long.csv", format!("part,x [mm],diameter_error [um]\n1,100,{}\n", "z".repeat(1_000_000)));
    refused(&place, &["compare", "shaft.toml", "--with", "long.csv"], "finite number");
    let many: String = (0..3000).map(|i| format!("wrong-{i} = \"{}\"\n", "y".repeat(300))).collect();
    place.write("many.toml", many + &model("stiffness.toml"));
    refused(&place, &["run", "many.toml"], "of which the first 20 are told");
}

#[test]
fn sizes_that_take_too_much_are_refused_with_a_remedy() {
    let place = Place::new();
    place.write("plate.toml", model("ground-plate.toml").replace("height = \"40 mm\"", "height = \"40 m\""));
    refused(&place, &["run", "plate.toml"], "elements; at most 50000 are computed with");
    place.write("batch.toml", model("lathe.toml").replace("parts = 12", "parts = 110000"));
    refused(&place, &["run", "batch.toml"], "are more than 500000 points");
}

#[test]
fn numbers_that_nothing_measures_are_refused_where_they_stand() {
    let place = Place::new();
    place.write("shaft.toml", model("lathe.toml"));
    place.write("m.csv", "part,x [mm],diameter_error [um]\n1,100,1e300\n");
    refused(&place, &["compare", "shaft.toml", "--with", "m.csv"], "m.csv:2:1: `1e300` in `diameter_error [um]`");
    place.write("huge.toml", model("lathe.toml").replacen("stiffness = \"", "stiffness = \"1e1", 1));
    refused(&place, &["run", "huge.toml"], "too large to be computed with");
}

/// The rows of a table, each so many times.
fn copied(text: &str, times: usize) -> String {
    let (header, rows) = text.split_once('\n').unwrap();
    format!("{header}\n{}", rows.repeat(times))
}

#[test]
fn copies_of_rows_tell_no_noise() {
    let place = Place::new();
    place.write("rigid.toml", model("story/rigid.toml"));
    let measured = model("story/measured.csv");
    let rows: Vec<&str> = measured.lines().filter(|line| !line.starts_with('#')).collect();
    let without_u: String = rows.iter().map(|row| format!("{}\n", row.rsplit_once(',').unwrap().0)).collect();
    assert!(without_u.starts_with("part,x [mm],radial_force [N],diameter_error [um]\n"), "{without_u}");
    let noise = |times: usize| {
        place.write("m.csv", copied(&without_u, times));
        let found = json(&place, &["compare", "rigid.toml", "--with", "m.csv"]);
        assert_eq!(found["noise"]["source"], "estimated", "{times} copies");
        found["noise"]["sigma"].as_f64().unwrap()
    };
    let once = noise(1);
    for times in [2, 3, 4, 5, 7] {
        assert!((noise(times) / once - 1.0).abs() < 0.3, "{times} copies: {} for {once}", noise(times));
    }
}

#[test]
fn a_gauge_reads_no_finer_than_its_step() {
    // A joint of 80 N/um, read thrice at each force to whole micrometres: mostly alike. What rounding leaves has a
    // standard deviation of 1 um/√12 = 0.289 um.
    let place = Place::new();
    place.write("joint.toml", model("stiffness.toml"));
    for odd in [0, 1] {
        let mut table = "force [N],displacement [um]\n".to_string();
        for step in 0..40 {
            let force = 25 * step;
            let read = (f64::from(force) / 80.0).round();
            (0..3).for_each(|i| {
                table += &format!("{force},{}\n", read + f64::from(u8::from(step == 20 && i == 0) * odd))
            });
        }
        place.write("m.csv", table);
        let found = json(&place, &["compare", "joint.toml", "--with", "m.csv"]);
        let sigma = found["noise"]["sigma"].as_f64().unwrap();
        assert!(sigma >= 0.2886, "{odd}: {}", found["noise"]);
    }
}

#[test]
fn a_formula_without_a_value_somewhere_is_a_failure_in_every_command() {
    let place = Place::new();
    let mine = "\n[effects.mine]\nformula = \"a/(part - 1)\"\na = \"3 um\"\n";
    place.write("m.toml", model("story/rigid.toml") + mine);
    place.write("m.csv", model("story/measured.csv"));
    for args in [&["run", "m.toml"][..], &["compare", "m.toml", "--with", "m.csv"]] {
        let answer = place.fem(args);
        assert_eq!((answer.status, answer.out.as_str()), (1, ""), "{args:?}");
        assert!(answer.err.contains("no finite number") && answer.err.contains("divisions by zero"), "{}", answer.err);
    }
}

#[test]
fn a_search_does_not_stay_in_the_valley_in_which_it_begins() {
    // A screw that wobbles with every turn makes waves along a circle, whose number grows with the radius: every turn
    // of 10 mm is a valley.
    let place = Place::new();
    let known = |line: &str| match line.split_once(" +- ") {
        Some((value, rest)) => format!("{value}{}\n", &rest[rest.find([' ', '"']).unwrap()..]),
        None => format!("{line}\n"),
    };
    place.write("made.toml", model("contour.toml").lines().map(known).collect::<String>());
    let run = place.fem(&["run", "made.toml", "-o", "out"]);
    assert_eq!(run.status, 0, "{}", run.err);
    for near in ["172.5", "128"] {
        place.write(
            "free.toml",
            place.read("made.toml").replace("radius = \"150 mm\"", &format!("radius = \"? near {near} mm\"")),
        );
        let found = json(&place, &["fit", "free.toml", "--with", "out/profile.csv"]);
        let radius = found["parameters"][0]["value"].as_f64().unwrap();
        assert!((radius - 150.0).abs() < 0.01, "from {near}: {radius}");
    }
}

#[test]
fn what_a_time_limit_leaves_undone_is_told() {
    let place = Place::new();
    let free = model("story/rigid.toml").replace("length = \"500 mm\"", "length = \"? near 480 mm\"");
    place.write("free.toml", free);
    place.write("rigid.toml", model("story/rigid.toml"));
    place.write("m.csv", model("story/measured.csv"));
    for args in [
        &["fit", "free.toml", "--with", "m.csv"][..],
        &["diagnose", "rigid.toml", "--with", "m.csv"],
        &["plan", "rigid.toml"],
    ] {
        let limited = [args, &["--time-limit", "1 ms"]].concat();
        let found = json(&place, &limited);
        assert!(found["left_undone"].as_array().is_some_and(|all| !all.is_empty()), "{args:?}");
        let page = place.fem(&limited);
        assert!(page.out.contains("the time was over; left undone:\n  "), "{}", page.out);
        assert!(!page.out.contains("nine times in ten it would have been"), "{}", page.out);
    }
    // With time enough nothing is, and nothing is said of it.
    let found = json(&place, &["fit", "free.toml", "--with", "m.csv", "--time-limit", "1 h"]);
    assert!(found.get("left_undone").is_none());
    for wrong in ["0.5", "-1 s", "? s", "5 +- 1 s", "3 mm"] {
        let answer = place.fem(&["fit", "free.toml", "--with", "m.csv", "--time-limit", wrong]);
        assert_eq!(answer.status, 2, "{wrong}");
    }
}

/// Ordinary users alone are held to a number of threads.
#[cfg(target_os = "linux")]
#[test]
fn where_no_thread_is_to_be_had_one_is_enough() {
    use std::os::unix::fs::PermissionsExt;
    use std::process::Command;

    let place = Place::new();
    place.write("shaft.toml", model("lathe.toml"));
    place.write("study.toml", model("study-lathe.toml").replace("\"lathe.toml\"", "\"shaft.toml\""));
    place.write("m.csv", "part,x [mm],diameter_error [um]\n1,100,90\n1,300,105\n2,100,95\n2,300,110\n3,100,99\n");
    let program = place.path("fem");
    std::fs::copy(env!("CARGO_BIN_EXE_fem"), &program).unwrap();
    for open in [&program, program.parent().unwrap()] {
        std::fs::set_permissions(open, PermissionsExt::from_mode(0o777)).unwrap();
    }
    let user = String::from_utf8(Command::new("id").arg("-u").output().unwrap().stdout).unwrap();
    let as_nobody: &[&str] = &["setpriv", "--reuid", "65534", "--clear-groups"];
    let limited = [if user.trim() == "0" { as_nobody } else { &[] }, &["prlimit", "--nproc=1"]].concat();
    for args in [
        "run shaft.toml -o out",
        "compare shaft.toml --with m.csv",
        "fit shaft.toml --with m.csv",
        "diagnose shaft.toml --with m.csv --time-limit 200ms",
        "plan shaft.toml --time-limit 200ms",
        "study study.toml -o points",
    ] {
        let answer = Command::new(limited[0])
            .args(&limited[1..])
            .arg(&program)
            .args(args.split(' '))
            .current_dir(program.parent().unwrap())
            .output()
            .unwrap();
        assert_eq!(answer.status.code(), Some(0), "{args}: {}", String::from_utf8_lossy(&answer.stderr));
    }
}

#[test]
fn a_contour_whose_angles_are_out_of_order_has_peaks() {
    let place = Place::new();
    let slow = model("contour.toml");
    let feed = slow.lines().find(|line| line.starts_with("feed")).unwrap();
    let gain = slow.lines().find(|line| line.starts_with("gain")).unwrap();
    place
        .write("slow.toml", slow.replace(feed, "feed = \"6e-07 mm/min\"").replace(gain, "gain = \"50000000000.0 /s\""));
    let answer = place.fem(&["run", "slow.toml", "-o", "out"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
}

#[test]
fn what_does_not_yield_has_no_stiffness_in_the_table() {
    let place = Place::new();
    place.write("lathe.toml", model("story/rigid.toml"));
    assert_eq!(place.fem(&["run", "lathe.toml", "-o", "out"]).status, 0);
    for file in place.files().iter().filter(|file| file.ends_with(".csv")) {
        assert!(!place.read(file).contains("inf"), "{file}");
    }
}

#[test]
fn a_fitted_formula_without_a_value_somewhere_is_not_written() {
    let place = Place::new();
    place.write("f.toml", model("fixture.toml") + "\n[effects.mine]\nformula = \"a*abs(x)/x\"\na = \"? um\"\n");
    let rows: String = (1..10).map(|i| format!("1,{},{},1\n", 30 * i, 5 + i)).collect();
    place.write("m.csv", format!("part,x [mm],height_error [um],u [um]\n{rows}"));
    let answer = place.fem(&["fit", "f.toml", "--with", "m.csv", "--add-to", "better.toml"]);
    assert!(
        answer.status == 1 && answer.err.contains("a formula of the model gives no finite number"),
        "{}",
        answer.err
    );
    assert!(!place.path("better.toml").exists());
}

#[test]
fn a_value_that_may_lie_far_beyond_the_part_is_corrected_for() {
    // Of what is written, 200 ± 500 mm, the rod has the first 200.
    let place = Place::new();
    let source = "\n[effects.extra-source]\nat = \"200 +- 500 mm\"\npower = \"0.5 +- 0.05 W\"\n";
    place.write("rod.toml", model("thermal.toml") + source);
    let answer = place.fem(&["correct", "rod.toml"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
}

#[test]
fn two_commands_tell_one_chi2() {
    // Repeats with a time of their own, whose scatter is that of neighbours.
    let place = Place::new();
    let screw = "[screw]\nmaterial = \"steel\"\ndiameter = \"44 mm\"\nlead = \"12 mm\"\nfixed_at = \"0 mm\"\n";
    let test = "[test]\npositions = 9\nruns = 5\n";
    place.write("m.toml", format!("process = \"axis\"\n[axis]\ntravel = \"500 mm\"\n{screw}{test}"));
    let noise = [0.4, -0.7, 0.2, 0.9, -0.3, -0.8, 0.6, 0.1, -0.5, 0.3, -0.2];
    let row = |i: usize| {
        let (run, at) = (1 + i / 18, i % 18);
        let (position, direction) = if at < 9 { (at, '+') } else { (17 - at, '-') };
        format!("{run},{},{direction},{},{}\n", 20 + 55 * position, 0.35 * (i + 1) as f64, noise[(7 * i) % 11])
    };
    let rows: String = (0..90).map(row).collect();
    place.write("m.csv", format!("run,position [mm],direction,time [min],deviation [um]\n{rows}"));
    let compared = json(&place, &["compare", "m.toml", "--with", "m.csv"])["models"][0]["chi2_per_dof"].clone();
    let before = json(&place, &["diagnose", "m.toml", "--with", "m.csv"])["before"]["chi2_per_dof"].clone();
    let [compared, before] = [compared, before].map(|own| own.as_f64().unwrap());
    assert!((compared - before).abs() < 1e-9 * compared, "{compared} {before}");
}

#[test]
fn names_of_others_are_shown_and_not_obeyed() {
    let place = Place::new();
    place.write("x\u{1b}[31m.toml", model("story/rigid.toml"));
    let header = "part,x [mm],radial_force [N],diameter_error [um],u [um],\u{1b}]0;PWNED\u{7}\u{9b}1m\n";
    place.write("m.csv", format!("{header}1,100,300,30,1,1\n1,200,300,2,1,1\n"));
    place.write("bad.csv", format!("{header}1,100,300,30,1,1\n1,200,300,\u{1b}[2J,1,1\n"));
    let name = "x\u{1b}[31m.toml";
    for args in [
        &["run", name, "-o", "o\u{1b}]0;x\u{7}"][..],
        &["compare", name, "--with", "m.csv"],
        &["compare", name, "--with", "m.csv", "--json"],
        &["compare", name, "--with", "bad.csv"],
        &["report", name, "--with", "m.csv", "-o", "o\u{1b}[2J.html", "--time-limit", "1 s"],
        &["run", "none\u{9b}1m.toml"],
    ] {
        let answer = place.fem(args);
        let is_harmless = |text: &str| text.chars().all(|c| !c.is_control() || matches!(c, '\n' | '\t'));
        assert!(is_harmless(&answer.out) && is_harmless(&answer.err), "{args:?}: {:?} {:?}", answer.out, answer.err);
    }
}

#[test]
fn lines_that_are_no_table_are_refused_before_they_are_parted() {
    let place = Place::new();
    place.write("rigid.toml", model("story/rigid.toml"));
    for (text, message) in [
        ("a,".repeat(6_000_000), "line 1 has 12000000 bytes; at most 10000000 are read"),
        (format!("# joined\n{}", ";".repeat(40_000)), "line 2 has 40001 columns; at most 1000 are read"),
        (format!("x [mm],diameter_error [um]\n1,{}", "9".repeat(11_000_000)), "line 2 has 11000002 bytes"),
    ] {
        place.write("m.csv", text);
        refused(&place, &["compare", "rigid.toml", "--with", "m.csv"], message);
        refused(&place, &["import", "m.csv"], message);
    }
}
