//! What a user sees: pages, errors, exit statuses, files.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod add;
mod axis;
mod bad_input;
mod budget;
mod cam;
mod compare;
mod compensate;
mod contour;
mod faults;
mod fem;
mod files;
mod fixture;
mod import;
mod measurement;
mod mesh_file;
mod pages;
mod passes;
mod ring;
mod stiffness;
mod story;
mod thermal;
mod writing;
mod written;
