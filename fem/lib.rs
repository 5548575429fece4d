//! Predicts what a machine, fixture and workpiece do to a part, compares the prediction with measurements,
//! and fits what is not exactly known.
//!
//! A model is read, run, and asked for what it found:
//!
//! ```
//! use fem::{Model, Progress, Source};
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
//! Measurements are put on a model as [`Data`], which [`compare`](compare()), [`fit`](fit()) and
//! [`diagnose`](diagnose()) ask; `examples/` does each in twenty lines.
//!
//! # The interface
//!
//! It is what stands here at the root, and it is unstable before 1.0: any 0.x release may change it, and the changelog
//! says so. Paths through modules are not part of it: they serve the program's own tests and its Python module, and may
//! change in any release.
//!
//! | to | take |
//! |---|---|
//! | read a model | [`Model`], of a [`Source`]; its [`Parameter`]s are what it does not know exactly |
//! | change one | [`add_effect`], [`revised`] by [`Setting`]s, each an [`Entry`] |
//! | run it | [`Model::run`], for a [`Run`]: its [`RunReport`] has [`Figure`]s, each effect a [`Contribution`] or, [`Untold`], why it has none |
//! | read measurements | [`Measurements`], as a [`Reading`] says (its [`Decimal`] mark, its columns) |
//! | put them on a model | [`Data`] |
//! | compare | [`compare`](compare()) or, several models, [`compare_all`], for a [`Comparison`] |
//! | fit | [`fit`](fit()), for a [`Fit`] of [`Estimate`]s with an [`Interval`] each; [`fitted`] is the model with them |
//! | find missing effects | [`diagnose`](diagnose()), for a [`Diagnosis`]: [`Verdict`], [`Missing`] effects, [`GoodnessOfFit`]; [`completed`] is the model with them |
//! | plan measurements | [`plan`], for a [`Plan`] |
//! | compensate an axis | [`compensate`](compensate()), for a [`Compensation`] and its [`Feasibility`] |
//! | add errors up | [`Budget`], for a [`BudgetEstimate`] |
//! | do many jobs | [`study`](study()) with a [`StudyPlan`], for a [`Study`] |
//! | look effects up | [`catalogue`]; the [`PROCESSES`], each a [`Process`] with its [`Observable`]s and effects ([`Description`]) |
//! | hand an answer on | an [`Answer`] as [`text`], [`json`], [`figures`] or files in a [`Folder`] that a [`Guard`] protects |
//! | watch, limit, stop | [`Progress`] |
//! | see what is wrong | [`Error`], of [`InputError`] with each [`Problem`], [`Failure`] and [`OutputError`] |
//! | read numbers | SI throughout; a [`Kind`] converts them, a [`Quantity`] has its [`Knowledge`] |
//! | be the program | [`command`] |
//!
//! Where names, paths and units stand in these they are texts (they dereference to `str`), and the process of a model
//! dereferences to [`Process`]. No type of another crate shows. Most types will grow: what only the program makes is
//! `non_exhaustive`.
//!
//! Answers are [`RunAnswer`], [`ComparisonAnswer`], [`FitAnswer`], [`DiagnosisAnswer`], [`PlanAnswer`],
//! [`CompensationAnswer`], [`BudgetAnswer`], [`StudyAnswer`] and [`CatalogueAnswer`].

// Layers, each using only those above it:
//
//     units                 quantities with units; SI inside
//     progress              how far a computation has come
//     formula               what users write: parsed, checked for units, evaluated
//     input                 reading a user's file: places, problems, one function per table
//     material  element  joint     what bodies, pieces and joints resist with
//     mesh                  plane meshes: nodes, elements, named sides; rings, rectangles, Gmsh files
//     series                the ring by Fourier series, which the finite elements are held against
//     solve                 shaft under a travelling force, equilibrium of joints, sparse check, heat; plane bodies
//     positioning           positioning tests by ISO 230-2, compensation tables
//     roundness             what instruments show of round surfaces: contacts and filters
//     tolerance             limits that a drawing sets: ISO 286-1, either way, both
//     gcode                 programs of machines: what they command, and with other words
//     process               the frame of a process: its definition, coordinates, effects, reports
//     processes             turning, ring, …: each with its effects
//     measure               measurement files
//     noise                 noise of measurements and what rows share of it: the covariance
//     model                 a model file: process, effects, what is known; run, add, schema
//     compare               a model against measurements
//     fit                   what a model does not know exactly, from measurements
//     compensate            tables for a controller, and what they cannot do
//     diagnose              which effect is missing
//     discover              laws that are in no catalogue: found in what a model leaves, written as formulas
//     budget                errors added up by rules and by drawing
//     knowledge             what is known of the values of a model, and how far a prediction may be off
//     correct               what to command so that the part comes out as the drawing asks
//     next                  the next part of a machine, from its own history
//     study                 many jobs with one model: points, rows, yield, worst case, sensitivity
//     remedy                which settings to change, what it gains and what it costs
//     validation            what handbooks, closed forms and benchmarks say, and what is computed
//     output                text, CSV, JSON, VTK; files that appear whole
//     ask                   what can be asked of models and measurements: questions in, answers out
//     workbench             the loop on a page in a browser of this computer
//     cli                   the commands

#[doc(hidden)]
pub mod ask;
#[doc(hidden)]
pub mod budget;
mod cli;
#[doc(hidden)]
pub mod compare;
#[doc(hidden)]
pub mod compensate;
#[doc(hidden)]
pub mod correct;
#[doc(hidden)]
pub mod diagnose;
#[doc(hidden)]
pub mod discover;
#[doc(hidden)]
pub mod element;
#[doc(hidden)]
pub mod fit;
#[doc(hidden)]
pub mod formula;
#[doc(hidden)]
pub mod gcode;
#[doc(hidden)]
pub mod input;
#[doc(hidden)]
pub mod joint;
#[doc(hidden)]
pub mod knowledge;
#[doc(hidden)]
pub mod material;
#[doc(hidden)]
pub mod measure;
#[doc(hidden)]
pub mod mesh;
#[doc(hidden)]
pub mod model;
#[doc(hidden)]
pub mod next;
#[doc(hidden)]
pub mod noise;
#[doc(hidden)]
pub mod output;
#[doc(hidden)]
pub mod positioning;
#[doc(hidden)]
pub mod process;
#[doc(hidden)]
pub mod processes;
#[doc(hidden)]
pub mod progress;
#[doc(hidden)]
pub mod remedy;
#[doc(hidden)]
pub mod roundness;
#[doc(hidden)]
pub mod series;
#[doc(hidden)]
pub mod solve;
#[doc(hidden)]
pub mod study;
#[doc(hidden)]
pub mod tolerance;
#[doc(hidden)]
pub mod units;
#[doc(hidden)]
pub mod validation;
mod workbench;

// Models.
pub use ask::revised;
pub use input::{Parameter, Source};
pub use model::{Contribution, Entry, Model, Run, Setting, Untold, add_effect};
pub use process::{Figure, RunReport};

// Quantities.
pub use units::{Kind, Knowledge, Quantity};

// Processes and the catalogue of effects.
pub use ask::catalogue;
pub use process::{Description, Observable, Process};
pub use processes::ALL as PROCESSES;

// Measurements.
pub use measure::{Decimal, Measurements, Reading};
pub use model::Data;

// Questions, and what they find.
pub use ask::{Study, compare_all, compensate, completed, fit, fitted, plan, study};
pub use budget::{Budget, Estimate as BudgetEstimate};
pub use compare::{Comparison, compare};
pub use compensate::{Compensation, Feasibility};
pub use diagnose::{Diagnosis, GoodnessOfFit, Missing, Plan, Verdict};
pub use discover::diagnose;
pub use fit::{Estimate, Fit, Interval};
pub use study::StudyPlan;

// Answers as text, JSON, figures and files.
pub use output::files::Guard;
pub use output::{
    Answer, BudgetAnswer, CatalogueAnswer, ComparisonAnswer, CompensationAnswer, DiagnosisAnswer, FitAnswer, Folder,
    PlanAnswer, RunAnswer, StudyAnswer, figures, json, text,
};

// Errors and progress.
pub use ask::Error;
pub use input::{InputError, Problem};
pub use output::OutputError;
pub use process::Failure;
pub use progress::Progress;

// The program.
pub use cli::command;
