//! Programs before and after.

use fem::gcode::{Across, Spot, Workpiece};

use super::interpreter::{Motion, motions, surface};
use super::styles::STYLES;
use super::{LENGTH, STEP, carry, shaft, wanted};
use crate::random::Random;
use crate::words::{mm, without};

/// A program without the numbers of its words across: what must not change.
fn others(text: &[u8]) -> Vec<u8> {
    without(text, "XU")
}

/// By how much the surface was changed too much or too little, um, at the worst place of the finished sections.
fn worst(before: &[Motion], after: &[Motion]) -> f64 {
    let place = |i: u32| LENGTH * (f64::from(i) + 0.37) / 1000.0;
    (0..1000).map(place).fold(0.0, |worst: f64, x| {
        let [was, is] = [before, after].map(|all| surface(all, x - LENGTH).unwrap().0);
        let nominal = if x < STEP { 20.0 } else { 15.0 };
        if (was - nominal).abs() > 0.05 { worst } else { worst.max((1e3 * (is - was) - wanted(x)).abs()) }
    })
}

#[test]
fn every_style_carries_the_contour_to_its_increment_and_keeps_every_other_byte() {
    for style in STYLES {
        let text = style.program();
        let found = carry(&shaft(), &text, false).unwrap_or_else(|error| panic!("{}: {error}", style.name));
        assert_eq!(others(&text), others(&found.bytes), "{}", style.name);
        let [before, after] = [&text, &found.bytes].map(|text| motions(text, true));
        // Half an increment of the words, as a radius, and what blocks of 2 mm cannot bow.
        let least = if style.name == "inches" { 0.1e-3 * 25.4 } else { 1e-3 };
        let half = 0.5e3 * least * if style.name.starts_with("radii") { 1.0 } else { 0.5 };
        let worst = worst(&before, &after);
        assert!(worst < half + 0.06, "{}: {worst} um of {half} um", style.name);
        assert!(
            found.words > 40 && found.added == 0 && !found.is_short && found.others.is_empty(),
            "{}: {:?} {}",
            style.name,
            found.left,
            found.words
        );
        // Whatever is not finished is where it was, to the last part: the sums of words that count on close.
        let ends = |all: &[Motion]| all.iter().filter(|own| !own.cuts).map(|own| own.to).collect::<Vec<_>>();
        let [was, is] = [ends(&before), ends(&after)];
        assert_eq!(was.len(), is.len());
        assert_eq!(was.last(), is.last(), "{}", style.name);
        // The same text comes out again where nothing is wanted.
        assert_eq!(carry(&shaft(), &text, false).unwrap().bytes, found.bytes);
    }
}

/// Roughing, a face, a chamfer, a fillet, a groove that is cut afterwards, and a way back.
const WHOLE: &str = "\
%
(SHAFT, X30 AND X40)
N10 G18 G21 G40 G54
N20 G96 S180 M4
N30 G0 X42. Z2.
N40 G1 Z-100. F0.3 (roughing)
N50 X44.
N60 G0 Z2.
N70 X31.
N80 G1 Z-59.8
N90 X41.
N100 G0 Z0.
N110 G1 X-1. (face)
N120 G0 X26. Z2.
N130 G1 X26. Z1. F0.12
N140 X30. Z-1. (chamfer)
N150 Z-59.
N160 G2 X32. Z-60. R1. (fillet)
N170 G1 X38.
N180 G3 X40. Z-61. I0. K-1. (edge)
N190 G1 Z-100.
N200 X44.
N210 G0 Z-31.
N220 G1 X24. F0.05 (groove)
N225 Z-30.
N230 X44.
N240 G0 X60. Z20.
N250 M30
%
";

#[test]
fn what_does_not_finish_the_part_keeps_its_place() {
    let found = carry(&shaft(), WHOLE.as_bytes(), false).unwrap();
    assert_eq!(others(WHOLE.as_bytes()), others(&found.bytes));
    let text = String::from_utf8(found.bytes.clone()).unwrap();
    let changed: Vec<&str> =
        WHOLE.lines().zip(text.lines()).filter(|(was, is)| was != is).map(|(was, _)| was).collect();
    let names: Vec<&str> = changed.iter().map(|line| line.split(' ').next().unwrap()).collect();
    // The chamfer's end is the bearing's start; the fillet moves with the bearing's end, the edge with the seat's start.
    assert_eq!(names, ["N140", "N160", "N170", "N180"], "{text}");
    let left: Vec<&str> = found.others.iter().map(|own| own.block.as_str()).collect();
    assert_eq!(left, ["line 16 (N140)", "line 18 (N160)", "line 20 (N180)", "line 25 (N225)"]);
    let [before, after] = [WHOLE.as_bytes(), &found.bytes].map(|text| motions(text, true));
    // Both arcs are as round as they were, about centres that moved with them.
    for (was, is) in before.iter().zip(&after).filter(|(was, _)| was.arc.is_some()) {
        let moved = |spot: fn(&Motion) -> i128| mm(spot(is) - spot(was));
        assert!((moved(|own| own.from.1) - moved(|own| own.to.1)).abs() < 1e-9, "line {}", was.line);
        assert_ne!(was.to, is.to);
    }
    // What is left is what is told, to the places at which both look.
    let is = worst(&before, &after);
    assert!((1e6 * found.left.worst - is).abs() < 0.1 && found.is_short && found.could_add, "{is} {:?}", found.left);
}

#[test]
fn blocks_put_between_carry_the_contour_within_the_tolerance_and_nothing_else_changes() {
    for (name, text) in [
        ("plain", WHOLE.to_string()),
        ("ends of both", WHOLE.replace('\n', "\r\n")),
        ("small and narrow", WHOLE.to_lowercase().replace("x44.", "x44").replace(" z", "z").replace(" x", "x")),
        ("skipped alike", WHOLE.replace("N190 ", "/N190 ")),
        ("without a last end", WHOLE.trim_end_matches(['%', '\n']).to_string()),
    ] {
        let found = carry(&shaft(), text.as_bytes(), true).unwrap_or_else(|error| panic!("{name}: {error}"));
        let [before, after] = [text.as_bytes(), &found.bytes].map(|text| motions(text, true));
        let worst = worst(&before, &after);
        assert!(
            worst < 1.0 + 0.3 && !found.is_short && found.added > 4,
            "{name}: {worst} {:?} {}",
            found.left,
            found.added
        );
        // Lines of the old program stand in the new one in their order, but for words across and those put in.
        let bare = |line: &[u8]| {
            others(line).into_iter().filter(|byte| !matches!(byte, b'X' | b'x' | b' ')).collect::<Vec<_>>()
        };
        let lines = |text: &[u8]| text.split(|byte| *byte == b'\n').map(bare).collect::<Vec<_>>();
        let (old, mut new) = (lines(text.as_bytes()), lines(&found.bytes).into_iter());
        for line in &old {
            assert!(new.any(|own| own == *line), "{name}: {:?}", String::from_utf8_lossy(line));
        }
    }
}

#[test]
fn comments_of_any_code_page_and_marks_of_the_file_stay() {
    let mut text = b"\xEF\xBB\xBF(L\xE4nge \xD8 X30)\nG21 G18 ;\xB5m X1\n".to_vec();
    text.extend_from_slice(&STYLES[0].program());
    text.extend_from_slice(b"\n\n  \t\n%\n\x00\xFF");
    let found = carry(&shaft(), &text, false).unwrap();
    assert_eq!(others(&text), others(&found.bytes));
    assert!(found.words > 40 && !found.is_short);
}

#[test]
fn radii_and_another_zero_are_as_the_model_says() {
    let text = "G0 X21 Z103\nX15 Z101\nG1 X15 Z70 F.1\nX15 Z40\nX20\nX20 Z20\nX20 Z0\nG0 X30\nM2\n";
    let work = Workpiece { across: Across::Radius, zero: Spot::default(), ..shaft() };
    let found = carry(&work, text.as_bytes(), false).unwrap();
    assert_eq!(others(text.as_bytes()), others(&found.bytes));
    let moved = text.replace("Z103", "Z3").replace("Z101", "Z1").replace("Z70", "Z-30").replace("Z40", "Z-60");
    let moved = moved.replace("Z20", "Z-80").replace("Z0", "Z-100");
    let back = |text: &[u8]| {
        let text = String::from_utf8(text.to_vec()).unwrap();
        let mut numbers = text.split('X').map(|part| part.split([' ', '\n']).next().unwrap().to_string()).skip(1);
        let parts =
            moved.split('X').map(|part| part.split_once([' ', '\n']).map_or(part, |(_, rest)| rest).to_string());
        let ends = moved.split('X').skip(1).map(|part| part.chars().find(|c| " \n".contains(*c)).unwrap());
        let mut all = String::from("G0 ");
        for (rest, end) in parts.skip(1).zip(ends) {
            all += &format!("X{}{end}{rest}", numbers.next().unwrap());
        }
        all
    };
    let [before, after] = [text.as_bytes(), &found.bytes].map(|text| motions(back(text).as_bytes(), false));
    let is = worst(&before, &after);
    assert!((1e6 * found.left.worst - is).abs() < 0.1, "{is} {:?}", found.left);
    // By the wrong zero or as diameters nothing is finished, and it is said where.
    for (work, what) in [
        (shaft(), "no block cuts along the part"),
        (
            Workpiece { zero: Spot::default(), ..shaft() },
            "part.ngc:3:1: no block finishes the part; nearest, this one cuts at 15.000 mm",
        ),
    ] {
        let error = carry(&work, text.as_bytes(), false).unwrap_err();
        assert!(error.contains(what) && error.contains("[program]"), "{error}");
    }
}

#[test]
fn what_cannot_be_followed_is_refused_where_it_stands() {
    let good = "G18 G21\nG0 X60. Z5.\nX30. Z1.\nG1 Z-60. F.1\nX40.\nZ-100.\nG0 X60.\nM30\n";
    assert!(carry(&shaft(), good.as_bytes(), false).is_ok());
    for (from, to, place, message) in [
        ("X30. Z1.", "G71 U1. R.5", "3:1", "`G71` is a cycle"),
        ("X30. Z1.", "G42 X30. Z1.", "3:1", "nose radius"),
        ("X30. Z1.", "G90 X30. Z-50.", "3:5", "system A"),
        ("X30. Z1.", "M98 P100", "3:1", "`M98` calls a subprogram"),
        ("X30. Z1.", "G65 P9000", "3:1", "`G65` calls a macro"),
        ("X30. Z1.", "X#100", "3:1", "`X` has no number"),
        ("X30. Z1.", "WHILE X1", "3:1", "`WHILE` is no word"),
        ("X30. Z1.", "G92 X0", "3:5", "moves the zero"),
        ("X30. Z1.", "X30. Y1. Z1.", "3:6", "what `Y1` does"),
        ("X30. Z1.", "G112 X30. Z1.", "3:1", "polar"),
        ("X30. Z1.", "G123 X30. Z1.", "3:1", "what `G123` does is not known"),
        ("X30. Z1.", "G0 G1 X30. Z1.", "3:4", "a second motion"),
        ("G1 Z-60. F.1", "G76 P10060 Q100", "4:1", "is a cycle"),
        ("G1 Z-60. F.1", "G33 Z-60. K1.5", "4:1", "cuts a thread"),
        ("G1 Z-60. F.1", "G1 Z-60. R2. F.1", "4:10", "a corner that the control computes"),
        ("G1 Z-60. F.1", "G1 Z-60.,R2.", "4:9", "a corner after a comma"),
        ("G1 Z-60. F.1", "G1 Z-60. W1.", "4:10", "told twice"),
        ("G1 Z-60. F.1", "G17 G2 X30. Z-60. R90.", "4:1", "other than G18"),
        ("G1 Z-60. F.1", "G2 X30. Z-60. I3. K1.", "4:1", "not on one circle"),
        ("G1 Z-60. F.1", "T0202\nG1 Z-60. F.1", "5:1", "nobody can tell where this cut begins"),
        ("X40.", "O200\nX40.", "5:1", "`O200` begins a further program"),
        ("X40.", "G55 X40.", "5:1", ""),
        ("X40.", "/U10.\nU0.", "6:1", "may be skipped"),
        ("X40.", "(X40.", "5:1", "the comment does not end"),
    ] {
        assert!(good.contains(from));
        let text = good.replacen(from, to, 1);
        match carry(&shaft(), text.as_bytes(), false) {
            // A zero that comes into force late makes the place unknown.
            Err(error) => {
                assert!(error.contains(&format!("part.ngc:{place}: ")) && error.contains(message), "{to}: {error}")
            }
            Ok(_) => panic!("{to} is taken"),
        }
    }
    // Several problems are told at once.
    let error =
        carry(&shaft(), good.replace("X30. Z1.", "G71 U1.").replace("X40.", "G65 P1").as_bytes(), false).unwrap_err();
    assert!(error.contains("G71") && error.contains("G65"), "{error}");
    // Only rough sizes are refused with the nearest block.
    let error = carry(&shaft(), good.replace("X30.", "X31.").replace("X40.", "X41.2").as_bytes(), false).unwrap_err();
    assert!(error.contains("no block finishes the part; nearest, this one cuts at 31.000 mm of diameter"), "{error}");
}

/// Whatever bytes a file has, it is read or refused, and what is written of it is read again.
#[test]
fn spoilt_programs_are_read_or_refused() {
    let mut random = Random(7);
    let mut read = 0;
    for _ in 0..1500 {
        let text = random.spoilt(WHOLE, b"0123456789.-+GXZUWIKRF /(;%\r\n");
        let adds = random.between(0.0, 1.0) < 0.5;
        if let Ok(found) = carry(&shaft(), &text, adds) {
            read += 1;
            assert!(adds || others(&text) == others(&found.bytes), "{}", String::from_utf8_lossy(&text));
        }
    }
    assert!((200..1400).contains(&read), "{read}");
}
