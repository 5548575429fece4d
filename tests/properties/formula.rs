//! A formula effect reaches every figure: written as a formula, a built-in effect gives the report of the
//! built-in one.

use fem::input::Source;
use fem::model::Model;
use fem::process::{Datum, Frame};
use fem::processes::ALL;
use fem::progress::Progress;
use fem::units::Unit;

/// An effect of a process and the same as a formula.
struct Twin {
    process: &'static str,
    /// Tables of the model; empty for those of the starting model of the process.
    model: &'static str,
    /// `[effects.NAME]` of the catalogue.
    built_in: &'static str,
    /// The same in `[effects.mine]`.
    formula: &'static str,
    /// Paths of what tells of the mechanics alone, which a formula does not reach.
    mechanics: &'static [&'static str],
    /// Largest difference of any figure or field relative to its size, and in SI: round-off, or the order
    /// that the formula leaves out.
    tolerance: (f64, f64),
}

const ROUND_OFF: (f64, f64) = (1e-9, 1e-15);

const LUMP: &str = r#"
    body = { material = { base = "steel", conductivity = "1e7 W/m/K" }, segments = [{ length = "200 mm", diameter = "20 mm" }] }
    source = [{ at = "200 mm", power = "15 W", on = [["0 min", "90 min"]] }]
    environment = { temperature = "20 degC" }
    time = { end = "180 min", step = "30 s" }
    measurement = { places = ["0 mm", "100 mm", "200 mm"], interval = "2 min" }
"#;

/// Servos that follow at once: a lag would turn the offset.
const CIRCLE: &str = r#"
    path = { shape = "circle", radius = "150 mm", feed = "1000 mm/min" }
    drives = { gain = "1000000 /s" }
    tolerance = { deviation = "10 um" }
"#;

/// A circle of 20 mm, 4 mm beside the axis of the cam.
const ECCENTRIC: &str = r#"
    profile = { start = ["24 mm", "0 mm"], segments = [{ arc = { centre = ["4 mm", "0 mm"], sweep = "360 deg" } }] }
    wheel = { radius = "175 mm" }
    cut = { stock = "20 um", force_per_rate = "10 N/(mm^2/s)" }
    program = { blocks = 360, cam_speed = "20 rpm" }
"#;

/// The force of the cut over the stiffness, in closed form: with ρ the distance from the axis at a polar
/// angle, the feed is (d² + 2·d·l·c + l²)/(d·c + l) per turn, c the cosine of the angle about the circle's
/// centre.
const YIELDING: &str = r#"
    [effects.mine]
    formula = "k*cam_speed*r/l*(d^2+2*d*l*(cos(angle)*sqrt(r^2-d^2*sin(angle)^2)-d*sin(angle)^2)/r+l^2)/(d*(cos(angle)*sqrt(r^2-d^2*sin(angle)^2)-d*sin(angle)^2)/r+l)"
    k = "0.04 ms"
    r = "20 mm"
    d = "4 mm"
    l = "195 mm"
"#;

const TWINS: &[Twin] = &[
    Twin {
        process: "turning",
        model: "",
        built_in: "[effects.guideway-taper]\nslope = \"30 um/m\"\n",
        formula: "[effects.mine]\nformula = \"2*slope*x\"\nslope = \"30 um/m\"\n",
        mechanics: &[],
        tolerance: ROUND_OFF,
    },
    Twin {
        process: "ring",
        model: "",
        built_in: "[effects.spindle-error]\namplitude = \"3 um\"\nphase = \"20 deg\"\n",
        formula: "[effects.mine]\nformula = \"(1 - state)*a*cos(2*(angle - phase))\"\na = \"3 um\"\nphase = \"20 deg\"\n",
        mechanics: &[],
        tolerance: ROUND_OFF,
    },
    Twin {
        process: "thermal",
        // It conducts so well that it is one lump, which a source warms evenly.
        model: LUMP,
        built_in: "[effects.extra-source]\nat = \"70 mm\"\npower = \"4 W\"\n",
        formula: "[effects.warmer]\nformula = \"power*time/capacity\"\npower = \"4 W\"\n\
                  capacity = \"231.81812190839082 J/K\"\n\
                  [effects.longer]\nformula = \"expansion*length*power*time/capacity\"\npower = \"4 W\"\n\
                  capacity = \"231.81812190839082 J/K\"\nexpansion = \"11.5e-6 /K\"\nlength = \"200 mm\"\n",
        // Heat that a formula does not supply, the place of the hottest of equals, and displacements of the
        // body.
        mechanics: &["energy", "discretisation", "hottest/x", "displacement", "stress"],
        // P·L/(kA) = 2.5e-4 K is left between the ends of the lump.
        tolerance: (1e-5, 5e-4),
    },
    Twin {
        process: "fixture",
        model: "",
        built_in: "[effects.locator-wear]\nrate = \"12 um/1000\"\n",
        formula: "[effects.mine]\nformula = \"rate*part\"\nrate = \"0.012 um\"\n",
        mechanics: &[],
        tolerance: ROUND_OFF,
    },
    Twin {
        process: "stiffness",
        model: "",
        built_in: "[effects.gap]\ngap = \"3 um\"\n",
        formula: "[effects.mine]\nformula = \"gap*step(force - least)\"\ngap = \"3 um\"\nleast = \"1 N\"\n",
        // A preload takes up clearance, not what a formula adds; what a reversal loses is clearance too.
        mechanics: &["preload/with/", "lost_motion", "worth_friction"],
        tolerance: ROUND_OFF,
    },
    Twin {
        process: "axis",
        model: "",
        built_in: "[effects.scale-error]\nslope = \"20 um/m\"\n",
        formula: "[effects.mine]\nformula = \"slope*position\"\nslope = \"20 um/m\"\n",
        mechanics: &[],
        tolerance: ROUND_OFF,
    },
    Twin {
        process: "rotary",
        model: "",
        built_in: "[effects.worm-second-harmonic]\namplitude = \"4 arcsec\"\nphase = \"20 deg\"\n",
        formula: "[effects.mine]\nformula = \"a*sin(2*180*angle + phase)\"\na = \"4 arcsec\"\nphase = \"20 deg\"\n",
        mechanics: &[],
        // A sine of some thousand radians keeps twelve digits.
        tolerance: (1e-9, 1e-15),
    },
    Twin {
        process: "contour",
        model: CIRCLE,
        built_in: "[effects.centre-offset]\nx = \"3 um\"\ny = \"-2 um\"\n",
        formula: "[effects.mine]\nformula = \"a*cos(angle) + b*sin(angle)\"\na = \"3 um\"\nb = \"-2 um\"\n",
        // Where the tool is apart from the deviation, and the places of peaks, which are flat.
        mechanics: &["following_error", "largest/angle", "smallest/angle"],
        // The formula leaves out the second order, offset²/2R = 4.3e-11 m, and in diameters twice that.
        tolerance: (1e-9, 9e-11),
    },
    Twin {
        process: "cam",
        model: ECCENTRIC,
        built_in: "[effects.grinding-deflection]\nstiffness = \"5 N/um\"\n",
        formula: YIELDING,
        // A peak is flat: its place is known to the root of round-off only.
        mechanics: &["angle"],
        tolerance: (1e-6, 1e-12),
    },
];

/// The SI value of a unit; of a temperature only its degrees.
fn factor(unit: &str) -> f64 {
    Unit::parse(unit).unwrap().factor
}

/// The model of a twin with this effect.
fn model(twin: &Twin, effect: &str) -> Model {
    // The starting model without its effects, which stand last.
    let start = || {
        let text = ALL.iter().find(|p| p.name() == twin.process).unwrap().starting_model();
        text.split("[effects.").next().unwrap().to_string()
    };
    let own = format!("process = \"{}\"\n{}", twin.process, twin.model);
    let text = if twin.model.is_empty() { start() } else { own };
    Model::parse(Source::new("model.toml", format!("{text}\n{effect}"))).unwrap()
}

/// Every number of a report in SI by a path: entries of figures, columns of tables, points of plots, fields
/// of frames.
fn numbers(twin: &Twin, effect: &str) -> Vec<(String, f64)> {
    let report = model(twin, effect).run(&Progress::default()).unwrap().report;
    let mut all = Vec::new();
    for figure in &report.figures {
        for (key, datum) in &figure.entries {
            entry(&format!("{}/{key}", figure.key), datum, &mut all);
        }
    }
    for (name, table) in report.tables.iter().map(|(n, t)| (*n, t)).chain([("profile", &report.profile)]) {
        for column in &table.columns {
            let unit = factor(&column.unit.unwrap_or_default());
            all.extend(column.values.iter().map(|v| (format!("{name}.csv/{}", column.name), unit * v)));
        }
    }
    for plot in &report.plots {
        let unit = plot.title.split(['[', ']']).nth(1).map_or(1.0, factor);
        all.extend(plot.points.iter().map(|p| (plot.title.clone(), unit * p.1)));
    }
    for drawing in &report.drawings {
        let spots = drawing.curves.iter().flat_map(|c| c.pieces.iter().flatten());
        all.extend(spots.map(|s| (format!("{}.svg", drawing.name), s.deviation)));
    }
    for animation in &report.animations {
        for i in [0, animation.frames / 2, animation.frames - 1] {
            let Frame { grid, .. } = (animation.frame)(i);
            for field in grid.point_fields.iter().chain(&grid.cell_fields) {
                all.extend(field.values.iter().map(|v| (format!("frame {i}/{}", field.name), *v)));
            }
        }
    }
    all
}

fn entry(path: &str, datum: &Datum, all: &mut Vec<(String, f64)>) {
    match datum {
        Datum::Quantity(_, value) | Datum::Number(value) => all.push((path.into(), *value)),
        Datum::Quantities(_, values) => all.extend(values.iter().map(|v| (path.to_string(), *v))),
        Datum::Count(count) => all.push((path.into(), *count as f64)),
        Datum::Flag(flag) => all.push((path.into(), f64::from(*flag))),
        Datum::Record(entries) => entries.iter().for_each(|(key, e)| entry(&format!("{path}/{key}"), e, all)),
        Datum::List(list) => list.iter().for_each(|e| entry(path, e, all)),
        Datum::Word(_) | Datum::Missing => {}
    }
}

#[test]
fn a_formula_reaches_every_figure() {
    for twin in TWINS {
        let [built_in, formula, without] = [twin.built_in, twin.formula, ""].map(|effect| numbers(twin, effect));
        assert_eq!(built_in.len(), formula.len(), "{}", twin.process);
        assert!(built_in != without, "{}: the effect changes nothing", twin.process);
        let (relative, absolute) = twin.tolerance;
        for ((path, a), (other, b)) in built_in.iter().zip(&formula) {
            assert_eq!(path, other, "{}", twin.process);
            if twin.mechanics.iter().any(|own| path.contains(own)) {
                continue;
            }
            let near = (a - b).abs() <= absolute + relative * a.abs().max(b.abs());
            assert!(near || a == b || (a.is_nan() && b.is_nan()), "{}: {path} is {a} and {b}", twin.process);
        }
    }
}

#[test]
fn a_formula_is_the_same_whenever_it_is_read() {
    for twin in TWINS {
        let read = || model(twin, twin.formula);
        let (one, other) = (read(), read());
        assert!(one.effects.iter().any(|effect| effect.formula.is_some()), "{}", twin.process);
        assert_eq!(one.effects, other.effects, "{}", twin.process);
        // They share nothing: what is left of one does not hang on the other.
        drop(other);
        assert_eq!(one.effects, read().effects, "{}", twin.process);
    }
}

#[test]
fn a_unit_too_long_for_a_kind_is_refused() {
    let stiffness = ALL.iter().find(|p| p.name() == "stiffness").unwrap().starting_model();
    let read = |unit: &str| {
        let own = format!("[effects.mine]\nformula = \"a*force\"\na = \"1 {unit}\"\n");
        Model::parse(Source::new("model.toml", format!("{stiffness}\n{own}")))
    };
    assert_eq!(read("um/N").unwrap().effects.last().unwrap().description.parameters[0].kind.unit, "um/N");
    let long = format!("um/N{}", "*m/m".repeat(20));
    let problems = read(&long).map(|_| ()).unwrap_err().problems;
    assert_eq!(problems.len(), 1, "{problems:?}");
    assert_eq!(problems[0].message, "the unit of `a` has more than 47 bytes");
}
