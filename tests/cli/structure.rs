//! Machines drawn as beams and joints: what a run says, what a diagnosis says of a soft joint, and drawings that cannot be.

use super::fem::{Mistake, Place, model};

#[test]
fn a_lathe_on_its_bed_says_what_gives_way() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe-on-bed.toml"));
    let answer = place.fem(&["run", "lathe.toml", "-o", "out"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!(answer.out);
    // What every part adds is what the structure adds: statics decides the forces.
    let column = |file: &str| -> Vec<Vec<f64>> {
        let text = place.read(file);
        text.lines().skip(1).map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect()
    };
    let (parts, whole) = (column("out/structure.csv"), column("out/compliance.csv"));
    for (parts, whole) in parts.iter().zip(&whole) {
        let sum: f64 = parts[1..].iter().sum();
        assert!((sum / whole[6] - 1.0).abs() < 1e-9, "{sum} {whole:?}");
    }
}

#[test]
fn a_starting_model_can_have_a_machine() {
    let place = Place::new();
    assert_eq!(place.fem(&["new", "turning", "--structure", "-o", "lathe.toml"]).status, 0);
    assert_eq!(place.fem(&["run", "lathe.toml", "-o", "out"]).status, 0);
    let answer = place.fem(&["new", "cam", "--structure"]);
    assert_eq!(answer.status, 2);
    assert!(answer.err.contains("`cam` does not stand on a structure") && answer.err.contains("turning, stiffness"));
}

#[test]
fn a_soft_joint_is_named() {
    let place = Place::new();
    place.write("machine.toml", model("pushed-lathe.toml"));
    place.write("pushed.csv", model("pushed-lathe.csv"));
    let answer = place.fem(&["diagnose", "machine.toml", "--with", "pushed.csv"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    insta::assert_snapshot!(answer.out);
}

/// A value that is roughly known is fitted and needs no effect; that it has moved far is told all the same.
#[test]
fn a_roughly_known_value_that_moves_is_told() {
    let place = Place::new();
    place.write("machine.toml", model("pushed-lathe.toml").replace("\"1500 kN*m/rad\"", "\"1500 +- 400 kN*m/rad\""));
    place.write("pushed.csv", model("pushed-lathe.csv"));
    let diagnose = ["diagnose", "machine.toml", "--with", "pushed.csv"];
    let answer = place.fem(&diagnose);
    assert!(answer.out.contains("nothing is missing"), "{}", answer.out);
    let told = answer.out.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(told.contains("moved structure.tailstock-tilt.stiffness 6"), "{told}");
    assert!(told.contains("(written as 1500 +- 400)"), "{told}");
    let verbose = place.fem(&[&diagnose[..], &["--verbose"]].concat());
    assert!(verbose.out.contains("roughly known values that the data move far"), "{}", verbose.out);
}

/// (in the model, replaced by, part of the message, part of the remedy)
const CASES: &[Mistake] = &[
    ("bed-left = [\"-500 mm\"", "bed-left = [\"-500 N\"", "not a length", "write it in mm"),
    (
        "between = [\"bed-left\", \"under-headstock\"]",
        "between = [\"bed-left\", \"under-hedstock\"]",
        "`under-hedstock` is no node",
        "did you mean `under-headstock`?",
    ),
    ("between = [\"quill\", \"centre\"]", "between = [\"quill\"]", "there are two ends", "NODE"),
    (
        "between = [\"quill\", \"centre\"]",
        "between = [\"quill\", \"quill\"]",
        "both ends are the same node",
        "name two nodes",
    ),
    (
        "between = [\"headstock-foot\", \"spindle\"]",
        "between = [\"headstock-foot\", \"under-headstock\"]",
        "the member has no length",
        "two places",
    ),
    ("diameter = \"60 mm\"", "", "the member has no section", "give `diameter`"),
    ("wall = \"25 mm\"", "wall = \"160 mm\"", "thicker than the section", "leave `wall` out"),
    ("bore = \"40 mm\"", "bore = \"90 mm\"", "the bore is as wide as the section", "below the diameter"),
    ("along = \"turning\"", "along = \"z\"", "`along` is \"z\"", "turning"),
    ("at = \"bed-right\"", "", "the joint holds nothing", "at = \"NODE\""),
    (
        "at = \"bed-right\"",
        "at = \"bed-right\"\nbetween = [\"bed-left\", \"bed-right\"]",
        "one of `at` and `between`",
        "two nodes",
    ),
    (
        "[structure.foot-along]\nat = \"bed-left\"\nalong = \"x\"",
        "[structure.foot-along]\nat = \"bed-left\"\nalong = \"turning\"",
        "not a rotational stiffness",
        "kN*m/rad",
    ),
    ("headstock = \"nose\"", "", "`headstock` is missing", "add headstock"),
    (
        "tailstock = \"centre\"",
        "tailstock = \"center\"",
        "`center` is neither a node nor a member",
        "did you mean `centre`?",
    ),
    (
        "tool = [\"bed-a\", \"bed-b\", \"bed-c\"]",
        "tool = \"bed-a\"",
        "`tool` travels from x = 0 mm to 600 mm, and its members go from -500 mm to -200 mm",
        "as far",
    ),
    (
        "tool = [\"bed-a\", \"bed-b\", \"bed-c\"]",
        "tool = \"headstock\"",
        "`headstock` stands upright",
        "members along x",
    ),
];

/// A headstock on surfaces in contact that its screws hold together: a cut that lifts it takes force off them, and beyond what
/// the screws hold they open. With clearance, all but the spring is one way or the other.
#[test]
fn seats_hold_by_their_preload() {
    let place = Place::new();
    let error = |name: &str, seat: &str| -> f64 {
        let on = "between = [\"under-headstock\", \"headstock-foot\"]\nalong = \"y\"\nstiffness";
        let text = model("lathe-on-bed.toml").replacen(on, &format!("{seat}{on}"), 1);
        assert!(text.contains(seat));
        place.write("lathe.toml", text);
        let answer = place.fem(&["run", "lathe.toml", "-o", name]);
        assert_eq!((answer.status, answer.err.as_str()), (0, ""));
        let [x, errors] = ["x", "diameter_error"].map(|key| place.column(&format!("{name}/profile.csv"), key));
        errors[x.iter().position(|x| *x == 0.0).unwrap()]
    };
    let spring = error("spring", "");
    // All of the cut stands on the headstock at x = 0, which rises twice as far in diameter.
    let contact = |preload: f64| 0.3 * (preload.sqrt() - (preload - 450.0).max(0.0).sqrt());
    for preload in [5000.0, 600.0] {
        let seated = error("contact", &format!("c = \"0.3 um/N^n\"\npreload = \"{preload} N\"\n"));
        let expected = 2.0 * contact(preload);
        assert!((seated - spring - expected).abs() < 1e-6, "{preload}: {seated} {spring} {expected}");
    }
    let crossed = error("gap", "gap = \"3 um\"\n") - spring;
    assert!(crossed.abs() < 1e-9 || (crossed - 6.0).abs() < 1e-9, "{crossed}");
    // The screws hold less than the cut: nothing but the frame's other joints bears what is left, and these hold no seat along y.
    let loose = model("lathe-on-bed.toml").replacen(
        "between = [\"under-headstock\", \"headstock-foot\"]\nalong = \"y\"",
        "between = [\"under-headstock\", \"headstock-foot\"]\nalong = \"y\"\nc = \"0.3 um/N^n\"\npreload = \"100 N\"",
        1,
    );
    place.write("loose.toml", loose);
    let answer = place.fem(&["run", "loose.toml"]);
    assert_ne!(answer.status, 0, "{}", answer.out);
    insta::assert_snapshot!(answer.err);
}

/// A machine that is pushed is at rest in its first row: a preloaded contact gives way by nothing there, and under a force by
/// its law, whatever rounding leaves of the preload.
#[test]
fn a_pushed_machine_may_stand_on_contacts() {
    let place = Place::new();
    let seat = "between = [\"under-headstock\", \"headstock-foot\"]\nalong = \"y\"\n";
    let good = model("pushed-lathe.toml");
    assert!(good.contains(seat));
    let readings = |more: &str| -> Vec<(f64, f64)> {
        place.write("machine.toml", good.replacen(seat, &format!("{seat}{more}"), 1));
        let answer = place.fem(&["run", "machine.toml", "-o", "out"]);
        assert_eq!((answer.status, answer.err.as_str()), (0, ""), "{more}");
        let columns = ["load", "dial", "force", "displacement"].map(|name| place.column("out/profile.csv", name));
        let [load, dial, force, read] = &columns;
        // Pushed and watched at the nose.
        let own = (0..load.len()).filter(|row| load[*row] == 1.0 && dial[*row] == 1.0);
        own.map(|row| (force[row], read[row])).collect()
    };
    let springs = readings("");
    assert!(springs.iter().any(|row| row.0 == 0.0) && springs.iter().any(|row| row.0 > 0.0));
    for (n, preload) in [(0.5, 2500.0), (0.6, 2000.0), (0.7, 20_000.0f64)] {
        let seated = readings(&format!("c = \"0.3 um/N^n\"\nn = {n}\npreload = \"{preload} N\"\n"));
        for ((force, spring), (_, seated)) in springs.iter().zip(&seated) {
            // The seat bears the whole of a force at the nose, and is lifted by it.
            let expected = 0.3 * (preload.powf(n) - (preload - force).powf(n));
            assert!((seated - spring - expected).abs() < 1e-6, "{n} {preload} {force}: {seated} {spring} {expected}");
        }
    }
}

/// (in the model, replaced by, part of the message, part of the remedy): joints that are no springs.
const SEATS: &[Mistake] = &[
    ("stiffness = \"800", "c = \"0.3 um/N^n\"\ngap = \"2 um\"\nstiffness = \"800", "not both", "behind one another"),
    ("stiffness = \"800", "preload = \"2 kN\"\nstiffness = \"800", "there is no contact", "a contact has `c`"),
    ("stiffness = \"800", "c = \"0.3 um\"\nstiffness = \"800", "`um`", "um/N^n"),
    ("stiffness = \"800", "c = \"0.3 um/N^n\"\nn = 1.5\nstiffness = \"800", "`n`", "1"),
    ("stiffness = \"800", "gap = \"-2 um\"\nstiffness = \"800", "`gap` is -2 um", "zero or more"),
];

#[test]
fn seats_that_cannot_be_are_told_with_their_remedy() {
    let good = model("lathe-on-bed.toml");
    let place = Place::new();
    place.refuses(("run", "lathe.toml"), &good, SEATS);
    place.write("lathe.toml", good.replace("along = \"", "gap = \"1 um\"\nalong = \""));
    let told = ("9 joints are more than the 8 that can be no springs", "make springs of those");
    place.is_refused(&["run", "lathe.toml"], "a gap in every joint", told);
}

#[test]
fn drawings_that_cannot_be_are_told_with_their_remedy() {
    Place::new().refuses(("run", "lathe.toml"), &model("lathe-on-bed.toml"), CASES);
}

/// What nothing holds is told by the node that moves most, and how many go with it.
#[test]
fn a_machine_that_can_move_is_told_with_its_node() {
    let good = model("lathe-on-bed.toml");
    let without = |name: &str| {
        let (before, after) = good.split_once(&format!("[structure.{name}]")).unwrap();
        let rest = after.find("\n[").map_or("", |at| &after[at + 1..]);
        format!("{before}{rest}")
    };
    for (name, message) in [
        ("foot-along", "9 nodes more: they can move along x"),
        ("tailstock-tilt", "can move along x"),
        ("headstock-seat", "they can move along y"),
    ] {
        let place = Place::new();
        place.write("lathe.toml", without(name));
        let answer = place.fem(&["run", "lathe.toml"]);
        assert_eq!(answer.status, 2, "{name}");
        assert!(answer.err.contains("nothing holds") && answer.err.contains(message), "{name}: {}", answer.err);
    }
}

/// The compliance of the lathe on its bed, pushed and watched at headstock, tailstock and five places of the tool: where the
/// tool stood, the part is the same.
#[test]
fn a_measured_compliance_stands_for_the_drawing() {
    let place = Place::new();
    place.write("drawn.toml", model("lathe-on-bed.toml"));
    place.write("measured.toml", model("measured-lathe.toml"));
    place.write("measured-lathe.csv", model("measured-lathe.csv"));
    let errors = |name: &str| -> Vec<f64> {
        assert_eq!(place.fem(&["run", &format!("{name}.toml"), "-o", name]).status, 0);
        let profile = place.read(&format!("{name}/profile.csv"));
        let rows = profile.lines().skip(1).map(|line| line.split(',').collect::<Vec<_>>());
        let rows = rows.filter(|row| ["0", "102", "306", "450", "600"].contains(&row[1]));
        rows.map(|row| row[4].parse().unwrap()).collect()
    };
    let (drawn, measured) = (errors("drawn"), errors("measured"));
    assert_eq!((drawn.len(), measured.len()), (5, 5));
    for (drawn, measured) in drawn.iter().zip(&measured) {
        assert!((drawn - measured).abs() < 1e-6, "{drawn} {measured}");
    }
}

/// Beyond the places at which the tool was pushed nothing is known, and a run says what is taken for it.
#[test]
fn a_cut_beyond_where_the_tool_was_pushed_is_told() {
    let place = Place::new();
    place.write("measured.toml", model("measured-lathe.toml"));
    let told = |csv: &str| {
        place.write("measured-lathe.csv", csv);
        let answer = place.fem(&["run", "measured.toml", "-o", "out", "--force"]);
        assert_eq!(answer.status, 0, "{}", answer.err);
        answer.out.lines().find(|line| line.contains("[compliance] of the tool")).map(str::to_string)
    };
    let all = model("measured-lathe.csv");
    assert_eq!(told(&all), None);
    let without: String = all.split_inclusive('\n').filter(|line| !line.contains("tool,600")).collect();
    let line = told(&without).unwrap();
    assert!(line.contains("from 0 mm to 450 mm; beyond it is taken to yield as there"), "{line}");
}

/// (in the file, replaced by, part of the message, part of the remedy)
const MEASURED: &[Mistake] = &[
    (
        "tool,306,headstock,,6.336334620\n",
        "",
        "nothing says how the tool at 306 mm moves where the headstock is pushed",
        "every pair",
    ),
    (
        "tool,306,headstock,,6.336334620\n",
        "tool,306,headstock,,6.336334620\nheadstock,,tool,306,9\n",
        "where both ways are one compliance",
        "measure both again",
    ),
    (
        "tailstock,,headstock,,4.540155580",
        "tailstock,,headstock,,94.54",
        "no machine has these compliances",
        "look at its sign",
    ),
    ("[um/kN]", "[um]", "`um` measures a length, not a compliance", "write compliance [um/kN]"),
    (
        "tailstock,,tailstock,,24",
        "tailstock,,tailstock,,-24",
        "the tailstock does not give way where it is pushed",
        "above zero",
    ),
    ("tool,0,headstock", "tol,0,headstock", "line 5: `tol` is no place", "did you mean `tool`?"),
    ("tool,0,headstock", "tool,,headstock", "`push_x` is empty", "at which x"),
    ("push_x [mm]", "pushed [mm]", "`pushed` is no column", "its columns are"),
];

#[test]
fn compliances_that_cannot_be_are_told_with_their_remedy() {
    let good = model("measured-lathe.csv");
    for (replaced, by, message, remedy) in MEASURED {
        let place = Place::new();
        place.write("measured.toml", model("measured-lathe.toml"));
        let text = good.replacen(replaced, by, 1);
        assert_ne!(text, good, "{replaced}");
        place.write("measured-lathe.csv", text);
        place.is_refused(&["run", "measured.toml"], by, (*message, *remedy));
    }
}

/// A node carries what stands at its place; a force beside it would turn it.
#[test]
fn what_stands_beside_its_node_is_told() {
    let good = model("lathe-on-bed.toml");
    Place::new().refuses(
        ("run", "lathe.toml"),
        &good,
        &[
            (
                "headstock = \"nose\"",
                "headstock = \"spindle\"",
                "`headstock` is the node `spindle` at x = -200 mm, and what stands there is at x = 0 mm",
                "name the node at its place",
            ),
            ("tailstock = \"centre\"", "tailstock = \"quill\"", "at x = 720 mm", "members along x"),
        ],
    );
    // Of members that each name their material none need be said of all.
    let each = good.replace("material = \"cast-iron\"\n", "").replace("wall = ", "material = \"cast-iron\"\nwall = ");
    let place = Place::new();
    place.write("lathe.toml", &each);
    assert_eq!(place.fem(&["run", "lathe.toml", "-o", "out"]).status, 0);
    place.write("lathe.toml", good.replace("material = \"cast-iron\"\n", ""));
    let told = ("`material` is missing in `structure.bed-a`", "add material");
    place.is_refused(&["run", "lathe.toml"], "a member without a material", told);
}
