//! Contact joints, alone, in series, and where the shaft is statically indeterminate.

use super::rig::*;
use crate::validation::{Case, Tolerance};

pub fn cases() -> Vec<Case> {
    let contact = "[tailstock-contact]\nc = \"0.3 um/N^n\"\nn = 0.5";
    let series = "[tailstock-contact]\nc = \"0.3 um/N^n\"\nn = 0.5\n[tailstock-compliance]\nstiffness = \"80 N/um\"";
    let carriage = "[carriage-contact]\nc = \"0.25 um/N^n\"\nn = 0.6";
    let law = 0.3e-6 * 400f64.sqrt();
    let at_tailstock = |name: &str, effects: &str, expected| {
        deflection(name, (expected, gap(&uniform("centres", effects), 0.5)), "seed 002 (29)")
    };
    let mut cases = vec![
        at_tailstock("contact alone", contact, law),
        at_tailstock("contact and spring in series", series, law + 400.0 / 80e6),
        at_tailstock("carriage contact, n = 0.6", carriage, 0.25e-6 * 400f64.powf(0.6)),
    ];
    // Newton's residual of 1e-12 of the forces bounds the error of the redundant force, and thus of the
    // deflection, by a few 1e-12.
    let newton = Tolerance::Relative(1e-11);
    for (n, c) in [(0.3, 2.0), (0.5, 0.5), (0.8, 0.05)] {
        for (a, place) in [(0.05, "x = 0.1 L"), (0.3, "x = 0.6 L"), (0.5, "x = L")] {
            let effects = format!(
                "[tailstock-contact]\nc = \"{c} um/N^n\"\nn = {n}\n[tailstock-compliance]\nstiffness = \"80 N/um\""
            );
            let computed = gap(&uniform("chuck-and-centre", &effects), a);
            let name = format!("chuck, centre with contact n = {n}, {place}");
            cases.push(row(
                name,
                "deflection",
                (on_closing_centre(a, 1e-6 * c, n), computed, "m"),
                newton,
                "force method and bisection",
            ));
        }
    }
    cases.extend(rubbing());
    cases
}

/// Friction of 60 N beside springs of 50 N/um under 400 N: by statics Q = P·x/L at the tailstock and P·(1 − x/L) at the
/// headstock, what the springs bear S = Q ± f by hand, and ΔD = 2·(S − Q)/k·(lever) beside what springs alone leave.
fn rubbing() -> Vec<Case> {
    let springs = "[headstock-compliance]\nstiffness = \"50 N/um\"\n[tailstock-compliance]\nstiffness = \"50 N/um\"\n";
    let along = |effects: &str, pass: &str| {
        let text = UNIFORM.replace("HELD", "centres").replace("cut = { ", &format!("cut = {{ {pass}"));
        profile(&lathe(&(text + "sweep = { positions = 11 }\n"), effects))
    };
    let rising = "from = \"0 mm\", to = \"500 mm\", ";
    // What the springs bear beyond Q at x = 0, L/5, 2L/5 … L, N. The pass before left 60 N at the end that the tool comes to
    // last, and at that where it enters 60 N less than all of it.
    let tables = [
        ("tailstock, toward the headstock", "tailstock", "", [60.0, 60.0, 60.0, 60.0, 20.0, -60.0]),
        ("headstock, toward the headstock", "headstock", "", [-60.0, -60.0, -60.0, -60.0, -20.0, 60.0]),
        ("tailstock, toward the tailstock", "tailstock", rising, [60.0, -20.0, -60.0, -60.0, -60.0, -60.0]),
        ("headstock, toward the tailstock", "headstock", rising, [-60.0, 20.0, 60.0, 60.0, 60.0, 60.0]),
    ];
    let case = |(name, unit, pass, beyond): (&str, &str, &str, [f64; 6])| -> Vec<Case> {
        let rubs = along(&format!("{springs}[{unit}-friction]\nforce = \"60 N\""), pass);
        let free = along(springs, pass);
        let one = |(i, beyond): (usize, f64)| {
            let share = i as f64 / 5.0;
            let lever = if unit == "tailstock" { share } else { 1.0 - share };
            let computed =
                rubs.get(2 * i).zip(free.get(2 * i)).map_or(f64::NAN, |(with, without)| 1e6 * (with - without));
            let expected = 2e6 * beyond / 50e6 * lever;
            let tolerance = Tolerance::Absolute(1e-9);
            row(
                format!("friction at the {name}, x = {share} L"),
                "change of diameter",
                (expected, computed, "um"),
                tolerance,
                "play operator",
            )
        };
        beyond.into_iter().enumerate().map(one).collect()
    };
    tables.into_iter().flat_map(case).collect()
}

/// A cantilever whose free end rests on a spring and a contact in series: R closes the gap, R·L³/3EI + c·Rⁿ
/// + R/k = w(L).
fn on_closing_centre(a: f64, c: f64, n: f64) -> f64 {
    let s = shaft40();
    let (p, l, ei) = (s.force, s.length, s.ei);
    let reach = a * a * (3.0 * l - a) / (6.0 * ei);
    let r = bisect(0.0, p, |r| r * l.powi(3) / (3.0 * ei) + c * r.powf(n) + r / 80e6 - p * reach);
    p * a.powi(3) / (3.0 * ei) - r * reach
}
