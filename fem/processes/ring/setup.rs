//! The tables of a ring model.

use std::sync::Arc;

use super::allowed::ALLOWED;
use super::base::Base;
use super::body::{self, Body};
use super::chuck::Chuck;
use super::circle::evenly;
use super::grip::Grip;
use super::instrument::Instrument;
use super::membrane::{Grasp, Membrane};
use super::response::{Proportions, Response};
use super::tube::{Sections, Shape};
use crate::input::{Cache, Reader};
use crate::material::Material;
use crate::process::Allowed;
use crate::process::estimates::CUTTING_FORCE;
use crate::units::{ANGLE, FORCE, FORCE_PER_DEPTH, LENGTH, MICRO, SPINDLE_SPEED};

/// The circle that deviations are measured from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference {
    /// The least-squares circle of each set-up, as roundness instruments do.
    LeastSquaresCircle,
    /// The circle of the set radius about the chuck's axis.
    Absolute,
}

/// A wave of the cut surface before it is cut: amplitude·cos lobes·(θ − phase).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lobe {
    /// Waves around.
    pub lobes: usize,
    /// Half of peak to valley, m.
    pub amplitude: f64,
    /// Angle of a crest, rad.
    pub phase: f64,
}

/// Everything a ring model says but its effects. SI units.
#[derive(Clone, Debug)]
pub struct Setup {
    /// Material of the ring.
    pub material: Material,
    /// Ro, m.
    pub outer_radius: f64,
    /// Ri, m.
    pub inner_radius: f64,
    /// b, m.
    pub width: f64,
    /// The cut surface before it is cut in the model's own programme; measured rows have their own.
    pub blank: Vec<Lobe>,
    /// Side by which the jaws hold it.
    pub grip: Grip,
    /// Angles at which the jaws stand, rad; evenly spaced from 0 unless a mesh says otherwise.
    pub jaw_angles: Vec<f64>,
    /// Full angle over which each jaw presses, rad; 0 for a line load.
    pub arc: f64,
    /// Force of each jaw at standstill, N.
    pub jaw_force: f64,
    /// Where the jaws press along the ring, from its face at the chuck, m; all along it where this is not said.
    pub reach: Option<[f64; 2]>,
    /// Section in which the cut surface is predicted, from that face, m.
    pub section: f64,
    /// How a membrane makes it, if one does.
    pub grasp: Option<Grasp>,
    /// Friction between jaws and ring.
    pub friction: Option<f64>,
    /// By how much the friction of the jaws is to hold more than the cut asks for.
    pub margin: f64,
    /// Force of the cut along the turning, N.
    pub cutting_force: Option<f64>,
    /// Spindle speed while cutting, rad/s.
    pub spindle_speed: Option<f64>,
    /// C, the radial force per depth of cut, N/m.
    pub force_per_depth: Option<f64>,
    /// The machine around the ring, where it is drawn.
    pub base: Option<Base>,
    /// Elements.
    pub body: Body,
    /// Rings of equal cells that were solved for this model, at any values of what it does not know.
    pub responses: Arc<Cache<Proportions, Response, 16>>,
    /// Rings that jaws press on a part of their width, in the same way.
    pub sections: Arc<Cache<Shape, Sections, 16>>,
    /// Circle that deviations are measured from.
    pub reference: Reference,
    /// Filter and gauge.
    pub instrument: Instrument,
    /// What the drawing allows.
    pub allowed: Allowed,
    /// Evenly spaced angles at which the cut surface is predicted.
    pub points: usize,
}

impl Reference {
    /// The words of the model file, the default first.
    pub const WORDS: &[(&'static str, Self)] =
        &[("least-squares-circle", Self::LeastSquaresCircle), ("absolute", Self::Absolute)];
}

impl Setup {
    /// Reads every table of a ring model but `[effects]`.
    pub fn read(model: &Reader) -> Self {
        let is_drawn = model.has_in("mesh", "file");
        let (material, radii, width, blank) = model.table("workpiece", "the ring", |t| {
            let material = Material::read(t, "material");
            let radii = read_radii(t, is_drawn);
            let width = t.quantity("width", LENGTH, "width of the ring, along its axis").positive().required();
            let blank = t.list("blank", "waves of the surface before it is cut, which copying copies", |t, _| Lobe {
                lobes: t.count("lobes", "waves around").between(2, 1000).required(),
                amplitude: t.quantity("amplitude", MICRO, "half of peak to valley").required(),
                phase: t.quantity("phase", ANGLE, "where a crest stands").or(0.0),
            });
            (material, radii, width, blank)
        });
        let about = "the chuck that holds the ring by its outside, or by its bore";
        let Chuck { grip, jaws, jaw_force, reach, membrane, friction, margin } =
            model.table("chuck", about, |t| Chuck::read(t, is_drawn, width));
        let cut = model.optional_table("cut", "how the ring is cut", |t| {
            let speed = t.quantity("spindle_speed", SPINDLE_SPEED, "spindle speed while it is cut").not_negative();
            let force = t.quantity("force_per_depth", FORCE_PER_DEPTH, "radial force of the cut per depth of cut");
            let along = t.quantity("cutting_force", FORCE, "force of the cut along the turning, which the jaws hold");
            let mean = t.quantity(
                "radial_force",
                FORCE,
                "mean radial force of the cut, if a joint of the machine is no spring",
            );
            (
                speed.optional(),
                force.estimated(CUTTING_FORCE).positive().optional(),
                along.estimated(CUTTING_FORCE).positive().optional(),
                mean.estimated(CUTTING_FORCE).positive().optional(),
            )
        });
        let (spindle_speed, force_per_depth, cutting_force, radial_force) = cut.unwrap_or_default();
        let base = Base::read(model, radial_force);
        if base.is_some() && force_per_depth.is_none() {
            let help =
                "add force_per_depth = \"1 kN/mm\" to [cut]: it is by the force of the cut that a machine gives way";
            model.problem("structure", "the machine is drawn, and the force of the cut is not said", help);
        }
        let body = body::read(model, jaws, radii);
        let (reference, instrument, points, section) = read_measurement(model, grip, width);
        let allowed = model
            .optional_table("tolerance", "what the drawing asks of the cut surface", |t| Allowed::read(t, &ALLOWED))
            .unwrap_or_default();
        let ([outer_radius, inner_radius], jaw_angles, arc) = match &body {
            Body::Cells(_) => (radii.map(Option::unwrap_or_default), evenly(jaws), 0.0),
            Body::Drawn(drawn) => ([drawn.outer_radius, drawn.inner_radius], drawn.jaws.clone(), drawn.arc),
        };
        let setup = Self {
            material,
            outer_radius,
            inner_radius,
            width,
            blank,
            grip,
            jaw_angles,
            arc,
            jaw_force,
            reach,
            section,
            grasp: None,
            friction,
            margin,
            cutting_force,
            spindle_speed,
            force_per_depth,
            base,
            body,
            responses: model.kept(),
            sections: model.kept(),
            reference,
            instrument,
            allowed,
            points,
        };
        match membrane {
            Some(membrane) => setup.grasped(membrane, model),
            None => setup,
        }
    }

    /// The ring in a membrane chuck.
    fn grasped(mut self, membrane: Membrane, model: &Reader) -> Self {
        self.arc = membrane.pad / self.held_radius();
        let Body::Cells(mesh) = self.body else { return self };
        if model.is_described() || !model.is_sound() {
            return self;
        }
        let ratio = self.inner_radius / self.outer_radius;
        let ring = Proportions { ratio, poisson_ratio: self.material.poisson_ratio, mesh, step: self.jaw_angles.len() };
        let known = model.kept::<Cache<(Proportions, Grip, f64), f64, 16>>();
        let unit = known.get_or((ring, self.grip, self.arc), |(ring, grip, arc)| Response::yielding(ring, *grip, *arc));
        let ring = unit.map_or(f64::NAN, |unit| *unit / (self.material.youngs_modulus * self.width));
        let grasp = Grasp::new(membrane, ring);
        self.jaw_force = grasp.force();
        self.grasp = Some(grasp);
        self
    }

    /// Radius of the surface that is cut, m.
    pub fn cut_radius(&self) -> f64 {
        match self.grip {
            Grip::Outside => self.inner_radius,
            Grip::Inside => self.outer_radius,
        }
    }

    /// Radius at which the jaws press, m.
    pub fn held_radius(&self) -> f64 {
        match self.grip {
            Grip::Outside => self.outer_radius,
            Grip::Inside => self.inner_radius,
        }
    }

    /// Name of the surface that is cut.
    pub fn cut_name(&self) -> &'static str {
        match self.grip {
            Grip::Outside => "bore",
            Grip::Inside => "outside",
        }
    }

    /// Spindle speed while cutting, rad/s; 0 where the model says none.
    pub fn speed(&self) -> f64 {
        self.spindle_speed.unwrap_or(0.0)
    }

    /// Radial deviation of the model's own ring before it is cut, m.
    pub fn blank_at(&self, angle: f64) -> f64 {
        self.blank.iter().map(|l| l.amplitude * (l.lobes as f64 * (angle - l.phase)).cos()).sum()
    }
}

/// Outer and inner radius, m; a mesh from a file has its own.
fn read_radii(t: &Reader, is_drawn: bool) -> [Option<f64>; 2] {
    let read = |key, about| {
        let field = t.quantity(key, LENGTH, about).positive();
        match is_drawn || t.is_described() {
            true => field.optional(),
            false => Some(field.required()),
        }
    };
    let outer = read("outer_diameter", "outer diameter; a mesh from a file has its own");
    let inner = read("inner_diameter", "diameter of the bore; a mesh from a file has its own");
    if let (Some(outer), Some(inner)) = (outer, inner)
        && inner >= outer
    {
        let help = format!("it must be below the outer diameter of {}", LENGTH.format(outer));
        t.problem("inner_diameter", "the bore is as wide as the ring", help);
    }
    for key in ["outer_diameter", "inner_diameter"] {
        if is_drawn && t.is_uncertain(key) {
            t.problem(key, "the mesh from a file has this diameter for certain", "leave it out, or the file");
        }
    }
    [outer, inner].map(|diameter| diameter.map(|d| 0.5 * d))
}

fn read_measurement(model: &Reader, grip: Grip, width: f64) -> (Reference, Instrument, usize, f64) {
    let usual = (Reference::LeastSquaresCircle, Instrument::default(), 360, 0.5 * width);
    let read = |t: &Reader| {
        let about = "what deviations are measured from";
        let reference = t.choice("reference", about, Reference::WORDS).or_first(usual.0);
        (
            reference,
            Instrument::read(t, grip),
            t.count("points", "evenly spaced angles at which the cut surface is predicted")
                .between(8, 100_000)
                .or(usual.2),
            read_section(t, width),
        )
    };
    model.optional_table("measurement", "how the cut surface is measured", read).unwrap_or(usual)
}

/// Reads the section in which a ring of some width (m) is measured.
fn read_section(t: &Reader, width: f64) -> f64 {
    let about = "section that is predicted, from the ring's face at the chuck; the middle if left out";
    let at = t.quantity("at", LENGTH, about).not_negative().or(0.5 * width);
    if at > width {
        let [at, width] = [at, width].map(|length| LENGTH.format(length));
        let help = "lengths along the ring are from its face at the chuck";
        t.problem("at", format!("the section lies at {at}, and the ring is {width} wide"), help);
    }
    at
}
