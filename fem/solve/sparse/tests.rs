use std::sync::Arc;

use super::*;
use crate::element::plane::{ALL, Elasticity, PlaneState};
use crate::mesh::{Grading, Mesh, RectangleMesh, RingMesh};

struct Problem {
    mesh: Mesh,
    freedoms: Freedoms,
    matrix: Matrix,
}

fn problem(mesh: Mesh, order: Order, held: impl Fn(&Mesh) -> Vec<usize>) -> Problem {
    let graph = Graph::new(&mesh);
    let sequence = order.find(&graph, mesh.nodes()).unwrap();
    let freedoms = Freedoms::new(2, &sequence, &held(&mesh));
    let pattern = Arc::new(Pattern::new(&graph, &freedoms));
    let law = Elasticity::new(PlaneState::Stress, 1.0, 0.3, 0.0, 1.0).unwrap();
    let matrix = Matrix::assemble::<2>(&mesh, &pattern, &freedoms, |_, sampled, coordinates, square| {
        law.stiffness(sampled, coordinates, square);
    })
    .unwrap();
    Problem { mesh, freedoms, matrix }
}

fn left_held(mesh: &Mesh) -> Vec<usize> {
    mesh.nodes_on("left").unwrap().iter().flat_map(|&node| [2 * node as usize, 2 * node as usize + 1]).collect()
}

impl Problem {
    fn solve(&self, loads: &[f64]) -> Result<Vec<f64>, SparseError> {
        let solver = Solver::new(&Analysis::of(&self.matrix)?, &self.matrix, &self.freedoms, self.mesh.nodes())?;
        let mut x = vec![0.0; loads.len()];
        solver.solve(&self.matrix, &self.freedoms.gather(loads), &mut x)?;
        Ok(self.freedoms.scatter(&x))
    }
}

#[test]
fn every_order_is_a_permutation_and_gives_one_answer() {
    for element in ALL {
        let mut answers = Vec::new();
        for order in [Order::Dissection, Order::MinimumDegree, Order::Natural] {
            let mesh = RectangleMesh::uniform([3.0, 1.0], [12, 5], *element).build().unwrap();
            let mut sequence = order.find(&Graph::new(&mesh), mesh.nodes()).unwrap();
            sequence.sort_unstable();
            assert!(sequence.iter().copied().eq(0..mesh.nodes().len() as u32), "{element:?} {order:?}");
            let problem = problem(mesh, order, left_held);
            let mut loads = vec![0.0; problem.freedoms.len()];
            loads[2 * problem.mesh.nearest_node([3.0, 1.0]) + 1] = 1.0;
            answers.push(problem.solve(&loads).unwrap());
        }
        for other in &answers[1..] {
            for (a, b) in answers[0].iter().zip(other) {
                assert!((a - b).abs() < 1e-9, "{element:?}: {a} {b}");
            }
        }
    }
}

#[test]
fn the_assembled_matrix_is_the_sum_of_the_elements() {
    let mesh = RectangleMesh::uniform([3.0, 1.0], [9, 7], ALL[3]).build().unwrap();
    let problem = problem(mesh, Order::Dissection, left_held);
    let motion: Vec<f64> = (0..problem.freedoms.len()).map(|k| (k as f64 * 0.7).sin()).collect();
    let product = problem.freedoms.scatter(&problem.matrix.multiply(&problem.freedoms.gather(&motion)));
    let law = Elasticity::new(PlaneState::Stress, 1.0, 0.3, 0.0, 1.0).unwrap();
    let sampled = crate::element::plane::Sampled::new(ALL[3]);
    let mut expected = vec![0.0; motion.len()];
    for element in problem.mesh.elements() {
        let mut square = [[[[0.0; 2]; 2]; 9]; 9];
        law.stiffness(&sampled, &problem.mesh.coordinates(element)[..8], &mut square);
        for (a, &row) in element.nodes.iter().enumerate() {
            for (b, &column) in element.nodes.iter().enumerate() {
                for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                    expected[2 * row as usize + i] += square[a][b][i][j] * motion[2 * column as usize + j];
                }
            }
        }
    }
    for (found, expected) in product.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-13);
    }
}

/// A ring large enough to be factored in halves.
fn large_ring() -> Mesh {
    let grading = Grading::uniform();
    RingMesh { outer_radius: 0.05, inner_radius: 0.04, circumferential: 300, radial: 6, element: ALL[3], grading }
        .build()
        .unwrap()
}

#[test]
fn the_answer_does_not_depend_on_the_number_of_threads() {
    let answer = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let held = problem(large_ring(), Order::Dissection, |_| vec![0, 1, 7]);
            assert!(Analysis::of(&held.matrix).unwrap().has_halves());
            let loads: Vec<f64> = (0..held.freedoms.len()).map(|k| (k as f64).sin()).collect();
            held.solve(&loads).unwrap()
        })
    };
    assert_eq!(answer(1), answer(2));
}

#[test]
fn a_large_loose_body_is_an_error() {
    let loose = problem(large_ring(), Order::Dissection, |_| vec![0, 1]);
    let loads = vec![1.0; loose.freedoms.len()];
    assert!(matches!(loose.solve(&loads), Err(SparseError::Singular { .. })));
}

#[test]
fn a_loose_body_is_an_error_and_no_garbage() {
    for held in [0, 1, 2] {
        let grading = Grading::uniform();
        let ring = RingMesh {
            outer_radius: 0.05,
            inner_radius: 0.04,
            circumferential: 48,
            radial: 3,
            element: ALL[3],
            grading,
        };
        let loose = problem(ring.build().unwrap(), Order::Dissection, |_| (0..held).collect());
        let mut loads = vec![0.0; loose.freedoms.len()];
        loads[10] = 1.0;
        let error = loose.solve(&loads).unwrap_err();
        assert!(matches!(error, SparseError::Singular { .. }), "{held} held: {error}");
    }
}

#[test]
fn dissection_fills_less_than_minimum_degree_on_a_large_ring() {
    let grading = Grading::uniform();
    let ring =
        RingMesh { outer_radius: 0.05, inner_radius: 0.04, circumferential: 360, radial: 14, element: ALL[3], grading };
    let mesh = ring.build().unwrap();
    let entries = |order| {
        let problem = problem(mesh.clone(), order, |_| vec![0, 1, 7]);
        Analysis::of(&problem.matrix).unwrap().operations()
    };
    let (dissection, degree) = (entries(Order::Dissection), entries(Order::MinimumDegree));
    println!("operations: dissection {dissection:.3e}, minimum degree {degree:.3e}");
    assert!(dissection < 1.1 * degree, "{dissection:.3e} {degree:.3e}");
}
