//! The heated rod, its base, and what heats as bodies.

use super::super::body::Body as Shape;
use super::super::boundary::Condition;
use super::super::setup::Setup;
use crate::process::{Body, Ends, Role, Segment, Skin};
use crate::solve::rod::PointSource;

/// Rims along a rod, at most; more than a picture needs.
const MOST_RIMS: usize = 40;
const X: [f64; 3] = [1.0, 0.0, 0.0];
const UP: [f64; 3] = [0.0, 1.0, 0.0];
const FRONT: [f64; 3] = [0.0, 0.0, 1.0];

/// A rod of segments with nodes along it (m), to scale.
pub fn rod(x: &[f64], segments: &[Segment]) -> Skin {
    Skin::stepped(x, segments, MOST_RIMS)
}

/// Surroundings of the body at a time (s): the base of a rod, heaters while they heat, a strip of heat that passes over
/// the top of a plate.
pub fn around(setup: &Setup, time: f64, nodes: &[[f64; 3]]) -> Vec<Body> {
    match &setup.body {
        Shape::Rod(segments) => {
            let widest = segments.iter().map(|s| s.section.diameter).fold(0.0, f64::max);
            let base = Skin::block(None, [-0.25 * widest, 0.0, 0.0], [0.25 * widest, 1.1 * widest, 1.1 * widest]);
            let mut bodies = vec![Body::new("base", Role::Machine, base)];
            for source in &setup.sources {
                let node = (0..nodes.len())
                    .min_by(|a, b| (nodes[*a][0] - source.at).abs().total_cmp(&(nodes[*b][0] - source.at).abs()));
                let [inner, outer, half] = [0.52, 0.68, 0.12].map(|part| part * widest);
                let rim = |x: f64, radius: f64| (node.map(|n| n as u32), [x, 0.0, 0.0], radius);
                let rims = [rim(-half, outer), rim(half, outer), rim(half, inner), rim(-half, inner)];
                let (name, role) = heater(source, time);
                bodies.push(Body::new(name, role, Skin::round(&rims, X, Ends::Joined)));
            }
            bodies
        }
        Shape::Plane(plane) if plane.thickness.is_revolved() => Vec::new(),
        Shape::Plane(plane) => {
            let ([left, right], [low, high]) = (plane.extent(0), plane.extent(1));
            let (middle, half) = (0.5 * plane.shown_thickness(), 0.55 * plane.shown_thickness());
            let strips = setup.boundaries.iter().filter_map(|boundary| match boundary.condition {
                Condition::Moving { speed, from, .. } if boundary.edge == "top" => Some(from + speed * time),
                _ => None,
            });
            let radius = 0.9 * (high - low);
            let wheel = |x: f64| {
                let from = [x, high + 1.02 * radius, -half];
                Body::new("wheel", Role::Tool, Skin::turned(None, from, FRONT, &[(0.0, radius), (2.0 * half, radius)]))
            };
            let on = |x: &f64| (left - radius..=right + radius).contains(x);
            let mut bodies: Vec<Body> = strips.filter(on).map(wheel).collect();
            for source in &setup.sources {
                let (name, role) = heater(source, time);
                let size = 0.15 * (high - low);
                let skin =
                    Skin::turned(None, [source.at, high, middle], UP, &[(0.02 * size, size), (2.0 * size, size)]);
                bodies.push(Body::new(name, role, skin));
            }
            bodies
        }
    }
}

/// Name and role of a heater at a time (s).
fn heater(source: &PointSource, time: f64) -> (&'static str, Role) {
    match source.power.within(time, [time; 2]) != 0.0 {
        true => ("heater, on", Role::Tool),
        false => ("heater, off", Role::Machine),
    }
}
