//! Predicts what a machine, fixture and workpiece do to a part, compares the prediction with measurements, and fits what is not
//! exactly known.
//!
//! Layers, each using only those above it:
//!
//! ```text
//! units                 quantities with units; SI inside
//! progress              how far a computation has come
//! formula               what users write: parsed, checked for units, evaluated
//! input                 reading a user's file: places, problems, one function per table
//! material  element  joint     what bodies, pieces and joints resist with
//! mesh                  plane meshes: nodes, elements, named sides; rings, rectangles, Gmsh files
//! series                the ring by Fourier series, which the finite elements are held against
//! solve                 shaft under a travelling force, equilibrium of joints, sparse check, heat; plane bodies
//! positioning           positioning tests by ISO 230-2, compensation tables
//! process               a process and its effects: turning, …
//! measure               measurement files
//! model                 a model file: process, effects, what is known; run, add, schema
//! compare               a model against measurements
//! fit                   what a model does not know exactly, from measurements
//! compensate            tables for a controller, and what they cannot do
//! diagnose              which effect is missing
//! budget                errors added up by rules and by drawing
//! output                text, CSV, JSON, VTK; files that appear whole
//! cli                   the commands
//! ```

pub mod budget;
pub mod cli;
pub mod compare;
pub mod compensate;
pub mod diagnose;
pub mod element;
pub mod fit;
pub mod formula;
pub mod input;
pub mod joint;
pub mod material;
pub mod measure;
pub mod mesh;
pub mod model;
pub mod output;
pub mod positioning;
pub mod process;
pub mod progress;
pub mod series;
pub mod solve;
pub mod units;
