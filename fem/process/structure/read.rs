//! Reads a structure: nodes, members, joints, supports, and what stands on them.

use std::collections::HashSet;

use super::draft::{Draft, Drawn, DrawnSeat, Port, Stand};
use crate::element::{Member, Rectangle, Round, Tube};
use crate::input::{Bounds, Name, Reader, did_you_mean};
use crate::joint::{Contact, Seat};
use crate::material::Material;
use crate::process::estimates;
use crate::solve::MOST_SEATS;
use crate::solve::structure::{Direction, Freedom, Spring};
use crate::units::{CONTACT_COEFFICIENT, FORCE, LENGTH, MICRO, NUMBER, ROTATIONAL_STIFFNESS, STIFFNESS};

/// Members shorter than this have no length, m.
const SHORTEST: f64 = 1e-6;
/// What stands no further beside a node stands on it, m.
const BESIDE: f64 = 0.01;
/// More members and joints than anybody draws.
const MOST: usize = 10_000;
/// The words for directions of forces and dials.
const ACROSS: &[(&str, Direction)] = &[("y", Direction::Y), ("x", Direction::X)];
/// The same with the sense in which a joint is pressed.
const PRESSED: &[(&str, (Direction, f64))] = &[
    ("y", (Direction::Y, 1.0)),
    ("x", (Direction::X, 1.0)),
    ("turning", (Direction::Turn, 1.0)),
    ("-y", (Direction::Y, -1.0)),
    ("-x", (Direction::X, -1.0)),
    ("-turning", (Direction::Turn, -1.0)),
];
/// The table of what stands on it.
const PORTS: &str = "ports";

/// A part of a structure as its table says it.
#[derive(Clone)]
enum Part {
    /// Its ends, the member, its width and height.
    Member([usize; 2], Member, [f64; 2]),
    /// Its spring, and by how much it gives way beside that: pressed along its direction or against it.
    Joint(Spring, Option<(f64, Seat)>),
}

/// A cross-section.
struct Section {
    area: f64,
    inertia: f64,
    /// κA.
    shear_area: f64,
    /// Width and height.
    size: [f64; 2],
}

impl Draft {
    /// Reads the table `[structure]`; `ports` reads what stands on it. `None` where there is none, or where what is drawn
    /// makes none, which is told.
    pub fn read<T>(
        model: &Reader,
        about: &'static str,
        ports: impl FnOnce(&Reader, &mut Self) -> Option<T>,
    ) -> Option<(Drawn, T)> {
        model.optional_table("structure", about, |t| Self::read_own(t, ports)).flatten()
    }

    fn read_own<T>(t: &Reader, ports: impl FnOnce(&Reader, &mut Self) -> Option<T>) -> Option<(Drawn, T)> {
        let mut draft = Self::default();
        let about = "places of the nodes: x along the axis from the headstock, y the way in which the work gives way";
        let nodes = t.table("nodes", about, |t| t.once(|t| t.named_pairs(LENGTH, "x and y of the node")));
        (draft.nodes, draft.structure.nodes) = nodes.into_iter().unzip();
        draft.drawn = draft.nodes.len();
        // Who has no members, or says it of each, need not say it of all.
        let material = (t.has("material") || t.is_described()).then(|| Material::read(t, "material"));
        t.may_be_left_out("material");
        draft.structure.held = draft.read_supports(t);
        let about = "a member (`between`, `section`) or a joint (`at` or `between`, `along`, `stiffness`)";
        let is_other = t.is_on_trial("nodes") || t.is_on_trial("material");
        let drawn = t.own_tables(&[PORTS], about, |_, t| match is_other {
            true => draft.read_part(t, material.as_ref()),
            false => t.once(|t| draft.read_part(t, material.as_ref())),
        });
        if drawn.len() > MOST {
            t.problem("", format!("{} members and joints are more than {MOST}", drawn.len()), "draw fewer");
        }
        for (name, own) in drawn {
            match own {
                Some(Part::Member(ends, member, size)) => {
                    draft.structure.members.push((ends, member));
                    draft.members.push(name);
                    draft.sizes.push(size);
                }
                Some(Part::Joint(spring, seat)) => {
                    let number = draft.structure.springs.len();
                    draft.seats.extend(seat.map(|(sign, law)| DrawnSeat { spring: number, sign, law }));
                    draft.structure.springs.push(spring);
                    draft.joints.push(name);
                }
                None => {}
            }
        }
        if draft.seats.len() > MOST_SEATS {
            let message = format!("{} joints are more than the {MOST_SEATS} that can be no springs", draft.seats.len());
            t.problem("", message, "make springs of those that hardly yield");
        }
        let ports = t.table(PORTS, "what stands where on it: nodes, or members along x", |t| ports(t, &mut draft));
        // What is drawn wrongly holds nothing, and need not be told so.
        if t.is_described() || !t.is_sound() {
            return None;
        }
        Some((draft.factored(t)?, ports?))
    }

    fn read_supports(&self, t: &Reader) -> Vec<Freedom> {
        let clamped = t.texts("clamped", "nodes that neither move nor turn").unwrap_or_default();
        let pinned = t.texts("pinned", "nodes that do not move, but turn").unwrap_or_default();
        let of = |key: &'static str, names: Vec<String>, ways: &[Direction]| {
            let nodes: Vec<usize> = names.iter().filter_map(|name| self.known_node(t, key, name)).collect();
            nodes.into_iter().flat_map(|node| ways.iter().map(move |way| Freedom { node, direction: *way })).collect()
        };
        let all: Vec<Freedom> = of("clamped", clamped, &[Direction::X, Direction::Y, Direction::Turn]);
        [all, of("pinned", pinned, &[Direction::X, Direction::Y])].concat()
    }

    fn read_part(&self, t: &Reader, material: Option<&Material>) -> Option<Part> {
        let between = t.texts("between", "the two nodes that it joins");
        let is_joint = t.has("along") || t.has("at");
        let (mut member, mut joint) = (None, None);
        if !is_joint || t.is_described() {
            member = self.read_member(t, between.as_deref(), material);
        }
        if is_joint || t.is_described() {
            joint = self.read_joint(t, between.as_deref());
        }
        member.or(joint)
    }

    fn read_member(&self, t: &Reader, between: Option<&[String]>, material: Option<&Material>) -> Option<Part> {
        let material = match material {
            Some(other) => Material::read_or(t, "material", other),
            None => Material::read(t, "material"),
        };
        let section = read_section(t, &material);
        if between.is_none() && !t.is_described() {
            let help = "a member has between = [\"NODE\", \"NODE\"] and a section, a joint `at` or `between`, `along` and \
                        `stiffness`";
            t.problem("", "this is neither a member nor a joint", help);
        }
        let [a, b] = self.ends(t, between?)?;
        let [from, to] = [a, b].map(|node| self.structure.nodes[node]);
        let Section { area, inertia, shear_area, size } = section?;
        let member = Member {
            span: [to[0] - from[0], to[1] - from[1]],
            axial_rigidity: material.youngs_modulus * area,
            flexural_rigidity: material.youngs_modulus * inertia,
            shear_rigidity: material.shear_modulus() * shear_area,
        };
        if member.length() < SHORTEST {
            t.problem("between", "the member has no length: its nodes are at one place", "join nodes at two places");
            return None;
        }
        Some(Part::Member([a, b], member, size))
    }

    fn read_joint(&self, t: &Reader, between: Option<&[String]>) -> Option<Part> {
        let at = t.text("at", "the node that it holds against the ground");
        let about = "the direction in which it yields; with a minus, against which it is pressed";
        let (direction, sign) = t.choice("along", about, PRESSED).required((Direction::Y, 1.0));
        let kind = if direction == Direction::Turn { ROTATIONAL_STIFFNESS } else { STIFFNESS };
        let stiffness = t.quantity("stiffness", kind, "stiffness of the joint").estimated(estimates::STIFFNESS);
        let stiffness = stiffness.positive().required();
        let seat = read_seat(t);
        let (node, from) = match (at, between) {
            (Some(at), None) => (self.known_node(t, "at", &at)?, None),
            (None, Some(between)) => self.ends(t, between).map(|[a, b]| (a, Some(b)))?,
            (one, _) => {
                let message = match one {
                    Some(_) => "a joint has one of `at` and `between`, not both",
                    None => "the joint holds nothing",
                };
                let help = "write at = \"NODE\" for a joint to the ground, between = [\"NODE\", \"NODE\"] for one of two nodes";
                t.problem("along", message, help);
                return None;
            }
        };
        Some(Part::Joint(Spring { at: Freedom { node, direction }, from, stiffness }, seat.map(|law| (sign, law))))
    }

    /// The two nodes of `between`.
    fn ends(&self, t: &Reader, between: &[String]) -> Option<[usize; 2]> {
        let [a, b] = between else {
            t.problem("between", "there are two ends", "write between = [\"NODE\", \"NODE\"]");
            return None;
        };
        let (a, b) = (self.known_node(t, "between", a), self.known_node(t, "between", b));
        let [a, b] = [a?, b?];
        if a == b {
            t.problem("between", "both ends are the same node", "name two nodes");
            return None;
        }
        Some([a, b])
    }

    fn known_node(&self, t: &Reader, key: &str, name: &str) -> Option<usize> {
        let node = self.node(name);
        if node.is_none() {
            let meant = did_you_mean(name, self.nodes.iter().map(Name::as_str), '`');
            let all: Vec<&str> = self.nodes.iter().map(Name::as_str).collect();
            t.problem(key, format!("`{name}` is no node"), format!("{meant}nodes are {}", all.join(", ")));
        }
        node
    }

    /// Reads where something pushes or looks: `at` a node, `from` another or the ground, `along` a direction.
    pub fn port(&self, t: &Reader) -> Option<Port> {
        let at = t.text("at", "the node");
        let from = t.text("from", "the node against which it stands; the ground if left out");
        let direction = t.choice("along", "the direction", ACROSS).or_first(Direction::Y);
        let Some(at) = at else {
            t.problem("", "`at` is missing: the node", "add at = \"NODE\"");
            return None;
        };
        let from = from.map(|from| self.known_node(t, "from", &from));
        let node = self.known_node(t, "at", &at)?;
        let from = match from {
            Some(from) => Some(from?),
            None => None,
        };
        Some(Port { at: Freedom { node, direction }, from })
    }

    /// Reads the node on which something stands, along y; `what` ("the cutter is held") is what members would leave open.
    pub fn holder(&self, t: &Reader, key: &'static str, about: &'static str, what: &str) -> Option<Freedom> {
        if !t.has(key) && !t.is_described() {
            t.problem("", format!("`{key}` is missing: {about}"), format!("add {key} = \"NODE\""));
            return None;
        }
        match self.stand(t, key, about)? {
            Stand::Node(node) => Some(Freedom { node, direction: Direction::Y }),
            Stand::Along(_) => {
                t.problem(key, format!("members do not say where on them {what}"), "name a node");
                None
            }
        }
    }

    /// Tells of what stands beside the node that it is said to stand on: what its force turns would be lost.
    pub fn check_place(&self, t: &Reader, key: &str, stand: &Stand, x: f64) {
        let Stand::Node(node) = stand else { return };
        let at = self.structure.nodes[*node][0];
        if (at - x).abs() <= BESIDE || !t.is_as_written() {
            return;
        }
        let (name, [at, x]) = (&self.nodes[*node], [at, x].map(|own| LENGTH.format(own)));
        let message = format!("`{key}` is the node `{name}` at x = {at}, and what stands there is at x = {x}");
        let help =
            "name the node at its place, or members along x; a force beside a node would turn it, which is not seen";
        t.problem(key, message, help);
    }

    /// Reads what something stands on: a node, or members along x. Told where it is missing.
    pub fn stand(&self, t: &Reader, key: &'static str, about: &'static str) -> Option<Stand> {
        let Some(names) = t.texts(key, about) else {
            t.problem("", format!("`{key}` is missing: {about}"), format!("add {key} = \"NODE\", or members along x"));
            return None;
        };
        if let [one] = &names[..]
            && let Some(node) = self.node(one)
        {
            return Some(Stand::Node(node));
        }
        let drawn: HashSet<&str> = self.members.iter().map(Name::as_str).collect();
        for name in &names {
            if !drawn.contains(name.as_str()) {
                let known: Vec<&str> = self.nodes.iter().chain(&self.members).map(Name::as_str).collect();
                let meant = did_you_mean(name, known.iter().copied(), '`');
                if self.node(name).is_some() {
                    let message = format!("`{name}` is a node, and a list is of members along x");
                    t.problem(key, message, format!("name one node alone, {key} = \"{name}\", or members alone"));
                    return None;
                }
                let message = format!("`{name}` is neither a node nor a member");
                t.problem(key, message, format!("{meant}known are {}", known.join(", ")));
                return None;
            }
        }
        let members: Vec<Name> = names.into_iter().map(Name::from).collect();
        for piece in self.pieces(&members) {
            let [across_x, across_y] = self.structure.members[piece].1.span.map(f64::abs);
            if across_x <= 1e-3 * across_y {
                let name = &self.members[piece];
                let help = "what stands along members has its place by its x: name members along x, or a node";
                t.problem(key, format!("`{name}` stands upright: no place on it has an x of its own"), help);
                return None;
            }
        }
        Some(Stand::Along(members))
    }
}

/// Reads by how much a joint gives way beside its spring, if it is no spring alone.
fn read_seat(t: &Reader) -> Option<Seat> {
    let c =
        t.quantity("c", CONTACT_COEFFICIENT, "coefficient of its contact, y = c*Q^n under the force Q that presses it");
    let c = c.estimated(estimates::CONTACT).not_negative().optional();
    let n = t.quantity("n", NUMBER, "exponent of the contact").bounds(Bounds::Within(0.0, 1.0)).or(0.5);
    let preload = t.quantity("preload", FORCE, "force that holds the contact together without a load");
    let preload = preload.estimated(estimates::PRELOAD).not_negative().or(0.0);
    let gap = t.quantity("gap", MICRO, "clearance, from the one flank to the other").estimated(estimates::CLEARANCE);
    let gap = gap.not_negative().optional();
    match (c, gap) {
        (Some(_), Some(_)) => {
            t.problem("gap", "a joint is a contact or has clearance, not both", "draw two joints behind one another");
            None
        }
        (Some(coefficient), None) => Some(Seat::Contact(Contact { coefficient, exponent: n }, preload)),
        (None, gap) => {
            if let Some(key) = ["n", "preload"].into_iter().find(|key| t.has(key) && !t.is_described()) {
                t.problem(
                    key,
                    "there is no contact",
                    "a contact has `c`, `n` and `preload`; leave it out beside a `gap`",
                );
            }
            gap.map(Seat::Clearance)
        }
    }
}

/// Reads the section of a member of this material.
fn read_section(t: &Reader, material: &Material) -> Option<Section> {
    let diameter = t.quantity("diameter", LENGTH, "outer diameter of a round section").positive().optional();
    let bore = t.quantity("bore", LENGTH, "diameter of its bore").not_negative().optional();
    let width = t.quantity("width", LENGTH, "width of a rectangular section, across the plane").positive().optional();
    let height = t.quantity("height", LENGTH, "height of it, in the plane").positive().optional();
    let wall = t.quantity("wall", LENGTH, "thickness of its wall, where it is hollow").positive().optional();
    let nu = material.poisson_ratio;
    let section =
        |area: f64, inertia: f64, kappa: f64, size: [f64; 2]| Section { area, inertia, shear_area: kappa * area, size };
    match (diameter, width.zip(height)) {
        (Some(diameter), None) if width.or(height).or(wall).is_none() => {
            let round = Round { diameter, bore: bore.unwrap_or(0.0) };
            if round.bore >= diameter {
                t.problem("bore", "the bore is as wide as the section or wider", "it must be below the diameter");
            }
            Some(section(round.area(), round.inertia(), round.shear_coefficient(nu), [diameter; 2]))
        }
        (None, Some((width, height))) if bore.is_none() => {
            let (outline, size) = (Rectangle { width, height }, [width, height]);
            let Some(wall) = wall else {
                return Some(section(outline.area(), outline.inertia(), outline.shear_coefficient(nu), size));
            };
            if 2.0 * wall >= width.min(height) {
                t.problem("wall", "the walls are thicker than the section", "leave `wall` out for a solid section");
            }
            let tube = Tube { outline, wall };
            Some(section(tube.area(), tube.inertia(), tube.shear_coefficient(nu), size))
        }
        _ => {
            let help = "give `diameter` (and `bore`), or `width` and `height` (and `wall`)";
            t.problem("", "the member has no section, or more than one", help);
            None
        }
    }
}
