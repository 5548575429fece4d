//! A program that serves a page; it ends with the test.

use std::io::{BufRead, BufReader};
use std::process::{Child, Stdio};

use super::fem::Place;

/// It, with the host and the path of its address.
pub struct Served {
    child: Child,
    pub host: String,
    pub path: String,
}

impl Drop for Served {
    fn drop(&mut self) {
        self.child.kill().unwrap();
        self.child.wait().unwrap();
    }
}

impl Served {
    /// Begins, and waits for the address.
    pub fn of(place: &Place, args: &[&str]) -> Self {
        let mut child = place.command(args).stderr(Stdio::piped()).stdout(Stdio::null()).spawn().unwrap();
        let mut told = String::new();
        BufReader::new(child.stderr.take().unwrap()).read_line(&mut told).unwrap();
        let address = told.split_whitespace().next().and_then(|own| own.strip_prefix("http://"));
        let (host, path) = address.and_then(|own| own.split_once('/')).unwrap_or_else(|| panic!("{told}"));
        Self { child, host: host.into(), path: path.into() }
    }
}
