//! Files of the page, which stand in the program.

use crate::output::sheet;

/// A file by its name: its type and its bytes.
pub fn asset(name: &str) -> Option<(&'static str, &'static [u8])> {
    const HTML: &str = "text/html; charset=utf-8";
    const JS: &str = "text/javascript; charset=utf-8";
    const TEXT: &str = "text/plain; charset=utf-8";
    const CSS: &str = "text/css; charset=utf-8";
    // Figures look and answer as in every page.
    const FIGURES: &str = concat!(include_str!("../../templates/figures.js"), "\nexport { livenAll };\n");
    match name {
        "figures.css" => return Some((CSS, sheet().as_bytes())),
        "figures.js" => return Some((JS, FIGURES.as_bytes())),
        _ => {}
    }
    macro_rules! of {
        ($($name:literal: $kind:expr,)*) => {
            match name {
                $($name => Some(($kind, include_bytes!(concat!("../../templates/workbench/", $name)).as_slice())),)*
                _ => None,
            }
        };
    }
    of! {
        "index.html": HTML,
        "workbench.css": CSS,
        "absent.js": JS,
        "app.js": JS,
        "bars.js": JS,
        "causes.js": JS,
        "columns.js": JS,
        "correct.js": JS,
        "data.js": JS,
        "dom.js": JS,
        "field.js": JS,
        "header.js": JS,
        "job.js": JS,
        "lists.js": JS,
        "main.js": JS,
        "model.js": JS,
        "numbers.js": JS,
        "plot.js": JS,
        "readings.js": JS,
        "residuals.js": JS,
        "server.js": JS,
        "steps.js": JS,
        "texts.js": JS,
        "trial.js": JS,
        "uplot/LICENSE": TEXT,
        "uplot/uPlot.iife.min.js": JS,
        "uplot/uPlot.min.css": CSS,
    }
}
