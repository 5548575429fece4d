//! Plates milled on portal machines: machine, table, clamps and plate as one dense frame, of which one joint is soft.
//!
//! The plate is a member like all others, on springs at its supports; clamps and cutter are pairs of forces between two nodes. What is
//! left of the plate is how far the spindle has gone up less how far the plate has.

use crate::dense::solve;
use crate::random::Random;
use crate::structure::{Joint, Member, SoftJoint, stiffness};

/// The joints that may be soft: those that a part on its table loads.
pub const JOINTS: [&str; 3] = ["guide-left", "guide-right", "ram-seat"];

/// Places along the plate, as parts of its length, and which of them are supports, clamps, and milled.
const PLACES: [f64; 9] = [0.0, 0.1, 0.2, 0.3, 0.5, 0.7, 0.8, 0.9, 1.0];
const SUPPORTS: [usize; 3] = [1, 4, 7];
const CLAMPS: [usize; 2] = [3, 5];
/// Forces of each clamp and of the cutter, N.
const FORCES: [[f64; 2]; 4] = [[2000.0, 300.0], [2000.0, 1200.0], [5000.0, 300.0], [5000.0, 1200.0]];
/// Stiffness of a support, N/m.
const SUPPORT: f64 = 4e8;

/// Nodes of the machine; those of table and plate follow, place by place.
const GUIDES: [usize; 2] = [0, 1];
const TABLE_ENDS: [usize; 2] = [2, 3];
const BEAM: [usize; 3] = [4, 5, 6];
const RAM: usize = 7;
const SPINDLE: usize = 8;
const FIRST: usize = 9;

struct Mill {
    length: f64,
    plate: [f64; 2],
    nodes: Vec<[f64; 2]>,
    /// Those of the machine, the table whole.
    members: Vec<Member>,
    joints: Vec<Joint>,
}

fn on_table(place: usize) -> usize {
    FIRST + place
}

fn on_plate(place: usize) -> usize {
    FIRST + PLACES.len() + place
}

impl Mill {
    fn draw(random: &mut Random) -> Self {
        let length = random.uniform(0.3, 0.6);
        let plate = [random.uniform(0.1, 0.2), random.uniform(0.03, 0.06)];
        let (over, low, high) = (random.uniform(0.1, 0.3), random.uniform(0.2, 0.4), random.uniform(0.5, 0.9));
        let ram = random.uniform(0.3, 0.7) * length;
        let mut nodes = vec![
            [-over, -low],
            [length + over, -low],
            [-over, -0.12],
            [length + over, -0.12],
            [-over, high],
            [ram, high],
            [length + over, high],
            [ram, high],
            [ram, 0.1],
        ];
        nodes.extend(PLACES.map(|part| [part * length, -0.12]));
        nodes.extend(PLACES.map(|part| [part * length, 0.0]));
        let mut member = |name, nodes, thin: f64, thick: f64| {
            let [width, height] = [0, 1].map(|_| random.uniform(thin, thick));
            Member { name, nodes, width, height }
        };
        let members = vec![
            member("bed", GUIDES, 0.15, 0.25),
            member("column-left", [GUIDES[0], BEAM[0]], 0.12, 0.2),
            member("column-right", [GUIDES[1], BEAM[2]], 0.12, 0.2),
            member("beam-left", [BEAM[0], BEAM[1]], 0.12, 0.2),
            member("beam-right", [BEAM[1], BEAM[2]], 0.12, 0.2),
            member("ram", [RAM, SPINDLE], 0.1, 0.15),
            member("table", TABLE_ENDS, 0.07, 0.12),
        ];
        let mut joint = |name, nodes, way, low: f64, high: f64| {
            let stiffness = random.log_uniform(low, high);
            Joint { name, nodes, way, stiffness }
        };
        let joints = vec![
            joint("guide-left", (TABLE_ENDS[0], Some(GUIDES[0])), 1, 2e8, 8e8),
            joint("guide-right", (TABLE_ENDS[1], Some(GUIDES[1])), 1, 2e8, 8e8),
            joint("feed", (TABLE_ENDS[0], Some(GUIDES[0])), 0, 1e8, 4e8),
            joint("ram-seat", (RAM, Some(BEAM[1])), 1, 2e8, 8e8),
            joint("ram-along", (RAM, Some(BEAM[1])), 0, 2e8, 8e8),
            joint("ram-tilt", (RAM, Some(BEAM[1])), 2, 2e6, 9e6),
            joint("foot-left", (GUIDES[0], None), 1, 1e8, 4e8),
            joint("foot-right", (GUIDES[1], None), 1, 1e8, 4e8),
            joint("foot-along", (GUIDES[0], None), 0, 1e8, 4e8),
        ];
        Self { length, plate, nodes, members, joints }
    }

    /// Height errors (m) place by place under each pair of forces.
    fn heights(&self, joints: &[Joint]) -> Vec<f64> {
        let table = self.members.iter().find(|own| own.name == "table").map_or([0.0; 2], |own| [own.width, own.height]);
        let piece = |nodes: [usize; 2], [width, height]: [f64; 2]| Member { name: "", nodes, width, height };
        let last = PLACES.len() - 1;
        let mut members: Vec<Member> = self
            .members
            .iter()
            .filter(|own| own.name != "table")
            .map(|own| piece(own.nodes, [own.width, own.height]))
            .collect();
        members.extend([piece([TABLE_ENDS[0], on_table(0)], table), piece([on_table(last), TABLE_ENDS[1]], table)]);
        for i in 0..last {
            members.push(piece([on_table(i), on_table(i + 1)], table));
            members.push(piece([on_plate(i), on_plate(i + 1)], self.plate));
        }
        let support = |place: &usize| Joint {
            name: "",
            nodes: (on_plate(*place), Some(on_table(*place))),
            way: 1,
            stiffness: SUPPORT,
        };
        // Nothing pushes along: whatever holds the plate so changes nothing.
        let along = Joint { name: "", nodes: (on_plate(0), Some(on_table(0))), way: 0, stiffness: 1e8 };
        let all: Vec<Joint> = joints.iter().copied().chain(SUPPORTS.iter().map(support)).chain([along]).collect();
        let matrix = stiffness(&self.nodes, &members, &all);
        let under = |pairs: &[(usize, usize, f64)]| {
            let mut force = vec![0.0; matrix.len()];
            for (up, down, size) in pairs {
                force[3 * up + 1] += size;
                force[3 * down + 1] -= size;
            }
            solve(matrix.clone(), force)
        };
        let of = |[clamp, cutter]: [f64; 2]| {
            let clamps = CLAMPS.map(|place| (on_table(place), on_plate(place), clamp));
            (0..PLACES.len()).map(move |place| (place, [clamps[0], clamps[1], (SPINDLE, on_plate(place), cutter)]))
        };
        let left = |(place, pairs): (usize, [(usize, usize, f64); 3])| {
            let moved = under(&pairs);
            moved[3 * SPINDLE + 1] - moved[3 * on_plate(place) + 1]
        };
        FORCES.into_iter().flat_map(of).map(left).collect()
    }

    /// The model, with the joints as they are meant.
    fn written(&self) -> String {
        let mm = |value: f64| format!("\"{} mm\"", 1e3 * value);
        let at = |place: usize| mm(PLACES[place] * self.length);
        let supports =
            SUPPORTS.map(|place| format!("{{ at = {}, stiffness = \"{} N/um\" }}", at(place), 1e-6 * SUPPORT));
        let clamps = CLAMPS.map(|place| format!("{{ at = {}, force = \"3 kN\" }}", at(place)));
        let mut text = format!(
            "process = \"fixture\"\nsupport = [{}]\nclamp = [{}]\n[workpiece]\nmaterial = \"cast-iron\"\nshear = true\nlength = {}\nwidth = {}\nheight = {}\n",
            supports.join(", "),
            clamps.join(", "),
            mm(self.length),
            mm(self.plate[0]),
            mm(self.plate[1])
        );
        let name = |node: usize| format!("n{node}");
        text += "[structure]\nmaterial = \"cast-iron\"\nports = { supports = \"table\", clamps = \"table\", spindle = \"n8\" }\n[structure.nodes]\n";
        for (node, [x, y]) in self.nodes[..FIRST].iter().enumerate() {
            text += &format!("{} = [{}, {}]\n", name(node), mm(*x), mm(*y));
        }
        self.members.iter().for_each(|member| text += &member.written(name));
        self.joints.iter().for_each(|joint| text += &joint.written(name));
        text
    }
}

/// A machine one of whose joints has a part of its stiffness, seen at this length in the tops of plates.
pub fn soft_joint(seed: u64, lambda: f64) -> SoftJoint {
    let mut random = Random::new("soft mill", seed);
    let mill = Mill::draw(&mut random);
    let joint = JOINTS[random.whole(0, JOINTS.len() - 1)];
    let part = random.uniform(0.25, 0.6);
    let mut joints = mill.joints.clone();
    joints.iter_mut().filter(|own| own.name == joint).for_each(|own| own.stiffness *= part);
    let (meant, real) = (mill.heights(&mill.joints), mill.heights(&joints));
    let change: f64 = meant.iter().zip(&real).map(|(a, b)| (b - a).powi(2)).sum();
    // The noise decides how well it is seen.
    let noise = 1e6 * change.sqrt() / lambda;
    let mut data = String::from("x [mm],clamp_force [N],cutter_force [N],height_error [um],u [um]\n");
    for (i, height) in real.iter().enumerate() {
        let (x, [clamp, cutter]) = (1e3 * PLACES[i % PLACES.len()] * mill.length, FORCES[i / PLACES.len()]);
        data += &format!("{x},{clamp},{cutter},{},{noise}\n", 1e6 * height + noise * random.normal());
    }
    let stiffness = joints.iter().find(|own| own.name == joint).map_or(f64::NAN, |own| 1e-6 * own.stiffness);
    SoftJoint { model: mill.written(), data, joint, stiffness, lambda }
}
