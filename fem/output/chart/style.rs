//! The one look of all figures: legible on light and dark grounds and on paper, and to people who see few
//! colours.

use std::fmt::Write;
use std::sync::LazyLock;

/// Colours of lines and dots on light and on dark grounds (Okabe and Ito 2008, darkened or lightened until they
/// stand out from their ground).
pub const COLOURS: [(&str, &str); 6] = [
    ("#0072b2", "#56b4e9"),
    ("#b84f00", "#f0a04b"),
    ("#00785a", "#2fc79a"),
    ("#a8437f", "#e29ac4"),
    ("#7a6000", "#e0c341"),
    ("#5c5c5c", "#b8b8b8"),
];

/// Steps of the scales of maps.
pub const STEPS: usize = 25;

/// Ends and middle of the scale of two colours, on light and on dark grounds.
const TWO: [[[f64; 3]; 3]; 2] = [
    [[0.0, 92.0, 158.0], [246.0, 246.0, 244.0], [184.0, 72.0, 0.0]],
    [[104.0, 190.0, 245.0], [44.0, 46.0, 50.0], [246.0, 160.0, 72.0]],
];
/// Stops of the scale of one direction, alike on all grounds (cividis: Nuñez, Anderton and Renslow 2018).
const ONE: [[f64; 3]; 6] = [
    [0.0, 34.0, 78.0],
    [53.0, 69.0, 108.0],
    [102.0, 105.0, 112.0],
    [148.0, 142.0, 119.0],
    [200.0, 184.0, 102.0],
    [254.0, 232.0, 56.0],
];

static SHEET: LazyLock<String> = LazyLock::new(make);

/// The style sheet of all figures.
pub fn sheet() -> &'static str {
    &SHEET
}

fn make() -> String {
    let mut text = String::from(
        ".fem{font-family:system-ui,-apple-system,\"Segoe UI\",Roboto,\"Liberation Sans\",sans-serif}\
         .fem text{font-size:13px;fill:#333}.fem .t{font-size:16px;font-weight:600}.fem .s{font-size:12px;fill:#595959}\
         .fem .n{font-size:12px;fill:#595959}.fem .x{font-size:12.5px;fill:#333}\
         .fem .a,.fem .g,.fem .o,.fem .z,.fem .c,.fem .k,.fem .e{fill:none}\
         .fem .a{stroke:#767676;stroke-width:1}.fem .g{stroke:#888;stroke-width:.6;stroke-opacity:.35}\
         .fem .z{stroke:#767676;stroke-width:1}.fem .o{stroke:#767676;stroke-width:1.4}\
         .fem .c{stroke-width:2;stroke-linejoin:round;stroke-linecap:round}.fem .h{stroke-dasharray:6 4}\
         .fem .f{stroke-width:1;stroke-opacity:.3}.fem .e{stroke-width:1.1;stroke-opacity:.65}\
         .fem .d{stroke:none;fill-opacity:.85}.fem .w{stroke:none;fill-opacity:.16}\
         .fem .k{stroke:#888;stroke-width:.7}.fem .b{fill:#0072b2}.fem .first{fill:#b84f00}\
         .fem .y{stroke:#00785a;stroke-width:2;stroke-dasharray:5 4;fill:none}\
         .fem .body{fill:#cfd4da;stroke:#5f6b78;stroke-width:1.2}.fem .held{fill:#9aa3ad;stroke:#5f6b78;stroke-width:1}",
    );
    colours(&mut text, |c| c.0);
    maps(&mut text, &TWO[0]);
    for i in 0..STEPS {
        let _ = write!(text, ".fem .p{i}{{fill:{}}}", colour(&ONE, i));
    }
    text.push_str(
        "@media screen and (prefers-color-scheme:dark){.fem text{fill:#e4e4e4}.fem .s,.fem .n{fill:#b4b4b4}\
         .fem .x{fill:#dcdcdc}.fem .a,.fem .z,.fem .o{stroke:#9a9a9a}.fem .b{fill:#56b4e9}.fem .first{fill:#f0a04b}\
         .fem .y{stroke:#2fc79a}.fem .body{fill:#454c55;stroke:#a5afba}.fem .held{fill:#6a737d;stroke:#a5afba}",
    );
    colours(&mut text, |c| c.1);
    maps(&mut text, &TWO[1]);
    text.push('}');
    text
}

/// Writing to a String does not fail, here and below.
fn colours(text: &mut String, pick: fn(&(&'static str, &'static str)) -> &'static str) {
    for (i, colour) in COLOURS.iter().enumerate() {
        let colour = pick(colour);
        let _ = write!(text, ".fem .c{i}{{stroke:{colour}}}.fem .d{i},.fem text.d{i}{{fill:{colour}}}");
    }
}

fn maps(text: &mut String, stops: &[[f64; 3]; 3]) {
    for i in 0..STEPS {
        let _ = write!(text, ".fem .q{i}{{fill:{}}}", colour(stops, i));
    }
}

/// Colour of a step of a scale with these stops.
fn colour(stops: &[[f64; 3]], step: usize) -> String {
    let at = step as f64 / (STEPS - 1) as f64 * (stops.len() - 1) as f64;
    let below = (at as usize).min(stops.len() - 2);
    let part = at - below as f64;
    let [r, g, b] = [0, 1, 2].map(|i| (stops[below][i] + part * (stops[below + 1][i] - stops[below][i])).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}
