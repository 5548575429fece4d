//! The command line: one file per command, which reads its arguments, asks, and prints.

mod add;
mod args;
mod budget;
mod compare;
mod compensate;
mod correct;
mod data;
mod demo;
mod diagnose;
mod discover;
mod effects;
mod error;
mod fit;
mod import;
mod look;
mod new;
mod next;
mod open;
mod plan;
mod report;
mod run;
mod say;
mod schema;
mod serve;
mod set;
mod start;
mod study;
mod terminal;
mod validate;
mod watch;
mod written;

use std::ffi::{OsStr, OsString};

use clap::{CommandFactory, Parser};

use crate::input::{Problem, one_line};
use crate::output::files;
use crate::output::study::OWN;

use args::{Args, Command};
use terminal::print;

/// Runs a command by its arguments, the name of the program first, and returns the exit status: 0 done, 1 not computed or
/// not written, 2 wrong input. Help and wrong arguments end the process at once, as Ctrl-C does from here on.
pub fn command(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    watch::prepare();
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    if let Err(problem) = arguments.iter().try_for_each(|argument| plain(argument)) {
        return error::Error::from(problem).report();
    }
    let args = Args::parse_from(arguments);
    let result = match args.command {
        None => start::start(),
        Some(Command::Run(args)) => run::run(&args),
        Some(Command::Compare(args)) => compare::run(&args),
        Some(Command::Discover(args)) => discover::run(&args),
        Some(Command::Fit(args)) => fit::run(&args),
        Some(Command::Diagnose(args)) => diagnose::run(&args),
        Some(Command::Compensate(args)) => compensate::run(&args),
        Some(Command::Correct(args)) => correct::run(&args),
        Some(Command::Next(args)) => next::run(&args),
        Some(Command::Open(args)) => open::run(&args),
        Some(Command::Report(args)) => report::run(&args),
        Some(Command::Plan(args)) => plan::run(&args),
        Some(Command::Budget(args)) => budget::run(&args),
        Some(Command::Study(args)) => study::run(&args),
        Some(Command::Effects(args)) => effects::effects(&args),
        Some(Command::Add(args)) => add::add(&args),
        Some(Command::Set(args)) => set::run(&args),
        Some(Command::Demo(args)) => demo::demo(&args),
        Some(Command::New(args)) => new::new(&args),
        Some(Command::Import(args)) => import::import(&args),
        Some(Command::Schema { of }) => schema::schema(of),
        Some(Command::Validate(args)) => validate::validate(&args),
        Some(Command::Completions { shell }) => {
            let mut script = Vec::new();
            clap_complete::generate(shell, &mut Args::command(), "fem", &mut script);
            print(&String::from_utf8_lossy(&script))
        }
    };
    match result {
        Ok(()) => 0,
        Err(error) => error.report(),
    }
}

/// Refuses the name of a file with a line end in it, for a list as a value may have some, or that the program needs itself.
fn plain(argument: &OsStr) -> Result<(), Problem> {
    let text = argument.to_string_lossy();
    let is_value = !text.starts_with('-') && text.split(['\n', '\r']).next().is_some_and(|first| first.contains('='));
    if is_value {
        return Ok(());
    }
    one_line(&text)?;
    let path = text.strip_prefix('-').and_then(|option| option.split_once('=')).map_or(&*text, |(_, path)| path);
    match path.split(['/', '\\']).find(|part| *part == files::LIST || OWN.contains(part)) {
        None => Ok(()),
        Some(own) => {
            let problem =
                Problem::new(format!("`{own}` is a file in which the program keeps what it has written itself"));
            Err(problem.help("name another file or folder"))
        }
    }
}
