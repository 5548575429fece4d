//! `fem add` keeps what is there.

use super::fem::{Place, model};

#[test]
fn comments_and_order_stay_and_the_effect_is_added() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    let answer = place.fem(&[
        "add",
        "lathe.toml",
        "guideway-wear",
        "depth=8 +- 2 um",
        "centre=200 mm",
        "width=60 mm",
        "-o",
        "new.toml",
    ]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let new = place.read("new.toml");
    let added = new.strip_prefix(&model("lathe.toml")).expect("the old text stands unchanged before the new");
    assert_eq!(added, "\n[effects.guideway-wear]\ndepth = \"8 +- 2 um\"\ncentre = \"200 mm\"\nwidth = \"60 mm\"\n");
    assert_eq!(place.fem(&["run", "new.toml"]).status, 0);
}

#[test]
fn what_is_left_out_stands_as_unknown() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    let answer = place.fem(&["add", "lathe.toml", "workpiece-heating", "-o", "new.toml"]);
    assert_eq!(answer.status, 0);
    assert!(answer.err.contains("unknown (`?`) in new.toml: power"), "{}", answer.err);
    assert!(place.read("new.toml").ends_with("[effects.workpiece-heating]\npower = \"? W\"\n"));
    let run = place.fem(&["run", "new.toml"]);
    assert_eq!(run.status, 2);
    assert!(run.err.contains("`effects.workpiece-heating.power` is unknown"), "{}", run.err);
}

#[test]
fn inline_tables_pure_numbers_and_models_without_effects() {
    let place = Place::new();
    let bare = "process = \"turning\" # the process\nworkpiece = { material = \"steel\", segments = [{ length = \"300 mm\", diameter = \"40 mm\" }] }\nworkholding.type = \"centres\"\ncut = { depth = \"0.5 mm\", feed = \"0.2 mm/rev\", spindle_speed = \"600 rpm\", radial_force = \"450 N\" }\n";
    place.write("bare.toml", bare);
    let inline = format!("{bare}effects = {{ setting-error = {{ offset = \"3 um\" }} }} # mine\n");
    place.write("inline.toml", &inline);
    for name in ["bare.toml", "inline.toml"] {
        let answer = place.fem(&["add", name, "force-feedback", "exponent=0.9", "-o", "new.toml", "--force"]);
        assert_eq!(answer.status, 0, "{name}: {}", answer.err);
        let new = place.read("new.toml");
        assert!(new.starts_with(bare), "{new}");
        assert!(new.contains("exponent = 0.9"), "{new}");
        assert_eq!(new.contains("# mine"), name == "inline.toml");
        assert_eq!(place.fem(&["run", "new.toml"]).status, 0);
    }
}

#[test]
fn line_ends_and_trailing_comments_stay_byte_for_byte() {
    let place = Place::new();
    for (name, text) in [
        ("crlf.toml", model("lathe.toml").replace('\n', "\r\n")),
        ("comment.toml", format!("{}# run_in = \"2 um\" was too much\n", model("lathe.toml"))),
        ("open.toml", model("lathe.toml").trim_end().to_string()),
    ] {
        place.write(name, &text);
        let answer = place.fem(&["add", name, "guideway-taper", "slope=3 um/m", "-o", "new.toml", "--force"]);
        assert_eq!(answer.status, 0, "{name}: {}", answer.err);
        let new = place.read("new.toml");
        assert!(new.starts_with(&text), "{name}");
        assert_eq!(new.contains("\r\n[effects.guideway-taper]\r\n"), name == "crlf.toml");
    }
}
