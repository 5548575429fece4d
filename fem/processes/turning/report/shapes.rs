//! The shaft and its joints in space, tool position by tool position and pass by pass.

use std::sync::Arc;

use super::super::elastic::{Cutting, Deflection, Elastic, condense};
use super::super::forward::{deflections, rest_forces};
use super::super::history::History;
use super::super::machine::Machine;
use super::super::setup::Setup;
use super::bodies::Bodies;
use super::structure;
use crate::process::{Animation, Arrow, Cell, Failure, Field, Forward, Frame, Grid, View};
use crate::progress::Progress;
use crate::solve::{Condensed, Rest};
use crate::units::{FORCE, LENGTH, MICRO, MOMENT, STRESS, TIME};

/// More frames than anybody watches.
const MOST_FRAMES: usize = 201;
/// More nodes than a line needs.
const MOST_NODES: f64 = 2000.0;

/// Frames with the tool at positions along every pass, in the order in which it travels.
///
/// Points are the nodes of the shaft on its axis (x, 0, 0), then headstock, tailstock and steady rests, then
/// the tool nose. The work gives way toward +y. `force` is what acts on the work there; `diameter_error` is what
/// the tool leaves behind it, and what it still meets ahead.
///
/// # Errors
/// The equilibrium of some position cannot be computed.
pub fn animation(machine: &Machine, forward: &Forward) -> Result<Animation, Failure> {
    let setup = machine.setup.clone();
    let nodes = nodes(&setup);
    let tools = tool_positions(&setup);
    let all: Vec<f64> = tools.iter().chain(&nodes).copied().chain(setup.steady_rests.iter().map(|r| r.at)).collect();
    let shaft = condense(machine, &all)?;
    let passes = passes(machine, forward, &tools)?;
    let bodies = Bodies::new(&setup, &nodes);
    let scene = Scene { setup, nodes, tools, shaft, passes, rests: machine.shaft().rests, bodies };
    Ok(Animation {
        name: "shaft",
        shown: "diameter_error",
        time: "time since the batch began, s",
        // The tool half way along the last pass.
        view: View::Oblique,
        telling: scene.frames() - scene.tools.len().div_ceil(2),
        most_magnified: f64::INFINITY,
        frames: scene.frames(),
        frame: Box::new(move |i| scene.frame(i)),
    })
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

/// A pass on the first part, tool position by tool position.
struct Pass {
    /// Times, s.
    times: Vec<f64>,
    deflections: Vec<Deflection>,
    rests: Vec<Vec<f64>>,
    /// Diameter errors before and after it, (x, error) with rising x, m.
    before: Vec<(f64, f64)>,
    after: Vec<(f64, f64)>,
}

/// All passes: those before the last as each copies what it meets, the last as it is predicted.
fn passes(machine: &Machine, forward: &Forward, tools: &[f64]) -> Result<Vec<Pass>, Failure> {
    let setup = &machine.setup;
    let shaft = condense(machine, tools)?;
    let (elastic, history) = (Elastic::new(machine, &shaft), History::on_part(machine, 1, None)?);
    let travel = (setup.schedule.pass.to - setup.schedule.pass.from).abs();
    let ordered = |errors: &[f64]| {
        let mut pairs: Vec<(f64, f64)> = tools.iter().copied().zip(errors.iter().copied()).collect();
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
        pairs
    };
    let copies = machine.feeds_back();
    let blank = |x: &f64| if copies { setup.blank.error(*x, setup.length()) } else { 0.0 };
    let mut errors: Vec<f64> = tools.iter().map(blank).collect();
    let (mut passes, mut begin) = (Vec::new(), 0.0);
    for (number, earlier) in setup.passes.iter().enumerate() {
        let before = ordered(&errors);
        let pass = |(i, x): (usize, &f64)| {
            elastic.pass(number, (i, *x), errors[i], &Cutting::on_part(machine, 1, *x), history.at(*x))
        };
        let deflections = tools.iter().enumerate().map(pass).collect::<Result<Vec<Deflection>, _>>()?;
        errors = deflections.iter().map(|d| d.error).collect();
        let duration = earlier.duration(travel);
        let times = tools.iter().map(|x| begin + duration * (x - tools[0]).abs() / travel).collect();
        let rests = rest_forces(machine, tools, &deflections)?;
        passes.push(Pass { times, deflections, rests, before, after: ordered(&errors) });
        begin += duration;
    }
    let deflections = deflections(machine, &shaft, tools, &Progress::default())?;
    let rests = rest_forces(machine, tools, &deflections)?;
    let times = tools.iter().map(|x| setup.schedule.time(1, *x)).collect();
    let after = setup.sweep().into_iter().zip(forward.prediction.iter().copied()).collect();
    passes.push(Pass { times, deflections, rests, before: ordered(&errors), after });
    Ok(passes)
}

impl Pass {
    /// The error at x while the tool stands at another place, m; none off the pass.
    fn error(&self, x: f64, tool: f64, to: f64) -> f64 {
        let is_cut = (x - tool) * (to - tool) <= 0.0;
        let errors = if is_cut { &self.after } else { &self.before };
        let i = errors.partition_point(|p| p.0 < x).clamp(1, errors.len().max(2) - 1);
        let (Some(a), Some(b)) = (errors.get(i - 1), errors.get(i)) else { return 0.0 };
        let share = (x - a.0) / (b.0 - a.0);
        if (-1e-9..=1.0 + 1e-9).contains(&share) { a.1 + share * (b.1 - a.1) } else { 0.0 }
    }
}

struct Scene {
    setup: Arc<Setup>,
    nodes: Vec<f64>,
    tools: Vec<f64>,
    /// Condensed to tools, nodes and rests, in this order.
    shaft: Condensed,
    passes: Vec<Pass>,
    rests: Vec<Rest>,
    bodies: Bodies,
}

/// A point of the scene that is not on the shaft's line.
struct Marker {
    at: [f64; 3],
    displacement: f64,
    force: f64,
}

impl Scene {
    /// A pass begins where the one before it has ended: that frame is not shown twice.
    fn frames(&self) -> usize {
        self.tools.len() + (self.passes.len() - 1) * (self.tools.len() - 1)
    }

    /// Pass and tool position of a frame.
    fn place(&self, i: usize) -> (usize, usize) {
        let count = self.tools.len();
        if i < count { (0, i) } else { (1 + (i - count) / (count - 1), 1 + (i - count) % (count - 1)) }
    }

    fn frame(&self, i: usize) -> Frame {
        let (number, tool) = self.place(i);
        let pass = &self.passes[number];
        let markers = self.markers(pass, tool);
        let mut grid = Grid::default();
        let (mut displacement, mut force) = (Vec::new(), Vec::new());
        let (mut diameter, mut moment, mut stress, mut error) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (x, w) in self.line(pass, tool) {
            let bending = self.bending_moment(pass, tool, x);
            let section = self.setup.section(x);
            grid.points.push([x, 0.0, 0.0]);
            displacement.push([0.0, w, 0.0]);
            force.push([0.0; 3]);
            diameter.push(section.diameter);
            moment.push(bending);
            stress.push(bending.abs() * 0.5 * section.diameter / section.inertia());
            error.push(pass.error(x, self.tools[tool], self.setup.schedule.pass.to));
        }
        for i in 1..self.nodes.len() as u32 {
            grid.push(Cell::Line, &[i - 1, i]);
        }
        let supports = self.nodes.len()..self.nodes.len() + markers.len() - 1;
        for marker in markers {
            grid.push(Cell::Vertex, &[grid.points.len() as u32]);
            grid.points.push(marker.at);
            displacement.push([0.0, marker.displacement, 0.0]);
            force.push([0.0, marker.force, 0.0]);
        }
        let mut bodies = self.bodies.at(supports.end);
        let place = (tool, self.tools[tool]);
        if let Some(base) = &self.setup.base
            && let Some(displaced) = structure::standing(base, &self.shaft, place, &pass.deflections[tool])
        {
            bodies.extend(base.drawn.bodies(grid.points.len() as u32));
            displacement.extend(base.drawn.draw(&displaced, &mut grid));
            force.resize(displacement.len(), [0.0; 3]);
        }
        // What is not on the shaft has nothing of it.
        for field in [&mut diameter, &mut moment, &mut stress, &mut error] {
            field.resize(grid.points.len(), 0.0);
        }
        grid.point_fields = vec![
            Field::vector("displacement", LENGTH, displacement),
            Field::vector("force", FORCE, force),
            Field::scalar("diameter", LENGTH, diameter),
            Field::scalar("bending_moment", MOMENT, moment),
            Field::scalar("bending_stress", STRESS, stress),
            Field::scalar("diameter_error", MICRO, error),
        ];
        let (x, time) = (self.tools[tool], pass.times[tool]);
        let of = match self.passes.len() {
            1 => String::new(),
            all => format!("pass {} of {all}, ", number + 1),
        };
        let radius = |x: f64| 0.5 * self.setup.diameter(x);
        let arrow = |node: usize| Arrow::new(node, radius(grid.points[node][0]));
        // Beside the tool, which would hide it.
        let nose = Arrow { aside: [0.0, 0.0, self.bodies.tool_width()], ..Arrow::new(supports.end, 0.0) };
        Frame {
            time,
            caption: format!("{of}tool at x = {:.0}, {:.2} after the start", LENGTH.shown(x), TIME.shown(time)),
            arrows: supports.clone().map(arrow).chain([nose]).collect(),
            bodies,
            grid,
        }
    }

    /// Places of the nodes and their deflections, m. One of them stands under the tool, where the line has its kink.
    fn line(&self, pass: &Pass, tool: usize) -> Vec<(f64, f64)> {
        let deflection = &pass.deflections[tool];
        let all = self.shaft.line(tool, deflection.force, &deflection.moved());
        let at = |i: usize| all[i];
        let (x, first) = (self.tools[tool], self.tools.len());
        let mut line: Vec<(f64, f64)> = self.nodes.iter().enumerate().map(|(i, x)| (*x, at(first + i))).collect();
        if let Some(node) = self.node_for(x) {
            line[node] = (x, at(tool));
        }
        line
    }

    /// The node that is moved under a tool at x (m): the nearest one beside it, unless that ends a segment.
    fn node_for(&self, x: f64) -> Option<usize> {
        let after = self.nodes.partition_point(|node| *node < x);
        let is_free = |i: &usize| *i > 0 && *i + 1 < self.nodes.len() && !self.setup.is_step(self.nodes[*i]);
        let distance = |i: &usize| (self.nodes[*i] - x).abs();
        let beside = [after.checked_sub(1), Some(after)].into_iter().flatten().filter(|i| *i < self.nodes.len());
        beside.filter(is_free).min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }

    fn markers(&self, pass: &Pass, tool: usize) -> Vec<Marker> {
        let deflection = &pass.deflections[tool];
        let supports = &deflection.supports;
        let supports_at = self.shaft.supports_under(tool, deflection.force, &deflection.moved());
        let ends = [supports_at[0], supports_at[1]];
        let on_axis = |x, displacement, force| Marker { at: [x, 0.0, 0.0], displacement, force };
        let mut markers = vec![on_axis(0.0, ends[0], -supports.forces[0])];
        if self.setup.workholding.has_tailstock() {
            markers.push(on_axis(self.setup.length(), ends[1], -supports.forces[1]));
        }
        for ((rest, forces), foot) in self.rests.iter().zip(&pass.rests).zip(&supports_at[3..]) {
            markers.push(on_axis(rest.at, foot + rest.offset + forces[tool] / rest.stiffness, -forces[tool]));
        }
        let x = self.tools[tool];
        let nose = [x, -0.5 * self.setup.diameter(x), 0.0];
        let work = self.shaft.line(tool, deflection.force, &deflection.moved())[tool];
        markers.push(Marker { at: nose, displacement: work - deflection.total, force: deflection.force });
        markers
    }

    /// M(s) = M₀ + Q_h·s + Σ R·⟨s − x_R⟩ − P·⟨s − x⟩, N m, with M₀ what a chuck takes so that M vanishes at
    /// the far end.
    fn bending_moment(&self, pass: &Pass, tool: usize, s: f64) -> f64 {
        let (deflection, x) = (&pass.deflections[tool], self.tools[tool]);
        let [head, tail] = deflection.supports.forces;
        let tail = if self.setup.workholding.has_tailstock() { tail } else { 0.0 };
        let rests = || self.rests.iter().zip(&pass.rests).map(|(rest, forces)| (rest.at, forces[tool]));
        let chuck = tail * self.setup.length() + rests().map(|(at, r)| at * r).sum::<f64>() - deflection.force * x;
        let ahead = |at: f64, force: f64| force * (s - at).max(0.0);
        chuck + head * s + rests().map(|(at, r)| ahead(at, r)).sum::<f64>() - ahead(x, deflection.force)
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::effects::bench::{gap, lathe};
    use super::*;
    use crate::process::ForwardModel;

    #[test]
    fn the_line_reaches_the_deflection_under_the_tool() {
        let lathe = lathe("centres", "headstock-compliance", &[60.0]);
        let report = lathe.report(lathe.predict(&Progress::default()).unwrap()).unwrap();
        let animation = &report.animations[0];
        for i in [1, 7, 50, 93] {
            let frame = (animation.frame)(i);
            let nose = frame.grid.points[frame.grid.points.len() - 1][0];
            let node = frame.grid.points.iter().position(|p| p[0] == nose && p[1] == 0.0).unwrap();
            let Some(field) = frame.grid.point_fields.iter().find(|f| f.name == "displacement") else { panic!() };
            let deflected = 1e6 * field.values[3 * node + 1];
            assert!((deflected / gap(&lathe, nose) - 1.0).abs() < 1e-9, "{deflected} at {nose}");
            assert!(frame.grid.points[..node + 1].is_sorted_by(|a, b| a[0] <= b[0]));
        }
    }
}
