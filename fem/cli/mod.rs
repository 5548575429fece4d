//! The command line: one file per command.

mod add;
mod args;
mod budget;
mod compare;
mod compensate;
mod data;
mod diagnose;
mod effects;
mod error;
mod fit;
mod import;
mod new;
mod plan;
mod run;
mod say;
mod schema;
mod terminal;
mod validate;
mod watch;

use std::process::ExitCode;

use clap::{CommandFactory, Parser};

use args::{Args, Command};
use terminal::print;

/// Runs the command that the user typed.
pub fn main() -> ExitCode {
    watch::prepare();
    let args = Args::parse();
    let result = match args.command {
        Command::Run(args) => run::run(&args),
        Command::Compare(args) => compare::run(&args),
        Command::Fit(args) => fit::run(&args),
        Command::Diagnose(args) => diagnose::run(&args),
        Command::Compensate(args) => compensate::run(&args),
        Command::Plan(args) => plan::run(&args),
        Command::Budget(args) => budget::run(&args),
        Command::Effects(args) => effects::effects(&args),
        Command::Add(args) => add::add(&args),
        Command::New(args) => new::new(&args),
        Command::Import(args) => import::import(&args),
        Command::Schema => schema::schema(),
        Command::Validate(args) => validate::validate(&args),
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(shell, &mut Args::command(), "fem", &mut script);
            print(&String::from_utf8_lossy(&script))
        }
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => error.report(),
    }
}
