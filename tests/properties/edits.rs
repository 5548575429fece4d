//! An edited model is the model of its own text, and one edit less is the model before.

use std::fmt::Debug;
use std::path::Path;

use fem::input::{Parameter, Source};
use fem::model::{Edit, Entry, Model, Setting, add_effect};
use fem::noise::effects as of_measurement;
use fem::processes::ALL;

use super::models;

/// What a model says, without the places in its text.
fn said(model: &Model) -> impl PartialEq + Debug + use<> {
    let plain = |all: &[Parameter]| -> Vec<String> {
        all.iter().map(|p| format!("{} {:?} {:?} {:?}", p.path, p.kind, p.quantity, p.bounds)).collect()
    };
    (
        model.title.clone(),
        model.effects.iter().map(|effect| format!("{effect:?}")).collect::<Vec<_>>(),
        model.measurement.iter().map(|term| format!("{term:?}")).collect::<Vec<_>>(),
        plain(&model.parameters),
        plain(&model.quantities),
        model.system.programme().columns.iter().map(|c| format!("{c:?}")).collect::<Vec<_>>(),
    )
}

/// The model without an effect that it has.
fn without(model: &Model, name: &str) -> Model {
    match model.effects.iter().any(|effect| effect.description.name == name) {
        true => model.edited(&[Edit::Remove { parent: "effects", name: name.into() }]).unwrap(),
        false => model.clone(),
    }
}

fn read(model: &Model, text: &str) -> Model {
    let source = Source::new(model.source.name.clone(), text);
    Model::parse(source).unwrap_or_else(|error| panic!("{:?}\n{text}", error.problems))
}

/// Holds an edited model against that of its text, and against that from which it came.
fn check(before: &Model, edited: &Model) {
    let text = edited.text();
    assert_eq!(said(&read(edited, &text)), said(edited), "{text}");
    let undone = edited.undone().unwrap().unwrap();
    assert_eq!(undone.text(), before.text());
    assert_eq!(said(&undone), said(before));
}

/// Every effect of every process, and of the measurement as far as it needs no word.
#[test]
fn a_model_with_an_effect_more_is_the_model_of_its_text() {
    for process in ALL {
        let (mut added, mut refused) = (0, Vec::new());
        let of_process = process.effects();
        let names = of_process.iter().map(|effect| &*effect.name);
        for name in names.chain(of_measurement::all().map(|effect| effect.name)) {
            let settings = match name {
                "step" => vec![Setting { key: "from".into(), value: Entry::Rows(vec![3]) }],
                "outlying-rows" => vec![Setting { key: "rows".into(), value: Entry::Rows(vec![2, 5]) }],
                _ => Vec::new(),
            };
            let of = |model: &Model| {
                let model = without(model, name);
                add_effect(&model, name, &settings).ok().map(|more| (model, more))
            };
            let Some((model, more)) = models(*process).iter().find_map(of) else {
                refused.push(name);
                continue;
            };
            check(&model, &more);
            added += 1;
        }
        // What is along a coordinate, by conditions or in a file has no meaning before somebody says which.
        assert!(added >= of_process.len() + 3, "{}: {refused:?}", process.name());
        assert!(of_process.iter().all(|effect| !refused.contains(&&*effect.name)), "{}: {refused:?}", process.name());
    }
}

/// Every quantity of every process, in the unit that stands there, and in one that is no longer exactly known.
#[test]
fn a_quantity_that_is_set_stands_where_it_stood() {
    for process in ALL {
        for model in models(*process) {
            for quantity in model.quantities.iter() {
                let Some(written) = model.written(&quantity.path) else { continue };
                let said_again = Edit::Set { path: quantity.path.clone(), entry: Entry::Text(written.into()) };
                assert_eq!(model.edited(&[said_again]).unwrap().text(), model.text(), "{}", quantity.path);
                let entry = Entry::Text(format!("? {}", quantity.kind.unit).trim_end().into());
                // What is chosen is never unknown.
                let Ok(open) = model.edited(&[Edit::Set { path: quantity.path.clone(), entry }]) else { continue };
                check(&model, &open);
                assert!(open.parameters.iter().any(|p| p.path == quantity.path));
                let lines = |model: &Model| model.text().lines().count();
                assert_eq!(lines(&open), lines(&model));
            }
        }
    }
}

#[test]
fn edits_one_after_the_other_are_undone_one_after_the_other() {
    let text = "# a lathe\r\nprocess = \"turning\" # the process\r\n[workpiece]\r\nmaterial = \"steel\"\r\n\
                segments = [{ length = \"300 mm\", diameter = \"40 mm\" }] # one\r\n[workholding]\r\ntype = \"centres\"\r\n\
                [cut]\r\ndepth = \"0.5 mm\"\r\nfeed = \"0.2 mm/rev\"\r\nspindle_speed = \"600 rpm\"\r\nradial_force = \"450 N\"\r\n\
                # the end";
    let model = read(&fixed(), text);
    let set = |path: &str, text: &str| Edit::Set { path: path.into(), entry: Entry::Text(text.into()) };
    let add = |parent: &'static str, name: &str, key: &str, text: &str| Edit::Add {
        parent,
        name: name.into(),
        keys: vec![(key.into(), Entry::Text(text.into()))],
    };
    let edits = [
        add("measurement", "gain", "factor", "?"),
        add("effects", "setting-error", "offset", "3 um"),
        set("workpiece.segments[0].diameter", "41 mm"),
        Edit::Remark("seen on a Monday".into()),
        set("effects.setting-error.offset", "? um"),
        add("effects", "guideway-taper", "slope", "2 um/m"),
        set("cut.radial_force", "450 +- 20 N"),
        Edit::Remove { parent: "effects", name: "setting-error".into() },
    ];
    let mut all = vec![model];
    for edit in &edits {
        let before = &all[all.len() - 1];
        let after = before.edited(std::slice::from_ref(edit)).unwrap();
        check(before, &after);
        all.push(after);
    }
    let last = &all[all.len() - 1];
    let once = all[0].edited(&edits).unwrap();
    assert_eq!((once.text(), once.edits()), (last.text(), &edits[..]));
    let expected = text
        .replace("40 mm", "41 mm")
        .replace("\"450 N\"", "\"450 +- 20 N\"")
        .replace("# a lathe", "# seen on a Monday\r\n# a lathe")
        + "\r\n\r\n[measurement.gain]\r\nfactor = \"?\"\r\n\r\n[effects.guideway-taper]\r\nslope = \"2 um/m\"\r\n";
    assert_eq!(last.text(), expected);
    assert!(all[0].undone().unwrap().is_none());
}

/// Two laws of one's own, of which the name of one begins as the other's and goes on with a dot.
#[test]
fn names_with_dots_are_told_apart() {
    let [dotted, plain] =
        ["[effects.\"w.a\"]\nformula = \"b*x\"\nb = \"2 um/m\"\n", "[effects.w]\nformula = \"a*x\"\na = \"? um/m\"\n"];
    let start = fixed().text();
    for text in [format!("{start}{dotted}{plain}"), format!("{start}{plain}{dotted}")] {
        let model = read(&fixed(), &text);
        let values = [("effects.w.a", "3 um/m", "? um/m"), ("effects.w.a.b", "5 um/m", "2 um/m")];
        for (path, new, old) in values {
            assert_eq!(model.written(path), Some(old), "{text}");
            let set = Edit::Set { path: path.into(), entry: Entry::Text(new.into()) };
            let edited = model.edited(&[set]).unwrap();
            assert_eq!(edited.text(), text.replace(old, new));
            check(&model, &edited);
        }
    }
}

/// Texts of several lines, and files whose ends of lines are not all the same.
#[test]
fn ends_of_lines_are_those_of_the_file() {
    let start = fixed().text().replacen("title = \"Shaft between centres\"", "title = \"\"\"a\nb\"\"\"", 1);
    let set = |path: &str, text: &str| Edit::Set { path: path.into(), entry: Entry::Text(text.into()) };
    let crlf = start.replace('\n', "\r\n");
    let edited = read(&fixed(), &crlf).edited(&[set("cut.depth", "0.6 mm")]).unwrap();
    assert_eq!(edited.text(), crlf.replacen("depth = \"0.5 mm\"", "depth = \"0.6 mm\"", 1));
    for mixed in [start.replacen('\n', "\r\n", 1), crlf.replacen("\r\n", "\n", 1)] {
        let model = read(&fixed(), &mixed);
        let edited = model.edited(&[set("cut.depth", "0.6 mm")]).unwrap();
        check(&model, &edited);
        assert_eq!(edited.title, model.title);
    }
}

/// A heading above a table is often that of those behind it as well.
#[test]
fn comments_outlive_the_table_that_they_stand_before() {
    let start = fixed().text();
    let remove = |name: &str| Edit::Remove { parent: "effects", name: name.into() };
    let without = |name: &str| fixed().edited(&[remove(name)]).unwrap().text();
    let comments = |text: &str| text.lines().filter(|l| l.starts_with('#')).map(str::to_string).collect::<Vec<_>>();
    for name in ["headstock-compliance", "tailstock-compliance"] {
        assert_eq!(comments(&without(name)), comments(&start), "{name}");
    }
    // Comments at the end of the file stay there, whatever was added behind them and is gone again.
    for end in ["# the end\n", "# one\n\n# two\n", "# open"] {
        let text = format!("{start}{end}");
        let model = read(&fixed(), &text);
        let more = read(&model, &add_effect(&model, "setting-error", &[]).unwrap().text());
        assert_eq!(more.edited(&[remove("setting-error")]).unwrap().text().trim_end(), text.trim_end());
    }
}

#[test]
fn a_process_is_that_of_the_tables() {
    let set = |word: &str| fixed().edited(&[Edit::Set { path: "process".into(), entry: Entry::Text(word.into()) }]);
    assert_eq!(set("nonsense").err().unwrap().message, "\"nonsense\" is no process known here");
    assert!(set("axis").is_err());
}

/// A rod whose room is recorded in a file beside it.
#[test]
fn files_are_found_from_another_folder_whatever_was_edited() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name);
    std::fs::create_dir(at("new")).unwrap();
    std::fs::write(at("room.csv"), "time [s],temperature [degC]\n0,20\n100000,22\n").unwrap();
    let start = ALL.iter().find(|process| process.name() == "thermal").unwrap().starting_model();
    let line = start.lines().find(|line| line.starts_with("temperature = ")).unwrap();
    let recorded = "temperature = { file = \"room.csv\", value = \"temperature\" } # the room";
    std::fs::write(at("rod.toml"), start.replace(line, recorded)).unwrap();
    let model = Model::load(&at("rod.toml")).unwrap();
    let known = model.process.effects().into_iter().map(|effect| effect.name);
    let more = known.filter_map(|name| add_effect(&model, &name, &[]).ok()).next().unwrap();
    let there = at("new/rod.toml");
    for model in [model, more] {
        assert_eq!(model.text_at(&at("other.toml")), model.text());
        let text = model.text_at(&there);
        assert!(text.contains("{ file = \"../room.csv\", value = \"temperature\" } # the room"), "{text}");
        std::fs::write(&there, &text).unwrap();
        let moved = Model::load(Path::new(&there)).unwrap();
        assert_eq!(said(&moved), said(&model));
    }
}

#[test]
fn what_makes_no_model_is_refused() {
    let model = fixed();
    let set = |path: &str, text: &str| Edit::Set { path: path.into(), entry: Entry::Text(text.into()) };
    for (edit, message) in [
        (set("cut.depth", "-1 mm"), "`depth` is -1 mm"),
        (set("cut.depht", "1 mm"), "`depht` is no key of `cut`"),
        (set("effects.setting-error.offset", "1 um"), "the model has no table for `effects.setting-error.offset`"),
        (set("workpiece.segments[7].diameter", "1 mm"), "the model has no table for `workpiece.segments[7].diameter`"),
        (Edit::Remove { parent: "effects", name: "gap".into() }, "the model has no table [effects.gap]"),
        (Edit::Add { parent: "title", name: "gap".into(), keys: Vec::new() }, "`title` is no table"),
    ] {
        let problem = model.edited(&[edit]).err().unwrap();
        assert_eq!((problem.message.as_str(), &problem.span), (message, &None));
    }
}

/// A plain lathe.
fn fixed() -> Model {
    let turning = ALL.iter().find(|process| process.name() == "turning").unwrap();
    Model::parse(Source::new("model.toml", turning.starting_model())).unwrap()
}
