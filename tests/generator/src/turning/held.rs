//! The shaft on its supports under a tool at one place, by the force method: reactions are the unknowns, and
//! the beam that they bend is a cantilever from x = 0 whose compliances are unit-load integrals.
//!
//! ```text
//!   w(s) = y0 + θ0·s + P·G(s, x) − Σ q_i·G(s, x_i)      away from the tool
//!   w(x_i) = u_i + q_i/k_i      Σ q_i = P               q_i presses towards the tool
//!   P·x − Σ q_i·x_i = M0,       M0 = 0 at a pin, θ0 = M0/tilt at a clamp
//! ```
//!
//! u_i is what a support is moved away from the tool: out of line, warmed, or sunk in its contact.

use super::shaft::Shaft;
use crate::dense::{root, solve};

/// Something that holds the shaft at a place; both ways.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Support {
    /// From the headstock, mm.
    pub at: f64,
    /// Of all springs under it, um/N.
    pub compliance: f64,
    /// c (um/N^n) and n of the contact under it, which presses only.
    pub contact: Option<(f64, f64)>,
}

/// How the shaft is held at x = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Root {
    /// By a pin.
    Pin,
    /// By a clamp that tilts by so much, 1e3 rad/(N mm); 0 where it does not.
    Clamp(f64),
}

/// What shaft and springs answer, contacts not counted.
#[derive(Debug, Clone, PartialEq)]
pub struct Held {
    supports: Vec<Support>,
    /// Of each support under one newton at the tool, N/N.
    borne: Vec<f64>,
    /// Reaction of support i that moving support j takes away, N/um.
    stiffness: Vec<Vec<f64>>,
    /// At the tool under one newton there, um/N.
    here: f64,
    /// At the tool when a support is moved by one, um/um.
    carried: Vec<f64>,
}

impl Held {
    /// The shaft under a tool at `x`; the first support is at x = 0.
    pub fn new(shaft: &Shaft, root: Root, supports: &[Support], x: f64) -> Self {
        let at = |i: usize| supports[i].at;
        let count = supports.len();
        let bends: Vec<Vec<f64>> =
            (0..count).map(|i| (0..count).map(|j| shaft.cantilever(at(j), at(i))).collect()).collect();
        let by_tool: Vec<f64> = (0..count).map(|i| shaft.cantilever(x, at(i))).collect();
        let own = shaft.cantilever(x, x);
        // Unknown are the reactions, then y0 and θ0.
        let mut matrix = vec![vec![0.0; count + 2]; count + 2];
        for (i, support) in supports.iter().enumerate() {
            for j in 0..count {
                matrix[i][j] = -bends[i][j];
            }
            matrix[i][i] -= support.compliance;
            matrix[i][count] = 1.0;
            matrix[i][count + 1] = at(i);
            matrix[count][i] = 1.0;
            matrix[count + 1][i] = at(i);
        }
        if let Root::Clamp(tilt) = root {
            matrix[count + 1][..count].iter_mut().for_each(|arm| *arm *= tilt);
            matrix[count + 1][count + 1] = 1.0;
        }
        let lever = if let Root::Clamp(tilt) = root { tilt * x } else { x };
        let answer = |force: f64, moved: Option<usize>| {
            let mut right: Vec<f64> = by_tool.iter().map(|bend| -force * bend).collect();
            if let Some(support) = moved {
                right[support] += 1.0;
            }
            right.extend([force, force * lever]);
            let found = solve(matrix.clone(), right);
            let bent: f64 = (0..count).map(|i| found[i] * by_tool[i]).sum();
            let at_tool = found[count] + found[count + 1] * x + force * own - bent;
            (found[..count].to_vec(), at_tool)
        };
        let (borne, here) = answer(1.0, None);
        let moved: Vec<(Vec<f64>, f64)> = (0..count).map(|j| answer(0.0, Some(j))).collect();
        let stiffness = (0..count).map(|i| moved.iter().map(|(q, _)| -q[i]).collect()).collect();
        let carried = moved.iter().map(|(_, w)| *w).collect();
        Self { supports: supports.to_vec(), borne, stiffness, here, carried }
    }

    /// How far the shaft goes away from the tool that presses with `force`, its supports moved by `imposed`,
    /// um.
    pub fn goes(&self, force: f64, imposed: &[f64]) -> f64 {
        self.goes_held_back(force, imposed, &vec![0.0; self.supports.len()])
    }

    /// The same where friction bears so much of the reaction of each support beside its joint, N.
    fn goes_held_back(&self, force: f64, imposed: &[f64], friction: &[f64]) -> f64 {
        let imposed = &self.sprung(imposed, friction)[..];
        let sunk = self.sunk(force, imposed, friction);
        let moved: f64 = self.carried.iter().zip(imposed).zip(&sunk).map(|((c, u), d)| c * (u + d)).sum();
        force * self.here + moved
    }

    /// Reactions towards the tool, N.
    pub fn reactions(&self, force: f64, imposed: &[f64]) -> Vec<f64> {
        let none = vec![0.0; self.supports.len()];
        self.borne_at(force, imposed, &self.sunk(force, imposed, &none))
    }

    /// How far the shaft goes away under a force where each support rubs with up to `most` (N) and its joint bore `borne`
    /// (N) before; and what the joints bear then.
    ///
    /// Friction bears what keeps a joint as it is, as far as it can: the first that rubs is looked for along its friction,
    /// the others at rest for it.
    pub fn rubs(&self, force: f64, imposed: &[f64], most: &[f64], borne: &[f64]) -> (f64, Vec<f64>) {
        let mut friction = vec![0.0; self.supports.len()];
        let rubbing: Vec<usize> = (0..friction.len()).filter(|i| most[*i] > 0.0).collect();
        self.hold_back(&rubbing, force, imposed, (most, borne), &mut friction);
        (self.goes_held_back(force, imposed, &friction), self.joints(force, imposed, &friction))
    }

    fn hold_back(
        &self,
        rubbing: &[usize],
        force: f64,
        imposed: &[f64],
        (most, borne): (&[f64], &[f64]),
        friction: &mut [f64],
    ) {
        let Some((&first, others)) = rubbing.split_first() else { return };
        // What the joint would bear beyond what it bore: the more friction, the less.
        let beyond = |held: f64, friction: &mut [f64]| {
            friction[first] = held;
            self.hold_back(others, force, imposed, (most, borne), friction);
            self.joints(force, imposed, friction)[first] - borne[first]
        };
        let most = most[first];
        let held = if beyond(most, friction) > 0.0 {
            most
        } else if beyond(-most, friction) < 0.0 {
            -most
        } else {
            root(-most, most, |held| -beyond(held, &mut friction.to_vec()))
        };
        beyond(held, friction);
    }

    /// What the joints bear, N.
    fn joints(&self, force: f64, imposed: &[f64], friction: &[f64]) -> Vec<f64> {
        let imposed = &self.sprung(imposed, friction)[..];
        let all = self.borne_at(force, imposed, &self.sunk(force, imposed, friction));
        all.iter().zip(friction).map(|(q, held)| q - held).collect()
    }

    /// The springs are in the shaft's answer with the whole reaction: friction takes its part back.
    fn sprung(&self, imposed: &[f64], friction: &[f64]) -> Vec<f64> {
        let all = imposed.iter().zip(friction).zip(&self.supports);
        all.map(|((moved, held), support)| moved - held * support.compliance).collect()
    }

    fn borne_at(&self, force: f64, imposed: &[f64], sunk: &[f64]) -> Vec<f64> {
        let taken = |row: &[f64]| -> f64 { row.iter().zip(imposed).zip(sunk).map(|((k, u), d)| k * (u + d)).sum() };
        self.borne.iter().zip(&self.stiffness).map(|(a, row)| force * a - taken(row)).collect()
    }

    /// How far each support sinks in its contact: the first contact is looked for along its reaction with the
    /// others at rest for it, one inside the other.
    fn sunk(&self, force: f64, imposed: &[f64], friction: &[f64]) -> Vec<f64> {
        let mut sunk = vec![0.0; self.supports.len()];
        let contacts: Vec<usize> =
            (0..sunk.len()).filter(|i| self.supports[*i].contact.is_some_and(|(c, _)| c > 0.0)).collect();
        self.settle(&contacts, force, (imposed, friction), &mut sunk);
        sunk
    }

    fn settle(&self, contacts: &[usize], force: f64, (imposed, friction): (&[f64], &[f64]), sunk: &mut [f64]) {
        let Some((&first, others)) = contacts.split_first() else { return };
        let Some((c, n)) = self.supports[first].contact else { return };
        let sinks = |q: f64| if q > 0.0 { c * q.powf(n) } else { 0.0 };
        // What the contact bears once it has sunk under `q`; the more it sinks the less.
        let bears = |q: f64, sunk: &mut [f64]| {
            sunk[first] = sinks(q);
            self.settle(others, force, (imposed, friction), sunk);
            self.borne_at(force, imposed, sunk)[first] - friction[first]
        };
        let most = bears(0.0, sunk);
        if most > 0.0 {
            let q = root(0.0, most, |q| q - bears(q, &mut sunk.to_vec()));
            bears(q, sunk);
        }
    }
}
