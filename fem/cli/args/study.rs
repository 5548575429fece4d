//! Arguments of `fem study`.

use std::path::PathBuf;

use clap::Subcommand;

use super::Limit;
use crate::study::Shard;

#[derive(Debug, clap::Args)]
#[command(
    args_conflicts_with_subcommands = true,
    subcommand_precedence_over_arg = true,
    after_help = "A study that was stopped, by whatever, goes on with the same command: no job is lost, none is done twice. `fem new study` writes
a commented plan.

Examples:
  fem study plan.toml
  fem study plan.toml --shard $SLURM_ARRAY_TASK_ID/8
  fem study merge out/plan-*-of-8 -o out/plan"
)]
pub struct Study {
    #[command(subcommand)]
    pub command: Option<StudyCommand>,
    /// The plan: a model, what varies in it, what is done and what is wanted
    pub plan: Option<PathBuf>,
    /// Where to write; out/<plan name> if left out, of a shard out/<plan name>-<i>-of-<n>
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Do part i of n of the jobs, i from 1
    #[arg(long, value_name = "i/n", value_parser = shard)]
    pub shard: Option<Shard>,
    /// Drop the rows that stand there of this or another plan, and begin anew
    #[arg(long)]
    pub restart: bool,
    /// Go on with rows, or drop them, that you have not begun on this account
    #[arg(long)]
    pub force: bool,
    /// Write the finished rows as Parquet too (where the program was built with the feature `parquet`)
    #[arg(long, value_name = "ROWS.parquet")]
    pub parquet: Option<PathBuf>,
    #[command(flatten)]
    pub limit: Limit,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Subcommand)]
pub enum StudyCommand {
    /// Put the rows of all shards together, as if the study had been done in one
    Merge(Merge),
}

#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  fem study merge out/plan-*-of-8 -o out/plan")]
pub struct Merge {
    /// The folders of the shards
    #[arg(required = true, value_name = "DIR")]
    pub folders: Vec<PathBuf>,
    /// Where to write
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

fn shard(text: &str) -> Result<Shard, String> {
    let parts = text.split_once('/').and_then(|(i, n)| Some((i.trim().parse().ok()?, n.trim().parse().ok()?)));
    match parts {
        Some((number, of)) if (1..=of).contains(&number) => Ok(Shard { number, of }),
        _ => Err("write i/n, i from 1 to n, as 3/8".into()),
    }
}
