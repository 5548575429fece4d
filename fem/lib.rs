//! Predicts what a machine, fixture and workpiece do to a part, compares the prediction with measurements,
//! and fits what is not exactly known.
//!
//! A model is read, run, and asked for what it found:
//!
//! ```
//! use fem::input::Source;
//! use fem::model::Model;
//! use fem::progress::Progress;
//!
//! let text = r#"
//!     process = "contour"
//!     path = { shape = "circle", radius = "150 mm", feed = "1000 mm/min" }
//!     drives = { gain = "50 /s" }
//!     effects.backlash-x.gap = "6 um"
//! "#;
//! let model = Model::parse(Source::new("circle.toml", text))?;
//! let run = model.run(&Progress::default())?;
//! let figure = |key: &str| run.report.figures.iter().find(|f| f.key == key).and_then(|f| f.value_at("value"));
//!
//! // The servos alone shrink the circle by 0.37 um; half of the play stands on either side of it.
//! let (largest, smallest) = (figure("largest").unwrap(), figure("smallest").unwrap());
//! assert!(largest < 3.0 && smallest < -3.0 && smallest > -3.4);
//!
//! // What the play changes, in micrometres.
//! let play = run.contributions.iter().find(|c| c.name == "backlash-x").unwrap();
//! assert!((1e6 * play.largest - 3.0).abs() < 0.01 && (1e6 * play.smallest + 3.0).abs() < 0.01);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Measurements are held against a model by [`compare::compare`], what it leaves open is estimated by
//! [`fit::fit`], and the effect that it lacks is named by [`diagnose::diagnose`]; `examples/` does each in
//! twenty lines.
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
//! process               the frame of a process: its definition, coordinates, effects, reports
//! processes             turning, ring, …: each with its effects
//! measure               measurement files
//! noise                 noise of measurements and what rows share of it: the covariance
//! model                 a model file: process, effects, what is known; run, add, schema
//! compare               a model against measurements
//! fit                   what a model does not know exactly, from measurements
//! compensate            tables for a controller, and what they cannot do
//! diagnose              which effect is missing
//! budget                errors added up by rules and by drawing
//! study                 many jobs with one model: points, rows, yield, worst case, sensitivity
//! validation            what handbooks, closed forms and benchmarks say, and what is computed
//! output                text, CSV, JSON, VTK; files that appear whole
//! ask                   what can be asked of models and measurements: questions in, answers out
//! cli                   the commands
//! ```

pub mod ask;
pub mod budget;
mod cli;
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
pub mod noise;
pub mod output;
pub mod positioning;
pub mod process;
pub mod processes;
pub mod progress;
pub mod series;
pub mod solve;
pub mod study;
pub mod units;
pub mod validation;

pub use cli::command;
