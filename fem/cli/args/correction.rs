//! Arguments of `fem correct` and `fem next`.

use std::path::PathBuf;

use super::Reading;
use crate::units::{Kind, Knowledge, MICRO, Quantity, TIME};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "The correction is solved through the model, so that force feedback, copying and contacts answer to it. [tolerance] in the
model says what the drawing asks.

Examples:
  fem correct models/lathe.toml
  fem correct models/lathe.toml -o correction
  fem correct models/lathe.toml --program part.ngc -o correction
  fem correct models/fixture.toml --program top.ngc --add-blocks -o correction
  fem correct lathe.toml --remedies --minutes 10"
)]
pub struct Correct {
    /// The model file, whose values are known
    pub model: PathBuf,
    /// Your own program of a lathe or a mill: written with other X or Z words in its finishing pass, and nothing else changed
    #[arg(long, value_name = "PART.ngc")]
    pub program: Option<PathBuf>,
    /// Put blocks before those that are too long for the contour to be straight over them
    #[arg(long, requires = "program")]
    pub add_blocks: bool,
    /// Ask which of its [[setting]]s to change: what each gains, what it costs, and which few do best together
    #[arg(long, conflicts_with = "program")]
    pub remedies: bool,
    /// Most minutes that remedies may cost beside what is made now, of all parts
    #[arg(long, value_name = "N", requires = "remedies", allow_negative_numbers = true, value_parser = finite)]
    pub minutes: Option<f64>,
    /// Where to write the corrected contour of every part; nothing is written if left out
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Go on with a model that failed against the measurements that it was fitted to
    #[arg(long)]
    pub despite_failure: bool,
    /// Replace files that this program did not write
    #[arg(long)]
    pub force: bool,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, clap::Args)]
#[command(
    after_help = "The log names the model of what is made, and keeps what was done and measured: entries are added to it, and nothing in it is
written again. `fem new next` explains it. What was measured before counts once, however often it is named.

Examples:
  fem new next -o log.toml
  fem next log.toml --with today.csv
  fem next log.toml --new-insert --pause '45 min'"
)]
pub struct Next {
    /// The log of the machine
    pub log: PathBuf,
    /// Measurements of parts, by their numbers on the machine; once for each of several files
    #[arg(long, value_name = "TODAY.csv")]
    pub with: Vec<PathBuf>,
    #[command(flatten)]
    pub reading: Reading,
    /// Offset of the radius with which the measured parts were made, where it is not that which was advised
    #[arg(long, value_name = "LENGTH", value_parser = offset, allow_hyphen_values = true, requires = "with")]
    pub applied: Option<f64>,
    /// Which of the jobs of the log was measured
    #[arg(long, value_name = "NAME")]
    pub job: Option<String>,
    /// The next part is cut by a new insert
    #[arg(long)]
    pub new_insert: bool,
    /// The tool is measured or touched anew before the next part
    #[arg(long)]
    pub new_set_up: bool,
    /// How long the machine rests before the next part
    #[arg(long, value_name = "TIME", value_parser = rest)]
    pub pause: Option<f64>,
    /// Which of the jobs comes next
    #[arg(long, value_name = "NAME")]
    pub next_job: Option<String>,
    /// Tell, and add nothing to the log
    #[arg(long)]
    pub dry_run: bool,
    /// Write the answer as a page too
    #[arg(long, value_name = "FILE.html")]
    pub page: Option<PathBuf>,
    /// Replace a page that this program did not write
    #[arg(long, requires = "page")]
    pub force: bool,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// A known quantity of a kind, SI.
fn known(text: &str, kind: &Kind) -> Result<f64, String> {
    let wrong = |message: &str| format!("{message}: write '{}'", kind.example());
    let quantity = Quantity::parse(text, kind).map_err(|error| wrong(&error.message))?;
    match quantity.knowledge {
        Knowledge::Known => Ok(quantity.value),
        _ => Err(wrong("it is known what was done")),
    }
}

fn offset(text: &str) -> Result<f64, String> {
    known(text, &MICRO)
}

fn rest(text: &str) -> Result<f64, String> {
    known(text, &TIME)
}

/// A number that is one.
fn finite(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|number| number.is_finite());
    number.ok_or_else(|| "write a number, as 10".into())
}
