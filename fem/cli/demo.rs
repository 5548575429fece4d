//! `fem demo`: a story to try everything on.

use std::path::Path;

use super::args;
use super::error::Error;
use super::terminal::print;
use crate::input::Problem;
use crate::output::OutputError;
use crate::output::files::{Guard, Stage};

/// The files of the story.
const FILES: [(&str, &str); 2] = [
    ("rigid.toml", include_str!("../../models/story/rigid.toml")),
    ("measured.csv", include_str!("../../models/story/measured.csv")),
];

pub fn demo(args: &args::Demo) -> Result<(), Error> {
    let directory = &args.directory;
    if let Some((name, _)) = FILES.iter().find(|(name, _)| directory.join(name).exists()) {
        let problem = Problem::new(format!("{} exists already", directory.join(name).display()));
        return Err(Error::Request(problem.help("name another folder: fem demo FOLDER")));
    }
    let unwritable = |error| OutputError::File { path: directory.clone(), error };
    let stage = Stage::new(directory, "demo", Guard { reads: &[], force: false }).map_err(unwritable)?;
    for (name, text) in FILES {
        stage.write(Path::new(name), text.as_bytes())?;
    }
    stage.publish()?;
    let folder = directory.display();
    print(&format!(
        "written {folder}/rigid.toml, a lathe that is believed to be rigid, and {folder}/measured.csv, twelve shafts that it turned

  cd {folder}
  fem run rigid.toml                                                what the model predicts
  fem compare rigid.toml --with measured.csv                        how far off it is, and where
  fem diagnose rigid.toml --with measured.csv --add-to better.toml  what is missing
  fem compare rigid.toml better.toml --with measured.csv            the error before and after
  fem report rigid.toml --with measured.csv -o report.html          all of it as a page for a browser
"
    ))
}
