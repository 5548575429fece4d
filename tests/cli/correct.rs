//! `fem correct`, and what the drawing asks.

use serde_json::Value as Json;

use super::fem::{Place, model};

fn parsed(text: &str) -> Json {
    serde_json::from_str(text).unwrap()
}

/// A slender shaft in the middle of which the cut bends it by tens of micrometres.
const SHAFT: &str = r#"
process = "turning"
workpiece = { material = "steel", segments = [{ length = "300 mm", diameter = "30 mm" }] }
workholding = { type = "centres" }
cut = { depth = "0.4 mm", feed = "0.15 mm/rev", spindle_speed = "900 rpm", radial_force = "200 N" }
batch = { parts = 3, cycle_time = "4 min" }
[effects.tool-wear]
run_in = "0 um"
rate = "9 um/km"
[effects.tailstock-compliance]
stiffness = "40 +- 4 N/um"
"#;

#[test]
fn what_the_drawing_asks_is_held_against_every_part() {
    let place = Place::new();
    for (tolerance, wrong) in [
        ("diameter = \"h6\"", ""),
        ("diameter = \"g6\"", ""),
        ("diameter = \"+-20 um\"\ntaper = \"5 um\"\nsections = [{ segment = 1, diameter = \"-5 to 20 um\" }]", ""),
        ("diameter = \"6h\"", "it is no tolerance class"),
        ("diameter = \"zc6\"", "of `zc` there is no table here"),
        ("diameter = \"h19\"", "there is no grade 19"),
        ("diameter = \"20 to -5 um\"", "the lower limit is not below the upper one"),
        ("diameter = \"+-20 N\"", "measures a force"),
        ("sections = [{ segment = 2, diameter = \"h6\" }]", "segment"),
    ] {
        place.write("shaft.toml", format!("{SHAFT}[tolerance]\n{tolerance}\n"));
        let run = place.fem(&["run", "shaft.toml", "--json", "-o", "out", "--force"]);
        assert_eq!(run.status, if wrong.is_empty() { 0 } else { 2 }, "{tolerance}: {}", run.err);
        assert!(run.err.contains(wrong), "{tolerance}: {}", run.err);
    }
    place.write("shaft.toml", format!("{SHAFT}[tolerance]\ndiameter = \"h6\"\ncylindricity = \"1 um\"\n"));
    let run = parsed(&place.fem(&["run", "shaft.toml", "--json", "-o", "out", "--force"]).out);
    let [diameter, form] = [&run["tolerance"][0], &run["tolerance"][1]];
    // 30 mm are 13 um in grade 6.
    assert_eq!(
        [&diameter["lower"], &diameter["upper"], &diameter["parts"]].map(|v| v.as_f64().unwrap().round()),
        [-13.0, 0.0, 3.0]
    );
    assert_eq!(diameter["out"], serde_json::json!([1, 2, 3]));
    assert_eq!((&form["lower"], form["upper"].as_f64().unwrap()), (&Json::Null, 1.0));
}

#[test]
fn a_correction_brings_every_part_to_the_middle_of_its_limits() {
    let place = Place::new();
    place.write("shaft.toml", format!("{SHAFT}[tolerance]\ndiameter = \"h6\"\n"));
    let answer = place.fem(&["correct", "shaft.toml", "--json", "-o", "out"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let found = parsed(&answer.out);
    assert_eq!((&found["process"], &found["unreached"]), (&"turning".into(), &0.into()));
    let (changes, left) = (found["correction"].as_array().unwrap(), found["left"].as_array().unwrap());
    assert!(changes.len() == left.len() && changes.len() >= 3 * 50, "{}", changes.len());
    for (change, left) in changes.iter().zip(left) {
        assert!((left["value"].as_f64().unwrap() + 6.5e-6).abs() < 1e-9, "{left}");
        assert!([&change["x"], &change["part"]] == [&left["x"], &left["part"]]);
        // The tool goes in where it leaves too much.
        assert!(change["radius_change"].as_f64().unwrap() < 0.0, "{change}");
        let [low, high] = [0, 1].map(|end| left["interval95"][end].as_f64().unwrap());
        assert!(low <= -6.5e-6 + 1e-9 && high >= -6.5e-6 - 1e-9, "{left}");
    }
    // Each part is worn away from the last.
    let offsets: Vec<f64> =
        found["offsets"].as_array().unwrap().iter().map(|own| own["radius_change"].as_f64().unwrap()).collect();
    assert!(offsets.len() == 3 && offsets.is_sorted_by(|a, b| a > b), "{offsets:?}");
    assert!(found["tolerance"]["probability_in"].as_f64().unwrap() > 0.9);
    assert!(place.read("out/correction.csv").starts_with("part,x [mm],radius_change [um],left [um],left_from [um],"));
    // The same model has the same answer.
    assert_eq!(place.fem(&["correct", "shaft.toml", "--json"]).out, answer.out);
}

/// What a correction adds and leaves is a measurement file, which the model foretells: also where the force answers, and a pass
/// went before.
#[test]
fn rows_tell_what_was_added_to_the_radius() {
    let place = Place::new();
    let passes = "[[pass]]\ndepth = \"1 mm\"\nradial_force = \"500 N\"\n[effects.force-feedback]\nexponent = 0.8\n";
    let shaft = SHAFT.replace("4 min", "6 min");
    place.write("shaft.toml", format!("{shaft}[tolerance]\ndiameter = \"h6\"\n{passes}"));
    assert_eq!(place.fem(&["correct", "shaft.toml", "-o", "out"]).status, 0);
    let with = ["compare", "shaft.toml", "--with", "out/correction.csv", "--json", "--columns"];
    let compared = |columns: &str| {
        let answer = place.fem(&[&with[..], &[columns]].concat());
        assert_eq!(answer.status, 0, "{}", answer.err);
        parsed(&answer.out)
    };
    let told = compared("left=diameter_error,left_from=-,left_to=-");
    assert!(told["models"][0]["rms"].as_f64().unwrap() < 1e-4, "{}", told["models"][0]["rms"]);
    assert_eq!(told["tolerance"][0]["within"], serde_json::json!(true), "{}", told["tolerance"]);
    assert!(told["rms_from_middle"]["value"].as_f64().unwrap() < 1e-4, "{}", told["rms_from_middle"]);
    let untold = compared("left=diameter_error,left_from=-,left_to=-,radius_change=-");
    assert!(untold["models"][0]["rms"].as_f64().unwrap() > 10.0, "{}", untold["models"][0]["rms"]);
}

#[test]
fn what_cannot_be_corrected_is_said() {
    let place = Place::new();
    place.write("open.toml", SHAFT.replace("40 +- 4", "?"));
    let open = place.fem(&["correct", "open.toml"]);
    assert!(open.status == 2 && open.err.contains("is unknown (`?`)") && open.err.contains("fem fit"), "{}", open.err);
    place.write("part.ngc", "G0 X42\nG1 Z-300\nM30\n");
    let both = place.fem(&["correct", "open.toml", "--remedies", "--program", "part.ngc"]);
    assert!(both.status == 2 && both.err.contains("cannot be used with"), "{}", both.err);
    // What is wrong with the machine itself is masked and not mended.
    let worn = "[effects.guideway-wear]\ndepth = \"20 um\"\ncentre = \"150 mm\"\nwidth = \"60 mm\"\n";
    place.write("worn.toml", format!("{SHAFT}{worn}"));
    let found = parsed(&place.fem(&["correct", "worn.toml", "--json"]).out);
    let masked = found["masked"].as_array().unwrap();
    // The depth of the wear stands twice on the diameter.
    assert!(masked.len() == 1 && masked[0]["effect"] == "guideway-wear", "{masked:?}");
    assert!((masked[0]["largest"].as_f64().unwrap() - 40e-6).abs() < 4e-6, "{masked:?}");
}

/// A grinder whose wheel has lost 30 um: the blocks stay, the wheel is told, and the rest of the error is theirs.
#[test]
fn a_cam_is_advised() {
    let place = Place::new();
    let circle = r#"
        process = "cam"
        wheel = { radius = "175 mm" }
        cut = { stock = "20 um", force_per_rate = "10 N/(mm^2/s)" }
        program = { blocks = 90, cam_speed = "20 rpm" }
        tolerance = { deviation = "±10 um" }
        [profile]
        start = ["24 mm", "0 mm"]
        segments = [{ arc = { centre = ["4 mm", "0 mm"], sweep = "360 deg" } }]
        [effects.wheel-wear]
        loss = "30 +- 1 um"
        [effects.servo-lag]
        time = "8 ms"
    "#;
    place.write("cam.toml", circle);
    let answer = place.fem(&["correct", "cam.toml", "--json", "-o", "out"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let found = parsed(&answer.out);
    let actions = found["actions"].as_array().unwrap();
    let of = |words: &str| actions.iter().find(|own| own["text"].as_str().unwrap().contains(words)).unwrap();
    // 20 rpm for 8 ms are 0.96 deg, which turn a centre 4 mm beside the axis by 67 um. What the wheel has lost stays on the cam.
    let (wheel, lag) = (of("for the wheel as it is, of 174.970 mm"), of("take 0.9600 deg off"));
    assert!((wheel["gain"].as_f64().unwrap() - 30e-6).abs() < 1e-6, "{wheel}");
    assert!((lag["gain"].as_f64().unwrap() - 65e-6).abs() < 3e-6, "{lag}");
    // With the wheel set, a seventh of the lag keeps 10 um.
    assert!(of("turn the cam at")["minutes"].as_f64().unwrap() > 0.0);
    assert_eq!(
        (found["correction"].as_array().unwrap().len(), &found["tolerance"]["probability_in"]),
        (0, &0.0.into())
    );
    assert!(place.read("out/correction.html").contains("make the programme for the wheel"));
}

/// A spring of 40 ± 4 N/um at the tailstock: the diameter there moves by 2·F/k·(x/L)², and its standard uncertainty by a tenth.
#[test]
fn a_run_tells_how_far_it_may_be_off() {
    let place = Place::new();
    place.write("shaft.toml", format!("{SHAFT}[tolerance]\ndiameter = \"+-40 um\"\n"));
    let answer = place.fem(&["run", "shaft.toml", "--json", "-o", "out"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let band = &parsed(&answer.out)["band"];
    let widest = band["observables"][0]["widest"].as_f64().unwrap();
    // 2·200/40 = 10 um, of which 95 % are 1.96 tenths; 400 draws tell that to some percent.
    assert!((widest / 1.96 - 1.0).abs() < 0.15, "{band}");
    let (csv, page) = (place.read("out/bands.csv"), place.fem(&["run", "shaft.toml", "-o", "more"]).out);
    let head = csv.lines().next().unwrap();
    assert!(head.ends_with("predicted [um],from [um],to [um],lower_limit [um],upper_limit [um]"), "{head}");
    assert!(
        page.contains("95 % band                the diameter up to ±") && page.contains("one value is known roughly"),
        "{page}"
    );
    assert!(place.files().contains(&"out/allowed.pvd".to_string()));
    // A model that knows everything says nothing of it.
    place.write("sure.toml", SHAFT.replace("40 +- 4", "40"));
    let sure = parsed(&place.fem(&["run", "sure.toml", "--json", "-o", "sure"]).out);
    assert!(sure["band"].is_null() && !place.files().contains(&"sure/bands.csv".to_string()));
}

/// Parts as they were measured, against the drawing and the uncertainty of the measurement.
#[test]
fn a_comparison_tells_what_is_in_and_out() {
    let place = Place::new();
    place.write("shaft.toml", format!("{SHAFT}[tolerance]\ndiameter = \"+-20 um\"\n"));
    place.write("seen.csv", "part,x [mm],diameter_error [um],u [um]\n1,150,10,1\n2,150,19,1\n3,150,30,1\n");
    let answer = place.fem(&["compare", "shaft.toml", "--with", "seen.csv", "--json"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert_eq!(parsed(&answer.out)["tolerance"][0]["out"], serde_json::json!([3]));
    let page = place.fem(&["compare", "shaft.toml", "--with", "seen.csv"]).out;
    assert!(page.contains("part 2 is neither proven in nor out: within ±2 um of a limit (ISO 14253-1"), "{page}");
}

/// What a process knows to do beside the command.
#[test]
fn what_to_do_beside_the_command_is_said() {
    let place = Place::new();
    let ring = model("ring.toml").replace("jaws = 3\n", "jaws = 3\nfriction = 0.15\n");
    place.write("ring.toml", ring.replace("force_per_depth", "cutting_force = \"300 N\"\nforce_per_depth"));
    let thermal = model("thermal.toml").replace("[[source]]", "[tolerance]\nlength = \"±8 um\"\n[[source]]");
    place.write("thermal.toml", thermal.replace("[[\"0 min\", \"90 min\"]]", "[[\"0 min\", \"180 min\"]]"));
    place.write("axis.toml", model("axis.toml"));
    place.write("contour.toml", model("contour.toml"));
    place.write("shaft.toml", SHAFT.replace("30 mm", "60 mm"));
    for (name, said) in [
        ("ring", "still hold the cut with a margin of 2.0, not 3000 N"),
        ("thermal", "before the size is set"),
        ("axis", "reversal compensation of"),
        ("contour", "the contour is within what is allowed"),
        ("shaft", "move the tailstock by"),
    ] {
        let found = parsed(&place.fem(&["correct", &format!("{name}.toml"), "--json"]).out);
        let actions = found["actions"].as_array().unwrap();
        assert!(actions.iter().any(|own| own["text"].as_str().unwrap().contains(said)), "{name}: {actions:?}");
    }
    // n·mu·F·Ro = S·Fc·Ri at the speed of the cut: 2·300 N·42 mm/(3·0.15·50 mm), and what turning takes off the jaws.
    let found = parsed(&place.fem(&["correct", "ring.toml", "--json"]).out);
    let speed = 400.0 * std::f64::consts::TAU / 60.0;
    let least = 2.0 * 300.0 * 42.0 / (3.0 * 0.15 * 50.0) + 0.06 * speed * speed;
    let to = found["actions"][0]["to"].as_f64().unwrap();
    assert!((to / least - 1.0).abs() < 1e-9, "{to} {least}");
    // The growth of a rod that is heated on and on settles: half of what is left after a time is left after some more.
    let found = parsed(&place.fem(&["correct", "thermal.toml", "--json"]).out);
    let minutes = found["actions"][0]["minutes"].as_f64().unwrap();
    assert!((20.0..180.0).contains(&minutes), "{minutes}");
}

/// Two springs of which the measurements know the sum: together they say what will be made, each for itself they do not.
#[test]
fn what_is_fitted_together_is_known_together() {
    let place = Place::new();
    let rough = SHAFT.replace("40 +- 4 N/um", "40 +- 20 N/um").replace("rate = \"9 um/km\"", "rate = \"9 +- 9 um/km\"");
    let rough = format!("{rough}[effects.setting-error]\noffset = \"0 +- 50 um\"\n");
    place.write("true.toml", SHAFT.replace(" +- 4", ""));
    place.write("rough.toml", rough);
    assert_eq!(place.fem(&["run", "true.toml", "-o", "out"]).status, 0);
    let rows: Vec<String> = place
        .read("out/profile.csv")
        .lines()
        .enumerate()
        .filter(|(i, _)| i % 12 == 0 || *i == 0)
        .map(|(_, line)| line.to_string())
        .collect();
    let data = rows.iter().enumerate().map(|(i, line)| format!("{line},{}\n", if i == 0 { "u [um]" } else { "0.8" }));
    place.write("m.csv", data.collect::<String>());
    let fitted = place.fem(&["fit", "rough.toml", "--with", "m.csv", "--add-to", "better.toml"]);
    assert_eq!(fitted.status, 0, "{}", fitted.err);
    let better = place.read("better.toml");
    assert!(better.contains("[known.together]") && better.contains("correlation = \""), "{better}");
    let widest = |name: &str| {
        let found = parsed(&place.fem(&["correct", name, "--json"]).out);
        let half =
            |left: &Json| 0.5 * (left["interval95"][1].as_f64().unwrap() - left["interval95"][0].as_f64().unwrap());
        found["left"].as_array().unwrap().iter().map(half).fold(0.0, f64::max)
    };
    let apart = better.split("[known.together]").next().unwrap().to_string();
    place.write("apart.toml", apart);
    let (together, apart) = (widest("better.toml"), widest("apart.toml"));
    assert!(together < 0.7 * apart, "{together} {apart}");
    // What is wrong in it is told with its place.
    place.write("wrong.toml", better.replace("correlation = \"", "correlation = \"7 "));
    let wrong = place.fem(&["correct", "wrong.toml"]);
    assert!(wrong.status == 2 && wrong.err.contains("`correlation` is none of"), "{}", wrong.err);
    // A fit that follows puts its own in the place of it.
    let again = place.fem(&["fit", "better.toml", "--with", "m.csv", "--add-to", "again.toml"]);
    assert_eq!((again.status, place.read("again.toml").matches("[known.together]").count()), (0, 1), "{}", again.err);
}

/// A model that fails against its measurements promises no more than it kept: what a constant leaves of three effects.
#[test]
fn what_stays_unexplained_is_kept_and_widens_what_is_promised() {
    let place = Place::new();
    place.write("measured.csv", model("story/measured.csv"));
    place.write("one.toml", format!("{}\n[effects.setting-error]\noffset = \"? um\"\n", model("story/rigid.toml")));
    let fitted = place.fem(&["fit", "one.toml", "--with", "measured.csv", "--add-to", "fitted.toml", "--json"]);
    assert_eq!(fitted.status, 0, "{}", fitted.err);
    // The noise of 1 um is not of the part.
    let rms = parsed(&fitted.out)["rms"].as_f64().unwrap();
    let expected = (rms * rms - 1.0).sqrt();
    let text = place.read("fitted.toml");
    assert!(text.contains(&format!("unexplained = \"{expected:.3} um\"")), "{expected}: {text}");
    let run = parsed(&place.fem(&["run", "fitted.toml", "--json", "-o", "out"]).out);
    let [widest, told] = [&run["band"]["observables"][0]["widest"], &run["band"]["unexplained"]];
    assert!((told.as_f64().unwrap() - expected).abs() < 1e-3 && widest.as_f64().unwrap() > 1.8 * expected, "{run}");
    // Nothing is corrected by it, unless that is asked for; then it is said.
    let refused = place.fem(&["correct", "fitted.toml", "-o", "no"]);
    assert!(refused.status == 2 && refused.err.contains("failed against the measurements"), "{}", refused.err);
    assert!(!place.files().iter().any(|file| file.starts_with("no/")));
    let forced = place.fem(&["correct", "fitted.toml", "--despite-failure"]);
    assert!(forced.status == 0 && forced.out.contains("caution: the model failed against"), "{}", forced.out);
    assert!(place.fem(&["run", "fitted.toml", "-o", "again"]).out.contains("caution: the model failed against"));
    // A fit that explains everything says nothing of it.
    let whole = place.fem(&["diagnose", "one.toml", "--with", "measured.csv", "--add-to", "whole.toml"]);
    assert!(whole.status == 0 && !place.read("whole.toml").contains("unexplained"), "{}", whole.err);
    for (wrong, help) in [("-1 um", "unexplained"), ("1 N", "measures a force")] {
        place
            .write("bad.toml", format!("{}\n[known.together]\nunexplained = \"{wrong}\"\n", model("story/rigid.toml")));
        let answer = place.fem(&["run", "bad.toml"]);
        assert!(answer.status == 2 && answer.err.contains(help), "{wrong}: {}", answer.err);
    }
}

/// A spring that is exactly known, of 40 N/um at the tailstock, or with a probability of 0.3 one of 20 N/um: the diameter
/// there moves by 2·F/k, so that the interval reaches from 10 to 20 um.
#[test]
fn what_may_be_there_instead_counts() {
    let place = Place::new();
    let sure = SHAFT.replace("40 +- 4", "40");
    let values = "effects.tailstock-compliance.stiffness = 20 N/um";
    let table = format!("[known.together]\ninstead = [{{ probability = 0.3, values = \"{values}\" }}]\n");
    place.write("shaft.toml", format!("{sure}{table}"));
    let run = parsed(&place.fem(&["run", "shaft.toml", "--json", "-o", "out"]).out);
    let (widest, others) = (&run["band"]["observables"][0]["widest"], &run["band"]["other_sets"]);
    assert!((widest.as_f64().unwrap() - 5.0).abs() < 1e-6 && *others == 1, "{run}");
    let page = place.fem(&["run", "shaft.toml", "-o", "more"]).out;
    assert!(page.contains("another set of effects explains the measurements"), "{page}");
    // What is left of a correction is as uncertain.
    let found = parsed(&place.fem(&["correct", "shaft.toml", "--json"]).out);
    assert_eq!(found["other_sets"], 1);
    let width = |own: &Json| own["interval95"][1].as_f64().unwrap() - own["interval95"][0].as_f64().unwrap();
    let widest = found["left"].as_array().unwrap().iter().map(width).fold(0.0f64, f64::max);
    assert!((widest - 10e-6).abs() < 0.2e-6, "{widest}");
    // Without the spring altogether nothing moves.
    let none = table.replace(&format!("values = \"{values}\""), "without = \"tailstock-compliance\", values = \"\"");
    place.write("none.toml", format!("{sure}{none}"));
    let run = parsed(&place.fem(&["run", "none.toml", "--json", "-o", "none"]).out);
    assert!((run["band"]["observables"][0]["widest"].as_f64().unwrap() - 5.0).abs() < 1e-6, "{run}");
    for (wrong, told) in [
        ("instead = [{ probability = 2, values = \"\" }]", "probability"),
        ("instead = [{ values = \"\" }]", "probability"),
        ("instead = [{ probability = 0.1, values = \"cut.depth 3\" }]", "without `=`"),
        ("instead = \"some\"", "expected a list"),
        ("of = \"cut.depth\"\ncorrelation = \"\"\nspread = \"square\"", "plain, logarithm or reciprocal"),
    ] {
        place.write("bad.toml", format!("{sure}[known.together]\n{wrong}\n"));
        let answer = place.fem(&["run", "bad.toml"]);
        assert!(answer.status == 2 && answer.err.contains(told), "{wrong}: {}", answer.err);
    }
}

/// Which of two springs gives way one force does not tell, and another force would be answered by a contact otherwise.
#[test]
fn a_diagnosis_leaves_in_the_model_what_may_be_there_instead() {
    let place = Place::new();
    let bare = SHAFT.split("[effects").next().unwrap();
    place.write("shaft.toml", bare);
    let off = [0.3, -0.8, 0.5, 0.9, -0.2, -0.6, 0.1, 0.7, -0.9, 0.4, -0.3, 0.2];
    let inertia = std::f64::consts::PI * 30f64.powi(4) / 64.0;
    let row = |(i, off): (usize, &f64)| {
        let share = (i as f64 + 0.5) / 12.0;
        // Of a shaft between centres F·a²·b²/(3·E·I·L), and of the spring.
        let bent = 200.0 * (share * (1.0 - share)).powi(2) * 300f64.powi(3) / (3.0 * 210e3 * inertia) * 1e3;
        format!("{},{},0.7\n", 300.0 * share, 2.0 * (bent + 200.0 / 40.0 * share * share) + off)
    };
    let rows: String = off.iter().enumerate().map(row).collect();
    place.write("measured.csv", format!("x [mm],diameter_error [um],u [um]\n{rows}"));
    let found = place.fem(&["diagnose", "shaft.toml", "--with", "measured.csv", "--add-to", "better.toml"]);
    assert_eq!(found.status, 0, "{}", found.err);
    let better = place.read("better.toml");
    assert!(better.contains("instead = ["), "{better}");
    // At twice the force a spring gives way twice as far, and an offset does not: nobody knows so well what comes of it.
    let widest = |text: String| {
        place.write("now.toml", text.replace("\"200 N\"", "\"400 N\"").replace("parts = 3", "parts = 1"));
        let run = parsed(&place.fem(&["run", "now.toml", "--json", "-o", "out"]).out);
        run["band"]["observables"][0]["widest"].as_f64().unwrap()
    };
    let spring = better.split("[known.together]").next().unwrap().to_string()
        + &better[better.find("[effects.tailstock-compliance]").unwrap()..];
    let (all, spring) = (widest(better.clone()), widest(spring));
    assert!(all > 1.05 * spring, "{all} {spring}: {better}");
}

#[test]
fn a_machine_is_commanded_no_farther_than_it_may() {
    let place = Place::new();
    place.write("shaft.toml", format!("{SHAFT}[correction]\nlargest = \"200 um\"\n"));
    assert_eq!(place.fem(&["correct", "shaft.toml"]).status, 0);
    place.write("shaft.toml", format!("{SHAFT}[correction]\nlargest = \"2 um\"\n"));
    let refused = place.fem(&["correct", "shaft.toml", "-o", "no"]);
    assert!(refused.status == 2 && refused.err.contains("and may by 2.0 um"), "{}", refused.err);
    assert!(!place.files().iter().any(|file| file.starts_with("no/")));
    place.write("shaft.toml", format!("{SHAFT}[correction]\nlargest = \"-2 um\"\n"));
    assert_eq!(place.fem(&["run", "shaft.toml"]).status, 2);
}
