//! Folders of others, with everything in them that could lead a program astray: links, forged lists, leftovers, pipes,
//! files under the names of results. Whatever is run there, nothing outside changes, and nothing within that the
//! program did not write.
//!
//! 120 folders are drawn; `FEM_HOSTILE=2000` before `cargo test --release --test cli hostile` draws so many.

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::time::{Duration, Instant};

use generator::random::Random;

use super::fem::Place;

/// Folders, unless the environment says how many.
const FOLDERS: u64 = 120;
/// No command may wait for something that never comes.
const PATIENCE: Duration = Duration::from_secs(60);

const MODEL: &str =
    "process = \"stiffness\"\njoint = { stiffness = \"80 +- 8 N/um\" }\ntest = { max_force = \"1 kN\" }\n";
const MEASURED: &str = "force [N],displacement [um],u [um]\n100,1.3,0.1\n300,3.7,0.1\n500,6.2,0.1\n900,11.3,0.1\n";
const PLAN: &str = "model = \"model.toml\"\n[design]\ntype = \"monte-carlo\"\nsamples = 20\nseed = 1\n[[input]]\n\
                    quantity = \"joint.stiffness\"\n[[result]]\nfigure = \"largest\"\n";

/// Where results go, and what may stand there.
const RESULTS: &[&str] = &[
    "out",
    "out/model",
    "out/plan",
    "out/model/profile.csv",
    "out/model/summary.json",
    "out/model/.fem-files.json",
    "out/plan/rows.csv",
    "out/plan/rows.partial.csv",
    "out/plan/.fem-study.json",
    "out/plan/study.json",
    "kept",
    "kept/residuals.csv",
    "profile.csv",
    "residuals.csv",
    ".fem-files.json",
    ".fem-1-0.partial",
    ".fem-000000000000000000000000.partial",
    "new.toml",
    "page.html",
];
const COMMANDS: &[&[&str]] = &[
    &["run", "model.toml"],
    &["run", "model.toml"],
    &["run", "model.toml", "-o", "."],
    &["run", "model.toml", "-o", "out/../kept"],
    &["compare", "model.toml", "--with", "measured.csv", "-o", "kept"],
    &["compare", "model.toml", "--with", "measured.csv", "-o", "."],
    &["study", "plan.toml"],
    &["study", "plan.toml"],
    &["study", "plan.toml", "--restart"],
    &["study", "plan.toml", "-o", "kept"],
    &["report", "model.toml", "-o", "page.html"],
    &["add", "model.toml", "gap", "gap=3 um", "-o", "new.toml"],
    &["set", "model.toml", "title=other", "-o", "new.toml"],
    &["fit", "model.toml", "--with", "measured.csv", "--add-to", "new.toml"],
];

/// What stands at a path, with all that tells it from another.
#[derive(Clone, Debug, PartialEq)]
struct Stands {
    inode: u64,
    mode: u32,
    owner: (u32, u32),
    holds: String,
}

fn look(root: &Path, path: &Path, found: &mut BTreeMap<PathBuf, Stands>) {
    let about = path.symlink_metadata().unwrap();
    let holds = match about.file_type() {
        kind if kind.is_symlink() => format!("-> {}", fs::read_link(path).unwrap().display()),
        kind if kind.is_file() => String::from_utf8_lossy(&fs::read(path).unwrap()).into_owned(),
        _ => String::new(),
    };
    let stands = Stands { inode: about.ino(), mode: about.mode(), owner: (about.uid(), about.gid()), holds };
    found.insert(path.strip_prefix(root).unwrap().to_path_buf(), stands);
    if about.is_dir() {
        for entry in fs::read_dir(path).unwrap() {
            look(root, &entry.unwrap().path(), found);
        }
    }
}

fn all(root: &Path) -> BTreeMap<PathBuf, Stands> {
    let mut found = BTreeMap::new();
    look(root, root, &mut found);
    found
}

/// Files of a user outside of the folder.
fn home(place: &Place) {
    for folder in ["home/sub", "home/empty", "home/model", "home/shaft"] {
        fs::create_dir_all(place.path(folder)).unwrap();
    }
    for (name, text) in [
        ("home/.bashrc", "my bashrc\n"),
        ("home/notes.txt", "my notes\n"),
        ("home/profile.csv", "mine\n"),
        ("home/sub/summary.json", "{}\n"),
        ("home/model/profile.csv", "mine too\n"),
        ("home/rows.partial.csv", "my rows\n"),
    ] {
        place.write(name, text);
    }
    fs::set_permissions(place.path("home/sub"), fs::Permissions::from_mode(0o700)).unwrap();
}

/// Plants something in the folder.
fn plant(place: &Place, random: &mut Random) {
    let at = place.path(&format!("repo/{}", random.pick(RESULTS)));
    if at.symlink_metadata().is_ok() || at.parent().is_some_and(|p| fs::create_dir_all(p).is_err()) {
        return;
    }
    let up = "../".repeat(at.strip_prefix(place.path("repo")).unwrap().components().count());
    match random.whole(0, 9) {
        0..=3 => {
            let to = random.pick(&["home", "home/.bashrc", "home/model", "home/sub", "home/rows.partial.csv", "none"]);
            let to = if random.chance(0.5) { format!("{up}{to}") } else { place.path(to).display().to_string() };
            symlink(to, &at).unwrap();
        }
        4 => drop(std::process::Command::new("mkfifo").arg(&at).status().unwrap()),
        5 => {
            fs::create_dir_all(at.join("empty")).unwrap();
            fs::write(at.join("mine.txt"), "mine").unwrap();
            let mode = random.pick(&[0o700, 0o755, 0o2770]);
            fs::set_permissions(&at, fs::Permissions::from_mode(mode)).unwrap();
        }
        6 => {
            fs::write(&at, "part,x [mm]\n").unwrap();
            fs::set_permissions(&at, fs::Permissions::from_mode(random.pick(&[0o444, 0o600, 0o644]))).unwrap();
        }
        7 => forge(at.parent().unwrap(), &up, random),
        8 => leave(place, at.parent().unwrap(), &up, random),
        _ => lay(at.parent().unwrap(), &place.read("own/.fem-files.json")),
    }
}

/// A list of files that the program is to take for its own.
fn forge(folder: &Path, up: &str, random: &mut Random) {
    let schema = random.pick(&["fem-files/1", "fem-files/2"]);
    let name = random.pick(&["home/.bashrc", "home/notes.txt", "home/profile.csv"]);
    let sha = "3f8d0a6c5f7a5b1f0c3e".repeat(4);
    let text = format!(
        "{{\n  \"seal\": \"{}\",\n  \"schema\": \"{schema}\",\n  \"files\": [\n    {{\"name\":\"{up}{name}\",\"of\":\"run\",\
         \"bytes\":10,\"fnv1a\":\"98c1b3a1a2b4f5d6\",\"sha256\":\"{sha}\"}}\n  ]\n}}\n",
        "0".repeat(64),
    );
    lay(folder, &text);
}

/// Lays a list into a folder that has none.
fn lay(folder: &Path, list: &str) {
    let at = folder.join(".fem-files.json");
    if at.symlink_metadata().is_err() {
        fs::write(at, list).unwrap();
    }
}

/// What looks as if a run had been killed there.
fn leave(place: &Place, folder: &Path, up: &str, random: &mut Random) {
    let hidden = folder.join(random.pick(&[".fem-1-0.partial", ".fem-7-3.partial"]));
    if fs::create_dir(&hidden).is_err() {
        return;
    }
    let into = random.pick(&["home", "home/sub", "link"]);
    let _ = symlink(place.path("home"), folder.join("link"));
    fs::write(hidden.join(".going"), format!("{}{into}\nnotes.txt\n{up}home/notes.txt", random.pick(&["", up])))
        .unwrap();
    for name in [".bashrc", "profile.csv", "summary.json"] {
        fs::write(hidden.join(name), "evil").unwrap();
    }
}

/// Runs a command that must end.
fn run(place: &Place, args: &[&str]) -> String {
    let mut command = place.command(args);
    command.current_dir(place.path("repo")).stdout(Stdio::null()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    let start = Instant::now();
    let status = loop {
        match child.try_wait().unwrap() {
            Some(status) => break status,
            None if start.elapsed() > PATIENCE => {
                child.kill().unwrap();
                panic!("{args:?} does not end");
            }
            None => std::thread::sleep(Duration::from_millis(1)),
        }
    };
    let told = String::from_utf8_lossy(&child.wait_with_output().unwrap().stderr).into_owned();
    assert!(status.code().is_some_and(|code| code <= 2) && !told.contains("panicked"), "{args:?}: {status} {told}");
    told
}

fn folder(seed: u64) -> (usize, usize) {
    let mut random = Random::new("hostile", seed);
    let place = Place::new();
    home(&place);
    fs::create_dir(place.path("repo")).unwrap();
    for (name, text) in [("model.toml", MODEL), ("measured.csv", MEASURED), ("plan.toml", PLAN)] {
        place.write(&format!("repo/{name}"), text);
    }
    // A list that the program has sealed, of another folder.
    run(&place, &["run", "model.toml", "-o", "../own"]);
    for _ in 0..random.whole(1, 5) {
        plant(&place, &mut random);
    }
    let own = place.read("own/.fem-files.json");
    let (outside, planted) = (all(&place.path("home")), all(&place.path("repo")));
    let (mut refused, mut done) = (0, 0);
    for _ in 0..3 {
        let mut args = random.pick(COMMANDS).to_vec();
        let forces = random.chance(0.25);
        if forces {
            args.push("--force");
        }
        let told = run(&place, &args);
        *if told.contains("error:") { &mut refused } else { &mut done } += 1;
        assert_eq!(all(&place.path("home")), outside, "seed {seed}, {args:?}: {told}");
        let now = all(&place.path("repo"));
        for (path, before) in &planted {
            let is_same = now.get(path) == Some(before);
            // What stands in the place of a result may go by force, if it is a file or a link; and a list that is the
            // program's own, wherever it was copied to.
            let is_file = before.mode & 0o170_000 == 0o100_000;
            let may_go = forces && (is_file || before.holds.starts_with("-> ")) || before.holds == own;
            assert!(
                is_same || may_go,
                "seed {seed}, {args:?}: {} was {before:?}\nis {:?}\n{told}",
                path.display(),
                now.get(path)
            );
            if !is_same {
                return (refused, done);
            }
        }
    }
    (refused, done)
}

#[test]
fn folders_of_others_lead_nowhere() {
    let folders = std::env::var("FEM_HOSTILE").ok().and_then(|n| n.parse().ok()).unwrap_or(FOLDERS);
    let (mut refused, mut done) = (0, 0);
    for seed in 0..folders {
        let (no, yes) = folder(seed);
        refused += no;
        done += yes;
    }
    // Both must happen, or nothing is tried.
    println!("{folders} folders: {done} commands done, {refused} refused");
    assert!(refused as u64 > folders / 3 && done as u64 > folders / 3, "{done} done, {refused} refused");
}

#[test]
fn links_that_a_user_names_outside_are_followed() {
    let place = Place::new();
    for folder in ["project", "disk"] {
        fs::create_dir(place.path(folder)).unwrap();
    }
    place.write("project/model.toml", MODEL);
    symlink(place.path("disk"), place.path("to-disk")).unwrap();
    symlink(place.path("disk"), place.path("project/disk")).unwrap();
    let fem = |output: &str| {
        let mut command = place.command(&["run", "model.toml", "-o", output]);
        super::fem::answer(command.current_dir(place.path("project")).output().unwrap())
    };
    assert_eq!(fem("../to-disk/results").status, 0);
    assert!(place.path("disk/results/profile.csv").exists());
    let refused = fem("disk/other");
    assert_eq!(refused.status, 2);
    assert!(
        refused.err.contains("project/disk is a link to") && refused.err.contains("name the folder"),
        "{}",
        refused.err
    );
    assert!(!place.path("disk/other").exists());
}

#[test]
fn a_folder_with_other_things_in_it_stays_the_folder_that_it_is() {
    let place = Place::new();
    place.write("model.toml", MODEL);
    for folder in ["o/private", "o/empty"] {
        fs::create_dir_all(place.path(folder)).unwrap();
    }
    place.write("o/private/secret", "mine");
    for (folder, mode) in [("o/private", 0o700), ("o", 0o2770)] {
        fs::set_permissions(place.path(folder), fs::Permissions::from_mode(mode)).unwrap();
    }
    let before = all(&place.path("o"));
    for _ in 0..2 {
        assert_eq!(place.fem(&["run", "model.toml", "-o", "o"]).status, 0);
        let now = all(&place.path("o"));
        assert!(before.iter().all(|(path, stands)| now.get(path) == Some(stands)), "{before:?}\n{now:?}");
        assert!(now.contains_key(Path::new("profile.csv")));
    }
    // A result that was locked is not replaced, nor one that was given a reader's mode widened.
    fs::set_permissions(place.path("o/profile.csv"), fs::Permissions::from_mode(0o444)).unwrap();
    let refused = place.fem(&["run", "model.toml", "-o", "o"]);
    assert!(refused.status == 2 && refused.err.contains("profile.csv is there already"), "{}", refused.err);
    fs::set_permissions(place.path("o/profile.csv"), fs::Permissions::from_mode(0o600)).unwrap();
    assert_eq!(place.fem(&["run", "model.toml", "-o", "o"]).status, 0);
    assert_eq!(place.path("o/profile.csv").metadata().unwrap().mode() & 0o777, 0o600);
}

#[cfg(target_os = "linux")]
#[test]
fn a_folder_in_which_somebody_stands_is_not_exchanged() {
    let place = Place::new();
    place.write("model.toml", MODEL);
    assert_eq!(place.fem(&["run", "model.toml"]).status, 0);
    let number = || place.path("out/model").metadata().unwrap().ino();
    let mut shell = std::process::Command::new("sleep").arg("60").current_dir(place.path("out/model")).spawn().unwrap();
    let before = number();
    assert_eq!(place.fem(&["run", "model.toml"]).status, 0);
    assert_eq!(number(), before);
    shell.kill().unwrap();
    shell.wait().unwrap();
}

#[test]
fn without_a_state_folder_nothing_is_taken_for_its_own() {
    let place = Place::new();
    place.write("model.toml", MODEL);
    place.write("file", "");
    let fem = |args: &[&str]| {
        super::fem::answer(place.command(args).env("XDG_STATE_HOME", place.path("file")).output().unwrap())
    };
    let first = fem(&["run", "model.toml"]);
    assert!(
        first.status == 0 && first.out.contains("the next run will not know these files as its own"),
        "{}",
        first.out
    );
    let again = fem(&["run", "model.toml"]);
    assert!(again.status == 2 && again.err.contains("is there already"), "{}", again.err);
    assert_eq!(fem(&["run", "model.toml", "--force"]).status, 0);
    assert!(!place.files().iter().any(|name| name.contains(".partial")));
}

#[test]
fn a_device_or_a_pipe_is_no_place_for_a_file() {
    let place = Place::new();
    place.write("model.toml", MODEL);
    std::process::Command::new("mkfifo").arg(place.path("pipe")).status().unwrap();
    for args in [&["report", "model.toml", "-o", "pipe"][..], &["report", "model.toml", "-o", "/dev/null"]] {
        for args in [args.to_vec(), [args, &["--force"]].concat()] {
            let answer = place.fem(&args);
            assert!(answer.status == 2, "{args:?}: {}", answer.err);
        }
    }
    assert!(!place.path("pipe").symlink_metadata().unwrap().is_file());
}

#[test]
fn a_pipe_to_which_nobody_writes_is_not_waited_for() {
    let place = Place::new();
    std::process::Command::new("mkfifo").arg(place.path("pipe.toml")).status().unwrap();
    place.write("model.toml", MODEL);
    place.write("measured.csv", MEASURED);
    for args in [
        &["run", "pipe.toml"][..],
        &["compare", "pipe.toml", "--with", "measured.csv"],
        &["compare", "model.toml", "--with", "pipe.toml"],
        &["budget", "pipe.toml"],
        &["study", "pipe.toml", "-o", "out"],
    ] {
        let answer = place.fem(args);
        assert!(answer.status == 2 && answer.err.contains("a pipe, and nobody writes"), "{args:?}: {}", answer.err);
    }
    // What the program is started with is read.
    let mut command = place.command(&["run", "/dev/stdin", "-o", "out"]);
    command.stdin(fs::File::open(place.path("model.toml")).unwrap());
    assert_eq!(command.output().unwrap().status.code(), Some(0));
    let mut command = place.command(&["run", "/dev/stdin", "-o", "other"]);
    let mut child = command.stdin(std::process::Stdio::piped()).spawn().unwrap();
    std::io::Write::write_all(&mut child.stdin.take().unwrap(), MODEL.as_bytes()).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(0));
}

#[test]
fn the_name_of_a_file_makes_no_lines_of_its_own() {
    let place = Place::new();
    let name = "a\nwritten model.toml: all is well\n.toml";
    place.write(name, MODEL);
    place.write("model.toml", MODEL);
    for args in [&["run", name][..], &["run", "model.toml", "-o", name], &["compare", "model.toml", "--with", name]] {
        let answer = place.fem(args);
        let lines = answer.out.lines().chain(answer.err.lines());
        assert!(answer.status == 2 && answer.err.contains("there is a line end in the name"), "{}", answer.err);
        assert!(!lines.into_iter().any(|line| line.starts_with("written")), "{}", answer.err);
    }
    assert!(!place.fem(&[]).out.contains("all is well"));
    // Of others a page shows what a terminal does not obey.
    let name = "b\u{1b}[2J.toml";
    place.write(name, MODEL);
    assert_eq!(place.fem(&["report", name, "-o", "page.html"]).status, 0);
    let page = place.read("page.html");
    assert!(page.contains("b\\u001b[2J") && !page.contains(|c: char| c.is_control() && c != '\n'), "{page}");
}

#[test]
fn a_page_is_replaced_by_a_newer_one_alone() {
    let place = Place::new();
    place.write("model.toml", MODEL);
    let report = || place.fem(&["report", "model.toml", "-o", "page.html"]).status;
    assert_eq!((report(), report()), (0, 0));
    let page = place.read("page.html");
    for changed in
        [page.replacen("<body", "<body ", 1), format!("{page}\n"), page.replacen("<!-- sealed ", "<!-- sealed 0", 1)]
    {
        place.write("page.html", &changed);
        assert_eq!((report(), place.read("page.html")), (2, changed));
    }
}

#[test]
fn what_is_read_is_not_written_over_by_a_way_that_is_made() {
    let place = Place::new();
    place.write("model.toml", MODEL);
    let answer = place.fem(&["add", "model.toml", "gap", "gap=3 um", "-o", "missing/../model.toml", "--force"]);
    assert!(answer.status == 2 && answer.err.contains("is itself what is read"), "{}", answer.err);
    assert_eq!(place.read("model.toml"), MODEL);
}

#[test]
fn links_beside_a_linked_model_and_in_its_checkout_are_not_followed() {
    let place = Place::new();
    for folder in ["repo/sub", "repo/.git", "home", "here"] {
        fs::create_dir_all(place.path(folder)).unwrap();
    }
    place.write("repo/sub/real.toml", MODEL);
    symlink("sub/real.toml", place.path("repo/m.toml")).unwrap();
    symlink("../home", place.path("repo/out")).unwrap();
    let fem = |from: &str, args: &[&str]| {
        super::fem::answer(place.command(args).current_dir(place.path(from)).output().unwrap())
    };
    for (from, args) in [
        ("here", &["run", "../repo/m.toml", "-o", "../repo/out"][..]),
        ("repo/sub", &["run", "real.toml", "-o", "../out"]),
    ] {
        let answer = fem(from, args);
        assert!(answer.status == 2 && answer.err.contains("is a link to"), "{args:?}: {}", answer.err);
    }
    assert_eq!(fs::read_dir(place.path("home")).unwrap().count(), 0);
}

#[test]
fn a_state_folder_of_others_is_none() {
    let place = Place::new();
    place.write("model.toml", MODEL);
    assert_eq!(place.fem(&["run", "model.toml"]).status, 0);
    fs::set_permissions(place.state(), fs::Permissions::from_mode(0o777)).unwrap();
    let answer = place.fem(&["run", "model.toml"]);
    assert!(answer.status == 2 && answer.err.contains("is there already"), "{}", answer.err);
}
