//! What can be typed.

mod correction;
mod shared;
mod study;

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Parser, Subcommand};

use crate::model::Setting;
use crate::output::CONTROLS;

pub use correction::{Correct, Next};
pub use shared::{Data, Limit, Mark, Reading};
pub use study::{Study, StudyCommand};

/// Predicts what a machine, fixture and workpiece do to a part.
#[derive(Debug, Parser)]
#[command(
    name = "fem",
    version,
    about,
    after_help = "Examples:
  fem demo                           a story to try everything on
  fem new turning -o shaft.toml      a commented model to start from
  fem run shaft.toml                 predict, summarise, write out/shaft/
  fem compare shaft.toml --with measured.csv
  fem effects turning                what else could be happening
  fem add shaft.toml tool-wear 'rate=8 um/km' -o worn.toml

Exit status: 0 done, 1 the computation or the writing failed, 2 the input is wrong."
)]
pub struct Args {
    /// What to do next is told where none is named
    #[command(subcommand)]
    pub command: Option<Command>,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Solve a model, print a summary, write profile, summary and shapes
    Run(Run),
    /// Hold models against measurements: how well, and where they fail
    Compare(Compare),
    /// Estimate what a model marks `+-` or `?` from measurements
    Fit(Fit),
    /// Which effect is missing, and what cannot be told apart
    Diagnose(Diagnose),
    /// Which law that is in no catalogue explains what a model leaves
    Discover(Discover),
    /// Before measuring: what could be seen, what would look alike
    Plan(Plan),
    /// An axis: backlash value, pitch tables, what they leave, and what they cannot do
    Compensate(Compensate),
    /// What to command so that the part comes out right, and what will be left
    Correct(Correct),
    /// Between parts: the next offset, what to measure, when to change the insert
    Next(Next),
    /// The workbench: the whole loop on a page in your browser
    Open(Open),
    /// One page of everything: prediction, residuals, causes, what to do next
    Report(Report),
    /// Add errors up, by the handbook's rules and by Monte Carlo
    Budget(Budget),
    /// Many jobs with one model: yield, worst case, which quantity to hold tighter
    Study(Study),
    /// The catalogue of effects: law, parameters, units, neutral value, source
    Effects(Effects),
    /// Write a model with one more effect
    Add(Add),
    /// Write a model with other values, or without some of its effects
    Set(Set),
    /// Write a commented model to start from
    New(New),
    /// Write a model and measurements to try everything on
    Demo(Demo),
    /// Write a measurement file of what an instrument or a spreadsheet wrote
    Import(Import),
    /// The JSON Schema of model files or plans, for editors
    Schema {
        /// Of which files
        #[arg(value_enum, default_value_t = SchemaOf::Model)]
        of: SchemaOf,
    },
    /// Every handbook and benchmark case: expected, computed, error
    Validate(Validate),
    /// A completion script for a shell
    #[command(after_help = "Example:\n  fem completions bash > /etc/bash_completion.d/fem")]
    Completions {
        /// For which shell
        shell: clap_complete::Shell,
    },
}

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  fem run models/lathe.toml
  fem run models/lathe.toml -o results
  fem run models/lathe.toml --plot figures
  fem run models/lathe.toml --json | jq .findings.largest")]
pub struct Run {
    /// The model file
    pub model: PathBuf,
    /// Where to write; out/<model name> if left out
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Write the figures alone, as SVG, into this folder
    #[arg(long, value_name = "DIR", conflicts_with = "output")]
    pub plot: Option<PathBuf>,
    /// Frames of the shapes for ParaView, at most
    #[arg(long, value_name = "N", default_value_t = 26, value_parser = clap::value_parser!(u32).range(2..=100_000))]
    pub frames: u32,
    /// Replace files that this program did not write
    #[arg(long)]
    pub force: bool,
    /// Print the summary as JSON
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Several models are shown side by side, in the order given: the error falling. `fem effects PROCESS` names the
columns of the measurements, which may be parted by commas, semicolons or tabs.

Examples:
  fem compare shaft.toml --with measured.csv
  fem compare rigid.toml springs.toml worn.toml --with measured.csv -o residuals"
)]
pub struct Compare {
    /// The model files
    #[arg(required = true, value_name = "MODEL")]
    pub models: Vec<PathBuf>,
    #[command(flatten)]
    pub data: Data,
    /// Where to write residuals.csv, figures and compared.pvd; nothing is written if left out
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Write the figures alone, as SVG, into this folder
    #[arg(long, value_name = "DIR", conflicts_with = "output")]
    pub plot: Option<PathBuf>,
    /// Replace files that this program did not write
    #[arg(long)]
    pub force: bool,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, clap::Args)]
#[command(after_help = "Example:
  fem fit shaft.toml --with measured.csv --add-to fitted.toml")]
pub struct Fit {
    /// The model file; it is not changed
    pub model: PathBuf,
    #[command(flatten)]
    pub data: Data,
    /// Write the model with the fitted values and their uncertainties
    #[arg(long, value_name = "NEW.toml")]
    pub add_to: Option<PathBuf>,
    /// Replace files that this program did not write
    #[arg(long)]
    pub force: bool,
    #[command(flatten)]
    pub limit: Limit,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, clap::Args)]
#[command(after_help = "Example:
  fem discover shaft.toml --with measured.csv --add-to better.toml")]
pub struct Discover {
    /// The model file; it is not changed
    pub model: PathBuf,
    #[command(flatten)]
    pub data: Data,
    #[command(flatten)]
    pub own: OwnLaws,
    /// Write the model with the best law
    #[arg(long, value_name = "NEW.toml")]
    pub add_to: Option<PathBuf>,
    /// Replace files that this program did not write
    #[arg(long)]
    pub force: bool,
    #[command(flatten)]
    pub limit: Limit,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// Laws that somebody has in mind.
#[derive(Debug, clap::Args)]
pub struct OwnLaws {
    /// Laws of your own to try among the others: [NAME] with formula = "…" and its parameters, known, `?` or in a range
    /// as "1 to 3"; a file, or a folder of them
    #[arg(long, value_name = "LAWS.toml")]
    pub candidates: Vec<PathBuf>,
}

#[derive(Debug, clap::Args)]
#[command(after_help = "What the model marks `+-` or `?` is re-fitted together with every effect on trial.
Several tests that name one machine are diagnosed together: a model and its --with for each, in the same order.

Examples:
  fem diagnose shaft.toml --with measured.csv
  fem diagnose shaft.toml --with measured.csv --add-to better.toml
  fem diagnose shafts.toml --with shafts.csv tailstock.toml --with tailstock.csv")]
pub struct Diagnose {
    /// The model file, or one for each of several tests of a machine; none is changed
    #[arg(value_name = "MODEL", required = true)]
    pub models: Vec<PathBuf>,
    #[command(flatten)]
    pub data: Data,
    #[command(flatten)]
    pub own: OwnLaws,
    /// Where to write diagnosis.json; nothing is written if left out
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Write the model with the missing effects and all fitted values
    #[arg(long, value_name = "NEW.toml")]
    pub add_to: Option<PathBuf>,
    /// Write the rows to measure next, to be filled in; where they need a longer batch, the model too, beside them
    #[arg(long, value_name = "ROWS.csv")]
    pub next: Option<PathBuf>,
    /// How many effects to look for together, at most
    #[arg(long, value_name = "N", default_value_t = crate::diagnose::MOST_EFFECTS as u8, value_parser = clap::value_parser!(u8).range(1..=8))]
    pub max_effects: u8,
    /// Replace files that this program did not write
    #[arg(long)]
    pub force: bool,
    #[command(flatten)]
    pub limit: Limit,
    /// Tell on stderr where the time went
    #[arg(long)]
    pub profile: bool,
    /// Print all: where the model fails, every cause and every effect on trial, every command
    #[arg(long)]
    pub verbose: bool,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, clap::Args)]
#[command(
    after_help = "A design is a measurement file without what is observed: coordinates, and `u` if the noise is known row by row.

Examples:
  fem plan shaft.toml --noise '1.5 um'
  fem plan shaft.toml --with design.csv"
)]
pub struct Plan {
    /// The model file
    pub model: PathBuf,
    /// The planned rows; some of the model's own programme if left out
    #[arg(long, value_name = "DESIGN.csv")]
    pub with: Vec<PathBuf>,
    #[command(flatten)]
    pub reading: Reading,
    /// Standard uncertainty of a row, where the design has no column u; once for each observable
    #[arg(long, value_name = "SIZE")]
    pub noise: Vec<String>,
    #[command(flatten)]
    pub limit: Limit,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, clap::Args)]
#[command(
    after_help = "The test is evaluated by ISO 230-2; what the model leaves open (`+-`, `?`) is fitted to it first. With -o, what is entered into a
controller stands in points.csv, segments.csv, both-directions.csv and linuxcnc.comp, and what is left along the travel in predicted.csv.

Examples:
  fem compensate axis.toml --with test.csv
  fem compensate axis.toml --with test.csv -o tables
  fem compensate axis.toml --with test.csv -o tables --for siemens-eec,heidenhain --axis X1"
)]
pub struct Compensate {
    /// The model file, of a process that moves to targets
    pub model: PathBuf,
    #[command(flatten)]
    pub data: Data,
    /// Where to write the tables; nothing is written if left out
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// The controls whose files are written; linuxcnc, where it takes so many targets, if left out
    #[arg(long = "for", value_name = "CONTROL", value_delimiter = ',', requires = "output", value_parser = controls())]
    pub controls: Vec<String>,
    /// The name of the axis in the control
    #[arg(long, value_name = "NAME", default_value = "X", value_parser = axis_name)]
    pub axis: String,
    /// Replace files that this program did not write
    #[arg(long)]
    pub force: bool,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// The controls that can be named, with what they are.
fn controls() -> PossibleValuesParser {
    PossibleValuesParser::new(CONTROLS.iter().map(|control| PossibleValue::new(control.name).help(control.about)))
}

/// The name of an axis: what stands in files of controls between brackets and blanks.
fn axis_name(text: &str) -> Result<String, String> {
    let is_one = (1..=16).contains(&text.len()) && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    is_one.then(|| text.to_string()).ok_or_else(|| "a name is 1 to 16 letters and digits: write X or X1".into())
}

#[derive(Debug, clap::Args)]
#[command(
    after_help = "The page is served to this computer alone, under an address that only you know; nothing outside of the folder is read or
written, and nothing is asked of the network. Files stay the truth: what is edited elsewhere shows at once.

Examples:
  fem open
  fem open models/story
  fem open models/story/rigid.toml"
)]
pub struct Open {
    /// The folder, or a model in one
    #[arg(default_value = ".", value_name = "FOLDER or MODEL")]
    pub path: PathBuf,
    /// Port of the page; any free one if left out
    #[arg(long, value_name = "PORT", default_value_t = 0)]
    pub port: u16,
}

#[derive(Clone, Debug, clap::Args)]
#[command(
    after_help = "The page is one HTML file that asks for nothing from the network. Without --with it shows the prediction; with several
models the error falls from one to the next, and the last is diagnosed.

Examples:
  fem report shaft.toml -o report.html
  fem report shaft.toml --with measured.csv -o report.html
  fem report shaft.toml --with measured.csv --serve"
)]
pub struct Report {
    /// The model files
    #[arg(required = true, value_name = "MODEL")]
    pub models: Vec<PathBuf>,
    /// The measurements; once for each of several files
    #[arg(long, value_name = "DATA.csv")]
    pub with: Vec<PathBuf>,
    #[command(flatten)]
    pub reading: Reading,
    /// The page to write
    #[arg(short, long, value_name = "FILE.html", required_unless_present = "serve")]
    pub output: Option<PathBuf>,
    /// Replace a file that is no such page
    #[arg(long)]
    pub force: bool,
    /// How many effects to look for together, at most
    #[arg(long, value_name = "N", default_value_t = crate::diagnose::MOST_EFFECTS as u8, value_parser = clap::value_parser!(u8).range(1..=8))]
    pub max_effects: u8,
    #[command(flatten)]
    pub limit: Limit,
    /// Show the page at an address of this computer alone, and renew it whenever a file changes
    #[arg(long)]
    pub serve: bool,
    /// Port of that address; any free one if left out
    #[arg(long, value_name = "PORT", default_value_t = 0, requires = "serve")]
    pub port: u16,
}

#[derive(Debug, clap::Args)]
#[command(after_help = "The file lists errors, or names a model whose inputs vary; `fem new budget` explains it.

Examples:
  fem budget budget.toml
  fem budget budget.toml --json | jq .handbook.total")]
pub struct Budget {
    /// The budget file
    pub file: PathBuf,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// Files that have a schema.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub enum SchemaOf {
    /// Model files
    Model,
    /// Plans of `fem study`
    Study,
}

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  fem effects
  fem effects turning
  fem effects tool-wear
  fem effects measurement            what instrument, datum and surroundings do to data
  fem effects zero-shift")]
pub struct Effects {
    /// A process, `measurement` or an effect; everything if left out
    pub name: Option<String>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, clap::Args)]
#[command(after_help = "Parameters that are left out are written as unknown (\"? um\"), for `fem fit` to find.

Examples:
  fem add shaft.toml tool-wear 'rate=8 +- 2 um/km' -o worn.toml
  fem add shaft.toml carriage-contact 'c=0.3 um/N^n' n=0.5 -o closer.toml
  fem add shaft.toml zero-shift by=part 'size=0.7 um' -o zeros.toml")]
pub struct Add {
    /// The model file; it is not changed
    pub model: PathBuf,
    /// The effect to add
    pub effect: String,
    /// Parameters, each with its unit
    #[arg(value_name = "KEY=VALUE")]
    pub settings: Vec<Setting>,
    /// Measurements with columns beside those of the process that a formula names; once for each of several files
    #[arg(long, value_name = "DATA.csv")]
    pub with: Vec<PathBuf>,
    #[command(flatten)]
    pub reading: Reading,
    /// The file to write
    #[arg(short, long, value_name = "NEW.toml")]
    pub output: PathBuf,
    /// Replace a file that is there already
    #[arg(long)]
    pub force: bool,
}

#[derive(Debug, clap::Args)]
#[command(after_help = "Comments and the order of the file stay as they are.

Examples:
  fem set shaft.toml 'cut.depth=0.6 mm' batch.parts=40 -o longer.toml
  fem set shaft.toml 'effects.tool-wear.rate=? um/km' -o open.toml
  fem set shaft.toml --without tool-wear -o sharp.toml")]
pub struct Set {
    /// The model file; it is not changed
    pub model: PathBuf,
    /// Keys by their paths, each with its value
    #[arg(value_name = "PATH=VALUE", required_unless_present = "without")]
    pub values: Vec<Setting>,
    /// Leave an effect out, of the process or of the measurement; may be given several times
    #[arg(long, value_name = "EFFECT")]
    pub without: Vec<String>,
    /// The file to write
    #[arg(short, long, value_name = "NEW.toml")]
    pub output: PathBuf,
    /// Replace a file that is there already
    #[arg(long)]
    pub force: bool,
}

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  fem new\n  fem new turning -o shaft.toml\n  fem new turning --structure -o lathe.toml\n  fem new fixture --sketch -o bracket.toml"
)]
pub struct New {
    /// The process to model, or `budget` or `study`; what there is if left out
    pub process: Option<String>,
    /// With the machine drawn as beams and joints
    #[arg(long, requires = "process")]
    pub structure: bool,
    /// With the part as it is drawn, in finite elements
    #[arg(long, requires = "process", conflicts_with = "structure")]
    pub sketch: bool,
    /// The file to write; it must not exist. Printed if left out
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  fem demo")]
pub struct Demo {
    /// The folder to write
    #[arg(value_name = "FOLDER", default_value = "fem-demo")]
    pub directory: PathBuf,
}

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Every command reads such files as they are. Alone, this one shows how; with -o it writes what was taken, and with --keep a
model that knows how its files are read. `fem effects PROCESS` names the columns. Workbooks (.xlsx, .ods), reports by ISO 230-2,
Q-DAS .dfq and Renishaw .rtx are read as well.

Examples:
  fem import test.csv
  fem import test.csv --process axis -o measured.csv
  fem import log.xlsx --model axis.toml --columns 'Ort=position [mm],Wert=deviation [um]' --keep axis.toml --force
  fem import parts.dfq --process turning --columns 'Near=diameter_error@x=20 mm' -o measured.csv
  fem import log.csv --process thermal --columns 'Zeit=time [s],T1=temperature@x=12 mm [degC]' -o measured.csv"
)]
pub struct Import {
    /// The file of an instrument or a spreadsheet
    pub file: PathBuf,
    /// The process that was measured; else that whose columns they are
    #[arg(long, value_name = "PROCESS", conflicts_with = "model")]
    pub process: Option<String>,
    /// The model that the file is for
    #[arg(long, value_name = "MODEL.toml")]
    pub model: Option<PathBuf>,
    /// Write what was taken, in the program's form
    #[arg(short, long, value_name = "FILE.csv")]
    pub output: Option<PathBuf>,
    /// Write the model, with how the file is read
    #[arg(long, value_name = "NEW.toml", requires = "model", conflicts_with = "output")]
    pub keep: Option<PathBuf>,
    /// Print JSON
    #[arg(long, conflicts_with_all = ["output", "keep"])]
    pub json: bool,
    /// Replace a file that is there already
    #[arg(long)]
    pub force: bool,
    #[command(flatten)]
    pub reading: Reading,
}

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  fem validate
  fem validate --source 'seed 002 (29)'
  fem validate --source NAFEMS --json")]
pub struct Validate {
    /// Only the cases whose source says this, such as `seed-002` or `NAFEMS`
    #[arg(long, value_name = "TEXT")]
    pub source: Option<String>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}
