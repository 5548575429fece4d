//! A frame as people look at it: bodies with their displacements magnified, arrows for forces, fields in the
//! units of the shop.

use vtkio::model::{
    Attribute, Attributes, ByteOrder, DataArray, DataSet, ElementType, IOBuffer, PolyDataPiece, Version, VertexNumbers,
    Vtk,
};

use super::survey::{Range, Survey};
use super::{VtkError, encode, shop_name};
use crate::process::{Body, Field, Frame, Grid, Role, Skin};
use crate::units::MICRO;

/// Length of the arrow of the largest force, as a part of the size of what is made.
const LONGEST: f64 = 0.16;
/// Forces below this part of the largest have no arrow.
const NO_FORCE: f64 = 0.01;
/// Role of the two points that carry the ends of every colour scale.
const SCALE: u8 = 9;

/// Points and faces of all bodies in the making.
#[derive(Default)]
struct Surfaces {
    points: Vec<[f64; 3]>,
    /// The point of the grid that each point shows, and whether it has the colours of the work.
    nodes: Vec<(Option<u32>, bool)>,
    connectivity: Vec<u64>,
    offsets: Vec<u64>,
    roles: Vec<u8>,
    bodies: Vec<u8>,
}

impl Surfaces {
    fn add(&mut self, number: usize, body: &Body, grid: &Grid, magnification: f64) {
        let first = self.points.len() as u64;
        for point in &body.skin.points {
            let at = point.node.map_or([0.0; 3], |node| moved(grid, node, magnification));
            self.points.push([0, 1, 2].map(|c| at[c] + point.offset[c]));
            self.nodes.push((point.node, body.role == Role::Work));
        }
        let faces = body.skin.triangles.iter().map(|f| &f[..]).chain(body.skin.quads.iter().map(|f| &f[..]));
        for face in faces {
            self.connectivity.extend(face.iter().map(|p| first + u64::from(*p)));
            self.offsets.push(self.connectivity.len() as u64);
            self.roles.push(body.role as u8);
            self.bodies.push(number.min(255) as u8);
        }
    }
}

/// Where a point of the grid is in the picture.
fn moved(grid: &Grid, node: u32, magnification: f64) -> [f64; 3] {
    let by = displacement(grid, node);
    let at = grid.points[node as usize];
    [0, 1, 2].map(|c| at[c] + magnification * by[c])
}

fn displacement(grid: &Grid, node: u32) -> [f64; 3] {
    match grid.point_field("displacement").map(|field| field.at(node as usize)) {
        Some([x, y, z]) => [*x, *y, *z],
        _ => [0.0; 3],
    }
}

/// The arrows of a frame as one body each.
fn arrows(frame: &Frame, survey: &Survey) -> Vec<Body> {
    let Some(forces) = frame.grid.point_field("force") else { return Vec::new() };
    let mut bodies = Vec::new();
    for arrow in &frame.arrows {
        let force = forces.at(arrow.node as usize);
        let size = force.iter().map(|c| c * c).sum::<f64>().sqrt();
        if size <= NO_FORCE * survey.force || !size.is_finite() {
            continue;
        }
        let axis = [0, 1, 2].map(|c| force[c] / size);
        let full = LONGEST * survey.size;
        let length = full * size / survey.force;
        let head = (0.3 * full).min(0.6 * length);
        let [thin, thick] = [0.03 * full, 0.09 * full];
        let tail = [0, 1, 2].map(|c| arrow.aside[c] - (arrow.standoff + length) * axis[c]);
        let meridian = [(0.0, thin), (length - head, thin), (length - head, thick), (length, 0.02 * thick)];
        bodies.push(Body::new("force", Role::Force, Skin::turned(Some(arrow.node), tail, axis, &meridian)));
    }
    bodies
}

/// The bytes of the `.vtp` file of a frame.
///
/// # Errors
/// NaN or infinity; a frame without bodies.
pub fn vtp(frame: &Frame, shown: &str, survey: &Survey) -> Result<Vec<u8>, VtkError> {
    let grid = &frame.grid;
    let mut surfaces = Surfaces::default();
    for (number, body) in (1..).zip(frame.bodies.iter().chain(&arrows(frame, survey))) {
        surfaces.add(number, body, grid, survey.magnification);
    }
    if surfaces.points.is_empty() {
        return Err(VtkError::Empty { points: 0, cells: 0 });
    }
    if let Some(point) = surfaces.points.iter().position(|p| p.iter().any(|c| !c.is_finite())) {
        return Err(VtkError::Coordinate { point, value: f64::NAN });
    }
    // Two points with the ends of every scale: whoever opens the file by hand sees the colours of the whole run.
    let ends = [0, 1].map(|_| surfaces.points[0]);
    let count = surfaces.points.len();
    let points: Vec<[f64; 3]> = surfaces.points.iter().copied().chain(ends).collect();
    let mut fields: Vec<&Field> = grid.point_fields.iter().filter(|field| field.components == 1).collect();
    fields.sort_by_key(|field| field.name != shown);
    let mut point = Vec::new();
    for field in fields {
        let Some(range) = survey.range(&field.name) else { continue };
        let values = scalars(field, range, &surfaces.nodes);
        point.push(scalar(shop_name(&field.name, field.kind), values));
    }
    let vectors = |scale: f64| {
        let of = |(node, _): &(Option<u32>, bool)| {
            node.map_or([0.0; 3], |n| displacement(grid, n)).map(|c| (scale * c) as f32 + 0.0)
        };
        let mut all: Vec<[f32; 3]> = surfaces.nodes.iter().map(of).collect();
        all.resize(count + 2, [0.0; 3]);
        all.into_flattened()
    };
    let vector = |name: &str, scale| data(name.into(), ElementType::Vectors, IOBuffer::F32(vectors(scale)));
    point.push(vector("displacement_magnified", survey.magnification));
    point.push(vector(&shop_name("displacement", MICRO), 1e6));
    let of_cells = |scale: u8, own: &[u8]| [&[scale; 2][..], own].concat();
    let cell = |name: &str, scale, own: &[u8]| {
        let scalars = ElementType::Scalars { num_comp: 1, lookup_table: None };
        data(name.into(), scalars, IOBuffer::U8(of_cells(scale, own)))
    };
    let points: Vec<f32> = points.as_flattened().iter().map(|c| *c as f32 + 0.0).collect();
    let piece = PolyDataPiece {
        points: IOBuffer::F32(points),
        verts: Some(VertexNumbers::XML { connectivity: vec![count as u64, count as u64 + 1], offsets: vec![1, 2] }),
        polys: Some(VertexNumbers::XML { connectivity: surfaces.connectivity, offsets: surfaces.offsets }),
        data: Attributes { point, cell: vec![cell("role", SCALE, &surfaces.roles), cell("body", 0, &surfaces.bodies)] },
        ..PolyDataPiece::default()
    };
    let file = Vtk {
        version: Version::new_xml(1, 0),
        title: String::new(),
        byte_order: ByteOrder::LittleEndian,
        data: DataSet::inline(piece),
        file_path: None,
    };
    encode(file)
}

/// A field in the unit of its kind: on what is made the values of its points, elsewhere what is nearest to zero, and
/// on the last two points the ends of the scale.
fn scalars(field: &Field, range: &Range, nodes: &[(Option<u32>, bool)]) -> Vec<f32> {
    let unit = field.kind.canonical();
    let of = |si: f64| ((si - unit.offset) / unit.factor) as f32 + 0.0;
    let value = |(node, is_work): &(Option<u32>, bool)| match (node, is_work) {
        (Some(node), true) => of(field.values[*node as usize]),
        _ => of(range.neutral()),
    };
    nodes.iter().map(value).chain(range.scale().map(|end| end as f32 + 0.0)).collect()
}

fn scalar(name: String, values: Vec<f32>) -> Attribute {
    data(name, ElementType::Scalars { num_comp: 1, lookup_table: None }, IOBuffer::F32(values))
}

fn data(name: String, elem: ElementType, data: IOBuffer) -> Attribute {
    Attribute::DataArray(DataArray { name, elem, data })
}
