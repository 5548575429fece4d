//! What a user sees: pages, errors, exit statuses, files.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod add;
mod agreement;
mod axis;
mod bad_input;
mod budget;
mod cam;
mod compare;
mod compensate;
mod contour;
mod correct;
mod discover;
mod events;
mod faults;
mod fem;
mod figures;
mod files;
mod fixture;
mod formula;
#[cfg(unix)]
mod hostile;
mod import;
mod measurement;
mod mesh_file;
mod next;
mod next_part;
mod odds;
mod pages;
mod passes;
mod program;
mod recorded;
mod records;
mod remedies;
mod report;
mod ring;
mod set;
mod start;
mod stiffness;
mod story;
mod study;
mod tailstock;
mod thermal;
mod validate;
mod writing;
mod written;
