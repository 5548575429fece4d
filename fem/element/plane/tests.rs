//! Properties that hold for every element of the list.

use super::*;

/// A distorted, slightly curved image of the element's reference nodes (m), turned against the axes.
fn distorted(element: &dyn PlaneElement) -> Vec<[f64; 2]> {
    let map = |&[xi, eta]: &[f64; 2]| {
        let bow = 0.07 * xi * eta + 0.04 * xi * xi;
        [0.3 + 1.1 * xi - 0.4 * eta + bow, -0.2 + 0.5 * xi + 0.9 * eta - 0.03 * eta * eta]
    };
    element.reference().iter().map(map).collect()
}

/// Places inside and on the border of the reference domain.
fn places(element: &dyn PlaneElement) -> Vec<[f64; 2]> {
    let inside = element.points().iter().map(|point| point.at);
    inside.chain(element.reference().iter().copied()).chain([[0.21, 0.13]]).collect()
}

fn steel(state: PlaneState) -> Elasticity {
    Elasticity::new(state, 210e9, 0.3, 11.5e-6, 0.02).unwrap()
}

/// Plane laws, and that of a body of revolution.
fn laws() -> [Elasticity; 3] {
    [steel(PlaneState::Stress), steel(PlaneState::Strain), Elasticity::revolved(210e9, 0.3, 11.5e-6).unwrap()]
}

/// The distorted element, of a body of revolution clear of its axis.
fn placed(law: &Elasticity, element: &dyn PlaneElement) -> Vec<[f64; 2]> {
    let radius = if law.thickness().is_revolved() { 2.5 } else { 0.0 };
    distorted(element).into_iter().map(|[x, y]| [x, y + radius]).collect()
}

/// Force on every degree of freedom: K u.
fn forces(law: &Elasticity, element: &'static dyn PlaneElement, motion: &[[f64; 2]]) -> Vec<f64> {
    let mut square = [[[[0.0; 2]; 2]; MAX_NODES]; MAX_NODES];
    law.stiffness(&Sampled::new(element), &placed(law, element), &mut square);
    let freedom = |a: usize, i: usize| -> f64 {
        (0..motion.len()).map(|b| square[a][b][i][0] * motion[b][0] + square[a][b][i][1] * motion[b][1]).sum()
    };
    (0..2 * motion.len()).map(|row| freedom(row / 2, row % 2)).collect()
}

#[test]
fn shapes_add_up_to_one_and_slopes_to_zero() {
    for element in ALL {
        for at in places(*element) {
            let (shapes, slopes) = (element.shapes(at), element.slopes(at));
            assert!((shapes.iter().sum::<f64>() - 1.0).abs() < 1e-14, "{element:?} {at:?}");
            for axis in 0..2 {
                assert!(slopes.iter().map(|slope| slope[axis]).sum::<f64>().abs() < 1e-14, "{element:?} {at:?}");
            }
            assert!(shapes[element.nodes()..].iter().all(|&unused| unused == 0.0), "{element:?}");
        }
    }
}

#[test]
fn shapes_are_one_at_their_node_and_zero_at_the_others() {
    for element in ALL {
        for (node, &at) in element.reference().iter().enumerate() {
            for (a, shape) in element.shapes(at).into_iter().enumerate() {
                assert!((shape - f64::from(u8::from(a == node))).abs() < 1e-15, "{element:?} {node} {a}");
            }
        }
    }
}

#[test]
fn slopes_are_differences_of_shapes() {
    let step = 1e-5;
    for element in ALL {
        for [xi, eta] in places(*element) {
            let slopes = element.slopes([xi, eta]);
            let (right, left) = (element.shapes([xi + step, eta]), element.shapes([xi - step, eta]));
            let (up, down) = (element.shapes([xi, eta + step]), element.shapes([xi, eta - step]));
            for a in 0..element.nodes() {
                let difference = [(right[a] - left[a]) / (2.0 * step), (up[a] - down[a]) / (2.0 * step)];
                for axis in 0..2 {
                    assert!((slopes[a][axis] - difference[axis]).abs() < 1e-9, "{element:?} {a} at {xi} {eta}");
                }
            }
        }
    }
}

#[test]
fn shapes_along_a_side_are_those_of_the_side() {
    for element in ALL {
        let reference = element.reference();
        for edge in element.edges() {
            for s in [-1.0, -0.4, 0.0, 0.7] {
                let (start, end) = (reference[edge[0]], reference[edge[1]]);
                let at = [0, 1].map(|axis| 0.5 * (1.0 - s) * start[axis] + 0.5 * (1.0 + s) * end[axis]);
                let mut expected = [0.0; MAX_NODES];
                for (&node, shape) in edge.iter().zip(edge_shapes(edge.len(), s)) {
                    expected[node] = shape;
                }
                for (shape, expected) in element.shapes(at).into_iter().zip(expected) {
                    assert!((shape - expected).abs() < 1e-14, "{element:?} {edge:?} {s}");
                }
            }
        }
    }
}

#[test]
fn area_is_positive_and_that_of_the_boundary() {
    for element in ALL {
        let coordinates = distorted(*element);
        let area = Sampled::new(*element).area(&coordinates);
        let mut around = 0.0;
        for edge in element.edges() {
            let curve = EdgeCurve::new(&edge.iter().map(|&node| coordinates[node]).collect::<Vec<_>>());
            for (s, weight) in quadrature::LINE_3 {
                let ([x, y], [dx, dy]) = (curve.point(s), curve.tangent(s));
                around += 0.5 * weight * (x * dy - y * dx);
            }
        }
        assert!(area > 0.0 && (area - around).abs() < 1e-13 * area, "{element:?}: {area} {around}");
        let mut turned = coordinates.clone();
        turned.swap(0, 1);
        assert!(Sampled::new(*element).distortion(&coordinates) > 0.3, "{element:?}");
        let folded = Sampled::new(*element).distortion(&turned);
        assert!(folded.is_nan() || folded <= 0.0, "{element:?}");
    }
}

#[test]
fn stiffness_is_symmetric_and_rigid_motion_needs_no_force() {
    for element in ALL {
        for law in laws() {
            let coordinates = placed(&law, *element);
            let mut square = [[[[0.0; 2]; 2]; MAX_NODES]; MAX_NODES];
            law.stiffness(&Sampled::new(*element), &coordinates, &mut square);
            let size = square[0][0][0][0];
            for a in 0..element.nodes() {
                for b in 0..element.nodes() {
                    for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                        let gap = square[a][b][i][j] - square[b][a][j][i];
                        assert!(gap.abs() < 1e-14 * size, "{element:?} {a}{i} {b}{j}");
                    }
                }
            }
            let rigid = |[x, y]: &[f64; 2]| match law.thickness().is_revolved() {
                true => [0.3, 0.0],
                false => [0.3 - 0.2 * y, -0.1 + 0.2 * x],
            };
            let rigid: Vec<[f64; 2]> = coordinates.iter().map(rigid).collect();
            for force in forces(&law, *element, &rigid) {
                assert!(force.abs() < 1e-13 * size, "{element:?}: {force} of {size}");
            }
        }
    }
}

#[test]
fn forces_and_energy_of_a_constant_strain_are_exact() {
    for (element, law) in ALL.iter().flat_map(|element| laws().map(|law| (element, law))) {
        let is_revolved = law.thickness().is_revolved();
        // What widens evenly stretches as much around.
        let strain = [1e-4, -3e-4, 2e-4, if is_revolved { -3e-4 } else { 0.0 }];
        let share = if is_revolved { [1.0, 0.0] } else { [0.3, 0.7] };
        let coordinates = placed(&law, *element);
        let sampled = Sampled::new(*element);
        let stretch =
            |&[x, y]: &[f64; 2]| [strain[0] * x + share[0] * strain[2] * y, strain[1] * y + share[1] * strain[2] * x];
        let motion: Vec<[f64; 2]> = coordinates.iter().map(stretch).collect();
        for at in places(*element) {
            let found = law.strain_at(&sampled, &coordinates, &motion, at);
            for (found, expected) in found.into_iter().zip(strain) {
                assert!((found - expected).abs() < 1e-14 * 2.5, "{element:?} {at:?}: {found} {expected}");
            }
        }
        let work: f64 = forces(&law, *element, &motion).iter().zip(motion.as_flattened()).map(|(f, u)| f * u).sum();
        let volume = sampled.extent(law.thickness(), &coordinates) * law.thickness().scale();
        let energy = law.energy_density(strain) * volume;
        // Of curved elements the volume of revolution is beyond the quadrature's degree by little.
        assert!((0.5 * work - energy).abs() < 1e-12 * energy, "{element:?}: {work} {energy}");
    }
}

#[test]
fn only_rigid_motions_have_no_energy() {
    for element in ALL {
        for law in laws() {
            let mut square = [[[[0.0; 2]; 2]; MAX_NODES]; MAX_NODES];
            law.stiffness(&Sampled::new(*element), &placed(&law, *element), &mut square);
            let size = 2 * element.nodes();
            let matrix = nalgebra::DMatrix::from_fn(size, size, |i, j| square[i / 2][j / 2][i % 2][j % 2]);
            let values = matrix.symmetric_eigenvalues();
            let loose = values.iter().filter(|value| value.abs() < 1e-9 * values.max()).count();
            assert_eq!(loose, if law.thickness().is_revolved() { 1 } else { 3 }, "{element:?}: {values}");
        }
    }
}

#[test]
fn stress_is_the_derivative_of_energy() {
    let strain = [2e-4, -1e-4, 3e-4, 1.5e-4];
    for law in laws() {
        let stress = law.stress(strain, 0.0);
        for component in 0..STRAINS {
            let energy = |step: f64| {
                let mut moved = strain;
                moved[component] += step;
                law.energy_density(moved)
            };
            let slope = (energy(1e-6) - energy(-1e-6)) / 2e-6;
            assert!((slope - stress[component]).abs() <= 1e-6 * stress[component].abs(), "{law:?} {component}");
        }
    }
}

#[test]
fn a_warm_free_element_has_no_stress() {
    let [stress, _, revolved] = laws();
    for (element, law) in ALL.iter().flat_map(|element| [(element, stress), (element, revolved)]) {
        let (sampled, coordinates) = (Sampled::new(*element), placed(&law, *element));
        let grown: Vec<[f64; 2]> = coordinates.iter().map(|&[x, y]| [11.5e-6 * 40.0 * x, 11.5e-6 * 40.0 * y]).collect();
        let thermal = law.thermal_forces(&sampled, &coordinates, &[40.0; MAX_NODES]);
        let held = forces(&law, *element, &grown);
        let size = held.iter().fold(0.0_f64, |size, force| size.max(force.abs()));
        for (held, thermal) in held.iter().zip(thermal.as_flattened()) {
            assert!((held - thermal).abs() < 1e-12 * size, "{element:?}");
        }
        let strain = law.strain_at(&sampled, &coordinates, &grown, [0.2, 0.3]);
        assert!(law.stress(strain, 40.0).iter().all(|stress| stress.abs() < 1.0), "{element:?}");
    }
}

/// Σ fₐ·u of a rise on a motion is Σ wₐ·ΔTₐ of the motion's work on it.
#[test]
fn thermal_forces_work_as_their_rises_do() {
    for (element, law) in ALL.iter().flat_map(|element| laws().map(|law| (element, law))) {
        let (sampled, coordinates) = (Sampled::new(*element), placed(&law, *element));
        let (mut rises, mut motion) = ([0.0; MAX_NODES], [[0.0; 2]; MAX_NODES]);
        for a in 0..element.nodes() {
            rises[a] = 10.0 + (3 * a) as f64 % 7.0;
            motion[a] = [1e-6 * ((5 * a) as f64 % 11.0), 1e-6 * ((7 * a) as f64 % 13.0)];
        }
        let forces = law.thermal_forces(&sampled, &coordinates, &rises);
        let by_force: f64 = forces.as_flattened().iter().zip(motion.as_flattened()).map(|(f, u)| f * u).sum();
        let works = law.thermal_work(&sampled, &coordinates, &motion);
        let by_rise: f64 = works.iter().zip(rises).map(|(w, rise)| w * rise).sum();
        assert!((by_force - by_rise).abs() < 1e-12 * by_force.abs(), "{element:?}: {by_force} {by_rise}");
    }
}

#[test]
fn heat_is_conserved() {
    for (element, revolved) in ALL.iter().flat_map(|element| [(element, false), (element, true)]) {
        let thickness = if revolved { Thickness::Revolved } else { Thickness::Uniform(0.02) };
        let law = Conduction { conductivity: 45.0, heat_capacity: 3.6e6, thickness };
        let raise = if revolved { 2.5 } else { 0.0 };
        let coordinates: Vec<[f64; 2]> = distorted(*element).into_iter().map(|[x, y]| [x, y + raise]).collect();
        let sampled = Sampled::new(*element);
        let mut square = [[[[0.0]]; MAX_NODES]; MAX_NODES];
        law.conductance(&sampled, &coordinates, &mut square);
        for a in 0..element.nodes() {
            let row: f64 = square[a].iter().map(|block| block[0][0]).sum();
            assert!(row.abs() < 1e-13 * square[0][0][0][0], "{element:?}");
        }
        let whole = law.heat_capacity * thickness.scale() * sampled.extent(thickness, &coordinates);
        for kind in [Capacity::Consistent, Capacity::Lumped] {
            law.capacity(kind, &sampled, &coordinates, &mut square);
            let sum: f64 = square.iter().flatten().map(|block| block[0][0]).sum();
            assert!((sum - whole).abs() < 1e-13 * whole, "{element:?} {kind:?}");
            assert!((0..element.nodes()).all(|a| square[a][a][0][0] > 0.0));
        }
    }
}

/// By Pappus the volume is that of the area on the way of its centre; so is the surface that of a side.
#[test]
fn volume_and_surface_of_revolution_are_those_of_the_centre() {
    let coordinates = [[1.0, 2.0], [3.0, 2.0], [3.0, 3.0], [1.0, 3.0]];
    let volume = Sampled::new(&Quad4).extent(Thickness::Revolved, &coordinates) * Thickness::Revolved.scale();
    assert!((volume - std::f64::consts::TAU * 2.5 * 2.0).abs() < 1e-12, "{volume}");
    let side = EdgeCurve::new(&[[1.0, 2.0], [4.0, 6.0]]);
    let surface: f64 = side.shape_integrals(Thickness::Revolved, WHOLE).iter().sum();
    assert!((surface - 4.0 * 5.0).abs() < 1e-12, "{surface}");
}

#[test]
fn edge_integrals_are_those_of_the_curve() {
    let thickness = Thickness::Uniform(1.0);
    for nodes in [[[1.0, 0.0], [1.0, 2.0]].as_slice(), &[[1.0, 0.0], [1.0, 2.0], [1.0, 1.0]]] {
        let edge = EdgeCurve::new(nodes);
        assert!((edge.length() - 2.0).abs() < 1e-15);
        let pressed = edge.pressure_forces(thickness).iter().fold([0.0, 0.0], |sum, f| [sum[0] + f[0], sum[1] + f[1]]);
        assert!((pressed[0] + 2.0).abs() < 1e-15 && pressed[1].abs() < 1e-15, "{pressed:?}");
        let half: f64 = edge.shape_integrals(thickness, [0.0, 1.0]).iter().sum();
        let whole: f64 = edge.shape_products(thickness).iter().flatten().sum();
        assert!((half - 1.0).abs() < 1e-15 && (whole - 2.0).abs() < 1e-15);
    }
}
