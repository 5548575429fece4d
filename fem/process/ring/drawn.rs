//! A ring whose mesh was drawn: any plane body with a round bore, which jaws hold on a circle about the bore's centre. Keyways, flats and holes are in the mesh.
//!
//! The sides `bore` are what is bored; `jaw-1`, `jaw-2` … are where the jaws press, counter-clockwise: sides, over which the force is spread evenly, or points, which
//! are line loads. The bore's centre is the origin, and the mesh is turned so that jaw 1 stands at 0°. A jaw may be moved and spread to wherever the border is
//! on the jaws' circle; its load is integrated exactly at any angle. The body floats: after the jaws have closed its bore is where its own first harmonic is zero.

use std::f64::consts::TAU;
use std::sync::{Arc, Mutex, PoisonError};

use super::response::{Jaw, unsolvable};
use crate::element::plane::{Elasticity, PlaneState};
use crate::mesh::{BORE, Mesh, Side};
use crate::process::Failure;
use crate::solve::elastic::{ElasticSystem, Loads};
use crate::solve::ring::{Bore, BoreShape, ContactArc, JawCircle};

/// Nodes are on a circle that differ in radius by less than this part of it: coordinates may be rounded.
const ROUND: f64 = 1e-5;
/// Arcs of jaws are alike, and jaws evenly spaced, that differ by less (rad).
const ALIKE: f64 = 1e-4;
/// Loads whose solutions are kept.
const MOST_SHAPES: usize = 64;

/// A drawn ring, checked and ready to be solved.
#[derive(Debug)]
pub struct Drawn {
    /// Turned so that jaw 1 stands at 0. Elements of lengths in m.
    pub mesh: Arc<Mesh>,
    /// Of the jaws' circle, m.
    pub outer_radius: f64,
    /// Of the bore, m.
    pub inner_radius: f64,
    /// Where the jaws stand, rad.
    pub jaws: Vec<f64>,
    /// Over which full angle each presses, rad; 0 where they are drawn as points.
    pub arc: f64,
    bore: Bore,
    circle: JawCircle,
    solved: Solved,
}

/// What has been solved: factors by Poisson's ratio, with E = b = 1, and shapes by the jaws.
#[derive(Debug, Default)]
struct Solved {
    /// One is enough: only a fit of Poisson's ratio asks for another.
    system: Mutex<Option<(f64, Arc<Body>)>>,
    shapes: Mutex<Vec<(f64, Vec<Jaw>, BoreShape)>>,
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
    /// What of the mesh is no ring in such a chuck.
    pub fn new(mesh: &Mesh, jaws: usize) -> Result<Self, String> {
        let inner_radius = bore_radius(mesh)?;
        let outer_radius = jaw_radius(mesh, jaws)?;
        let seats: Vec<Seat> = (1..=jaws).map(|jaw| seat(mesh, jaw)).collect::<Result<_, _>>()?;
        let arc = seats[0].arc;
        if let Some(k) = seats.iter().position(|seat| (seat.arc - arc).abs() > ALIKE) {
            let (own, first) = (seats[k].arc.to_degrees(), arc.to_degrees());
            return Err(format!("`jaw-{}` presses over {own:.2} deg and `jaw-1` over {first:.2} deg", k + 1));
        }
        let angles = places(&seats)?;
        let mesh = Arc::new(mesh.clone().turned(-seats[0].angle));
        let bore = Bore::new(&mesh).map_err(|error| error.to_string())?;
        let on_circle: Vec<Side> =
            mesh.boundary().into_iter().filter(|side| is_on(&mesh, *side, outer_radius)).collect();
        let circle = JawCircle::new(&mesh, &on_circle);
        Ok(Self { mesh, outer_radius, inner_radius, jaws: angles, arc, bore, circle, solved: Solved::default() })
    }

    /// Adds the forces of jaws, `force` being that of an even share, N.
    ///
    /// # Errors
    /// A jaw stands or reaches beyond the circle that the mesh has.
    pub fn press(&self, loads: &mut Loads, jaws: &[Jaw], force: f64) -> Result<(), Failure> {
        for (k, jaw) in jaws.iter().enumerate() {
            let push = ContactArc { angle: jaw.angle, width: jaw.arc, force: force * jaw.share };
            if !self.circle.carries(&push) {
                let (at, over) = (jaw.angle.to_degrees(), jaw.arc.to_degrees());
                return Err(Failure {
                    message: format!(
                        "jaw {} at {at:.2} deg over {over:.2} deg is not on the circle of the mesh",
                        k + 1
                    ),
                    help: "move the jaw to where the border is round, or draw more of the circle".into(),
                });
            }
            self.circle.press(loads, &push).map_err(|error| unsolvable(&error))?;
        }
        Ok(())
    }

    /// The bore under jaws of one newton on a body with E = b = 1.
    ///
    /// # Errors
    /// A jaw is off the body, or its equations cannot be solved.
    pub fn bore_under(&self, poisson_ratio: f64, jaws: &[Jaw]) -> Result<BoreShape, Failure> {
        // A panic while a list was held leaves it whole: entries are added and removed in one step each.
        let shapes = || self.solved.shapes.lock().unwrap_or_else(PoisonError::into_inner);
        let is_same = |(nu, known, _): &&(f64, Vec<Jaw>, BoreShape)| *nu == poisson_ratio && known == jaws;
        if let Some((.., shape)) = shapes().iter().find(is_same) {
            return Ok(shape.clone());
        }
        let mut loads = Loads::none(&self.mesh);
        self.press(&mut loads, jaws, 1.0)?;
        let solution = self.system(poisson_ratio)?.solve(&loads).map_err(|error| unsolvable(&error))?;
        let shape = self.bore.shape(&solution.nodes);
        let mut list = shapes();
        if list.len() >= MOST_SHAPES {
            list.remove(0);
        }
        list.push((poisson_ratio, jaws.to_vec(), shape.clone()));
        Ok(shape)
    }

    fn system(&self, poisson_ratio: f64) -> Result<Arc<Body>, Failure> {
        let mut known = self.solved.system.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, system)) = known.as_ref().filter(|(nu, _)| *nu == poisson_ratio) {
            return Ok(system.clone());
        }
        let law = Elasticity::new(PlaneState::Stress, 1.0, poisson_ratio, 0.0, 1.0);
        let law = law.map_err(|error| unsolvable(&error))?;
        let system = Arc::new(ElasticSystem::free(self.mesh.clone(), law).map_err(|error| unsolvable(&error))?);
        *known = Some((poisson_ratio, system.clone()));
        Ok(system)
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
    let [x, y] = mesh.nodes()[nodes[i] as usize].map(|x| 1e3 * x);
    let (own, radius) = (1e3 * radii[i], 1e3 * radius);
    Err(format!(
        "{name} is no circle about the origin: its node at ({x:.4}, {y:.4}) mm has a radius of {own:.4} mm, not {radius:.4} mm"
    ))
}

fn bore_radius(mesh: &Mesh) -> Result<f64, String> {
    let nodes = mesh.nodes_on(BORE).map_err(|error| error.to_string())?;
    let radius = common_radius(mesh, &nodes, "`bore`")?;
    let covered =
        mesh.sides(BORE).map_or(0.0, |sides| sides.iter().map(|&side| mesh.curve(side).length()).sum::<f64>());
    // Straight sides are chords, shorter than their arcs by a hundredth at most where eight go around.
    let around = covered / (TAU * radius);
    match (0.95..1.05).contains(&around) {
        true => Ok(radius),
        false => Err(format!("`bore` covers {:.0} deg of its circle and not all of it", 360.0 * around)),
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
            "`{name}` is not one arc: it covers {:.2} of {:.2} deg",
            covered.to_degrees(),
            (high - low).to_degrees()
        )),
    }
}

/// Where the jaws stand from jaw 1 (rad): three wherever they can press in equilibrium, others evenly.
fn places(seats: &[Seat]) -> Result<Vec<f64>, String> {
    let spacing = TAU / seats.len() as f64;
    let places: Vec<f64> =
        seats.iter().map(|seat| (seat.angle - seats[0].angle + ALIKE).rem_euclid(TAU) - ALIKE).collect();
    let even: Vec<f64> = (0..seats.len()).map(|k| spacing * k as f64).collect();
    if places.iter().zip(&even).all(|(place, even)| (place - even).abs() < ALIKE) {
        return Ok(even);
    }
    let shown = || places.iter().map(|place| format!("{:.2}", place.to_degrees())).collect::<Vec<_>>().join(", ");
    if places.windows(2).any(|pair| pair[1] < pair[0]) {
        return Err(format!("jaws are numbered counter-clockwise, and stand at {} deg from jaw 1", shown()));
    }
    match *places {
        [_, b, c] if b < 0.5 * TAU && c - b < 0.5 * TAU && c > 0.5 * TAU => Ok(places),
        [_, _, _] => Err(format!("jaws at {} deg cannot press in equilibrium", shown())),
        _ => Err(format!(
            "jaws at {} deg are not evenly spaced, and statics does not say what each presses with",
            shown()
        )),
    }
}
