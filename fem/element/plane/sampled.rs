//! An element's shape functions at its quadrature points, and integrals over one element.

use super::quadrature::Point;
use super::{MAX_NODES, PlaneElement, Thickness};

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

/// The integrals ∫ ∂Nₐ/∂xᵢ ∂N_b/∂xⱼ w dA (no unit; of a body of revolution m) over one element, w the weight of its
/// thickness, from which both the stiffness of an isotropic material and the conduction matrix are combined. `xy[a][b]`
/// has the x-derivative at a; yx is its transpose.
#[derive(Clone, Debug)]
pub struct GradientProducts {
    /// ∫ ∂Nₐ/∂x ∂N_b/∂x w dA.
    pub xx: [[f64; MAX_NODES]; MAX_NODES],
    /// ∫ ∂Nₐ/∂x ∂N_b/∂y w dA.
    pub xy: [[f64; MAX_NODES]; MAX_NODES],
    /// ∫ ∂Nₐ/∂y ∂N_b/∂y w dA.
    pub yy: [[f64; MAX_NODES]; MAX_NODES],
}

/// The integrals (m) over one element of a body of revolution with the hoops Hₐ = Nₐ/y, from which its stiffness is made
/// up beside the products of gradients.
#[derive(Clone, Debug)]
pub struct HoopProducts {
    /// ∫ Hₐ H_b y dA.
    pub hoops: [[f64; MAX_NODES]; MAX_NODES],
    /// ∫ Hₐ ∂N_b/∂x y dA.
    pub x: [[f64; MAX_NODES]; MAX_NODES],
    /// ∫ Hₐ ∂N_b/∂y y dA.
    pub y: [[f64; MAX_NODES]; MAX_NODES],
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

    /// ∫ f w dA in the same way, w the weight of the thickness; `add(w dA, y, N, ∂N/∂x, ∂N/∂y)`, y the coordinate (m) of
    /// the quadrature point.
    pub fn integrate_weighted(
        &self,
        thickness: Thickness,
        coordinates: &[[f64; 2]],
        mut add: impl FnMut(f64, f64, &[f64; MAX_NODES], &[f64; MAX_NODES], &[f64; MAX_NODES]),
    ) {
        self.integrate(coordinates, |da, shapes, along_x, along_y| {
            let y: f64 = shapes.iter().zip(coordinates).map(|(shape, node)| shape * node[1]).sum();
            add(da * thickness.weight(y), y, shapes, along_x, along_y);
        });
    }

    /// Area of the element, m².
    pub fn area(&self, coordinates: &[[f64; 2]]) -> f64 {
        let mut area = 0.0;
        self.integrate(coordinates, |da, _, _, _| area += da);
        area
    }

    /// ∫ w dA: the area (m²), or of a body of revolution the volume over 2π (m³).
    pub fn extent(&self, thickness: Thickness, coordinates: &[[f64; 2]]) -> f64 {
        let mut extent = 0.0;
        self.integrate_weighted(thickness, coordinates, |own, _, _, _, _| extent += own);
        extent
    }

    /// The products of gradients, see [`GradientProducts`].
    pub fn gradient_products(&self, thickness: Thickness, coordinates: &[[f64; 2]]) -> GradientProducts {
        let zero = [[0.0; MAX_NODES]; MAX_NODES];
        let mut products = GradientProducts { xx: zero, xy: zero, yy: zero };
        let nodes = self.element.nodes();
        self.integrate_weighted(thickness, coordinates, |own, _, _, along_x, along_y| {
            for a in 0..nodes {
                let (x, y) = (along_x[a] * own, along_y[a] * own);
                for b in 0..nodes {
                    products.xx[a][b] += x * along_x[b];
                    products.xy[a][b] += x * along_y[b];
                    products.yy[a][b] += y * along_y[b];
                }
            }
        });
        products
    }

    /// The products of hoops of a body of revolution, see [`HoopProducts`].
    pub fn hoop_products(&self, coordinates: &[[f64; 2]]) -> HoopProducts {
        let zero = [[0.0; MAX_NODES]; MAX_NODES];
        let mut products = HoopProducts { hoops: zero, x: zero, y: zero };
        let nodes = self.element.nodes();
        let thickness = Thickness::Revolved;
        self.integrate_weighted(thickness, coordinates, |own, y, shapes, along_x, along_y| {
            let hoops = thickness.hoops(shapes, y).map(|hoop| hoop * own);
            for a in 0..nodes {
                for b in 0..nodes {
                    products.hoops[a][b] += hoops[a] * shapes[b] / y;
                    products.x[a][b] += hoops[a] * along_x[b];
                    products.y[a][b] += hoops[a] * along_y[b];
                }
            }
        });
        products
    }

    /// ∫ Nₐ N_b w dA (m²; of a body of revolution m³).
    pub fn shape_products(&self, thickness: Thickness, coordinates: &[[f64; 2]]) -> [[f64; MAX_NODES]; MAX_NODES] {
        let mut products = [[0.0; MAX_NODES]; MAX_NODES];
        let nodes = self.element.nodes();
        self.integrate_weighted(thickness, coordinates, |own, _, shapes, _, _| {
            for a in 0..nodes {
                for b in 0..nodes {
                    products[a][b] += shapes[a] * shapes[b] * own;
                }
            }
        });
        products
    }

    /// The point of the element (m) at the reference point `at`.
    pub fn point_at(&self, coordinates: &[[f64; 2]], at: [f64; 2]) -> [f64; 2] {
        let shapes = self.element.shapes(at);
        [0, 1].map(|axis| shapes.iter().zip(coordinates).map(|(shape, node)| shape * node[axis]).sum())
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
