//! `fem set` changes values and leaves effects out; the rest of the file stays.

use super::fem::{Place, model};

/// Each with the line that it changes, and that line after it.
#[test]
fn a_value_changes_and_every_comment_stays() {
    let place = Place::new();
    let text = model("lathe.toml");
    for (name, text) in [("lathe.toml", text.clone()), ("crlf.toml", text.replace('\n', "\r\n"))] {
        place.write(name, &text);
        let line = |key: &str| text.lines().find(|line| line.starts_with(key)).unwrap().to_string();
        for (set, before, after) in [
            ("cut.depth=0.6 mm", line("depth"), line("depth").replacen(&value(&line("depth")), "\"0.6 mm\"", 1)),
            ("batch.parts=7", line("parts"), line("parts").replacen(&value(&line("parts")), "7", 1)),
            ("title=Other", line("title"), line("title").replacen(&value(&line("title")), "\"Other\"", 1)),
        ] {
            let answer = place.fem(&["set", name, set, "-o", "new.toml", "--force"]);
            assert_eq!(answer.status, 0, "{}", answer.err);
            assert_eq!(answer.out, format!("written new.toml: {name} with {}\n", set.replace('=', " = ")));
            assert_eq!(place.read("new.toml"), text.replacen(&before, &after, 1));
        }
    }
}

/// Value of a line `key = value # comment`.
fn value(line: &str) -> String {
    let value = line.split_once(" = ").unwrap().1;
    let end = value.strip_prefix('"').map_or(value.find(' '), |rest| rest.find('"').map(|end| end + 2));
    value[..end.unwrap_or(value.len())].to_string()
}

#[test]
fn an_effect_is_left_out_and_put_back() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    let add = ["add", "lathe.toml", "guideway-taper", "slope=3 um/m", "-o", "taper.toml"];
    assert_eq!(place.fem(&add).status, 0);
    for names in [&["guideway-taper"][..], &["effects.guideway-taper"], &["guideway-taper", "guideway-taper"]] {
        let without: Vec<&str> = names.iter().flat_map(|name| ["--without", name]).collect();
        let answer = place.fem(&[&["set", "taper.toml"], &*without, &["-o", "back.toml", "--force"]].concat());
        assert_eq!(answer.status, 0, "{}", answer.err);
        assert_eq!(answer.out, format!("written back.toml: taper.toml without {}\n", names.join(", without ")));
        assert_eq!(place.read("back.toml"), model("lathe.toml"));
    }
    let both = ["effects.guideway-taper.slope=1 um/m", "--without", "guideway-taper", "-o", "new.toml"];
    let answer = place.fem(&[&["set", "taper.toml"], &both[..]].concat());
    assert!(answer.err.contains("belongs to an effect that is left out"), "{}", answer.err);
}

/// Names that begin alike, and one name in both catalogues.
#[test]
fn the_effect_that_is_meant_is_left_out() {
    let place = Place::new();
    let joint = "process = \"stiffness\"\n[joint]\nstiffness = \"100 N/um\"\n[test]\nmax_force = \"1 kN\"\n";
    let law = |name: &str, b: u32| format!("[effects.{name}]\nformula = \"b*force\"\nb = \"{b} um/kN\"\n");
    place.write("two.toml", format!("{joint}{}{}", law("w", 1), law("\"w.a\"", 2)));
    let answer = place.fem(&["set", "two.toml", "effects.w.a.b=3 um/kN", "--without", "w", "-o", "new.toml"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert_eq!(place.read("new.toml"), format!("{joint}{}", law("\"w.a\"", 3)));
    let shift = "[measurement.zero-shift]\nby = \"branch\"\n";
    place.write("both.toml", format!("{joint}{}{shift}", law("zero-shift", 1)));
    let answer = place.fem(&["set", "both.toml", "--without", "zero-shift", "-o", "one.toml"]);
    assert!(answer.err.contains("write effects.zero-shift or measurement.zero-shift"), "{}", answer.err);
    let answer = place.fem(&["set", "both.toml", "--without", "effects.zero-shift", "-o", "one.toml"]);
    assert_eq!((answer.status, place.read("one.toml")), (0, format!("{joint}{shift}")), "{}", answer.err);
}

#[test]
fn a_key_that_was_left_out_stands_behind_the_others_of_its_table() {
    let place = Place::new();
    place.write(
        "joint.toml",
        "process = \"stiffness\"\n[joint]\nstiffness = \"100 N/um\"\n\n[test] # slowly\nmax_force = \"1 kN\"\n",
    );
    let answer = place.fem(&["set", "joint.toml", "test.steps=5", "joint.stiffness=? N/um", "-o", "new.toml"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let expected = "process = \"stiffness\"\n[joint]\nstiffness = \"? N/um\"\n\n[test] # slowly\nmax_force = \"1 kN\"\nsteps = 5\n";
    assert_eq!(place.read("new.toml"), expected);
}

#[test]
fn what_makes_no_model_is_refused_and_nothing_is_written() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    for (words, message) in [
        (&["cut.depht=1 mm"][..], "its keys are depth, feed"),
        (&["cut.depth=1", "batch.parts=7"], "cut.depth=1: `depth`: the unit is missing"),
        (&["batch.parts=7", "cut.depth=1 N"], "cut.depth=1 N: "),
        (&["workpiece.segments[9].length=1 mm"], "an entry of a list, from 0"),
        (&["workpiece.segments[1]=5"], "no table for `workpiece.segments[1]`"),
        (&["cat.depth=1 mm"], "the model has no table for `cat.depth`"),
        (&["cut.depth"], "KEY=VALUE"),
        (&["cut.depth=1 mm", "cut.depth=2 mm"], "`cut.depth` is given twice"),
        (&["--without", "tool-waer"], "did you mean `tool-wear`?"),
        (&[], "required"),
    ] {
        let answer = place.fem(&[&["set", "lathe.toml"], words, &["-o", "new.toml"]].concat());
        assert_eq!(answer.status, 2, "{words:?}: {}", answer.err);
        assert!(answer.err.contains(message), "{words:?}: {}", answer.err);
        assert!(!place.path("new.toml").exists());
    }
    let own = place.fem(&["set", "lathe.toml", "cut.depth=1 mm", "-o", "lathe.toml", "--force"]);
    assert!(own.err.contains("is itself what is read"), "{}", own.err);
}
