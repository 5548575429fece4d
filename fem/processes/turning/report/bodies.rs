//! The shaft, what holds it and the tool as bodies.

use super::super::setup::{Setup, Workholding};
use crate::process::{Body, Ends, Role, Skin};

/// Rims along the shaft, at most; more than a picture needs.
const MOST_RIMS: usize = 32;
/// Along the shaft, along the tool.
const X: [f64; 3] = [1.0, 0.0, 0.0];
const DOWN: [f64; 3] = [0.0, -1.0, 0.0];

/// Everything that is drawn; points of the grid are the nodes of the shaft, its supports in their order, the nose.
pub struct Bodies {
    /// All but the tool.
    held: Vec<Body>,
    /// Largest diameter, m.
    diameter: f64,
}

impl Bodies {
    /// The bodies of a shaft with its nodes (m).
    pub fn new(setup: &Setup, nodes: &[f64]) -> Self {
        let diameter = setup.segments.iter().map(|s| s.section.diameter).fold(0.0, f64::max);
        let mut held = vec![Body::new("shaft", Role::Work, Skin::stepped(nodes, &setup.segments, MOST_RIMS))];
        let mut node = nodes.len() as u32;
        let mut add = |name, skin: fn(u32, f64) -> Skin, diameter: f64| {
            held.push(Body::new(name, Role::Machine, skin(node, diameter)));
            node += 1;
        };
        match setup.workholding {
            Workholding::Centres => add("headstock centre", |node, d| centre(node, d, -1.0), setup.diameter(0.0)),
            Workholding::Chuck | Workholding::ChuckAndCentre => add("chuck", chuck, diameter),
        }
        if setup.workholding.has_tailstock() {
            add("tailstock centre", |node, d| centre(node, d, 1.0), setup.diameter(setup.length()));
        }
        for rest in &setup.steady_rests {
            add("steady rest", steady_rest, setup.diameter(rest.at));
        }
        Self { held, diameter }
    }

    /// All of them, with the nose of the tool at a point of the grid.
    pub fn at(&self, nose: usize) -> Vec<Body> {
        let half = 0.5 * self.tool_width();
        let meridian = [(0.0, 0.05 * half), (2.0 * half, half), (8.0 * half, half)];
        let tool = Skin::square(Some(nose as u32), [0.0; 3], DOWN, &meridian);
        self.held.iter().cloned().chain([Body::new("tool", Role::Tool, tool)]).collect()
    }

    /// Width of the tool as it is drawn, m.
    pub fn tool_width(&self) -> f64 {
        0.3 * self.diameter
    }
}

/// A centre in an end of a shaft of such a diameter (m), on its side of the shaft: −1 at the headstock.
fn centre(node: u32, diameter: f64, side: f64) -> Skin {
    let r = 0.5 * diameter;
    Skin::turned(Some(node), [0.0; 3], [side, 0.0, 0.0], &[(0.0, 0.25 * r), (0.9 * r, 0.75 * r), (2.2 * r, 0.75 * r)])
}

/// A chuck behind the end of the shaft.
fn chuck(node: u32, diameter: f64) -> Skin {
    let r = 0.5 * diameter;
    let meridian = [(0.0, 1.25 * r), (0.5 * r, 1.25 * r), (0.5 * r, 2.1 * r), (1.8 * r, 2.1 * r)];
    Skin::turned(Some(node), [0.0; 3], [-1.0, 0.0, 0.0], &meridian)
}

/// A ring around the shaft.
fn steady_rest(node: u32, diameter: f64) -> Skin {
    let (inner, outer, half) = (0.515 * diameter, 0.8 * diameter, 0.14 * diameter);
    let rim = |x: f64, radius: f64| (Some(node), [x, 0.0, 0.0], radius);
    Skin::round(&[rim(-half, outer), rim(half, outer), rim(half, inner), rim(-half, inner)], X, Ends::Joined)
}
