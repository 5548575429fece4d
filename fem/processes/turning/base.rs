//! What headstock, tailstock, steady rests and tool stand on: a structure of the user's own.

use crate::input::Reader;
use crate::process::structure::{Draft, Drawn, NEAR, Stand};
use crate::solve::structure::{Along, Chain, Direction, Displaced, Freedom, Seen};
use crate::solve::{Foundation, Rest, Seats};
use crate::units::LENGTH;
use nalgebra::DMatrix;

/// The machine under the shaft as a plane structure in the plane of the axis and the radial force.
pub struct Base {
    /// The structure.
    pub drawn: Drawn,
    ports: Ports,
}

/// What stands on a structure.
struct Ports {
    /// Headstock, tailstock, the headstock's turning, the feet of the rests; what there is not is `None`.
    supports: Vec<Option<Freedom>>,
    tool: Carriage,
}

/// Where the tool stands.
enum Carriage {
    /// At a node, wherever it cuts.
    Node(usize),
    /// On members, along which it travels.
    Along(Chain),
}

impl Base {
    /// Reads the structure under a shaft of such a length (m), with a tailstock or without, if there is one.
    pub fn read(model: &Reader, length: f64, tailstock: bool, rests: &[Rest]) -> Option<Self> {
        let about = "the machine under the shaft: beams and joints in the plane of axis and radial force";
        let (drawn, ports) = Draft::read(model, about, |t, draft| Ports::read(t, draft, length, tailstock, rests))?;
        Some(Self { drawn, ports })
    }

    /// What a shaft sees of it with the tool at each of the positions (m).
    pub fn foundation(&self, positions: &[f64]) -> Foundation {
        let Drawn { factored, seats, .. } = &self.drawn;
        let ports = &self.ports.supports;
        let still = vec![0.0; 3 * factored.structure().nodes.len()];
        let pairs: Vec<Vec<(Freedom, f64)>> = seats.iter().map(|seat| self.drawn.pair(seat)).collect();
        // Displacements of all freedoms under unit loads on supports and seats.
        let of_supports: Vec<Vec<f64>> =
            ports.iter().map(|own| own.map_or_else(|| still.clone(), |own| factored.under(&[(own, 1.0)]))).collect();
        let of_seats: Vec<Vec<f64>> = pairs.iter().map(|pair| factored.under(pair)).collect();
        let seat = |i: usize, moved: &[f64]| pairs[i].iter().map(|(at, sign)| sign * moved[at.number()]).sum::<f64>();
        let support = |i: usize, moved: &[f64]| ports[i].map_or(0.0, |own: Freedom| moved[own.number()]);
        let (count, among) = (ports.len(), seats.len());
        let displaced: Vec<&[f64]> = of_supports.iter().chain(&of_seats).map(Vec::as_slice).collect();
        let (mut cross, mut tool, mut seats_to_tool) = (Vec::new(), Vec::new(), Vec::new());
        for Seen { own, mut others } in self.tool_sees(positions, &displaced) {
            seats_to_tool.push(others.split_off(count));
            cross.push(others);
            tool.push(own);
        }
        Foundation {
            supports: DMatrix::from_fn(count, count, |i, j| {
                0.5 * (support(i, &of_supports[j]) + support(j, &of_supports[i]))
            }),
            cross,
            tool,
            seats: Seats {
                laws: seats.iter().map(|seat| seat.law).collect(),
                stiffness: seats.iter().map(|seat| self.drawn.stiffness(seat)).collect(),
                to_supports: DMatrix::from_fn(among, count, |i, j| seat(i, &of_supports[j])),
                among: DMatrix::from_fn(among, among, |i, j| seat(i, &of_seats[j])),
                cross: seats_to_tool,
            },
        }
    }

    /// What the tool sees of itself and of some displacements at each of the positions (m).
    fn tool_sees(&self, positions: &[f64], displaced: &[&[f64]]) -> Vec<Seen> {
        let factored = &self.drawn.factored;
        match &self.ports.tool {
            Carriage::Node(node) => {
                let freedom = Freedom { node: *node, direction: Direction::Y };
                let own = factored.under(&[(freedom, 1.0)])[freedom.number()];
                let others = displaced.iter().map(|moved| moved[freedom.number()]).collect();
                vec![Seen { own, others }; positions.len()]
            }
            Carriage::Along(chain) => {
                let along = Along::new(factored, chain);
                // The chain was asked to reach along the whole shaft.
                let still = || Seen { own: 0.0, others: vec![0.0; displaced.len()] };
                positions.iter().map(|x| along.at(*x, displaced.iter().copied()).unwrap_or_else(still)).collect()
            }
        }
    }

    /// The structure under the forces (N) on its supports, in the order of
    /// [`Condensed::reactions_under`](crate::solve::Condensed::reactions_under), the tool's force (N) at x (m), and seats that have given way (m).
    pub fn under(&self, reactions: &[f64], x: f64, force: f64, seats: &[f64]) -> Displaced<'_> {
        let Ports { supports, tool } = &self.ports;
        let on_supports = supports.iter().zip(reactions).filter_map(|(own, force)| Some(((*own)?, *force)));
        let mut at_nodes: Vec<(Freedom, f64)> = on_supports.collect();
        let mut inside = Vec::new();
        match tool {
            Carriage::Node(node) => at_nodes.push((Freedom { node: *node, direction: Direction::Y }, -force)),
            Carriage::Along(chain) => inside.extend(chain.load(self.drawn.factored.structure(), x, -force)),
        }
        self.drawn.factored.displaced(&at_nodes, &inside, &self.drawn.feet(seats))
    }
}

impl Ports {
    fn read(t: &Reader, draft: &mut Draft, length: f64, has_tailstock: bool, rests: &[Rest]) -> Option<Self> {
        let node = |draft: &mut Draft, key: &'static str, stand: &Stand, x: f64| {
            let node = draft.node_at(stand, x);
            if node.is_none() {
                off(t, draft, key, stand, [x, x]);
            }
            node
        };
        let mut stands = |key: &'static str, about: &'static str, places: &[f64]| -> Option<Vec<usize>> {
            let stand = draft.stand(t, key, about)?;
            places.iter().for_each(|x| draft.check_place(t, key, &stand, *x));
            places.iter().map(|x| node(draft, key, &stand, *x)).collect()
        };
        let headstock = stands("headstock", "what the headstock stands on, at x = 0", &[0.0]);
        let is_asked = |needed: bool, key: &'static str| needed || t.has(key) || t.is_described();
        let tailstock = if is_asked(has_tailstock, "tailstock") {
            stands("tailstock", "what the tailstock stands on, at the end of the shaft", &[length])
        } else {
            Some(Vec::new())
        };
        let feet: Vec<f64> = rests.iter().map(|rest| rest.at).collect();
        let feet = if is_asked(!rests.is_empty(), "rests") {
            stands("rests", "what the steady rests stand on", &feet)
        } else {
            Some(Vec::new())
        };
        let about = "what the carriage stands on: members along which it travels, or a node";
        let tool = draft.stand(t, "tool", about);
        let offset = t.quantity("tool_offset", LENGTH, "from the tool to the middle of its carriage, along x").or(0.0);
        let (headstock, tailstock, feet) = (headstock?, tailstock?, feet?);
        let tool = match tool? {
            Stand::Node(node) => Carriage::Node(node),
            Stand::Along(members) => {
                let (from, to) = (offset, length + offset);
                let mut reach = draft.reach(&members).into_iter();
                if !reach.any(|(low, high)| from >= low - NEAR && to <= high + NEAR) {
                    off(t, draft, "tool", &Stand::Along(members), [from, to]);
                    return None;
                }
                Carriage::Along(Chain { members: draft.pieces(&members), offset })
            }
        };
        let y = |node: usize| Some(Freedom { node, direction: Direction::Y });
        let head = *headstock.first()?;
        let turn = Some(Freedom { node: head, direction: Direction::Turn });
        let ends = [y(head), tailstock.first().and_then(|node| y(*node)), turn];
        let supports = ends.into_iter().chain(feet.into_iter().map(y)).collect();
        Some(Self { supports, tool })
    }
}

/// Tells that something stands beyond the ends of its members.
fn off(t: &Reader, draft: &Draft, key: &str, stand: &Stand, [from, to]: [f64; 2]) {
    let Stand::Along(members) = stand else { return };
    let at = match from == to {
        true => format!("stands at x = {}", LENGTH.format(from)),
        false => format!("travels from x = {} to {}", LENGTH.format(from), LENGTH.format(to)),
    };
    let message = format!("`{key}` {at}, and its members go {}", draft.reach_in_words(members));
    t.problem(
        key,
        message,
        "name members that go as far, or draw them longer; x begins at the shaft's end in the headstock",
    );
}
