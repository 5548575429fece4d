//! The picture of the calibration: what was told with a probability, against how much of it is there, from the table of
//! whole machines in `README.md`.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use statrs::distribution::{Beta, ContinuousCDF};

/// How much of what was told within a range of probabilities is there, and how much was told.
type Count = (usize, usize);

/// Width and height of the plane, and the margins left and above, pixels.
const PLANE: f64 = 360.0;
const LEFT: f64 = 60.0;
const ABOVE: f64 = 16.0;

/// A text of the repository.
fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_path_buf()
}

fn place() -> PathBuf {
    root().join("docs/calibration.svg")
}

/// Rows of the table with their names.
type Counted = Vec<(String, Vec<Count>)>;

/// Lower and upper ends of the ranges of probability, and the rows.
fn table() -> (Vec<[f64; 2]>, Counted) {
    let text = read(&root().join("tests/diagnosis/README.md"));
    let cells = |line: &str| line.trim_matches('|').split('|').map(|cell| cell.trim().to_string()).collect::<Vec<_>>();
    let mut lines = text.lines().skip_while(|line| !line.contains("| 5 to 10 % |"));
    let range = |cell: &String| {
        let (from, to) = cell.trim_end_matches(" %").split_once(" to ").unwrap();
        [from, to].map(|end| 0.01 * end.parse::<f64>().unwrap())
    };
    let ranges = cells(lines.next().unwrap()).iter().filter(|cell| !cell.is_empty()).map(range).collect();
    let count = |cell: &String| {
        let (there, told) = cell.split_once(" of ").unwrap();
        (there.parse().unwrap(), told.parse().unwrap())
    };
    let row = |line: &str| {
        let cells = cells(line);
        (cells[0].clone(), cells[1..].iter().map(count).collect())
    };
    (ranges, lines.skip(1).take_while(|line| line.starts_with('|')).map(row).collect())
}

/// The interval of a share, 95 %, of which so many of so many were seen (Clopper and Pearson 1934).
fn interval((seen, all): Count) -> [f64; 2] {
    let quantile = |a: usize, b: usize, p: f64| Beta::new(a as f64, b as f64).unwrap().inverse_cdf(p);
    [
        if seen == 0 { 0.0 } else { quantile(seen, all - seen + 1, 0.025) },
        if seen == all { 1.0 } else { quantile(seen + 1, all - seen, 0.975) },
    ]
}

fn picture(ranges: &[[f64; 2]], counts: &[Count]) -> String {
    let (x, y) = (|p: f64| LEFT + PLANE * p, |share: f64| ABOVE + PLANE * (1.0 - share));
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0} {:.0}\" font-family=\"sans-serif\" font-size=\"12\">\n\
         <title>Probability told, against the share that is there</title>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        LEFT + PLANE + 16.0,
        ABOVE + PLANE + 62.0,
    );
    let mut line = |from: [f64; 2], to: [f64; 2], style: &str| {
        let ([x1, y1], [x2, y2]) = (from, to);
        writeln!(svg, "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" {style}/>").unwrap();
    };
    for tenth in 0..=10 {
        let at = 0.1 * f64::from(tenth);
        line([x(at), y(0.0)], [x(at), y(1.0)], "stroke=\"#e6e6e6\"");
        line([x(0.0), y(at)], [x(1.0), y(at)], "stroke=\"#e6e6e6\"");
    }
    line([x(0.0), y(0.0)], [x(1.0), y(1.0)], "stroke=\"#888\" stroke-dasharray=\"5 4\"");
    let told = || ranges.iter().zip(counts).filter(|(_, count)| count.1 > 0);
    for ([from, to], count) in told() {
        let (middle, share, [low, high]) = (0.5 * (from + to), count.0 as f64 / count.1 as f64, interval(*count));
        line([x(middle), y(low)], [x(middle), y(high)], "stroke=\"#0b62a4\" stroke-width=\"2\"");
        line([x(*from), y(share)], [x(*to), y(share)], "stroke=\"#0b62a4\" stroke-width=\"4\"");
    }
    let mut text = |at: [f64; 2], anchor: &str, words: &str| {
        let [x, y] = at;
        writeln!(svg, "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" fill=\"#222\">{words}</text>").unwrap();
    };
    for fifth in 0..=5 {
        let at = 0.2 * f64::from(fifth);
        text([x(at), y(0.0) + 16.0], "middle", &format!("{:.0} %", 100.0 * at));
        text([x(0.0) - 6.0, y(at) + 4.0], "end", &format!("{:.0} %", 100.0 * at));
    }
    for ([from, to], count) in told() {
        text([x(0.5 * (from + to)), y(0.0) + 32.0], "middle", &count.1.to_string());
    }
    text([x(0.0) - 6.0, y(0.0) + 32.0], "end", "told");
    text([x(0.5), y(0.0) + 52.0], "middle", "probability told of an effect, and how many were told so");
    writeln!(
        svg,
        "<text transform=\"translate(14 {:.1}) rotate(-90)\" text-anchor=\"middle\" fill=\"#222\">share that is there</text>\n</svg>",
        y(0.5)
    )
    .unwrap();
    svg
}

fn of_the_table() -> String {
    let (ranges, rows) = table();
    let (all, processes) = rows.split_last().unwrap();
    assert_eq!(all.0, "all");
    for (range, counts) in all.1.iter().enumerate() {
        let sum = processes.iter().fold((0, 0), |sum, row| (sum.0 + row.1[range].0, sum.1 + row.1[range].1));
        assert_eq!(sum, *counts, "range {range} of the row of all processes");
    }
    picture(&ranges, &all.1)
}

#[test]
fn the_picture_of_the_calibration_is_that_of_the_table() {
    assert_eq!(read(&place()), of_the_table(), "draw it anew: README.md says how");
}

#[test]
#[ignore = "writes docs/calibration.svg"]
fn draw_the_calibration() {
    std::fs::write(place(), of_the_table()).unwrap();
}

/// Of none and of all of n the interval has a closed form: an end p with pⁿ or (1 − p)ⁿ = 2.5 %.
#[test]
fn a_share_that_was_seen_never_or_always_has_the_closed_interval() {
    for n in [1, 7, 40, 1114] {
        let end = 0.025f64.powf(1.0 / n as f64);
        let [never, always] = [interval((0, n)), interval((n, n))];
        assert!(never[0] == 0.0 && (never[1] - (1.0 - end)).abs() < 1e-9, "{never:?}");
        assert!(always[1] == 1.0 && (always[0] - end).abs() < 1e-9, "{always:?}");
    }
}
