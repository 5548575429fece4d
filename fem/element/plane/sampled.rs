//! An element's shape functions at its quadrature points, and integrals over one element.

use super::quadrature::Point;
use super::{MAX_NODES, PlaneElement};

/// The shape functions at one quadrature point.
#[derive(Clone, Copy, Debug)]
pub struct SampledPoint {
    weight: f64,
    /// Shape functions Nₐ.
    shapes: [f64; MAX_NODES],
    /// Their derivatives (∂Nₐ/∂ξ, ∂Nₐ/∂η).
    slopes: [[f64; 2]; MAX_NODES],
}

/// An element with its shape functions at its quadrature points, sampled once for all elements of the kind.
#[derive(Clone, Debug)]
pub struct Sampled {
    element: &'static dyn PlaneElement,
    points: Vec<SampledPoint>,
}

/// The integrals ∫ ∂Nₐ/∂xᵢ ∂N_b/∂xⱼ dA (no unit) over one element, from which both the stiffness of an
/// isotropic material and the conduction matrix are combined. `xy[a][b]` has the x-derivative at a; yx is its
/// transpose.
#[derive(Clone, Debug)]
pub struct GradientProducts {
    /// ∫ ∂Nₐ/∂x ∂N_b/∂x dA.
    pub xx: [[f64; MAX_NODES]; MAX_NODES],
    /// ∫ ∂Nₐ/∂x ∂N_b/∂y dA.
    pub xy: [[f64; MAX_NODES]; MAX_NODES],
    /// ∫ ∂Nₐ/∂y ∂N_b/∂y dA.
    pub yy: [[f64; MAX_NODES]; MAX_NODES],
}

/// Jacobian ∂(x, y)/∂(ξ, η) of an element at a point: `[[x_ξ, x_η], [y_ξ, y_η]]` (m).
fn jacobian(slopes: &[[f64; 2]; MAX_NODES], coordinates: &[[f64; 2]]) -> [[f64; 2]; 2] {
    let mut jacobian = [[0.0; 2]; 2];
    for (slope, node) in slopes.iter().zip(coordinates) {
        for i in 0..2 {
            for j in 0..2 {
                jacobian[i][j] += node[i] * slope[j];
            }
        }
    }
    jacobian
}

/// Determinant of the Jacobian (m²) and the gradients (∂Nₐ/∂x (1/m) of all nodes, ∂Nₐ/∂y of all nodes).
type Gradients = (f64, [f64; MAX_NODES], [f64; MAX_NODES]);

fn gradients(slopes: &[[f64; 2]; MAX_NODES], coordinates: &[[f64; 2]]) -> Gradients {
    let [[x_xi, x_eta], [y_xi, y_eta]] = jacobian(slopes, coordinates);
    let determinant = x_xi * y_eta - x_eta * y_xi;
    let inverse = determinant.recip();
    let (mut along_x, mut along_y) = ([0.0; MAX_NODES], [0.0; MAX_NODES]);
    for (a, &[xi, eta]) in slopes.iter().enumerate() {
        along_x[a] = (xi * y_eta - eta * y_xi) * inverse;
        along_y[a] = (eta * x_xi - xi * x_eta) * inverse;
    }
    (determinant, along_x, along_y)
}

impl Sampled {
    /// Samples `element` at its own quadrature points.
    pub fn new(element: &'static dyn PlaneElement) -> Self {
        let sample = |point: &Point| SampledPoint {
            weight: point.weight,
            shapes: element.shapes(point.at),
            slopes: element.slopes(point.at),
        };
        Self { element, points: element.points().iter().map(sample).collect() }
    }

    /// The element.
    pub fn element(&self) -> &'static dyn PlaneElement {
        self.element
    }

    /// ∫ f dA over the element with corners and middles at `coordinates` (m), where f is added up by
    /// `add(dA, N, ∂N/∂x, ∂N/∂y)` at each quadrature point (m², –, 1/m, 1/m).
    pub fn integrate(
        &self,
        coordinates: &[[f64; 2]],
        mut add: impl FnMut(f64, &[f64; MAX_NODES], &[f64; MAX_NODES], &[f64; MAX_NODES]),
    ) {
        for point in &self.points {
            let (determinant, along_x, along_y) = gradients(&point.slopes, coordinates);
            add(determinant * point.weight, &point.shapes, &along_x, &along_y);
        }
    }

    /// Area of the element, m².
    pub fn area(&self, coordinates: &[[f64; 2]]) -> f64 {
        let mut area = 0.0;
        self.integrate(coordinates, |da, _, _, _| area += da);
        area
    }

    /// The products of gradients, see [`GradientProducts`].
    pub fn gradient_products(&self, coordinates: &[[f64; 2]]) -> GradientProducts {
        let zero = [[0.0; MAX_NODES]; MAX_NODES];
        let mut products = GradientProducts { xx: zero, xy: zero, yy: zero };
        let nodes = self.element.nodes();
        self.integrate(coordinates, |da, _, along_x, along_y| {
            for a in 0..nodes {
                let (x, y) = (along_x[a] * da, along_y[a] * da);
                for b in 0..nodes {
                    products.xx[a][b] += x * along_x[b];
                    products.xy[a][b] += x * along_y[b];
                    products.yy[a][b] += y * along_y[b];
                }
            }
        });
        products
    }

    /// ∫ Nₐ N_b dA (m²).
    pub fn shape_products(&self, coordinates: &[[f64; 2]]) -> [[f64; MAX_NODES]; MAX_NODES] {
        let mut products = [[0.0; MAX_NODES]; MAX_NODES];
        let nodes = self.element.nodes();
        self.integrate(coordinates, |da, shapes, _, _| {
            for a in 0..nodes {
                for b in 0..nodes {
                    products[a][b] += shapes[a] * shapes[b] * da;
                }
            }
        });
        products
    }

    /// Gradients at the reference point `at`: (∂Nₐ/∂x of all nodes, ∂Nₐ/∂y of all nodes), 1/m.
    pub fn gradients_at(&self, coordinates: &[[f64; 2]], at: [f64; 2]) -> ([f64; MAX_NODES], [f64; MAX_NODES]) {
        let (_, along_x, along_y) = gradients(&self.element.slopes(at), coordinates);
        (along_x, along_y)
    }

    /// Smallest determinant of the Jacobian over quadrature points and nodes, relative to the mean: 1 for a
    /// parallelogram, ≤ 0 for an element turned inside out or folded. NaN where a coordinate is.
    pub fn distortion(&self, coordinates: &[[f64; 2]]) -> f64 {
        let determinant = |slopes: &[[f64; 2]; MAX_NODES]| gradients(slopes, coordinates).0;
        let reference: f64 = self.points.iter().map(|point| point.weight).sum();
        let mean = (self.area(coordinates) / reference).abs();
        let inside = self.points.iter().map(|point| determinant(&point.slopes));
        let corners = self.element.reference().iter().map(|&at| determinant(&self.element.slopes(at)));
        let smallest = |low: f64, next: f64| if next < low || next.is_nan() { next } else { low };
        inside.chain(corners).fold(f64::INFINITY, smallest) / mean
    }
}
