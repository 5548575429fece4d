//! The tables of a turning model.

use std::sync::Arc;

use super::base::Base;
use super::batch;
use super::cut::{Conditions, Cut};
use super::edge::Edge;
use super::heating::HeatedRods;
use super::imported::Imported;
use super::passes::{Blank, EarlierPass};
use super::program::Programs;
use super::schedule::Schedule;
use super::tolerance::Tolerance;
use crate::element::{BeamPiece, Rectangle, Round};
use crate::input::Reader;
use crate::material::Material;
use crate::process::{Making, Segment, estimates};
use crate::solve::{Foundation, Hold, Rest, Shaft};
use crate::units::{LENGTH, STIFFNESS};

/// Largest number of predicted points, rows of `profile.csv`, which take some 300 MB; beyond it a slip is more
/// likely than a wish.
const MOST_POINTS: usize = 500_000;
/// Largest number of beam elements.
const MOST_ELEMENTS: f64 = 1e6;
/// Height of the spindle axis above the guideways where a model does not say, m: a lathe that swings 500 mm.
const CENTRE_HEIGHT: f64 = 0.25;

/// How the shaft is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Workholding {
    /// Between two centres.
    Centres,
    /// In a chuck, free at the other end.
    Chuck,
    /// In a chuck, on a centre at the other end.
    ChuckAndCentre,
}

/// Whether beams shear.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BeamTheory {
    /// Shear-flexible.
    Timoshenko,
    /// Slender.
    EulerBernoulli,
}

/// Everything a turning model says but its effects. SI units.
#[derive(Clone)]
pub struct Setup {
    /// The material of the shaft.
    pub material: Material,
    /// Uniform lengths of the shaft, from the headstock.
    pub segments: Vec<Segment>,
    /// Ends of the segments, m.
    ends: Vec<f64>,
    /// Way in which it is held.
    pub workholding: Workholding,
    /// Height of the spindle axis above the guideways, m.
    pub centre_height: f64,
    /// Distance between front and rear guideway, m, if the model tells of it.
    pub guideway_spacing: Option<f64>,
    /// Springs under it.
    pub steady_rests: Vec<Rest>,
    /// What supports and tool stand on, if the model tells of it.
    pub base: Option<Arc<Base>>,
    /// Their compliance, if it was measured.
    pub imported: Option<Arc<Imported>>,
    /// Compliance of the tool holder, m/N; 0 without `[tool]`.
    pub holder_compliance: f64,
    /// Depth and force of the last pass.
    pub cut: Cut,
    /// The passes before it, in their order.
    pub passes: Vec<EarlierPass>,
    /// Error of the blank along the shaft.
    pub blank: Blank,
    /// Pass, parts, pauses.
    pub schedule: Schedule,
    /// The cutting edge, if the model tells of it.
    pub edge: Option<Edge>,
    /// What the drawing asks of every part.
    pub tolerance: Tolerance,
    /// Where its lathe program lies.
    pub programs: Programs,
    /// Positions at which the profile is predicted.
    pub positions: usize,
    /// Longest beam element that is shown, m.
    pub element_size: f64,
    /// Beam theory.
    pub beam: BeamTheory,
    /// Rods whose heating is known, kept by the model.
    pub heated: Arc<HeatedRods>,
}

impl Workholding {
    /// The words of the model file.
    pub const WORDS: &[(&'static str, Self)] =
        &[("centres", Self::Centres), ("chuck", Self::Chuck), ("chuck-and-centre", Self::ChuckAndCentre)];

    /// Whether a tailstock holds the far end.
    pub fn has_tailstock(self) -> bool {
        self != Self::Chuck
    }
}

impl Setup {
    /// Reads every table of a turning model but `[effects]`.
    pub fn read(model: &Reader) -> Self {
        let (material, segments, blank) = model.table("workpiece", "the finished shaft", |t| {
            let material = Material::read(t, "material");
            let segments = t.list("segments", "uniform lengths of the shaft, from the headstock", Segment::read);
            let blank = Blank::read(t, segments.iter().map(|s: &Segment| s.length).sum());
            (material, segments, blank)
        });
        let length: f64 = segments.iter().map(|s| s.length).sum();
        if segments.is_empty() {
            let help = "add segments = [{ length = \"300 mm\", diameter = \"50 mm\" }]";
            model.problem("workpiece", "the shaft has no segments", help);
        }
        let (workholding, centre_height, guideway_spacing, steady_rests) =
            model.table("workholding", "how the shaft is held", |t| {
                let kind = t.choice("type", "how the shaft is held", Workholding::WORDS).required(Workholding::Centres);
                let height = t.quantity("centre_height", LENGTH, "height of the spindle axis above the guideways");
                let height = height.positive().or(CENTRE_HEIGHT);
                let spacing = t.quantity("guideway_spacing", LENGTH, "distance between front and rear guideway");
                let spacing = spacing.positive().optional();
                (kind, height, spacing, t.list("steady_rests", "springs under the shaft", |t, _| read_rest(t, length)))
            });
        let base = Base::read(model, length, workholding.has_tailstock(), &steady_rests).map(Arc::new);
        let imported = Imported::read(model, workholding.has_tailstock()).map(Arc::new);
        let (element_size, beam) = read_mesh(model, length);
        let holder_compliance =
            model.optional_table("tool", "the tool holder, a cantilever", |t| read_holder(t, beam)).unwrap_or(0.0);
        let (cut, pass) = Cut::read(model, length);
        let passes = EarlierPass::read_all(model, &cut, &pass);
        let earlier: f64 = passes.iter().map(|p| p.duration((pass.to - pass.from).abs())).sum();
        let positions = model
            .optional_table("sweep", "where the profile is predicted", |t| {
                t.count("positions", "evenly spaced tool positions along the pass").between(2, 1_000_000).or(101)
            })
            .unwrap_or(101);
        let (parts, cycle_time, events) = batch::read(model, earlier + pass.duration());
        let schedule = Schedule::new(pass, earlier, (parts, cycle_time), events, &segments);
        if positions.saturating_mul(parts) > MOST_POINTS {
            let message = format!("{positions} positions on {parts} parts are more than {MOST_POINTS} points");
            model.problem("batch", message, "take fewer positions or parts");
        }
        let edge = Edge::read(model, &schedule);
        let tolerance = Tolerance::read(model, &segments);
        let programs = Programs::read(model, length);
        let ends = segments.iter().scan(0.0, |x, s| {
            *x += s.length;
            Some(*x)
        });
        Self {
            material,
            ends: ends.collect(),
            segments,
            workholding,
            centre_height,
            guideway_spacing,
            steady_rests,
            base,
            imported,
            holder_compliance,
            cut,
            passes,
            blank,
            schedule,
            edge,
            tolerance,
            programs,
            positions,
            element_size,
            beam,
            heated: model.kept(),
        }
    }

    /// How long the batch takes.
    pub fn making(&self) -> Making {
        let Schedule { pass, .. } = &self.schedule;
        let earlier: f64 = self.passes.iter().map(|own| own.duration((pass.to - pass.from).abs())).sum();
        Making { whole: self.schedule.duration(), part: earlier + pass.duration(), cycle: "batch.cycle_time" }
    }

    /// Length of the shaft, m.
    pub fn length(&self) -> f64 {
        self.ends.last().copied().unwrap_or(0.0)
    }

    /// Ends of the segments, m.
    pub fn ends(&self) -> &[f64] {
        &self.ends
    }

    /// Whether a segment ends at x (m).
    pub fn is_step(&self, x: f64) -> bool {
        self.ends.iter().any(|end| (x - end).abs() <= 1e-9 * end)
    }

    /// Number of the segment at x; on a step that of the one toward the tailstock.
    pub fn segment(&self, x: f64) -> usize {
        let number = self.ends.partition_point(|end| x >= end * (1.0 - 1e-12));
        number.min(self.segments.len().saturating_sub(1))
    }

    /// The section at x; on a step that of the segment toward the tailstock.
    pub fn section(&self, x: f64) -> Round {
        self.segments.get(self.segment(x)).map_or(Round { diameter: f64::NAN, bore: 0.0 }, |s| s.section)
    }

    /// Finished diameter at x, m.
    pub fn diameter(&self, x: f64) -> f64 {
        self.section(x).diameter
    }

    /// The finished shaft as a beam, with the given hold at the headstock.
    pub fn shaft(&self, hold: Hold) -> Shaft {
        let piece = |s: &Segment| BeamPiece {
            length: s.length,
            flexural_rigidity: self.material.youngs_modulus * s.section.inertia(),
            shear_rigidity: match self.beam {
                BeamTheory::EulerBernoulli => f64::INFINITY,
                BeamTheory::Timoshenko => {
                    s.section.shear_coefficient(self.material.poisson_ratio)
                        * self.material.shear_modulus()
                        * s.section.area()
                }
            },
        };
        Shaft {
            pieces: self.segments.iter().map(piece).collect(),
            hold,
            tailstock: self.workholding.has_tailstock(),
            rests: self.steady_rests.clone(),
        }
    }

    /// Positions at which the profile is predicted, rising, m.
    pub fn sweep(&self) -> Vec<f64> {
        let pass = self.schedule.pass;
        // Of a pass that ends at an unknown place every position is unknown.
        let (low, high) = if (pass.from + pass.to).is_nan() { (f64::NAN, f64::NAN) } else { pass.ends() };
        let last = (self.positions - 1) as f64;
        (0..self.positions).map(|i| low + (high - low) * (i as f64 / last)).collect()
    }

    /// What supports and tool stand on, with the tool at each of the positions (m); `None` where that is rigid.
    pub fn foundation(&self, positions: &[f64]) -> Option<Foundation> {
        let drawn = self.base.as_ref().map(|base| base.foundation(positions));
        let imported = self.imported.as_ref().map(|own| own.foundation(positions, self.steady_rests.len()));
        match (drawn, imported) {
            (Some(drawn), Some(imported)) => Some(drawn.on(&imported)),
            (one, other) => one.or(other),
        }
    }

    /// How the headstock holds the shaft's rotation when nothing tilts.
    pub fn hold(&self) -> Hold {
        match self.workholding {
            Workholding::Centres => Hold::Free,
            Workholding::Chuck | Workholding::ChuckAndCentre => Hold::Compliance(0.0),
        }
    }

    /// Nominal force of the cut at a place (m) and the model's own settings, N.
    pub fn nominal_force(&self, x: f64) -> f64 {
        self.cut.force.at(x, self.cut.depth, self.schedule.pass.feed)
    }

    /// Force and depth of the last pass at a place (m) and the model's own settings, where the passes before have
    /// left an error of the diameter (m).
    pub fn conditions(&self, x: f64, error: f64) -> Conditions {
        let (force, depth) = (self.nominal_force(x), self.cut.depth);
        Conditions { force, nominal: force, nominal_depth: depth, set_depth: depth + 0.5 * error }
    }
}

fn read_rest(t: &Reader, length: f64) -> Rest {
    let at = t.quantity("at", LENGTH, "distance from the headstock").positive().required();
    let stiffness = t.quantity("stiffness", STIFFNESS, "stiffness of the rest").estimated(estimates::STIFFNESS);
    let stiffness = stiffness.positive().required();
    if at > length {
        t.problem(
            "at",
            "the steady rest stands beyond the shaft",
            format!("the shaft is {} long", LENGTH.format(length)),
        );
    }
    let offset = t.quantity("offset", LENGTH, "how far it stands out of line, away from the tool");
    let offset = offset.estimated(estimates::ALIGNMENT).or(0.0);
    Rest { at, stiffness, offset }
}

/// P(l³/3EI + l/κGA) per unit force, without shear in slender beams, m/N.
fn read_holder(t: &Reader, beam: BeamTheory) -> f64 {
    let overhang = t.quantity("overhang", LENGTH, "free length of the holder").estimated(estimates::OVERHANG);
    let overhang = overhang.positive().required();
    let width = t.quantity("width", LENGTH, "width, across the force").positive().required();
    let height = t.quantity("height", LENGTH, "height, along the force").positive().required();
    let material = Material::read(t, "material");
    let section = Rectangle { width, height };
    let shear = section.shear_coefficient(material.poisson_ratio) * material.shear_modulus() * section.area();
    let bending = overhang.powi(3) / (3.0 * material.youngs_modulus * section.inertia());
    match beam {
        BeamTheory::Timoshenko => bending + overhang / shear,
        BeamTheory::EulerBernoulli => bending,
    }
}

fn read_mesh(model: &Reader, length: f64) -> (f64, BeamTheory) {
    const BEAMS: &[(&str, BeamTheory)] =
        &[("timoshenko", BeamTheory::Timoshenko), ("euler-bernoulli", BeamTheory::EulerBernoulli)];
    let mesh = model.optional_table("mesh", "the shaft as beam elements", |t| {
        let size = t.quantity("element_size", LENGTH, "longest beam element").chosen().positive().or(5e-3);
        if length / size > MOST_ELEMENTS {
            let message = format!("the shaft would have {:.1e} elements", length / size);
            t.problem("element_size", message, "beams are exact at any length: a few millimetres are enough");
        }
        (size, t.choice("beam", "whether beams shear", BEAMS).or_first(BeamTheory::Timoshenko))
    });
    mesh.unwrap_or((5e-3, BeamTheory::Timoshenko))
}
