//! A shaft on a structure: closed forms of beams and frames, and the whole machine as another program assembles it.

use super::rig::*;
use crate::processes::turning::condense;
use crate::processes::turning::elastic::{Cutting, Elastic};
use crate::validation::bench::tables;
use crate::validation::{Case, Tolerance};

/// A frame of some ten unknowns, whose stiffnesses lie six powers of ten apart.
const FRAME: Tolerance = Tolerance::Relative(1e-9);
/// Values of another program, printed to 1e-9 um.
const PRINTED: Tolerance = Tolerance::Relative(1e-10);

/// The lathe of the models: its tables, and its effect.
fn on_bed() -> (String, &'static str) {
    let text = tables(include_str!("../../../models/lathe-on-bed.toml"));
    (text, "[carriage-compliance]\nstiffness = \"80 N/um\"")
}

const STATICS: &str = "beams and frames by statics and slope deflection, with shear";
const OPENSEES: &str =
    "OpenSees 3.7.1: machine, shaft and carriage as one frame (tests/validation/opensees/lathe_on_bed.py)";

/// E and κG/G of the structures below: steel, solid, 60 mm square.
struct Bar {
    ea: f64,
    ei: f64,
    shear: f64,
}

fn bar() -> Bar {
    let (e, nu, side) = (210e9, 0.3, 0.06f64);
    let area = side * side;
    let kappa = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
    Bar { ea: e * area, ei: e * side.powi(4) / 12.0, shear: kappa * e / (2.0 * (1.0 + nu)) * area }
}

pub fn cases() -> Vec<Case> {
    [bed(), overhang(), portal(), machine(), seats(), secant()].concat()
}

/// What a structure adds to the gap at x (m) under 400 N on the uniform shaft between centres, m.
fn added(structure: &str, x: f64) -> f64 {
    let text = UNIFORM.replace("HELD", "centres");
    gap(&lathe(&format!("{text}\n[structure]\nmaterial = \"steel\"\n{structure}"), ""), x) - gap(&lathe(&text, ""), x)
}

fn deflected(name: String, pair: (f64, f64)) -> Case {
    row(name, "deflection", (pair.0, pair.1, "m"), FRAME, STATICS)
}

/// Supports that stand still, and a tool that travels along a beam on two of them.
fn bed() -> Vec<Case> {
    const BED: &str = r#"
        pinned = ["left", "right"]
        clamped = ["nose", "centre"]
        nodes = { left = ["-100 mm", "-200 mm"], right = ["700 mm", "-200 mm"], nose = ["0 mm", "0 mm"], centre = ["500 mm", "0 mm"] }
        ports = { headstock = "nose", tailstock = "centre", tool = "bed" }
        bed = { between = ["left", "right"], width = "60 mm", height = "60 mm" }
    "#;
    let Bar { ei, shear, .. } = bar();
    let length = 0.8;
    let at = |x: f64| {
        let (a, b) = (x + 0.1, 0.7 - x);
        let yields = (a * b).powi(2) / (3.0 * ei * length) + a * b / (shear * length);
        deflected(format!("tool on a bed on two feet, x = {:.0} mm", 1e3 * x), (400.0 * yields, added(BED, x)))
    };
    [0.0, 0.2, 0.3, 0.5].map(at).to_vec()
}

/// The nose at the end of a spindle that is clamped in its last bearing.
fn overhang() -> Vec<Case> {
    const OVERHANG: &str = r#"
        clamped = ["bearing", "centre", "slide"]
        nodes = { bearing = ["-150 mm", "0 mm"], nose = ["0 mm", "0 mm"], centre = ["500 mm", "0 mm"], slide = ["0 mm", "-200 mm"] }
        ports = { headstock = "nose", tailstock = "centre", tool = "slide" }
        spindle = { between = ["bearing", "nose"], width = "60 mm", height = "60 mm" }
    "#;
    let Bar { ei, shear, .. } = bar();
    let yields = 0.15f64.powi(3) / (3.0 * ei) + 0.15 / shear;
    let at = |x: f64| {
        let share = 1.0 - x / 0.5;
        let name = format!("nose on an overhanging spindle, x = {:.0} mm", 1e3 * x);
        deflected(name, (400.0 * share * share * yields, added(OVERHANG, x)))
    };
    [0.0, 0.1, 0.4].map(at).to_vec()
}

/// The headstock in the middle of a portal frame with clamped feet: its corners turn by θ = (QL/8)/(2EI/L + k), and the
/// middle sinks by QL³/192EI + QL/4κGA + θL/4 and what the columns shorten. k is what a clamped column resists turning with,
/// 4EI/h of slender ones, less what the girder yields to its thrust: H = sθ − tu, u = HL/2EA.
fn portal() -> Vec<Case> {
    const PORTAL: &str = r#"
        clamped = ["left-foot", "right-foot", "centre", "slide"]
        ports = { headstock = "nose", tailstock = "centre", tool = "slide" }
        left-column = { between = ["left-foot", "left"], width = "60 mm", height = "60 mm" }
        left-girder = { between = ["left", "nose"], width = "60 mm", height = "60 mm" }
        right-girder = { between = ["nose", "right"], width = "60 mm", height = "60 mm" }
        right-column = { between = ["right-foot", "right"], width = "60 mm", height = "60 mm" }
        [structure.nodes]
        left-foot = ["-300 mm", "400 mm"]
        left = ["-300 mm", "0 mm"]
        nose = ["0 mm", "0 mm"]
        right = ["300 mm", "0 mm"]
        right-foot = ["300 mm", "400 mm"]
        centre = ["500 mm", "0 mm"]
        slide = ["0 mm", "-200 mm"]
    "#;
    let Bar { ea, ei, shear } = bar();
    let (l, h) = (0.6, 0.4);
    let phi = 12.0 * ei / (shear * h * h);
    let [s, t] = [6.0 * ei / (h * h), 12.0 * ei / h.powi(3)].map(|slender| slender / (1.0 + phi));
    let shortens = 0.5 * l / ea;
    let column = 4.0 * ei / h * (1.0 + phi / 4.0) / (1.0 + phi) - s * s * shortens / (1.0 + t * shortens);
    let turns = l / 8.0 / (2.0 * ei / l + column);
    let sinks = l.powi(3) / (192.0 * ei) + l / (4.0 * shear) + turns * l / 4.0 + 0.5 * h / ea;
    let at = |x: f64| {
        let share = 1.0 - x / 0.5;
        let name = format!("headstock on a portal frame, x = {:.0} mm", 1e3 * x);
        deflected(name, (400.0 * share * share * sinks, added(PORTAL, x)))
    };
    [0.0, 0.25].map(at).to_vec()
}

/// The lathe on its bed, held in several ways.
fn machine() -> Vec<Case> {
    const PLACES: [f64; 5] = [0.0, 0.102, 0.306, 0.45, 0.6];
    let (on_bed, effects) = on_bed();
    let chuck = on_bed.replace("type = \"centres\"", "type = \"chuck-and-centre\"");
    let rest = (chuck
        .replace("[workholding]", "[workholding]\nsteady_rests = [{ at = \"300 mm\", stiffness = \"30 N/um\" }]"))
    .replace("[structure.ports]", "[structure.ports]\nrests = \"bed-b\"");
    let beside = on_bed.replace("[structure.ports]", "[structure.ports]\ntool_offset = \"-120 mm\"");
    let held: [(&str, &str, [f64; 5]); 4] = [
        ("between centres", &on_bed, [22.010204469, 52.219645799, 94.345781768, 72.431523244, 27.920609122]),
        ("in chuck and centre", &chuck, [21.217183920, 35.780794614, 66.206822056, 59.326882143, 27.788748340]),
        (
            "in chuck and centre, on a rest",
            &rest,
            [20.002141520, 28.002448174, 30.806435524, 36.425139971, 27.304955090],
        ),
        ("carriage 120 mm beside", &beside, [21.534372294, 51.973192108, 94.475015822, 72.759263319, 28.396441297]),
    ];
    let rows = |(name, text, expected): &(&str, &str, [f64; 5])| {
        let lathe = lathe(text, effects);
        let at = |(x, expected): (&f64, &f64)| {
            let computed = lathe.as_ref().map_or(f64::NAN, |lathe| 1e6 * observed(lathe, *x, &[]));
            let name = format!("lathe on its bed {name}, x = {:.0} mm", 1e3 * x);
            row(name, "diameter error", (*expected, computed, "um"), PRINTED, OPENSEES)
        };
        PLACES.iter().zip(expected).map(at).collect::<Vec<_>>()
    };
    held.iter().flat_map(rows).collect()
}

/// Joints that are no springs, where statics gives their forces: the seat of the headstock bears Q = P(1 − x/L), and what it
/// gives way by, e, moves the work at x by e(1 − x/L).
fn seats() -> Vec<Case> {
    const CONTACT: &str = "a contact under a preload, y = c*(Q + P)^n - c*P^n, and statics";
    const CLEARANCE: &str = "a clearance that the force crosses, and statics";
    let (on_bed, effects) = on_bed();
    let (before, after) = on_bed.split_once("[structure.headstock-seat]").unwrap_or_default();
    let with = |seat: &str| {
        let after = after.replacen("along = \"y\"", &format!("along = \"-y\"\n{seat}"), 1);
        lathe(&format!("{before}[structure.headstock-seat]{after}"), effects)
    };
    let plain = lathe(&on_bed, effects);
    let at = |seated: &Option<Lathe>, x: f64| match (seated, &plain) {
        (Some(seated), Some(plain)) => observed(seated, x, &[]) - observed(plain, x, &[]),
        _ => f64::NAN,
    };
    let mut cases = Vec::new();
    for x in [0.0, 0.15, 0.45] {
        let share = 1.0 - x / 0.6;
        let force = 450.0 * share;
        for preload in [0.0, 2000.0f64] {
            let e = 0.3e-6 * ((force + preload).powf(0.6) - preload.powf(0.6));
            let seated = with(&format!("c = \"0.3 um/N^n\"\nn = 0.6\npreload = \"{preload} N\""));
            let name = format!("headstock on a contact under {preload:.0} N, x = {:.0} mm", 1e3 * x);
            let pair = (2.0 * share * e, at(&seated, x), "m");
            cases.push(row(name, "change of the diameter", pair, FRAME, CONTACT));
        }
        let pair = (2.0 * share * 4e-6, at(&with("gap = \"4 um\""), x), "m");
        let name = format!("headstock with 4 um of clearance, x = {:.0} mm", 1e3 * x);
        cases.push(row(name, "change of the diameter", pair, FRAME, CLEARANCE));
    }
    cases
}

/// A contact in a seat whose force statics does not give: the same lathe with a spring in its place that yields as much under
/// the force that it then bears, found by bisection over linear lathes.
fn secant() -> Vec<Case> {
    const SECANT: &str = "a spring of the contact's secant stiffness, by bisection";
    let (on_bed, effects) = on_bed();
    let chuck = on_bed.replace("type = \"centres\"", "type = \"chuck-and-centre\"");
    let (before, after) = chuck.split_once("[structure.tailstock-seat]").unwrap_or_default();
    let with = |stiffness: f64, seat: &str| {
        let after = after.replacen("along = \"y\"", &format!("along = \"-y\"\n{seat}"), 1);
        let after = after.replacen("400 +- 100 N/um", &format!("{stiffness} N/um"), 1);
        lathe(&format!("{before}[structure.tailstock-seat]{after}"), effects)
    };
    let contact = |force: f64| 0.5 * force.sqrt();
    let at = |x: f64| {
        // The stiffness of the spring rises with what is tried, and with it the stiffness that the contact would have.
        let excess = |log: f64| {
            let stiffness = log.exp();
            let force = with(stiffness, "").as_ref().map_or(f64::NAN, |lathe| tailstock_force(lathe, x));
            1.0 / (1.0 / 400.0 + contact(force) / force) - stiffness
        };
        let stiffness = bisect(5f64.ln(), 400f64.ln(), |log| -excess(log)).exp();
        let [spring, seated] = [with(stiffness, ""), with(400.0, "c = \"0.5 um/N^n\"\nn = 0.5")]
            .map(|lathe| lathe.as_ref().map_or(f64::NAN, |lathe| observed(lathe, x, &[])));
        let name = format!("tailstock on a contact, chuck and centre, x = {:.0} mm", 1e3 * x);
        row(name, "diameter error", (spring, seated, "m"), FRAME, SECANT)
    };
    [0.2, 0.4, 0.55].map(at).to_vec()
}

/// Force on the tailstock with the tool at x (m), N.
fn tailstock_force(lathe: &Lathe, x: f64) -> f64 {
    let solve = || {
        let shaft = condense(lathe.machine(), &[x]).ok()?;
        let at = Cutting::new(lathe.machine(), &lathe.machine().moment_on(1, x), lathe.setup().conditions(x, 0.0));
        Elastic::new(lathe.machine(), &shaft).deflect(0, &at).ok().map(|d| d.supports.forces[1])
    };
    solve().unwrap_or(f64::NAN)
}
