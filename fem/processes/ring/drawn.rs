//! A ring whose mesh was drawn: any plane body with a round bore, which jaws hold on a circle about the
//! bore's centre. Keyways, flats and holes are in the mesh.
//!
//! The sides `bore` are bored; `jaw-1`, `jaw-2` … are where the jaws press, counter-clockwise: sides, over
//! which the force is spread evenly, or points, which are line loads. The bore's centre is the origin, and
//! the mesh is turned so that jaw 1 stands at 0°. A jaw may be moved and spread to wherever the border is on
//! the jaws' circle; its load is integrated exactly at any angle. The body floats: after the jaws have
//! closed its bore is where its own first harmonic is zero.

use std::f64::consts::TAU;
use std::sync::Arc;

use super::circle::evenly;
use super::jaws::Jaw;
use super::response::unsolvable;
use crate::element::plane::{Elasticity, PlaneState};
use crate::input::Cache;
use crate::mesh::{BORE, Mesh, Side};
use crate::process::Failure;
use crate::solve::elastic::{ElasticSystem, Loads};
use crate::solve::ring::{Bore, BoreShape, JawCircle};
use crate::units::{ANGLE, LENGTH};

/// Nodes are on a circle that differ in radius by less than this part of it: coordinates may be rounded.
const ROUND: f64 = 1e-5;
/// Arcs of jaws are alike, and jaws evenly spaced, that differ by less (rad).
const ALIKE: f64 = 1e-4;

/// A mesh as it was read, and the number of jaws in which it is held.
#[derive(Clone, Debug)]
pub struct Held {
    /// The mesh of the file, lengths in m.
    pub mesh: Arc<Mesh>,
    /// Number of jaws.
    pub jaws: usize,
}

/// Equal are those of the same reading; numbers are not compared.
impl PartialEq for Held {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.mesh, &other.mesh) && self.jaws == other.jaws
    }
}

/// A drawn ring, checked and ready to be solved.
#[derive(Debug)]
pub struct Drawn {
    /// The mesh, turned so that jaw 1 stands at 0; lengths in m.
    pub mesh: Arc<Mesh>,
    /// Radius of the jaws' circle, m.
    pub outer_radius: f64,
    /// Radius of the bore, m.
    pub inner_radius: f64,
    /// Angles at which the jaws stand, rad.
    pub jaws: Vec<f64>,
    /// Full angle over which each presses, rad; 0 where they are drawn as points.
    pub arc: f64,
    bore: Bore,
    circle: JawCircle,
    /// Factors by Poisson's ratio, with E = b = 1. One is enough: only a fit of that ratio asks for another.
    systems: Cache<f64, Body, 1>,
    /// Shapes of the bore by Poisson's ratio and jaws.
    shapes: Cache<(f64, Vec<Jaw>), BoreShape, 64>,
}

/// The factored stiffness.
type Body = ElasticSystem<Arc<Mesh>>;

/// A jaw as the mesh has it: the middle and the full angle of its contact, rad.
#[derive(Clone, Copy, Debug)]
struct Seat {
    angle: f64,
    arc: f64,
}

impl Drawn {
    /// The ring with this mesh, held by so many jaws.
    ///
    /// # Errors
    /// The mesh is no ring in such a chuck, and why.
    pub fn new(mesh: &Mesh, jaws: usize) -> Result<Self, String> {
        let inner_radius = bore_radius(mesh)?;
        let outer_radius = jaw_radius(mesh, jaws)?;
        let seats: Vec<Seat> = (1..=jaws).map(|jaw| seat(mesh, jaw)).collect::<Result<_, _>>()?;
        let arc = seats[0].arc;
        if let Some(k) = seats.iter().position(|seat| (seat.arc - arc).abs() > ALIKE) {
            let (own, first) = (ANGLE.shown(seats[k].arc), ANGLE.shown(arc));
            return Err(format!("`jaw-{}` presses over {own:.2} and `jaw-1` over {first:.2}", k + 1));
        }
        let jaws = angles(&seats)?;
        let mesh = Arc::new(mesh.clone().turned(-seats[0].angle));
        let bore = Bore::new(&mesh).map_err(|error| error.to_string())?;
        let on_circle: Vec<Side> =
            mesh.boundary().into_iter().filter(|side| is_on(&mesh, *side, outer_radius)).collect();
        let circle = JawCircle::new(&mesh, &on_circle);
        let (systems, shapes) = Default::default();
        Ok(Self { mesh, outer_radius, inner_radius, jaws, arc, bore, circle, systems, shapes })
    }

    /// Adds the forces of jaws, `force` being that of an even share, N.
    ///
    /// # Errors
    /// A jaw stands or reaches beyond the circle that the mesh has.
    pub fn press(&self, loads: &mut Loads, jaws: &[Jaw], force: f64) -> Result<(), Failure> {
        for (k, jaw) in jaws.iter().enumerate() {
            let load = jaw.load(force);
            if !self.circle.carries(&load) {
                let (at, over) = (ANGLE.shown(jaw.angle), ANGLE.shown(jaw.arc));
                return Err(Failure {
                    message: format!("jaw {} at {at:.2} over {over:.2} is not on the circle of the mesh", k + 1),
                    help: "move the jaw to where the border is round, or draw more of the circle".into(),
                });
            }
            self.circle.press(loads, &load).map_err(unsolvable)?;
        }
        Ok(())
    }

    /// The bore under jaws of one newton on a body with E = b = 1.
    ///
    /// # Errors
    /// A jaw is off the body, or its equations cannot be solved.
    pub fn bore_under(&self, poisson_ratio: f64, jaws: &[Jaw]) -> Result<Arc<BoreShape>, Failure> {
        self.shapes.get_or((poisson_ratio, jaws.to_vec()), |_| {
            let mut loads = Loads::none(&self.mesh);
            self.press(&mut loads, jaws, 1.0)?;
            let system = self.systems.get_or(poisson_ratio, |_| {
                let law = Elasticity::new(PlaneState::Stress, 1.0, poisson_ratio, 0.0, 1.0).map_err(unsolvable)?;
                ElasticSystem::free(self.mesh.clone(), law).map_err(unsolvable)
            })?;
            Ok(self.bore.shape(&system.solve(&loads).map_err(unsolvable)?.nodes))
        })
    }
}

/// Whether all nodes of a side are at `radius` from the origin.
fn is_on(mesh: &Mesh, side: Side, radius: f64) -> bool {
    mesh.side_nodes(side).as_slice().iter().all(|&node| (from_origin(mesh, node) / radius - 1.0).abs() < ROUND)
}

fn from_origin(mesh: &Mesh, node: u32) -> f64 {
    let [x, y] = mesh.nodes()[node as usize];
    x.hypot(y)
}

/// The radius (m) on which all these nodes lie.
fn common_radius(mesh: &Mesh, nodes: &[u32], name: &str) -> Result<f64, String> {
    let radii: Vec<f64> = nodes.iter().map(|&node| from_origin(mesh, node)).collect();
    // The middle one: a node out of place does not move it.
    let mut sorted = radii.clone();
    sorted.sort_unstable_by(f64::total_cmp);
    let radius = sorted[sorted.len() / 2];
    let Some(i) = radii.iter().position(|r| (r / radius - 1.0).abs() >= ROUND) else { return Ok(radius) };
    let [x, y] = mesh.nodes()[nodes[i] as usize].map(|x| LENGTH.from_si(x));
    let (own, radius) = (LENGTH.shown(radii[i]), LENGTH.shown(radius));
    Err(format!(
        "{name} is no circle about the origin: its node at ({x:.4}, {y:.4}) mm has a radius of {own:.4}, \
         not {radius:.4}"
    ))
}

fn bore_radius(mesh: &Mesh) -> Result<f64, String> {
    let nodes = mesh.nodes_on(BORE).map_err(|error| error.to_string())?;
    let radius = common_radius(mesh, &nodes, "`bore`")?;
    let covered =
        mesh.sides(BORE).map_or(0.0, |sides| sides.iter().map(|&side| mesh.curve(side).length()).sum::<f64>());
    // Straight sides are chords, shorter than their arcs by a hundredth at most where eight go around.
    let around = covered / radius;
    match (0.95..1.05).contains(&(around / TAU)) {
        true => Ok(radius),
        false => Err(format!("`bore` covers {:.0} of its circle and not all of it", ANGLE.shown(around))),
    }
}

/// Nodes of a jaw, by sides or by points.
fn jaw_nodes(mesh: &Mesh, jaw: usize) -> Result<Vec<u32>, String> {
    let name = format!("jaw-{jaw}");
    let points = mesh.points(&name);
    match mesh.nodes_on(&name) {
        Ok(nodes) if points.is_empty() => Ok(nodes),
        Ok(_) => Err(format!("`{name}` is drawn twice, as sides and as points")),
        Err(_) if points.len() == 1 => Ok(points.to_vec()),
        Err(_) if points.len() > 1 => Err(format!("`{name}` is {} points: one jaw is one point", points.len())),
        Err(_) => {
            let known: Vec<&str> = mesh.names().chain(mesh.point_names()).collect();
            Err(format!("there is no physical group `{name}`; there are {}", known.join(", ")))
        }
    }
}

fn jaw_radius(mesh: &Mesh, jaws: usize) -> Result<f64, String> {
    let nodes: Vec<Vec<u32>> = (1..=jaws).map(|jaw| jaw_nodes(mesh, jaw)).collect::<Result<_, _>>()?;
    if jaw_nodes(mesh, jaws + 1).is_ok() {
        return Err(format!("there is a physical group `jaw-{}`, and the chuck has {jaws} jaws", jaws + 1));
    }
    common_radius(mesh, &nodes.concat(), "what the jaws press on")
}

fn seat(mesh: &Mesh, jaw: usize) -> Result<Seat, String> {
    let name = format!("jaw-{jaw}");
    let angle_of = |node: u32| {
        let [x, y] = mesh.nodes()[node as usize];
        y.atan2(x)
    };
    let Ok(sides) = mesh.sides(&name) else {
        let point = mesh.points(&name).first();
        return Ok(Seat { angle: point.map_or(0.0, |&node| angle_of(node)), arc: 0.0 });
    };
    // Angles from the first node; a jaw covers less than half of the circle.
    let first = mesh.side_nodes(sides[0]).as_slice()[0];
    let from = |node: u32| (angle_of(node) - angle_of(first) + 1.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
    let (mut low, mut high, mut covered) = (0.0f64, 0.0f64, 0.0);
    for &side in sides {
        let nodes = mesh.side_nodes(side);
        let ends = [nodes.as_slice()[0], nodes.as_slice()[1]].map(from);
        (low, high) = (low.min(ends[0]).min(ends[1]), high.max(ends[0]).max(ends[1]));
        covered += (ends[1] - ends[0]).abs();
    }
    match (covered - (high - low)).abs() < ALIKE {
        true => Ok(Seat { angle: angle_of(first) + 0.5 * (low + high), arc: high - low }),
        false => Err(format!(
            "`{name}` is not one arc: it covers {:.2} of {:.2}",
            ANGLE.from_si(covered),
            ANGLE.shown(high - low)
        )),
    }
}

/// Angles of the jaws from jaw 1 (rad): three wherever they can press in equilibrium, others evenly.
fn angles(seats: &[Seat]) -> Result<Vec<f64>, String> {
    let angles: Vec<f64> =
        seats.iter().map(|seat| (seat.angle - seats[0].angle + ALIKE).rem_euclid(TAU) - ALIKE).collect();
    let even = evenly(seats.len());
    if angles.iter().zip(&even).all(|(angle, even)| (angle - even).abs() < ALIKE) {
        return Ok(even);
    }
    let shown = || angles.iter().map(|a| format!("{:.2}", ANGLE.from_si(*a))).collect::<Vec<_>>().join(", ");
    if angles.windows(2).any(|pair| pair[1] < pair[0]) {
        return Err(format!("jaws are numbered counter-clockwise, and stand at {} deg from jaw 1", shown()));
    }
    match *angles {
        [_, b, c] if b < 0.5 * TAU && c - b < 0.5 * TAU && c > 0.5 * TAU => Ok(angles),
        [_, _, _] => Err(format!("jaws at {} deg cannot press in equilibrium", shown())),
        _ => Err(format!(
            "jaws at {} deg are not evenly spaced, and statics does not say what each presses with",
            shown()
        )),
    }
}
