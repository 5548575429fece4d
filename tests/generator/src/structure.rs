//! Machines drawn as beams and joints, pushed at some places and watched by dials: a frame by the textbook's stiffness
//! matrices, dense, solved by elimination.
//!
//! A lathe-like or a column-like machine of random size stands on two feet, with two units on seats that yield and tilt:
//! six joints. One of them is softer than the model says.

use crate::dense::solve;
use crate::random::Random;

/// A measured machine of which one joint is soft.
pub struct SoftJoint {
    /// The model, every joint as it was meant.
    pub model: String,
    /// The measurement.
    pub data: String,
    /// The soft joint.
    pub joint: &'static str,
    /// Its true stiffness, N/um or kN*m/rad.
    pub stiffness: f64,
    /// Length of what its softness changes, in standard deviations.
    pub lambda: f64,
}

/// The joints that may be soft.
pub const JOINTS: [&str; 6] = ["left-foot", "right-foot", "first-seat", "first-tilt", "second-seat", "second-tilt"];

/// Joints: names, nodes (the second is the ground where it is none), direction, stiffness in SI.
#[derive(Clone, Copy)]
pub(crate) struct Joint {
    pub name: &'static str,
    pub nodes: (usize, Option<usize>),
    pub way: usize,
    pub stiffness: f64,
}

/// A member: name, nodes, width, height in m, of cast iron.
pub(crate) struct Member {
    pub name: &'static str,
    pub nodes: [usize; 2],
    pub width: f64,
    pub height: f64,
}

impl Joint {
    /// Its table, with the names of nodes by their numbers.
    pub fn written(&self, name: impl Fn(usize) -> String) -> String {
        let at = match self.nodes.1 {
            None => format!("at = \"{}\"", name(self.nodes.0)),
            Some(other) => format!("between = [\"{}\", \"{}\"]", name(self.nodes.0), name(other)),
        };
        let (along, stiffness) = match self.way {
            0 => ("x", format!("{} N/um", 1e-6 * self.stiffness)),
            1 => ("y", format!("{} N/um", 1e-6 * self.stiffness)),
            _ => ("turning", format!("{} kN*m/rad", 1e-3 * self.stiffness)),
        };
        format!("[structure.{}]\n{at}\nalong = \"{along}\"\nstiffness = \"{stiffness}\"\n", self.name)
    }
}

impl Member {
    /// Its table, with the names of nodes by their numbers.
    pub fn written(&self, name: impl Fn(usize) -> String) -> String {
        let [a, b] = self.nodes.map(name);
        let [width, height] = [self.width, self.height].map(|length| 1e3 * length);
        format!(
            "[structure.{}]\nbetween = [\"{a}\", \"{b}\"]\nwidth = \"{width} mm\"\nheight = \"{height} mm\"\n",
            self.name
        )
    }
}

struct Machine {
    nodes: Vec<(&'static str, [f64; 2])>,
    members: Vec<Member>,
    joints: Vec<Joint>,
    loads: Vec<usize>,
    dials: Vec<usize>,
}

const YOUNG: f64 = 110e9;
const NU: f64 = 0.26;

impl Machine {
    /// Bed on two feet; a first and a second unit, each a column on its seat with an arm toward the other.
    fn draw(random: &mut Random) -> Self {
        let length = random.uniform(0.8, 2.0);
        let height = random.uniform(0.2, 0.5);
        let (first, second) = (random.uniform(0.15, 0.35) * length, random.uniform(0.65, 0.85) * length);
        let arm = random.uniform(0.1, 0.2) * length;
        let nodes = vec![
            ("left", [0.0, 0.0]),
            ("under-first", [first, 0.0]),
            ("under-second", [second, 0.0]),
            ("right", [length, 0.0]),
            ("first-base", [first, 0.0]),
            ("first-top", [first, height]),
            ("first-end", [first + arm, height]),
            ("second-base", [second, 0.0]),
            ("second-top", [second, height]),
            ("second-end", [second - arm, height]),
        ];
        let mut member = |name, nodes, thin: f64, thick: f64| {
            let [width, height] = [0, 1].map(|_| random.uniform(thin, thick));
            Member { name, nodes, width, height }
        };
        let members = vec![
            member("bed-left", [0, 1], 0.1, 0.2),
            member("bed-middle", [1, 2], 0.1, 0.2),
            member("bed-right", [2, 3], 0.1, 0.2),
            member("first-column", [4, 5], 0.12, 0.25),
            member("first-arm", [5, 6], 0.06, 0.12),
            member("second-column", [7, 8], 0.12, 0.25),
            member("second-arm", [8, 9], 0.06, 0.12),
        ];
        let mut joint = |name, nodes, way, low: f64, high: f64| {
            let stiffness = random.log_uniform(low, high);
            Joint { name, nodes, way, stiffness }
        };
        let joints = vec![
            joint("left-foot", (0, None), 1, 1e8, 4e8),
            joint("right-foot", (3, None), 1, 1e8, 4e8),
            joint("left-foot-along", (0, None), 0, 1e8, 4e8),
            joint("first-seat", (4, Some(1)), 1, 2e8, 8e8),
            joint("first-seat-along", (4, Some(1)), 0, 2e8, 8e8),
            joint("first-tilt", (4, Some(1)), 2, 1e6, 8e6),
            joint("second-seat", (7, Some(2)), 1, 2e8, 8e8),
            joint("second-seat-along", (7, Some(2)), 0, 2e8, 8e8),
            joint("second-tilt", (7, Some(2)), 2, 1e6, 8e6),
        ];
        Self { nodes, members, joints, loads: vec![6, 9], dials: vec![0, 3, 1, 4, 5, 6, 2, 7, 8, 9] }
    }

    /// Readings of all dials, place by place, under a unit force along y.
    fn readings(&self, joints: &[Joint]) -> Vec<f64> {
        let places: Vec<[f64; 2]> = self.nodes.iter().map(|node| node.1).collect();
        let size = 3 * places.len();
        let stiffness = stiffness(&places, &self.members, joints);
        let of_load = |load: &usize| {
            let mut force = vec![0.0; size];
            force[3 * load + 1] = 1.0;
            let moved = solve(stiffness.clone(), force);
            self.dials.iter().map(|dial| moved[3 * dial + 1]).collect::<Vec<f64>>()
        };
        self.loads.iter().flat_map(of_load).collect()
    }

    /// The model, with the joints as they are meant.
    fn written(&self) -> String {
        let mm = |value: f64| 1e3 * value;
        let mut text = String::from(
            "process = \"stiffness\"\n\n[test]\nmax_force = \"1000 N\"\nsteps = 4\n\n[structure]\nmaterial = \"cast-iron\"\n\n[structure.nodes]\n",
        );
        for (name, [x, y]) in &self.nodes {
            text += &format!("{name} = [\"{} mm\", \"{} mm\"]\n", mm(*x), mm(*y));
        }
        let list = |nodes: &[usize]| {
            let of = |node: &usize| format!("{{ at = \"{}\" }}", self.nodes[*node].0);
            nodes.iter().map(of).collect::<Vec<_>>().join(", ")
        };
        text += &format!("\n[structure.ports]\nloads = [{}]\ndials = [{}]\n", list(&self.loads), list(&self.dials));
        let name = |node: usize| self.nodes[node].0.to_string();
        self.members.iter().for_each(|member| text += &format!("\n{}", member.written(name)));
        self.joints.iter().for_each(|joint| text += &format!("\n{}", joint.written(name)));
        text
    }
}

/// Stiffness of a frame over u, v, θ of every node.
pub(crate) fn stiffness(nodes: &[[f64; 2]], members: &[Member], joints: &[Joint]) -> Vec<Vec<f64>> {
    let size = 3 * nodes.len();
    let mut stiffness = vec![vec![0.0; size]; size];
    for member in members {
        let [a, b] = member.nodes.map(|node| nodes[node]);
        let own = beam([b[0] - a[0], b[1] - a[1]], member.width, member.height);
        let at = |k: usize| 3 * member.nodes[k / 3] + k % 3;
        for (i, row) in own.iter().enumerate() {
            row.iter().enumerate().for_each(|(j, value)| stiffness[at(i)][at(j)] += value);
        }
    }
    for joint in joints {
        let one = 3 * joint.nodes.0 + joint.way;
        stiffness[one][one] += joint.stiffness;
        if let Some(node) = joint.nodes.1 {
            let other = 3 * node + joint.way;
            stiffness[other][other] += joint.stiffness;
            stiffness[one][other] -= joint.stiffness;
            stiffness[other][one] -= joint.stiffness;
        }
    }
    stiffness
}

/// Stiffness of a beam that shears between its ends (u, v, θ each), along and across the plane's axes.
fn beam([dx, dy]: [f64; 2], width: f64, height: f64) -> Vec<Vec<f64>> {
    let length = dx.hypot(dy);
    let (c, s) = (dx / length, dy / length);
    let area = width * height;
    let ei = YOUNG * width * height.powi(3) / 12.0;
    let shear = 10.0 * (1.0 + NU) / (12.0 + 11.0 * NU) * YOUNG / (2.0 * (1.0 + NU)) * area;
    let phi = 12.0 * ei / (shear * length * length);
    let (axial, q) = (YOUNG * area / length, ei / (length.powi(3) * (1.0 + phi)));
    let l = length;
    let local = [
        [axial, 0.0, 0.0, -axial, 0.0, 0.0],
        [0.0, 12.0 * q, 6.0 * l * q, 0.0, -12.0 * q, 6.0 * l * q],
        [0.0, 6.0 * l * q, (4.0 + phi) * l * l * q, 0.0, -6.0 * l * q, (2.0 - phi) * l * l * q],
        [-axial, 0.0, 0.0, axial, 0.0, 0.0],
        [0.0, -12.0 * q, -6.0 * l * q, 0.0, 12.0 * q, -6.0 * l * q],
        [0.0, 6.0 * l * q, (2.0 - phi) * l * l * q, 0.0, -6.0 * l * q, (4.0 + phi) * l * l * q],
    ];
    let turn = |k: usize, j: usize| -> f64 {
        match (k % 3, j % 3) {
            _ if k / 3 != j / 3 => 0.0,
            (0, 0) | (1, 1) => c,
            (0, 1) => s,
            (1, 0) => -s,
            (2, 2) => 1.0,
            _ => 0.0,
        }
    };
    let entry = |i: usize, j: usize| -> f64 {
        (0..6).map(|a| (0..6).map(|b| turn(a, i) * local[a][b] * turn(b, j)).sum::<f64>()).sum()
    };
    (0..6).map(|i| (0..6).map(|j| entry(i, j)).collect()).collect()
}

/// A machine one of whose joints has a part of its stiffness, seen at this length.
pub fn soft_joint(seed: u64, lambda: f64) -> SoftJoint {
    measured(seed, lambda, true)
}

/// The same machine with the same noise, every joint as it was meant.
pub fn as_written(seed: u64, lambda: f64) -> SoftJoint {
    measured(seed, lambda, false)
}

fn measured(seed: u64, lambda: f64, is_soft: bool) -> SoftJoint {
    const FORCES: [f64; 4] = [250.0, 500.0, 750.0, 1000.0];
    let mut random = Random::new("soft joint", seed);
    let machine = Machine::draw(&mut random);
    let joint = JOINTS[random.whole(0, JOINTS.len() - 1)];
    let part = random.uniform(0.25, 0.6);
    let mut joints = machine.joints.clone();
    joints.iter_mut().filter(|own| own.name == joint).for_each(|own| own.stiffness *= part);
    let (meant, real) = (machine.readings(&machine.joints), machine.readings(&joints));
    let squares: f64 = meant.iter().zip(&real).map(|(a, b)| (b - a).powi(2)).sum();
    let of_forces: f64 = FORCES.iter().map(|force| force * force).sum();
    // The noise decides how well it is seen.
    let noise = 1e6 * (squares * of_forces).sqrt() / lambda;
    let mut data = String::from("load,dial,force [N],displacement [um],u [um]\n");
    for (i, reading) in if is_soft { &real } else { &meant }.iter().enumerate() {
        for force in FORCES {
            let (load, dial) = (i / machine.dials.len() + 1, i % machine.dials.len() + 1);
            let value = 1e6 * reading * force + noise * random.normal();
            data += &format!("{load},{dial},{force},{value},{noise}\n");
        }
    }
    let own = joints.iter().find(|own| own.name == joint);
    let unit = if joint.ends_with("tilt") { 1e-3 } else { 1e-6 };
    let stiffness = own.map_or(f64::NAN, |own| unit * own.stiffness);
    SoftJoint { model: machine.written(), data, joint, stiffness, lambda }
}
