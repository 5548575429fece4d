//! Programs before and after.

use fem::gcode::{Breadth, Spot, Workpiece};

use super::interpreter::{Motion, height, motions};
use super::styles::STYLES;
use super::{LENGTH, WIDTH, carry, top, wanted};
use crate::random::Random;
use crate::words::{mm, without};

/// A program without the numbers of its Z words: what must not change.
fn others(text: &[u8]) -> Vec<u8> {
    without(text, "Z")
}

/// Places over the top on the tracks of a path, mm.
fn on_tracks(path: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let between =
        |pair: &[[f64; 2]]| [0.21, 0.5, 0.83].map(|s| [0, 1].map(|i| pair[0][i] + s * (pair[1][i] - pair[0][i])));
    let all = path.windows(2).flat_map(between);
    all.filter(|[x, y]| (0.0..=LENGTH).contains(x) && (0.0..=WIDTH).contains(y)).collect()
}

/// By how much the height was changed too much or too little, um, at the worst place.
fn worst(before: &[Motion], after: &[Motion], places: &[[f64; 2]]) -> f64 {
    let off = |place: &[f64; 2]| {
        let [was, is] = [before, after].map(|all| height(all, *place).unwrap().0);
        (1e3 * (is - was) - wanted(place[0], place[1])).abs()
    };
    places.iter().map(off).fold(0.0, f64::max)
}

#[test]
fn every_style_carries_the_top_to_its_increment_and_keeps_every_other_byte() {
    for style in STYLES {
        let text = style.program();
        let found = carry(&top(), &text, false).unwrap_or_else(|error| panic!("{}: {error}", style.name));
        assert_eq!(others(&text), others(&found.bytes), "{}", style.name);
        let [before, after] = [&text, &found.bytes].map(|text| motions(text));
        let half = if style.name == "inches" { 0.5 * 0.1 * 25.4 } else { 0.5 };
        let places = on_tracks(&style.path());
        assert!(places.len() > 300, "{}", style.name);
        let worst = worst(&before, &after, &places);
        // A track carries the mean over its breadth, here of 8.33 mm: beside a sine that is off by b²/24 times its bow.
        let bow = if style.is_across { (LENGTH / 12.0).powi(2) / 24.0 * 6.0 / 121.0 } else { 0.0 };
        assert!(worst < half + bow + 0.06, "{}: {worst} um of {half} um", style.name);
        assert!(found.words > 100 && found.added == 0 && found.others.is_empty(), "{}: {}", style.name, found.words);
        assert!(found.unfinished.is_empty(), "{}: {:?}", style.name, found.unfinished);
        // What is left is the slope across the breadth of a track: 5 mm of 0.3 um/mm, or of the one along it.
        assert!(found.left.worst < 1e-6 * (1.5 + 4.1 * 0.7 + half), "{}: {:?}", style.name, found.left);
        // Ways without a cut end where they did: sums of words that count on close.
        let ends = |all: &[Motion]| all.iter().filter(|own| !own.cuts).map(|own| own.to).collect::<Vec<_>>();
        assert_eq!(ends(&before), ends(&after), "{}", style.name);
    }
}

/// A face by a larger cutter, the finishing pass there and back with a round turn, a slot and a hole that are cut
/// afterwards, and the edge with a radius that stands in the control.
const WHOLE: &str = "\
%
(TOP Z0, 100 BY 40)
N10 G17 G21 G40 G49 G80 G90
N20 T1 M6
N30 G54 G0 X-40. Y20. S800 M3
N40 G43 H1 Z50.
N50 Z0.5 (leaves half)
N60 G1 X140. F500 (roughing)
N70 G0 Z50.
N80 T2 M6
N90 G0 X-14. Y10.
N100 G43 H2 Z50.
N110 Z1.
N120 G1 Z0. F300
N130 X110.
N140 G3 X110. Y30. J10.
N150 G1 X-14.
N160 G0 Z50.
N170 X50. Y-10.
N180 G1 Z-3. F100 (slot)
N190 Y50.
N200 G0 Z10.
N210 X20. Y20.
N220 G1 Z-8. (hole)
N230 G2 X20. Y20. I3.
N240 G0 Z10.
N250 G41 D2 G1 X-10. Y0. F200
N260 Z-5.
N270 X110. (edge)
N280 G40 Y-30.
N290 G0 Z50.
N300 G91 G28 Z0.
N310 M30
%
";

#[test]
fn what_does_not_finish_the_top_keeps_its_place() {
    let found = carry(&top(), WHOLE.as_bytes(), false).unwrap();
    let text = String::from_utf8(found.bytes.clone()).unwrap();
    let changed: Vec<&str> =
        WHOLE.lines().zip(text.lines()).filter(|(was, is)| was != is).map(|(was, _)| was).collect();
    assert_eq!(changed, ["N120 G1 Z0. F300"], "{text}");
    assert!(found.others.is_empty() && found.is_short && found.could_add, "{:?}", found.others);
    // One height for all: the mean of what is wanted.
    let [low, high] = found.changed;
    let mean = (0..1000).map(|i| wanted(LENGTH * (f64::from(i) + 0.5) / 1000.0, 0.5 * WIDTH)).sum::<f64>() / 1000.0;
    assert!((low - high).abs() < 1e-12 && (1e6 * low - mean).abs() < 0.55, "{low} {high} {mean}");
    // The model's places are told: each has that change.
    assert!(found.carried.len() == 3 * 401 && found.carried.iter().all(|own| (own - low).abs() < 1e-12));
}

#[test]
fn blocks_put_between_carry_the_top_and_nothing_else_changes() {
    for (name, text) in [
        ("plain", WHOLE.to_string()),
        ("ends of both", WHOLE.replace('\n', "\r\n")),
        ("small and narrow", WHOLE.to_lowercase().replace(" x", "x").replace(" y", "y").replace(" f", "f")),
        ("skipped alike", WHOLE.replace("N130 ", "/N130 ")),
        ("straight over", WHOLE.replace("G3 X110. Y30. J10.", "G1 Y30.")),
    ] {
        let found = carry(&top(), text.as_bytes(), true).unwrap_or_else(|error| panic!("{name}: {error}"));
        let [before, after] = [text.as_bytes(), &found.bytes].map(motions);
        let tracks = on_tracks(&(0..=250).map(|i| [0.4 * f64::from(i), 10.0]).collect::<Vec<_>>());
        let back = on_tracks(&(0..=250).map(|i| [0.4 * f64::from(i), 30.0]).collect::<Vec<_>>());
        for places in [tracks, back] {
            let worst = worst(&before, &after, &places);
            // The chord, half an increment at either end, and the start of a track, whose height is that of the end of
            // the turn.
            assert!(worst < 1.0 + 0.6, "{name}: {worst}\n{}", String::from_utf8_lossy(&found.bytes));
        }
        assert!(found.added > 8, "{name}: {}", found.added);
        // Lines of the old program stand in the new one in their order, but for Z words and those put in.
        let bare = |line: &[u8]| {
            others(line).into_iter().filter(|byte| !matches!(byte, b'Z' | b'z' | b' ')).collect::<Vec<_>>()
        };
        let lines = |text: &[u8]| text.split(|byte| *byte == b'\n').map(bare).collect::<Vec<_>>();
        let (old, mut new) = (lines(text.as_bytes()), lines(&found.bytes).into_iter());
        for line in &old {
            assert!(new.any(|own| own == *line), "{name}: {:?}", String::from_utf8_lossy(line));
        }
        // Arcs lie flat, as they did, and what is not finished is where it was.
        assert!(after.iter().filter(|own| own.arc.is_some()).all(|own| own.from[2] == own.to[2]), "{name}");
        let deep =
            |all: &[Motion]| all.iter().filter(|own| mm(own.to[2]).abs() > 0.3).map(|own| own.to).collect::<Vec<_>>();
        assert_eq!(deep(&before), deep(&after), "{name}");
    }
}

#[test]
fn an_arc_in_the_finishing_pass_moves_as_a_whole() {
    let text = "G0 X-14 Y30 Z5\nG1 Z0 F300\nX60\nG2 X60 Y10 Z0 R10\nG1 X-14 Z0\nG0 Z5\nM2\n";
    let found = carry(&top(), text.as_bytes(), true).unwrap();
    let [before, after] = [text.as_bytes(), &found.bytes].map(motions);
    let arc = after.iter().find(|own| own.arc.is_some()).unwrap();
    assert_eq!(arc.from[2], arc.to[2]);
    // As high as is wanted in the mean over the half disc that is nearest to it, but for the tracks on either side,
    // which go on from it.
    let of_disc = (0..2500).map(|i| [60.0 + 0.44 * f64::from(i % 50), -2.0 + 0.88 * f64::from(i / 50)]);
    let own = of_disc.filter(|[x, y]| (x - 60.0).hypot(y - 20.0) < 22.0 && (0.0..WIDTH).contains(y));
    let own: Vec<f64> = own.map(|[x, y]| wanted(x, y)).collect();
    let (is, mean) = (1e3 * mm(arc.to[2]), own.iter().sum::<f64>() / own.len() as f64);
    assert!((is - mean).abs() < 1.0, "{is} {mean}");
    let straight = on_tracks(&(0..=100).map(|i| [0.4 * f64::from(i), 30.0]).collect::<Vec<_>>());
    assert!(worst(&before, &after, &straight) < 1.6);
    assert!(found.unfinished.len() == 1 && found.unfinished[0][1] > 0.099, "{:?}", found.unfinished);
}

#[test]
fn comments_of_any_code_page_and_marks_of_the_file_stay() {
    let mut text = b"\xEF\xBB\xBF(L\xE4nge \xD8 Z30)\nG21 G17 ;\xB5m Z1\n".to_vec();
    text.extend_from_slice(&STYLES[0].program());
    text.extend_from_slice(b"\n\n  \t\n%\n\x00\xFF");
    let found = carry(&top(), &text, false).unwrap();
    assert_eq!(others(&text), others(&found.bytes));
    assert!(found.words > 150);
}

/// A zero in the middle of the top and above it gives the same changes; without one the program finishes nothing, and
/// it is said where.
#[test]
fn the_zero_is_as_the_model_says() {
    let text = "G0 X-64 Y0 Z5\nG1 Z-2 F300\nX64\nG0 Z50\nM2\n";
    let work = Workpiece {
        zero: Spot { x: 0.5e-3 * LENGTH, y: 0.0, r: 2e-3 },
        breadth: Some(Breadth { half: 0.5e-3 * WIDTH, reach: 20e-3 }),
        ..top()
    };
    let found = carry(&work, text.as_bytes(), true).unwrap();
    let [before, after] = [text.as_bytes(), &found.bytes].map(motions);
    for i in 0..200 {
        let x = -50.0 + 0.5 * f64::from(i);
        let [was, is] = [&before, &after].map(|all| height(all, [x, 0.0]).unwrap().0);
        let off = 1e3 * (is - was) - wanted(x + 50.0, 20.0);
        assert!(off.abs() < 1.6 && (was + 2.0).abs() < 1e-9, "{x} {off}");
    }
    // What a flat cutter of 40 mm takes more at a place, for it stands lower somewhere on its way over it.
    let z = |x: f64| 1e3 * height(&after, [x, 0.0]).unwrap().0;
    let all: Vec<f64> = (0..=1200).map(|i| z(-60.0 + 0.1 * f64::from(i))).collect();
    let lowest =
        |at: usize| all[at.saturating_sub(200)..=(at + 200).min(1200)].iter().copied().fold(f64::INFINITY, f64::min);
    let deeper = (100..=1100).map(|at| all[at] - lowest(at)).fold(0.0, f64::max);
    let told = 1e6 * found.deeper.unwrap().worst;
    assert!(deeper > 5.0 && (told - deeper).abs() < 0.1, "{told} {deeper}");
    let error = carry(&top(), text.as_bytes(), false).unwrap_err();
    let what = "top.ngc:3:1: no block finishes the part; nearest, this one cuts at -2.000 mm of height where the part has 0.000 mm";
    assert!(error.contains(what) && error.contains("[program]"), "{error}");
}

/// Whatever bytes a file has, it is read or refused, and what is written of it is read again.
#[test]
fn spoilt_programs_are_read_or_refused() {
    let mut random = Random(11);
    let mut read = 0;
    for _ in 0..400 {
        let text = random.spoilt(WHOLE, b"0123456789.-+GXYZIJRFDH /(;%\r\n");
        let adds = random.between(0.0, 1.0) < 0.5;
        if let Ok(found) = carry(&top(), &text, adds) {
            read += 1;
            assert!(adds || others(&text) == others(&found.bytes), "{}", String::from_utf8_lossy(&text));
        }
    }
    assert!((50..380).contains(&read), "{read}");
}
