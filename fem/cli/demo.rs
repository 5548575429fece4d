//! `fem demo`: a story to try everything on.

use super::args;
use super::error::Error;
use super::terminal::print;
use crate::ask::STORY;
use crate::input::Problem;
use crate::output::files::{self, Guard};

pub fn demo(args: &args::Demo) -> Result<(), Error> {
    let directory = &args.directory;
    if let Some((name, _)) = STORY.iter().find(|(name, _)| directory.join(name).exists()) {
        let problem = Problem::new(format!("{} exists already", directory.join(name).display()));
        return Err(Error::from(problem.help("name another folder: fem demo FOLDER")));
    }
    for (name, text) in STORY {
        files::write(&directory.join(name), text.as_bytes(), Guard { reads: &[], force: false })?;
    }
    let folder = directory.display();
    print(&format!(
        "written {folder}/rigid.toml, a lathe that is believed to be rigid, {folder}/measured.csv, twelve shafts that it turned,
and {folder}/corrected.csv, the same job made again as the fifth command says

  cd {folder}
  fem run rigid.toml                                                what the model predicts
  fem compare rigid.toml --with measured.csv                        how far off it is, and where
  fem diagnose rigid.toml --with measured.csv --add-to better.toml  what is missing
  fem compare rigid.toml better.toml --with measured.csv            the error before and after
  fem correct better.toml -o correction                             what to command
  fem compare better.toml --with corrected.csv                      what is left on the parts then
  fem report rigid.toml --with measured.csv -o report.html          all of it as a page for a browser
"
    ))
}
