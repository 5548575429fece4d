use super::*;
use crate::element::plane::{ALL, Quad4, Quad8, Sampled, Tri3};

fn ring(element: &'static dyn PlaneElement, toward: Vec<f64>) -> RingMesh {
    let grading = Grading { toward, ratio: 4.0, reach: 0.3 };
    RingMesh { outer_radius: 0.05, inner_radius: 0.04, circumferential: 48, radial: 2, element, grading }
}

fn area(mesh: &Mesh) -> f64 {
    let own = |element: Element<'_>| Sampled::new(element.kind).area(&mesh.coordinates(element)[..element.nodes.len()]);
    mesh.elements().map(own).sum()
}

#[test]
fn rings_have_their_area_and_sides() {
    for element in ALL {
        let mesh = ring(*element, vec![]).build().unwrap();
        let exact = std::f64::consts::PI * (0.05_f64.powi(2) - 0.04_f64.powi(2));
        let tolerance = if element.edges()[0].len() == 3 { 1e-6 } else { 3e-3 };
        assert!((area(&mesh) / exact - 1.0).abs() < tolerance, "{element:?} {}", area(&mesh) / exact - 1.0);
        for (name, radius) in [(OUTSIDE, 0.05), (BORE, 0.04)] {
            assert_eq!(mesh.sides(name).unwrap().len(), 48, "{element:?}");
            for node in mesh.nodes_on(name).unwrap() {
                let [x, y] = mesh.nodes()[node as usize];
                assert!((x.hypot(y) - radius).abs() < 1e-15);
            }
        }
        assert_eq!(mesh.connected(), Ok(()));
    }
}

#[test]
fn graded_cells_end_at_the_given_angles_and_shrink_there() {
    let toward = vec![0.1, 2.2, 4.3];
    let borders = Grading { toward: toward.clone(), ratio: 4.0, reach: 0.3 }.circle(48).unwrap();
    assert_eq!(borders.len(), 49);
    for angle in toward {
        assert!(borders.iter().any(|border| (border - angle).abs() < 1e-12), "{angle}: {borders:?}");
    }
    let sizes: Vec<f64> = borders.windows(2).map(|ends| ends[1] - ends[0]).collect();
    let (small, large) = sizes.iter().fold((f64::MAX, 0.0_f64), |(s, l), &x| (s.min(x), l.max(x)));
    assert!(large / small > 2.5 && large / small < 4.5, "{}", large / small);
    ring(&Quad8, vec![0.1, 2.2, 4.3]).build().unwrap();
}

#[test]
fn stepped_bodies_have_their_area_and_faces() {
    let pieces = [(0.05, 0.045), (0.12, 0.02), (0.06, 0.045), (0.07, 0.015)];
    for element in ALL {
        let mesh = SteppedMesh { pieces: &pieces, size: 0.008, element: *element }.build().unwrap();
        let exact: f64 = pieces.iter().map(|(length, height)| length * height).sum();
        assert!((area(&mesh) / exact - 1.0).abs() < 1e-13, "{element:?}");
        assert_eq!(mesh.connected(), Ok(()));
        let length = |name: &str| mesh.sides(name).unwrap().iter().map(|&side| mesh.curve(side).length()).sum::<f64>();
        // The walls of the steps are ends too.
        for (name, expected) in [("underside", 0.3), ("top", 0.3), ("ends", 0.045 + 2.0 * 0.025 + 0.03 + 0.015)] {
            assert!((length(name) - expected).abs() < 1e-13, "{element:?} {name} {}", length(name));
        }
        for node in mesh.nodes_on("top").unwrap() {
            let [x, y] = mesh.nodes()[node as usize];
            assert!(pieces.iter().any(|(_, height)| (y - height).abs() < 1e-15), "{x} {y}");
        }
        assert_eq!(mesh.boundary().len(), mesh.names().map(|name| mesh.sides(name).unwrap().len()).sum::<usize>());
    }
    let flat = SteppedMesh { pieces: &[(0.1, 0.0)], size: 0.01, element: &Quad4 };
    assert!(flat.build().unwrap_err().to_string().contains("height"));
}

#[test]
fn rectangles_have_their_sides() {
    for element in ALL {
        let mesh = RectangleMesh::uniform([0.6, 1.0], [3, 5], *element).build().unwrap();
        assert!((area(&mesh) - 0.6).abs() < 1e-14);
        for (name, count, at) in [("bottom", 3, [0.3, 0.0]), ("right", 5, [0.6, 0.5]), ("top", 3, [0.3, 1.0])] {
            let sides = mesh.sides(name).unwrap();
            assert_eq!(sides.len(), count, "{element:?} {name}");
            let length: f64 = sides.iter().map(|&side| mesh.curve(side).length()).sum();
            assert!((length - if name == "right" { 1.0 } else { 0.6 }).abs() < 1e-14);
            let middle = mesh.curve(sides[count / 2]).point(0.0);
            assert!((middle[0] - at[0]).hypot(middle[1] - at[1]) < 1e-14, "{middle:?}");
        }
    }
    assert!(matches!(ring(&Tri3, vec![]).build().unwrap().sides("left"), Err(MeshError::UnknownName { .. })));
}

#[test]
fn errors_name_the_element() {
    let nodes = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [5.0, 0.0], [6.0, 0.0], [5.0, 1.0]];
    let build = |nodes: &[[f64; 2]], quads: &[u32], triangles: &[u32]| {
        let blocks = vec![Block::new(&Quad4, quads.to_vec()), Block::new(&Tri3, triangles.to_vec())];
        Mesh::new(nodes.to_vec(), blocks, BTreeMap::new())
    };
    let apart = build(&nodes, &[0, 1, 2, 3], &[4, 5, 6]).unwrap();
    assert_eq!(
        apart.connected().unwrap_err().to_string(),
        "the mesh falls into 2 pieces: element 1 is not connected to element 0"
    );
    let turned = build(&nodes, &[0, 1, 2, 3], &[4, 6, 5]).unwrap_err();
    assert!(turned.to_string().starts_with("element 1 (tri3) near (5.000000, 0.000000) m is inside out"), "{turned}");
    let unused = build(&nodes, &[0, 1, 2, 3], &[]).unwrap_err();
    assert_eq!(unused.to_string(), "node 4 at (5.000000, 0.000000) m belongs to no element");
    assert!(matches!(build(&nodes, &[0, 1, 2, 9], &[]), Err(MeshError::UnknownNode { element: 0, node: 9, last: 6 })));
    assert!(matches!(build(&nodes, &[0, 1, 2], &[]), Err(MeshError::Ragged { .. })));
    assert!(matches!(build(&nodes, &[], &[]), Err(MeshError::Empty)));
    let flat = build(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]], &[], &[0, 1, 2]).unwrap_err();
    assert!(matches!(flat, MeshError::Inverted { element: 0, .. }), "{flat}");
}

#[test]
fn the_border_of_a_ring_is_its_bore_and_its_outside() {
    for element in ALL {
        let mut mesh = ring(*element, vec![]).build().unwrap();
        assert_eq!(mesh.boundary().len(), 96, "{element:?}");
        mesh.name_rest("rest", &[BORE]).unwrap();
        let sorted = |name: &str| {
            let mut sides = mesh.sides(name).unwrap().to_vec();
            sides.sort_unstable();
            sides
        };
        assert_eq!(sorted("rest"), sorted(OUTSIDE), "{element:?}");
    }
}

/// A point is its element's nodes weighed by their shape functions, and they find it again; beside the body
/// there is nothing.
#[test]
fn points_are_found_in_their_element() {
    for element in ALL {
        let mesh = ring(*element, vec![0.1]).build().unwrap();
        for i in 0..50 {
            let (angle, radius) = (0.3 + 0.7 * f64::from(i), 0.0401 + 0.0098 * f64::from(i % 10) / 10.0);
            let point = [radius * angle.cos(), radius * angle.sin()];
            let place = mesh.locate(point).unwrap_or_else(|| panic!("{element:?} {point:?}"));
            let found = [0, 1].map(|axis| place.shares.iter().map(|(n, s)| s * mesh.nodes()[*n][axis]).sum::<f64>());
            assert!((found[0] - point[0]).hypot(found[1] - point[1]) < 1e-14, "{element:?} {point:?} {found:?}");
        }
        assert_eq!(mesh.locate([0.0, 0.0]), None);
        assert_eq!(mesh.locate([0.06, 0.0]), None);
    }
}

/// A shoulder borders the outside or the bore; a solid length has its axis.
#[test]
fn bodies_of_revolution_have_their_sides() {
    let wall = |length: f64, radii: [f64; 2]| Wall { length, radii };
    let walls = vec![wall(0.04, [0.02, 0.05]), wall(0.06, [0.02, 0.035]), wall(0.03, [0.0, 0.03])];
    for element in ALL {
        let revolved =
            RevolvedMesh { walls: walls.clone(), size: 0.01, sections: vec![0.047, 0.04], element: *element };
        let mesh = revolved.build().unwrap();
        assert!((area(&mesh) - (0.04 * 0.03 + 0.06 * 0.015 + 0.03 * 0.03)).abs() < 1e-15, "{element:?}");
        let cells = revolved.cells();
        assert_eq!(
            mesh.element_count() as f64,
            if element.corners() == 4 { cells } else { 2.0 * cells },
            "{element:?}"
        );
        let along = |name: &str| -> f64 { mesh.sides(name).unwrap().iter().map(|s| mesh.curve(*s).length()).sum() };
        for (name, length) in [
            (LEFT, 0.03),
            (RIGHT, 0.03),
            (OUTSIDE, 0.04 + 0.015 + 0.06 + 0.005 + 0.03),
            (BORE, 0.04 + 0.06 + 0.02),
            ("axis", 0.03),
        ] {
            assert!((along(name) - length).abs() < 1e-14, "{element:?} {name}: {}", along(name));
        }
        assert!(mesh.nodes().iter().any(|node| (node[0] - 0.047).abs() < 1e-15), "{element:?}");
    }
    let apart = vec![wall(0.04, [0.03, 0.05]), wall(0.04, [0.0, 0.02])];
    let apart = RevolvedMesh { walls: apart, size: 0.01, sections: Vec::new(), element: &Quad8 };
    assert!(matches!(apart.build(), Err(MeshError::Disconnected { .. })));
    let turned = RevolvedMesh { walls: vec![wall(0.04, [0.05, 0.03])], ..apart };
    assert!(matches!(turned.build(), Err(MeshError::Parameter { .. })));
}
