use super::*;

/// Two quad4 and two tri3 over 2 × 1, the second quad clockwise, node tags dense but out of order, a stray
/// point.
const TEXT: &str = r#"$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 7 "jaw-1"
2 9 "body"
$EndPhysicalNames
$Entities
1 2 1 0
1 0 0 0 0
5 0 0 0 2 0 0 1 7 2 1 -2
6 0 0 0 2 0 0 0 2 1 -2
1 0 0 0 2 1 0 1 9 1 5
$EndEntities
$Nodes
3 8 1 8
0 1 0 1
8
0.5 0.5 0
1 5 0 3
3
1
2
0 0 0
1 0 0
2 0 0
2 1 1 4
4
7
6
5
0 1 0 0.1 0.2
1 1 0 0.1 0.2
2 1 0 0.1 0.2
2 2 0 0.1 0.2
$EndNodes
$Elements
4 6 1 6
0 1 15 1
1 8
1 5 1 2
2 3 1
3 1 2
2 1 3 2
4 3 1 7 4
5 1 7 6 2
2 1 2 1
6 7 6 5
$EndElements
"#;

/// The same file in binary.
fn binary(big: bool) -> Vec<u8> {
    let mut bytes = b"$MeshFormat\n4.1 1 8\n".to_vec();
    let int = |value: i32| if big { value.to_be_bytes() } else { value.to_le_bytes() };
    let size = |value: u64| if big { value.to_be_bytes() } else { value.to_le_bytes() };
    let float = |value: f64| if big { value.to_be_bytes() } else { value.to_le_bytes() };
    bytes.extend(int(1));
    bytes.extend(b"\n$EndMeshFormat\n$PhysicalNames\n1\n1 7 \"jaw-1\"\n$EndPhysicalNames\n$Entities\n");
    [0, 1, 0, 0].iter().for_each(|&count| bytes.extend(size(count)));
    bytes.extend(int(5));
    [0.0; 6].iter().for_each(|&x| bytes.extend(float(x)));
    bytes.extend(size(1));
    bytes.extend(int(7));
    bytes.extend(size(0));
    bytes.extend(b"\n$EndEntities\n$Nodes\n");
    [1, 3, 1, 3].iter().for_each(|&count| bytes.extend(size(count)));
    [2, 1, 0].iter().for_each(|&value| bytes.extend(int(value)));
    [3, 3, 1, 2].iter().for_each(|&count| bytes.extend(size(count)));
    [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0].iter().for_each(|&x| bytes.extend(float(x)));
    bytes.extend(b"\n$EndNodes\n$Elements\n");
    [2, 2, 1, 2].iter().for_each(|&count| bytes.extend(size(count)));
    [1, 5, 1].iter().for_each(|&value| bytes.extend(int(value)));
    [1, 1, 3, 1].iter().for_each(|&count| bytes.extend(size(count)));
    [2, 1, 2].iter().for_each(|&value| bytes.extend(int(value)));
    [1, 2, 3, 1, 2].iter().for_each(|&count| bytes.extend(size(count)));
    bytes.extend(b"\n$EndElements\n");
    bytes
}

fn area(mesh: &Mesh) -> f64 {
    mesh.elements().map(|own| Sampled::new(own.kind).area(&mesh.coordinates(own)[..own.nodes.len()])).sum()
}

#[test]
fn text_with_mixed_elements_and_tags_out_of_order() {
    let mesh = read_gmsh(TEXT.as_bytes(), 1e-3).unwrap();
    assert_eq!((mesh.nodes().len(), mesh.element_count(), mesh.blocks().len()), (7, 3, 2));
    assert!((area(&mesh) - 2.5e-6).abs() < 1e-18);
    let jaw = mesh.sides("jaw-1").unwrap();
    let length: f64 = jaw.iter().map(|&side| mesh.curve(side).length()).sum();
    assert!((length - 2e-3).abs() < 1e-15);
    // the body lies to the left of every side
    assert!(jaw.iter().all(|&side| mesh.curve(side).tangent(0.0)[0] > 0.0));
    assert_eq!(mesh.names().collect::<Vec<_>>(), ["jaw-1"]);
}

#[test]
fn binary_of_both_byte_orders() {
    for big in [false, true] {
        let mesh = read_gmsh(&binary(big), 1.0).unwrap();
        assert_eq!((mesh.nodes().len(), mesh.element_count()), (3, 1));
        assert!((area(&mesh) - 0.5).abs() < 1e-15);
        assert_eq!(mesh.sides("jaw-1").unwrap().len(), 1);
    }
}

#[test]
fn every_element_can_be_turned_over() {
    for element in crate::element::plane::ALL {
        let mut nodes: Vec<u32> = (0..element.nodes() as u32).collect();
        turn_over(*element, &mut nodes);
        let turned: Vec<[f64; 2]> = nodes.iter().map(|&node| element.reference()[node as usize]).collect();
        let sampled = Sampled::new(*element);
        assert!((sampled.area(&turned) + sampled.area(element.reference())).abs() < 1e-14, "{element:?}");
        assert!(sampled.distortion(&turned) < 0.0);
        for edge in element.edges().iter().filter(|edge| edge.len() == 3) {
            let [start, end, middle] = [edge[0], edge[1], edge[2]].map(|node| turned[node]);
            let gap = [0, 1].map(|axis| 0.5 * (start[axis] + end[axis]) - middle[axis]);
            assert!(gap.iter().all(|gap| gap.abs() < 1e-15), "{element:?}");
        }
    }
}

#[test]
fn errors_tell_the_place() {
    let read = |from: &str, to: &str| read_gmsh(TEXT.replacen(from, to, 1).as_bytes(), 1.0).unwrap_err().to_string();
    assert_eq!(read("1 0 0\n2 0 0", "1 o 0\n2 0 0"), "Nodes, line 26: expected a number, found `o`");
    assert_eq!(read("4 3 1 7 4", "4 3 1 17 4"), "element 4 has a node 17 that the file does not hold");
    assert_eq!(read("0 1 0 0.1", "0 1 2 0.1"), "node 4 is off the plane z = 0 by 2.000e0");
    assert_eq!(read("2 3 1\n", "2 3 2\n"), "element 2 of the physical curve `jaw-1` is not a side of a plane element");
    let old = read("4.1 0 8", "2.2 0 8");
    assert!(old.ends_with("it is of format 2.2"), "{old}");
    assert!(read("2 1 2 1\n6 7 6 5", "3 1 4 1\n6 7 6 5 1").starts_with("element 6 is of Gmsh type 4"));
}

#[test]
fn a_cut_file_is_an_error_wherever_it_is_cut() {
    for length in 0..TEXT.len() - 20 {
        assert!(read_gmsh(&TEXT.as_bytes()[..length], 1.0).is_err(), "{length}");
    }
    let whole = binary(false);
    for length in 0..whole.len() - 20 {
        assert!(read_gmsh(&whole[..length], 1.0).is_err(), "{length}");
    }
}
