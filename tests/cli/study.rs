//! Studies as a user meets them: rows that no number of threads, no end of the program and no number of shards
//! changes; jobs that fail; plans that are refused; and numbers that `fem run`, `fem fit` and closed forms give too.

use std::process::Stdio;
use std::time::{Duration, Instant};

use serde_json::Value as Json;

use super::fem::{Answer, Mistake, Place, answer, model};

/// A spring whose deflection under 1 kN is 1000/k.
const SPRING: &str =
    "process = \"stiffness\"\njoint = { stiffness = \"80 +- 8 N/um\" }\ntest = { max_force = \"1 kN\" }\n";

/// A plan over the spring.
fn plan(design: &str, rest: &str) -> String {
    format!("model = \"spring.toml\"\n{rest}\n[design]\n{design}\n")
}

fn place(design: &str, rest: &str) -> Place {
    let place = Place::new();
    place.write("spring.toml", SPRING);
    place.write("plan.toml", plan(design, rest));
    place
}

fn json(place: &Place, args: &[&str]) -> Json {
    let answer = place.fem(&[args, &["--json"]].concat());
    assert_eq!(answer.status, 0, "{}", answer.err);
    serde_json::from_str(&answer.out).unwrap()
}

fn on_threads(place: &Place, threads: &str, args: &[&str]) -> Answer {
    answer(place.command(args).env("RAYON_NUM_THREADS", threads).output().unwrap())
}

/// Rows without their header, cell by cell.
fn rows(place: &Place, file: &str) -> Vec<Vec<String>> {
    place.read(file).lines().skip(1).map(|line| line.split(',').map(str::to_string).collect()).collect()
}

#[test]
fn rows_depend_on_the_seed_and_on_no_number_of_threads() {
    for design in ["random", "latin-hypercube", "sobol"] {
        let place = place(&format!("type = \"{design}\"\nsamples = 40\nindices = true"), "");
        for threads in ["1", "2", "5"] {
            assert_eq!(on_threads(&place, threads, &["study", "plan.toml", "-o", threads]).status, 0);
        }
        let one = place.read("1/rows.csv");
        assert_eq!((one.lines().count(), one.starts_with("job,joint.stiffness [N/um],")), (121, true));
        assert!(one == place.read("2/rows.csv") && one == place.read("5/rows.csv"), "{design}");
        assert_eq!(place.read("1/study.json"), place.read("5/study.json"));
        place.write("plan.toml", plan(&format!("type = \"{design}\"\nsamples = 40\nindices = true\nseed = 2"), ""));
        assert_eq!(place.fem(&["study", "plan.toml", "-o", "other"]).status, 0);
        assert_ne!(one, place.read("other/rows.csv"));
    }
}

/// A small generator of moments (Steele, Lea, Flood 2014).
fn mixed(seed: u64) -> u64 {
    let mut z = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z ^ (z >> 27)
}

#[test]
fn a_study_that_is_killed_goes_on_where_it_was() {
    let place = place("type = \"random\"\nsamples = 4000", "");
    assert_eq!(place.fem(&["study", "plan.toml", "-o", "whole"]).status, 0);
    let whole = place.read("whole/rows.csv");
    let there = || std::fs::read_to_string(place.path("killed/rows.partial.csv")).unwrap_or_default();
    let is_done = || place.path("killed/rows.csv").exists();
    let mut before = 0;
    for i in 0..36 {
        if is_done() {
            // Once more from the beginning.
            std::fs::remove_dir_all(place.path("killed")).unwrap();
            before = 0;
        }
        let mut command = place.command(&["study", "plan.toml", "-o", "killed"]);
        let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        // Two of three after some rows more, however fast the machine is, and one while the program begins.
        let began = Instant::now();
        while i % 3 > 0 && there().len() <= before && !is_done() {
            assert!(began.elapsed() < Duration::from_secs(60), "no row in a minute");
            std::thread::sleep(Duration::from_millis(1));
        }
        std::thread::sleep(Duration::from_micros(mixed(i) % 25_000));
        child.kill().unwrap();
        child.wait().unwrap();
        if is_done() {
            continue;
        }
        let text = there();
        // Nothing of what was there is lost but what was torn, and what is there is a beginning of the whole.
        assert!(whole.starts_with(&text), "kill {i}");
        let kept = text.rfind('\n').map_or(0, |end| end + 1);
        assert!(kept >= before, "kill {i}: {kept} of {before} bytes");
        before = kept;
    }
    // A line that was torn by the loss of the machine's power.
    if !is_done() {
        let torn = there() + "\0\0\0\n17,";
        place.write("killed/rows.partial.csv", torn);
    }
    let last = place.fem(&["study", "plan.toml", "-o", "killed"]);
    assert_eq!(last.status, 0, "{}", last.err);
    assert!(whole == place.read("killed/rows.csv"));
    assert_eq!(place.read("whole/study.json"), place.read("killed/study.json"));
    let again = place.fem(&["study", "plan.toml", "-o", "killed"]);
    assert_eq!((again.status, again.out == last.out), (0, true), "{}", again.err);
}

#[test]
fn shards_put_together_are_the_whole() {
    for (design, count) in [("type = \"sobol\"\nsamples = 33\nindices = true", 99), ("samples = 10", 10)] {
        let place = place(design, "");
        assert_eq!(place.fem(&["study", "plan.toml", "-o", "whole"]).status, 0);
        let folders = ["a", "b", "c", "d"];
        for (i, folder) in folders.iter().enumerate() {
            let shard = format!("{}/4", i + 1);
            let done = place.fem(&["study", "plan.toml", "--shard", &shard, "-o", folder]);
            assert_eq!(done.status, 0, "{}", done.err);
            assert!(done.err.contains(&format!("shard {shard}")), "{}", done.err);
        }
        let merged = place.fem(&["study", "merge", "c", "a", "d", "b", "-o", "merged"]);
        assert_eq!(merged.status, 0, "{}", merged.err);
        assert_eq!(rows(&place, "merged/rows.csv").len(), count);
        for file in ["rows.csv", "study.json", ".fem-study.json"] {
            assert_eq!(place.read(&format!("whole/{file}")), place.read(&format!("merged/{file}")), "{file}");
        }
        let told = |folders: &[&str]| place.fem(&[&["study", "merge"], folders, &["-o", "none"]].concat());
        for (folders, message) in [
            (&["a", "b", "d"][..], "are in none of the folders"),
            (&["a", "b", "c"], "are in none of the folders"),
            (&["a", "b", "c", "d", "b"], "stands in two folders"),
            (&["a", "whole"], "stands in two folders"),
            (&["a", "."], "holds no rows of a study"),
        ] {
            let refused = told(folders);
            assert_eq!(refused.status, 2, "{folders:?}");
            assert!(refused.err.contains(message) && refused.err.contains("help: "), "{folders:?}: {}", refused.err);
        }
        assert!(!place.path("none").exists());
        place.write("other.toml", plan(&format!("{design}\nseed = 9"), ""));
        assert_eq!(place.fem(&["study", "other.toml", "--shard", "2/4", "-o", "e"]).status, 0);
        let foreign = told(&["a", "e", "c", "d"]);
        assert!(foreign.err.contains("different plans: `seed` was 1 and is 9"), "{}", foreign.err);
        let over = place.fem(&["study", "plan.toml", "--shard", "2/4", "-o", "late", "--time-limit", "0 s"]);
        assert_eq!(over.status, 0, "{}", over.err);
        let unfinished = told(&["a", "late", "c", "d"]);
        assert!(unfinished.err.contains("is not finished"), "{}", unfinished.err);
    }
}

#[test]
fn a_time_limit_leaves_jobs_for_the_next_time() {
    let place = place("samples = 20", "");
    let over = place.fem(&["study", "plan.toml", "-o", "out", "--time-limit", "0 s"]);
    assert_eq!(over.status, 0);
    assert!(over.err.contains("20 jobs are left"), "{}", over.err);
    assert!(!place.path("out/rows.csv").exists());
    assert_eq!(place.fem(&["study", "plan.toml", "-o", "out"]).status, 0);
    assert_eq!(rows(&place, "out/rows.csv").len(), 20);
    assert!(!place.path("out/rows.partial.csv").exists());
}

/// The name of the first number that a run of the spring tells.
fn figure(place: &Place) -> String {
    let run = json(place, &["run", "spring.toml"]);
    let findings = run["findings"].as_object().unwrap();
    let numbers = findings.iter().flat_map(|(key, f)| f.as_object().unwrap().iter().map(move |(e, v)| (key, e, v)));
    let (key, entry, _) = numbers.into_iter().find(|(_, _, value)| value.is_f64()).unwrap();
    format!("{key}.{entry}")
}

#[test]
fn a_job_that_fails_is_told_and_stops_no_other() {
    let place = place("type = \"table\"\nfile = \"points.csv\"", "");
    place.write("points.csv", "joint.stiffness [N/um]\n80\n-3\n100\n0.09 kN\n".replace("0.09 kN", "90"));
    let name = figure(&place);
    let result = format!("[[result]]\nfigure = \"{name}\"");
    let told = json(&place, &["run", "spring.toml"]);
    let (key, entry) = name.split_once('.').unwrap();
    let usual = told["findings"][key][entry].as_f64().unwrap();
    let unit = told["findings"][key]["unit"].as_str().unwrap();
    // Good where it is no more than usual: for 80, 90 and 100 N/um, if it falls with the stiffness, or for 80 alone.
    let tolerance = format!("tolerance = {{ upper = \"{} {unit}\" }}", usual * (1.0 + 1e-9 * usual.signum()));
    place.write("plan.toml", plan("type = \"table\"\nfile = \"points.csv\"", "") + &result + "\n" + &tolerance);
    let answer = place.fem(&["study", "plan.toml"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert!(answer.out.contains("4, 1 failed") && answer.out.contains("job 2: joint.stiffness cannot be -3 N/um"));
    let rows = rows(&place, "out/plan/rows.csv");
    assert_eq!((rows.len(), rows[1][2].as_str(), rows[1][3].as_str()), (4, "", "joint.stiffness cannot be -3 N/um"));
    let first: f64 = rows[0][2].parse().unwrap();
    assert!((first - usual).abs() <= 4.0 * f64::EPSILON * usual.abs() && rows[0][3].is_empty());
    let found = json(&place, &["study", "plan.toml"]);
    let accepted = &found["results"][0]["yield"];
    assert_eq!((accepted["failed"].as_u64(), found["failed"].as_u64()), (Some(1), Some(1)));
    // A failed job is not good, and is not left out.
    assert_eq!(accepted["share"].as_f64().unwrap(), accepted["good"].as_f64().unwrap() / 4.0);
    assert!(accepted["interval95"].is_null(), "a table stands for no distribution");
    // Where nothing else is to be had, the command fails.
    place.write("points.csv", "joint.stiffness [N/um]\n-3\n-4\n");
    let none = place.fem(&["study", "plan.toml", "-o", "none"]);
    assert!(none.status == 1 && none.err.contains("every job failed: joint.stiffness cannot be -3"), "{}", none.err);
}

#[test]
fn rows_are_what_a_run_gives() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml").replace("positions = 101", "positions = 11"));
    let grid = "model = \"lathe.toml\"\n[design]\ntype = \"grid\"\n[[input]]\nquantity = \"cut.radial_force\"\nvalues = [\"300 N\", \"0.45 kN\"]\n[[input]]\nquantity = \"effects.tool-wear.rate\"\nfrom = \"4 um/km\"\nto = \"8 um/km\"\nsteps = 3\n[[input]]\nquantity = \"workpiece.segments[1].length\"\nvalues = [\"300 mm\"]\n[[result]]\nfigure = \"largest\"\n[[result]]\nfigure = \"batch.part_means.11\"\n[[result]]\nfigure = \"form.form\"\n";
    place.write("plan.toml", grid);
    let answer = place.fem(&["study", "plan.toml", "-o", "out"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let rows = rows(&place, "out/rows.csv");
    assert_eq!(rows.len(), 6);
    // Reading JSON may round a number to its neighbour.
    let same = |cell: &str, number: &Json| {
        let (cell, number) = (cell.parse::<f64>().unwrap(), number.as_f64().unwrap());
        assert!((cell - number).abs() <= 4.0 * f64::EPSILON * number.abs(), "{cell} for {number}");
    };
    for row in &rows {
        let text =
            place.read("lathe.toml").replace("radial_force = \"450 N\"", &format!("radial_force = \"{} N\"", row[1]));
        place.write("one.toml", text.replace("rate = \"8 um/km\"", &format!("rate = \"{} um/km\"", row[2])));
        let run = json(&place, &["run", "one.toml"]);
        let found = &run["findings"];
        same(&row[4], &found["largest"]["value"]);
        same(&row[5], &found["batch"]["part_means"][11]);
        assert_eq!(found["form"]["form"], row[6].as_str());
    }
    let cells: Vec<(&str, &str)> = rows.iter().map(|r| (r[1].as_str(), r[2].as_str())).collect();
    assert_eq!(cells, [("300", "4"), ("300", "6"), ("300", "8"), ("450", "4"), ("450", "6"), ("450", "8")]);
    // Rows of results are a table of points.
    let columns: String = place
        .read("out/rows.csv")
        .lines()
        .map(|l| l.split(',').skip(1).take(2).collect::<Vec<_>>().join(",") + "\n")
        .collect();
    place.write("points.csv", columns);
    place.write("table.toml", "model = \"lathe.toml\"\ndesign = { type = \"table\", file = \"points.csv\" }\nresult = [{ figure = \"largest\" }]\n");
    assert_eq!(place.fem(&["study", "table.toml", "-o", "again"]).status, 0);
    let again = self::rows(&place, "again/rows.csv");
    assert!(rows.iter().zip(&again).all(|(a, b)| a[4] == b[3]) && again.len() == 6);
}

/// 1000/k of a normal k of 80 ± 8, not nearer than what the law is cut off at: moments and yield by quadrature.
#[test]
fn moments_and_yield_are_those_of_the_law() {
    let place = place("type = \"random\"\nsamples = 4000", "");
    let name = figure(&place);
    let told = json(&place, &["run", "spring.toml"]);
    let (key, entry) = name.split_once('.').unwrap();
    let at_80 = told["findings"][key][entry].as_f64().unwrap();
    place.write("stiff.toml", SPRING.replace("80 +- 8", "160"));
    let stiff = json(&place, &["run", "stiff.toml"])["findings"][key][entry].as_f64().unwrap();
    // It is in inverse or in direct proportion to the stiffness.
    let power = (stiff / at_80).log2().round();
    assert!((stiff / at_80 - 2f64.powf(power)).abs() < 1e-6 && power != 0.0, "{name}: {at_80} and {stiff}");
    let of = |k: f64| at_80 * (k / 80.0).powf(power);
    let unit = told["findings"][key]["unit"].as_str().unwrap();
    let limits = [of(70.0).min(of(95.0)), of(70.0).max(of(95.0))];
    let tolerance = format!("tolerance = {{ lower = \"{} {unit}\", upper = \"{} {unit}\" }}\n", limits[0], limits[1]);
    let plan = plan("type = \"random\"\nsamples = 4000", "") + &format!("[[result]]\nfigure = \"{name}\"\n{tolerance}");
    place.write("plan.toml", plan);
    let found = json(&place, &["study", "plan.toml"]);
    let result = &found["results"][0];
    let (mut first, mut second, mut within, mut weight) = (0.0, 0.0, 0.0, 0.0);
    for i in 0..=120_000 {
        let z = -6.0 + 1e-4 * f64::from(i);
        let (w, y) = ((-0.5 * z * z).exp(), of(80.0 + 8.0 * z));
        (first, second, weight) = (first + w * y, second + w * y * y, weight + w);
        within += if (limits[0]..=limits[1]).contains(&y) { w } else { 0.0 };
    }
    let (mean, share) = (first / weight, within / weight);
    let std = (second / weight - mean * mean).sqrt();
    let number = |value: &Json| value.as_f64().unwrap();
    assert!((number(&result["mean"]) - mean).abs() < 4.0 * std / 4000f64.sqrt());
    // The kurtosis of 1/k is a little above that of a normal law.
    assert!((number(&result["std"]) - std).abs() < 4.0 * std * (1.0f64 / 4000.0).sqrt());
    let (low, high) = (number(&result["yield"]["interval95"][0]), number(&result["yield"]["interval95"][1]));
    assert!((number(&result["yield"]["share"]) - share).abs() < 4.0 * (share * (1.0 - share) / 4000.0).sqrt());
    assert!(low < number(&result["yield"]["share"]) && number(&result["yield"]["share"]) < high && high - low < 0.03);
    // The worst job is one of those that lie furthest out.
    let ends = [number(&result["smallest"]["value"]), number(&result["largest"]["value"])];
    let beyond = |y: f64| (limits[0] - y).max(y - limits[1]);
    assert_eq!(beyond(number(&result["worst"]["value"])), beyond(ends[0]).max(beyond(ends[1])));
}

#[test]
fn fits_and_diagnoses_are_those_of_the_commands() {
    let place = Place::new();
    place.write("spring.toml", SPRING.replace("80 +- 8", "? near 80"));
    for (name, stiffness) in [("m1.csv", 70.0), ("m2.csv", 90.0)] {
        // A scatter as the uncertainty says.
        let scatter = [0.11, -0.08, 0.02, -0.15, 0.09, 0.13, -0.04, -0.12, 0.06, 0.01];
        let row = |(i, off): (u32, f64)| {
            let force = 100.0 * f64::from(i);
            format!("{force},{},0.1\n", force / stiffness + off)
        };
        let rows: String = (1..).zip(scatter).map(row).collect();
        place.write(name, format!("force [N],displacement [um],u [um]\n{rows}"));
    }
    for task in ["fit", "diagnose"] {
        place.write("plan.toml", format!("model = \"spring.toml\"\ntask = \"{task}\"\ndata = \"m*.csv\"\n"));
        let answer = place.fem(&["study", "plan.toml", "-o", task]);
        assert_eq!(answer.status, 0, "{}", answer.err);
        let header = place.read(&format!("{task}/rows.csv")).lines().next().unwrap().to_string();
        let column = header.split(',').position(|name| name == "joint.stiffness [N/um]").unwrap();
        let rows = rows(&place, &format!("{task}/rows.csv"));
        assert_eq!((rows.len(), rows[0][1].as_str(), rows[1][1].as_str()), (2, "m1.csv", "m2.csv"));
        for row in rows {
            let single = json(&place, &["fit", "spring.toml", "--with", &row[1]]);
            let value = single["parameters"][0]["value"].as_f64().unwrap();
            let found: f64 = row[column].parse().unwrap();
            assert!((found - value).abs() < 1e-3 * value, "{task}: {found} for {value}");
        }
    }
    let words = place.read("diagnose/rows.csv");
    assert!(words.contains(",adequate,nothing,"), "{words}");
    // A data file of a row's own, from a table, and a quantity that is entered instead of fitted.
    place.write("points.csv", "data,test.max_force [kN]\nm2.csv,1\nm1.csv,2\n");
    place.write(
        "plan.toml",
        "model = \"spring.toml\"\ntask = \"fit\"\ndesign = { type = \"table\", file = \"points.csv\" }\n",
    );
    assert_eq!(place.fem(&["study", "plan.toml", "-o", "table"]).status, 0);
    let rows = rows(&place, "table/rows.csv");
    assert_eq!((rows[0][2].as_str(), rows[1][2].as_str()), ("m2.csv", "m1.csv"));
}

#[test]
fn rows_that_were_altered_are_not_believed() {
    let place = place("type = \"random\"\nsamples = 40", "");
    let study = |more: &[&str]| place.fem(&[&["study", "plan.toml", "-o", "out"], more].concat());
    assert_eq!(study(&[]).status, 0);
    let whole = place.read("out/rows.csv");
    let lines: Vec<&str> = whole.split_inclusive('\n').collect();
    // Another number, no number, two rows exchanged, the last one gone.
    let cells: Vec<&str> = lines[7].split(',').collect();
    let other = |cell: &str| lines[7].replacen(cells[2], cell, 1);
    let altered = |line: &str| [&lines[..7], &[line], &lines[8..]].concat().concat();
    let exchanged = [&lines[..7], &[lines[8], lines[7]], &lines[9..]].concat().concat();
    for text in [altered(&other("1.5")), altered(&other("nan")), exchanged, lines[..40].concat()] {
        place.write("out/rows.csv", &text);
        let refused = study(&[]);
        assert!(refused.status == 2 && refused.err.contains("is not as it was written"), "{}", refused.err);
        assert_eq!(place.read("out/rows.csv"), text);
    }
    assert_eq!(study(&["--restart"]).status, 0);
    assert_eq!(place.read("out/rows.csv"), whole);
    // Unfinished ones are computed again from there on.
    std::fs::remove_file(place.path("out/rows.csv")).unwrap();
    place.write("out/rows.partial.csv", altered(&other("1.5")));
    let again = study(&[]);
    assert!(again.status == 0 && again.err.contains("note: row 7 in out was not as it was written"), "{}", again.err);
    assert_eq!(place.read("out/rows.csv"), whole);
    // A shard is asked too.
    for shard in ["1/2", "2/2"] {
        let folder = &shard[..1];
        assert_eq!(place.fem(&["study", "plan.toml", "-o", folder, "--shard", shard]).status, 0);
    }
    let second = place.read("2/rows.csv");
    place.write("2/rows.csv", second.replacen("\n22,", "\n22,1", 1));
    let merged = place.fem(&["study", "merge", "1", "2", "-o", "merged"]);
    assert!(merged.status == 2 && merged.err.contains("row 22 of shard 2/2"), "{}", merged.err);
    // What the rows are held against is no file to go on without.
    place.write("2/rows.csv", &second);
    std::fs::remove_file(place.path("2/.fem-rows.sums")).unwrap();
    let merged = place.fem(&["study", "merge", "1", "2", "-o", "merged"]);
    assert!(merged.status == 2 && merged.err.contains("copy the whole folder"), "{}", merged.err);
    std::fs::remove_file(place.path("out/.fem-rows.sums")).unwrap();
    place.write("out/rows.csv", altered(&other("999")));
    for force in [&[][..], &["--force"]] {
        let refused = study(force);
        assert!(refused.status == 2 && refused.err.contains("nothing tells whether"), "{}", refused.err);
    }
    assert_eq!(study(&["--restart"]).status, 0);
    std::fs::remove_file(place.path("out/.fem-study.json")).unwrap();
    let refused = study(&["--force"]);
    assert!(refused.status == 2 && refused.err.contains("take the file away"), "{}", refused.err);
    assert!(!refused.err.contains("--force"), "{}", refused.err);
}

#[test]
fn what_was_begun_otherwise_is_refused() {
    let place = place("samples = 20", "");
    let name = figure(&place);
    assert_eq!(place.fem(&["study", "plan.toml", "-o", "out"]).status, 0);
    let rows = place.read("out/rows.csv");
    place.write("plan.toml", plan("samples = 21", ""));
    let changed = place.fem(&["study", "plan.toml", "-o", "out"]);
    assert_eq!(changed.status, 2);
    assert!(changed.err.contains("of another plan: `samples` was 20 and is 21"), "{}", changed.err);
    assert!(changed.err.contains("--restart"), "{}", changed.err);
    place.write("plan.toml", plan("samples = 20", ""));
    let shard = place.fem(&["study", "plan.toml", "-o", "out", "--shard", "1/2"]);
    assert!(shard.status == 2 && shard.err.contains("those of shard 1/1, not of 1/2"), "{}", shard.err);
    place.write("spring.toml", SPRING.replace("80", "81"));
    let other = place.fem(&["study", "plan.toml", "-o", "out"]);
    assert!(other.err.contains("the content of spring.toml was "), "{}", other.err);
    assert_eq!(place.read("out/rows.csv"), rows, "nothing was touched");
    assert_eq!(place.fem(&["study", "plan.toml", "-o", "out", "--restart"]).status, 0);
    assert_ne!(place.read("out/rows.csv"), rows);
    // What is wanted of the rows that are there needs no new ones.
    let result = format!("[[result]]\nfigure = \"{name}\"\n");
    place.write("plan.toml", plan("samples = 20", "") + &result);
    assert_eq!(place.fem(&["study", "plan.toml", "-o", "two"]).status, 0);
    let unit = json(&place, &["run", "spring.toml"])["findings"][name.split_once('.').unwrap().0]["unit"].clone();
    let tolerance = format!("tolerance = {{ upper = \"1 {}\" }}\n", unit.as_str().unwrap());
    place.write("plan.toml", plan("samples = 20", "# a comment\ntitle = \"Other\"") + &result + &tolerance);
    let told = place.fem(&["study", "plan.toml", "-o", "two"]);
    assert!(told.status == 0 && told.out.contains("yield"), "{}", told.err);
    // Files of others stay.
    std::fs::create_dir(place.path("mine")).unwrap();
    place.write("mine/rows.csv", "mine\n");
    let mine = place.fem(&["study", "plan.toml", "-o", "mine", "--restart"]);
    assert!(mine.status == 2 && place.read("mine/rows.csv") == "mine\n", "{}", mine.err);
}

#[test]
fn a_starting_plan_runs_and_has_a_schema() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml").replace("positions = 101", "positions = 5"));
    assert!(place.fem(&["new", "study", "-o", "plan.toml"]).out.contains("next: fem study plan.toml"));
    let text = place.read("plan.toml").replace("samples = 1000", "samples = 20");
    place.write("plan.toml", text);
    let answer = place.fem(&["study", "plan.toml"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    assert!(answer.out.contains("cut.depth = ") && answer.out.contains("effects.headstock-compliance.stiffness = "));
    let schema: Json = serde_json::from_str(&place.fem(&["schema", "study"]).out).unwrap();
    assert_eq!(schema["properties"]["design"]["properties"]["samples"]["minimum"], 1);
    assert!(schema["properties"]["input"]["items"]["properties"]["half_field"].is_object());
    assert!(schema["properties"]["result"]["items"]["properties"]["tolerance"].is_object());
}

const GOOD: &str = r#"model = "lathe.toml"
task = "run"
[design]
type = "latin-hypercube"
samples = 4
seed = 1
[[input]]
quantity = "cut.depth"
distribution = "uniform"
half_field = "0.1 mm"
[[input]]
quantity = "effects.tool-wear.rate"
half_field = "2 um/km"
[[result]]
figure = "largest.value"
tolerance = { lower = "0 um", upper = "200 um" }
"#;

const MISTAKES: &[Mistake] = &[
    ("model = \"lathe.toml\"", "", "`model` is missing", "add model = "),
    ("model = \"lathe.toml\"", "model = \"lath.toml\"", "lath.toml", "relative to the folder"),
    ("task = \"run\"", "task = \"walk\"", "`task` is \"walk\"", "\"run\", \"fit\", \"diagnose\""),
    ("task = \"run\"", "tusk = \"run\"", "`tusk` is no key", "did you mean `task`?"),
    ("task = \"run\"", "task = \"fit\"", "the measurements are missing", "add data ="),
    ("task = \"run\"", "task = \"fit\"\ndata = \"no*.csv\"", "there is no such file", "by the folder of the plan"),
    ("task = \"run\"", "data = \"lathe.toml\"", "a run has no measurements", "\"fit\" or \"diagnose\""),
    ("\"latin-hypercube\"", "\"latin\"", "`type` is \"latin\"", "\"random\""),
    ("\"latin-hypercube\"", "\"grid\"", "draws nothing has no `samples`", "change `type`"),
    ("\"latin-hypercube\"", "\"table\"", "a table is missing", "add file ="),
    ("samples = 4", "samples = 0", "`samples` is 0", "from 1 to"),
    ("seed = 1", "file = \"lathe.toml\"", "only a design of type \"table\" has a `file`", "remove `file`"),
    ("seed = 1", "indices = 3", "expected true or false", "indices = true"),
    ("\"cut.depth\"", "\"cut.depths\"", "has no quantity `cut.depths`", "did you mean `cut.depth`?"),
    ("quantity = \"cut.depth\"", "", "`quantity` is missing", "the path of a key"),
    ("\"cut.depth\"", "\"effects.tool-wear.rate\"", "stands in two inputs", "keep one"),
    ("half_field = \"0.1 mm\"", "", "nothing says how far `cut.depth` scatters", "add `half_field`"),
    ("half_field = \"0.1 mm\"", "half_field = \"0.1 N\"", "not a length", "write it in mm"),
    ("half_field = \"0.1 mm\"", "half_field = \"0.1 +- 0.01 mm\"", "is written with `+-`", "half_field ="),
    ("half_field = \"0.1 mm\"", "half_field = \"0.1 mm\"\nvalue = \"-2 mm\"", "`value` is -2 mm", "above zero"),
    ("half_field = \"0.1 mm\"", "values = [\"1 mm\"]", "said twice", "`from`, `to` and `steps`"),
    ("half_field = \"2 um/km\"", "from = \"2 um/km\"\nto = \"3 um/km\"", "even values need", "all three"),
    ("half_field = \"2 um/km\"", "values = []", "cannot take all of these", "list what it may be"),
    ("\"largest.value\"", "\"largest.valu\"", "there is no result `largest.valu`", "did you mean `largest.value`?"),
    ("upper = \"200 um\"", "upper = \"-200 um\"", "the tolerance is empty", "above `lower`"),
    ("upper = \"200 um\"", "upper = \"200\"", "the unit is missing", "write it in um"),
    ("lower = \"0 um\", upper = \"200 um\"", "", "the tolerance has no end", "`upper` or both"),
];

#[test]
fn mistakes_in_a_plan_are_told_with_their_remedy() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml").replace("positions = 101", "positions = 5"));
    place.write("plan.toml", GOOD);
    let good = place.fem(&["study", "plan.toml"]);
    assert_eq!(good.status, 0, "{}", good.err);
    place.refuses(("study", "plan.toml"), GOOD, MISTAKES);
    let table = "model = \"lathe.toml\"\ndesign = { type = \"table\", file = \"points.csv\" }\n";
    for (points, message) in [
        ("cut.deep [mm]\n1\n", "has no quantity `cut.deep`"),
        ("cut.depth [N]\n1\n", "not a length"),
        ("cut.depth [mm],cut.depth [mm]\n1,1\n", "two columns are `cut.depth`"),
        ("cut.depth [mm]\nx\n", "no finite number"),
        ("cut.depth [mm]\n", "the table has no rows"),
        ("cut.depth [mm],data\n1,\n", "names no file of measurements"),
    ] {
        place.write("points.csv", points);
        place.write("plan.toml", table);
        let told = place.fem(&["study", "plan.toml"]);
        assert!(told.status == 2 && told.err.contains(message), "{points}: {}", told.err);
    }
}

/// The rows in a form that other programs take; they stay in `rows.csv`, from which the study goes on.
#[test]
fn rows_are_written_as_parquet_too() {
    let place = place("type = \"random\"\nsamples = 8", "");
    let study = ["study", "plan.toml", "-o", "out", "--parquet"];
    let answer = place.fem(&[&study[..], &["rows.parquet"]].concat());
    assert_eq!(answer.status, 0, "{}", answer.err);
    let bytes = std::fs::read(place.path("rows.parquet")).unwrap();
    assert!(bytes.starts_with(b"PAR1") && bytes.ends_with(b"PAR1"));
    assert_eq!(rows(&place, "out/rows.csv").len(), 8);
    // A name that says something else is refused before anything is computed, and what somebody else wrote stays.
    let args = [&study[..], &["rows.csv"]].concat();
    place.is_refused(&args, "another ending", ("rows.csv does not end in .parquet", "name the file that is written"));
    place.write("other.parquet", "mine");
    assert_eq!(place.fem(&[&study[..], &["other.parquet"]].concat()).status, 2);
    assert_eq!(place.read("other.parquet"), "mine");
}
