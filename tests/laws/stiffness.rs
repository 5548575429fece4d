//! A joint under load: it gives no work, and knows no side.

use proptest::prelude::*;

use super::{ROUND_OFF, alike, model, observed, reported, times};

/// A spring (N/um) with some of what bends its curve.
pub(super) fn joint() -> impl Strategy<Value = (f64, Vec<String>)> {
    let number = |from: f64, to: f64| from..to;
    let drawn = (number(0.5, 8.0), number(0.05, 0.5), number(0.35, 0.9), number(5.0, 200.0), number(0.2, 5.0));
    (20.0..300.0, drawn, prop::collection::vec(prop::bool::ANY, 4)).prop_map(|(stiffness, drawn, some)| {
        let (gap, c, n, friction, settled) = drawn;
        let all = [
            format!("[effects.gap]\ngap = \"{gap} um\"\n"),
            format!("[effects.contact-joint]\nc = \"{c} um/N^n\"\nn = {n}\n"),
            format!("[effects.dry-friction]\nforce = \"{friction} N\"\n"),
            format!("[effects.settling]\ndepth = \"{settled} um\"\n"),
        ];
        (stiffness, all.into_iter().zip(&some).filter(|(_, own)| **own).map(|(effect, _)| effect).collect())
    })
}

pub(super) fn text((stiffness, effects): &(f64, Vec<String>), loading: &str) -> String {
    format!(
        "process = \"stiffness\"\njoint = {{ stiffness = \"{stiffness} N/um\" }}\n\
         test = {{ max_force = \"1000 N\", steps = 20, loading = \"{loading}\" }}\n{}",
        effects.concat()
    )
}

fn displacements(joint: &(f64, Vec<String>), loading: &str, force: &[f64], unloading: bool) -> Vec<f64> {
    let branch = vec![f64::from(u8::from(unloading)); force.len()];
    observed(&model(&text(joint, loading)), "displacement", &[("force", force), ("branch", &branch)])
}

proptest! {
    #![proptest_config(super::random(160))]

    /// The work of the load along a loop is what the joint keeps or wastes.
    #[test]
    fn a_joint_gives_no_work(joint in joint()) {
        let up: Vec<f64> = (0..=400).map(|i| 2.5 * f64::from(i)).collect();
        let down: Vec<f64> = up.iter().rev().copied().collect();
        let moved = [displacements(&joint, "from-zero", &up, false), displacements(&joint, "from-zero", &down, true)];
        let force = [up, down].concat();
        let moved = moved.concat();
        let step = |i: usize| 0.5 * (force[i] + force[i + 1]) * (moved[i + 1] - moved[i]);
        let work: f64 = (0..force.len() - 1).map(step).sum();
        let size: f64 = (0..force.len() - 1).map(|i| step(i).abs()).sum();
        prop_assert!(work >= -1e-9 * size, "the joint gave {:e} J of {size:e}", -work);
    }

    /// The work that a run tells of is that between the branches of its curve. A sum over steps ΔF is off by
    /// ΔF/2 times all the way that the joint goes, at most; clearance is taken up and let go under no force.
    #[test]
    fn the_work_of_a_loop_lies_between_its_branches(joint in joint()) {
        const STEP: f64 = 0.5;
        let up: Vec<f64> = (0..=2000).map(|i| STEP * f64::from(i)).collect();
        let down: Vec<f64> = up.iter().rev().copied().collect();
        let branches = [displacements(&joint, "from-zero", &up, false), displacements(&joint, "from-zero", &down, true)];
        let (force, moved) = ([up, down].concat(), branches.concat());
        let (mut work, mut way) = (0.0, 0.0);
        for (force, moved) in force.windows(2).zip(moved.windows(2)) {
            work += 0.5 * (force[0] + force[1]) * (moved[1] - moved[0]);
            way += (moved[1] - moved[0]).abs();
        }
        let told = reported(&model(&text(&joint, "from-zero")), "loop", "area");
        prop_assert!((work - told).abs() <= 0.5 * STEP * way + 1e-12, "{work:e} and {told:e} J");
    }

    /// What has neither friction nor settled gives all work back: it returns as it came.
    #[test]
    fn an_elastic_joint_returns_as_it_came(joint in joint()) {
        let (stiffness, effects) = joint;
        let wasteful = |effect: &String| effect.contains("friction") || effect.contains("settling");
        let joint = (stiffness, effects.into_iter().filter(|effect| !wasteful(effect)).collect());
        let force: Vec<f64> = (1..=20).map(|i| 50.0 * f64::from(i)).collect();
        let [up, down] = [false, true].map(|unloading| displacements(&joint, "from-zero", &force, unloading));
        alike(&up, &down, ROUND_OFF)?;
    }

    /// Pushed instead of pulled the joint moves the other way, but for where the gauge is zero: clearance is counted from
    /// its one side. Under no force it may stand anywhere in it.
    #[test]
    fn a_reversed_loop_has_no_side(joint in joint()) {
        // What has settled under the first load is no loop.
        let (stiffness, effects) = joint;
        let joint = (stiffness, effects.into_iter().filter(|e| !e.contains("settling")).collect::<Vec<_>>());
        let force: Vec<f64> = (-19..=19).filter(|i| *i != 0).map(|i| 50.0 * f64::from(i)).collect();
        let turned: Vec<f64> = force.iter().map(|force| -force).collect();
        let down: Vec<f64> = displacements(&joint, "reversed", &turned, true).iter().map(|moved| -moved).collect();
        let about_first = |moved: &[f64]| moved.iter().map(|value| value - moved[0]).collect::<Vec<f64>>();
        let up = displacements(&joint, "reversed", &force, false);
        alike(&about_first(&up), &about_first(&down), ROUND_OFF)?;
    }

    /// All lengths by s and all forces by p: displacements by s. A contact c·F^n keeps its shape with c by s/pⁿ.
    #[test]
    fn larger_joints_yield_in_proportion(
        (stiffness, gap, n, friction) in (20.0..300.0, 0.5..8.0, 0.35..0.9, 5.0..200.0), s in 0.3..3.0, p in 0.3..3.0,
    ) {
        let yielded = |s: f64, p: f64| {
            let text = format!(
                "process = \"stiffness\"\njoint = {{ stiffness = \"{} N/um\" }}\n\
                 test = {{ max_force = \"{} N\", steps = 20, loading = \"from-zero\" }}\n\
                 [effects.gap]\ngap = \"{} um\"\n[effects.dry-friction]\nforce = \"{} N\"\n\
                 [effects.contact-joint]\nc = \"{} um/N^n\"\nn = {n}\n",
                stiffness * p / s, 1000.0 * p, gap * s, friction * p, 0.2 * s / f64::powf(p, n),
            );
            let force: Vec<f64> = (1..=20).map(|i| 50.0 * p * f64::from(i)).collect();
            let branch = |word: f64| vec![word; force.len()];
            [0.0, 1.0].map(|word| observed(&model(&text), "displacement", &[("force", &force), ("branch", &branch(word))])).concat()
        };
        alike(&times(s, &yielded(1.0, 1.0)), &yielded(s, p), ROUND_OFF)?;
    }
}
