//! The shaft and its joints in space, tool position by tool position.

use std::sync::Arc;

use super::super::elastic::Deflection;
use super::super::forward::{condense, deflections, rest_forces};
use super::super::machine::Machine;
use super::super::setup::Setup;
use crate::process::{Animation, Cell, Failure, Field, Frame, Grid};
use crate::progress::Progress;
use crate::solve::Condensed;

/// More frames than anybody watches.
const MOST_FRAMES: usize = 201;
/// More nodes than a line needs.
const MOST_NODES: f64 = 2000.0;

/// Frames with the tool at positions along the pass, in the order in which it travels.
///
/// Points are the nodes of the shaft on its axis (x, 0, 0), then headstock, tailstock and steady rests, then
/// the tool nose. The work gives way toward +y. `force` is what acts on the work there.
///
/// # Errors
/// The equilibrium of some position cannot be computed.
pub fn animation(machine: &Machine) -> Result<Animation, Failure> {
    let setup = machine.setup.clone();
    let nodes = nodes(&setup);
    let tools = tool_positions(&setup);
    let all: Vec<f64> = tools.iter().chain(&nodes).copied().chain(setup.steady_rests.iter().map(|r| r.at)).collect();
    let shaft = condense(machine, &all)?;
    let deflections = deflections(machine, &condense(machine, &tools)?, &tools, &Progress::default())?;
    let rests = rest_forces(machine, &tools, &deflections)?;
    let scene = Scene { setup, nodes, tools, shaft, deflections, rests };
    Ok(Animation { name: "shaft", frames: scene.tools.len(), frame: Box::new(move |i| scene.frame(i)) })
}

/// Ends of the beam elements: every segment divided evenly into elements of at most the element size.
fn nodes(setup: &Setup) -> Vec<f64> {
    let size = setup.element_size.max(setup.length() / MOST_NODES);
    let mut nodes = vec![0.0];
    let mut start = 0.0;
    for segment in &setup.segments {
        let count = (segment.length / size).ceil().max(1.0) as usize;
        nodes.extend((1..=count).map(|i| start + segment.length * (i as f64 / count as f64)));
        start += segment.length;
    }
    nodes
}

fn tool_positions(setup: &Setup) -> Vec<f64> {
    let pass = setup.schedule.pass;
    let count = setup.positions.min(MOST_FRAMES);
    (0..count).map(|i| pass.from + (pass.to - pass.from) * (i as f64 / (count - 1) as f64)).collect()
}

struct Scene {
    setup: Arc<Setup>,
    nodes: Vec<f64>,
    tools: Vec<f64>,
    /// Condensed to tools, nodes and rests, in this order.
    shaft: Condensed,
    deflections: Vec<Deflection>,
    rests: Vec<Vec<f64>>,
}

/// A point of the scene that is not on the shaft's line.
struct Marker {
    at: [f64; 3],
    displacement: f64,
    force: f64,
}

impl Scene {
    fn frame(&self, tool: usize) -> Frame {
        let markers = self.markers(tool);
        let mut grid = Grid::default();
        let (mut displacement, mut force) = (Vec::new(), Vec::new());
        let (mut diameter, mut moment, mut stress) = (Vec::new(), Vec::new(), Vec::new());
        for (&x, w) in self.nodes.iter().zip(self.line(tool)) {
            let bending = self.bending_moment(tool, x);
            let section = self.setup.section(x);
            grid.points.push([x, 0.0, 0.0]);
            displacement.push([0.0, w, 0.0]);
            force.push([0.0; 3]);
            diameter.push(section.diameter);
            moment.push(bending);
            stress.push(bending.abs() * 0.5 * section.diameter / section.inertia());
        }
        for i in 1..self.nodes.len() as u32 {
            grid.push(Cell::Line, &[i - 1, i]);
        }
        for marker in markers {
            grid.push(Cell::Vertex, &[grid.points.len() as u32]);
            grid.points.push(marker.at);
            displacement.push([0.0, marker.displacement, 0.0]);
            force.push([0.0, marker.force, 0.0]);
            diameter.push(0.0);
            moment.push(0.0);
            stress.push(0.0);
        }
        grid.point_fields = vec![
            Field::vector("displacement", displacement),
            Field::vector("force", force),
            Field::scalar("diameter", diameter),
            Field::scalar("bending_moment", moment),
            Field::scalar("bending_stress", stress),
        ];
        Frame { time: self.setup.schedule.time(1, self.tools[tool]), grid }
    }

    /// Deflection of every node, m.
    fn line(&self, tool: usize) -> Vec<f64> {
        let deflection = &self.deflections[tool];
        let [head, tail] = deflection.supports.displacements;
        let unit = self.shaft.shape(tool);
        (self.tools.len()..self.tools.len() + self.nodes.len())
            .map(|i| unit[i] * deflection.force + self.shaft.influence[i][0] * head + self.shaft.influence[i][1] * tail)
            .collect()
    }

    fn markers(&self, tool: usize) -> Vec<Marker> {
        let deflection = &self.deflections[tool];
        let supports = &deflection.supports;
        let on_axis = |x, displacement, force| Marker { at: [x, 0.0, 0.0], displacement, force };
        let mut markers = vec![on_axis(0.0, supports.displacements[0], -supports.forces[0])];
        if self.setup.workholding.has_tailstock() {
            markers.push(on_axis(self.setup.length(), supports.displacements[1], -supports.forces[1]));
        }
        for (rest, forces) in self.setup.steady_rests.iter().zip(&self.rests) {
            markers.push(on_axis(rest.at, forces[tool] / rest.stiffness, -forces[tool]));
        }
        let x = self.tools[tool];
        let nose = [x, -0.5 * self.setup.diameter(x), 0.0];
        markers.push(Marker { at: nose, displacement: -deflection.carriage, force: deflection.force });
        markers
    }

    /// M(s) = M₀ + Q_h·s + Σ R·⟨s − x_R⟩ − P·⟨s − x⟩, N m, with M₀ what a chuck takes so that M vanishes at
    /// the far end.
    fn bending_moment(&self, tool: usize, s: f64) -> f64 {
        let (deflection, x) = (&self.deflections[tool], self.tools[tool]);
        let [head, tail] = deflection.supports.forces;
        let tail = if self.setup.workholding.has_tailstock() { tail } else { 0.0 };
        let rests = || self.setup.steady_rests.iter().zip(&self.rests).map(|(rest, forces)| (rest.at, forces[tool]));
        let chuck = tail * self.setup.length() + rests().map(|(at, r)| at * r).sum::<f64>() - deflection.force * x;
        let ahead = |at: f64, force: f64| force * (s - at).max(0.0);
        chuck + head * s + rests().map(|(at, r)| ahead(at, r)).sum::<f64>() - ahead(x, deflection.force)
    }
}
