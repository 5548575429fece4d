//! What several commands take alike: measurements and how they are read, and how long a command may take.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use crate::progress::Progress;
use crate::units::{Knowledge, Quantity, TIME};

/// Measurements and how they are read.
#[derive(Debug, clap::Args)]
pub struct Data {
    /// The measurements; once for each of several files
    #[arg(long, value_name = "DATA.csv", required = true)]
    pub with: Vec<PathBuf>,
    #[command(flatten)]
    pub reading: Reading,
}

/// How long a command may take.
#[derive(Clone, Debug, clap::Args)]
pub struct Limit {
    /// When to stop with what is found by then, as '30 s' or '5 min'; what is left undone is told
    #[arg(long, value_name = "TIME", value_parser = time)]
    pub time_limit: Option<Duration>,
}

fn time(text: &str) -> Result<Duration, String> {
    let wrong = |message: &str| format!("{message}: write '30 s' or '5 min'");
    let time = Quantity::parse(text, &TIME).map_err(|error| wrong(&error.message))?;
    match time.knowledge {
        Knowledge::Known => Duration::try_from_secs_f64(time.value).map_err(|_| wrong("no such time")),
        _ => Err(wrong("a limit is known")),
    }
}

impl Limit {
    /// The progress of a command that is watched and may take so long.
    pub fn progress(&self) -> Arc<Progress> {
        Arc::new(Progress::within(self.time_limit))
    }
}

/// What a file does not say itself.
#[derive(Clone, Debug, clap::Args)]
pub struct Reading {
    /// What columns are: 'Zeit=time [s],T1=temperature@x=12 mm'; - leaves one out
    #[arg(long, value_name = "HEADING=NAME,..")]
    pub columns: Vec<String>,
    /// The decimal mark, where a file could mean either; the other one groups thousands
    #[arg(long, value_name = "MARK")]
    pub decimal: Option<Mark>,
    /// The line in which the headings stand; 0 where there are none
    #[arg(long, value_name = "LINE")]
    pub header: Option<usize>,
    /// Take readings as they are typed, slips of the pen too
    #[arg(long)]
    pub as_typed: bool,
    /// The sheet of a workbook
    #[arg(long, value_name = "NAME")]
    pub sheet: Option<String>,
}

/// A decimal mark.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub enum Mark {
    /// 1,5
    Comma,
    /// 1.5
    Point,
}
