//! Structures against closed forms, against the plain solve of a shaft, and by laws that hold for all of them.

use super::*;
use crate::element::BeamPiece;
use crate::solve::frame::Frame;

const EA: f64 = 4e8;
const EI: f64 = 2e6;

fn member(nodes: &[[f64; 2]], ends: [usize; 2]) -> ([usize; 2], Member) {
    let [a, b] = ends.map(|own| nodes[own]);
    let span = [b[0] - a[0], b[1] - a[1]];
    (ends, Member { span, axial_rigidity: EA, flexural_rigidity: EI, shear_rigidity: f64::INFINITY })
}

fn freedom(node: usize, direction: Direction) -> Freedom {
    Freedom { node, direction }
}

fn clamped(node: usize) -> [Freedom; 3] {
    [Direction::X, Direction::Y, Direction::Turn].map(|direction| freedom(node, direction))
}

/// Portal frame with clamped feet, a load H along the girder, no member longer or shorter: the columns' ends move by
/// u = H h³/(12 EI)·(2 + 3k)/(1 + 6k), k = h/l of equal sections: slope deflection, where each column has 4θ EI/h − 6u EI/h² at
/// its top, the girder 6θ EI/l, and the shears of both columns are H.
#[test]
fn a_portal_frame_sways_as_slope_deflection_says() {
    let (l, h) = (2.0, 1.5);
    let nodes = vec![[0.0, 0.0], [0.0, h], [l, h], [l, 0.0]];
    let stiff = |ends| {
        let (ends, member) = member(&nodes, ends);
        (ends, Member { axial_rigidity: 1e6 * EA, ..member })
    };
    let members = [[0, 1], [1, 2], [2, 3]].map(stiff).to_vec();
    let held = [clamped(0), clamped(3)].concat();
    let portal = Structure { members, held, nodes: nodes.clone(), ..Structure::default() };
    let found = portal.factored().unwrap().compliance(&[freedom(1, Direction::X)])[(0, 0)];
    let k = h / l;
    let expected = h.powi(3) / (12.0 * EI) * (2.0 + 3.0 * k) / (1.0 + 6.0 * k);
    assert!((found / expected - 1.0).abs() < 1e-5, "{found} {expected}");
}

/// A straight beam on springs is the shaft of the plain solve, at nodes and between them.
#[test]
fn a_straight_structure_is_a_shaft() {
    let piece = BeamPiece { length: 0.4, flexural_rigidity: EI, shear_rigidity: 3e7 };
    let shaft = Frame::new(&[piece; 4]).unwrap();
    let shaft = shaft.translational_spring(0, 6e7).unwrap().translational_spring(4, 4e7).unwrap();
    let nodes: Vec<[f64; 2]> = (0..3).map(|i| [0.8 * f64::from(i), 0.0]).collect();
    let beam = |ends| {
        let (ends, member) = member(&nodes, ends);
        (ends, Member { shear_rigidity: 3e7, ..member })
    };
    let springs =
        [(0, 6e7), (2, 4e7)].map(|(node, stiffness)| Spring { at: freedom(node, Direction::Y), from: None, stiffness });
    let structure = Structure {
        members: vec![beam([0, 1]), beam([1, 2])],
        springs: springs.to_vec(),
        held: vec![freedom(0, Direction::X)],
        nodes: nodes.clone(),
    };
    let factored = structure.factored().unwrap();
    let ends = [freedom(0, Direction::Y), freedom(2, Direction::Y)];
    let chain = Chain { members: vec![0, 1], offset: 0.0 };
    let (along, of_ends) = (Along::new(&factored, &chain), factored.under_each(&ends));
    let at = |x| along.at(x, of_ends.iter().map(Vec::as_slice));
    for (node, x) in [(0, 0.0), (1, 0.4), (2, 0.8), (3, 1.2), (4, 1.6)] {
        let plain = shaft.solve(&[(node, 1.0)]).unwrap().displacement;
        let seen = at(x).unwrap();
        for (found, expected) in [(seen.own, plain[node]), (seen.others[0], plain[0]), (seen.others[1], plain[4])] {
            assert!((found - expected).abs() < 1e-10 * plain[node].abs(), "{x}: {found} {expected}");
        }
    }
    assert_eq!(at(1.7), None);
}

/// Maxwell and Betti, and the balance of a moved ground: a structure on springs follows what its ground does.
#[test]
fn compliance_is_symmetric_and_positive() {
    let nodes = vec![[0.0, 0.0], [0.7, 0.1], [1.1, 0.8], [0.2, 0.9]];
    let members = [[0, 1], [1, 2], [2, 3], [3, 0], [1, 3]].map(|ends| member(&nodes, ends)).to_vec();
    let spring = |node, direction, stiffness| Spring { at: freedom(node, direction), from: None, stiffness };
    let springs = vec![
        spring(0, Direction::X, 3e7),
        spring(0, Direction::Y, 5e7),
        spring(1, Direction::Y, 2e7),
        Spring { at: freedom(2, Direction::Turn), from: Some(3), stiffness: 1e5 },
    ];
    let structure = Structure { nodes, members, springs, held: Vec::new() };
    let factored = structure.factored().unwrap();
    let all: Vec<Freedom> = (0..4).flat_map(clamped).collect();
    let compliance = factored.compliance(&all);
    for (i, own) in all.iter().enumerate() {
        let under = factored.under(&[(*own, 1.0)]);
        for (j, other) in all.iter().enumerate() {
            let size = (compliance[(i, i)] * compliance[(j, j)]).sqrt();
            assert!((under[other.number()] - compliance[(i, j)]).abs() < 1e-10 * size);
        }
    }
    assert!(compliance.cholesky().is_some());
}

#[test]
fn what_nothing_holds_is_named() {
    let nodes = vec![[0.0, 0.0], [1.0, 0.0], [2.0, 0.5]];
    let spring = |node, direction| Spring { at: freedom(node, direction), from: None, stiffness: 5e7 };
    let of = |members: &[[usize; 2]], springs: &[Spring]| {
        let members = members.iter().map(|ends| member(&nodes, *ends)).collect();
        let structure = Structure { nodes: nodes.clone(), members, springs: springs.to_vec(), held: Vec::new() };
        structure.factored().err()
    };
    let [x, y, far] = [spring(0, Direction::X), spring(0, Direction::Y), spring(2, Direction::Y)];
    assert_eq!(of(&[[0, 1], [1, 2]], &[x, y, far]), None);
    // It turns about the first node, the far end moves most, and the middle half as far.
    let turning = Some(StructureError::Loose { at: freedom(2, Direction::Y), nodes: 2 });
    assert_eq!(of(&[[0, 1], [1, 2]], &[x, y]), turning);
    assert!(matches!(
        of(&[[0, 1], [1, 2]], &[y, far]),
        Some(StructureError::Loose { at: Freedom { direction: Direction::X, .. }, .. })
    ));
    // A node that no member joins.
    assert!(matches!(of(&[[0, 1]], &[x, y, far]), Some(StructureError::Loose { .. })));
}

/// A force within a member, its line and its energy: the line passes through what the force moves, and half of force times
/// way is what members and springs have taken up.
#[test]
fn a_force_within_a_member_does_the_work_that_is_taken_up() {
    let nodes = vec![[0.0, 0.0], [0.7, 0.0], [1.1, 0.3], [0.2, -0.9]];
    let members = [[0, 1], [1, 2], [2, 3]].map(|ends| member(&nodes, ends)).to_vec();
    let springs = vec![Spring { at: freedom(0, Direction::Y), from: Some(3), stiffness: 3e7 }];
    let factored = Structure { nodes, members, springs, held: clamped(3).to_vec() }.factored().unwrap();
    for offset in [0.0, 0.05, -0.03] {
        let chain = Chain { members: vec![0], offset };
        let along_x = factored.under(&[(freedom(2, Direction::X), 1.0)]);
        let seen = Along::new(&factored, &chain).at(0.3, [&along_x[..]]).unwrap();
        let load = chain.load(factored.structure(), 0.3, 500.0).unwrap();
        let displaced = factored.displaced(&[], &[load], &[]);
        let line = displaced.line(0, 6);
        let (members, springs) = displaced.energies();
        let work: f64 = members.iter().chain(&springs).sum();
        assert!((work / (0.5 * 500.0 * 500.0 * seen.own) - 1.0).abs() < 1e-10, "{offset}");
        assert!((displaced.node(2)[0] / (500.0 * seen.others[0]) - 1.0).abs() < 1e-10);
        let under = line.iter().find(|(place, _)| (place[0] - 0.3 - offset).abs() < 1e-12).unwrap();
        let slope = (seen.own * 500.0 - under.1[1]).abs();
        assert!(if offset == 0.0 { slope < 1e-15 } else { slope > 0.0 });
        let ends = [line[0].1, line[6].1];
        assert!((0..2).all(|k| (ends[0][k] - displaced.node(0)[k]).abs() < 1e-15));
        assert!((0..2).all(|k| (ends[1][k] - displaced.node(1)[k]).abs() < 1e-15));
    }
}
