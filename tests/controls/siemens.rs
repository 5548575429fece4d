//! SINUMERIK: `$AA_ENC_COMP` with machine data 32450, and `$AN_CEC` by direction.

use super::Added;
use super::axis::Files;
use super::text::{linear, value_of};

/// Values of `NAME[index,point…]`, at points from MIN on, STEP apart, to MAX.
fn table(text: &str, name: &str, index: usize, tail: &str) -> Vec<(f64, f64)> {
    let parameter = |what: &str| value_of(text, &format!("${name}_{what}[{index}{tail}]"));
    let (step, first, last) = (parameter("STEP"), parameter("MIN"), parameter("MAX"));
    // A table that is repeated goes once round.
    let is_repeated = parameter("IS_MODULO") == 1.0;
    assert_eq!(is_repeated, last - first == 360.0);
    let points = ((last - first) / step).round() as usize;
    let head = format!("${name}[{index},");
    assert_eq!(text.lines().filter(|line| line.starts_with(&head)).count(), points + 1);
    let value = |point: usize| value_of(text, &format!("{head}{point}{tail}]"));
    assert!(!is_repeated || value(0) == value(points));
    (0..=points).map(|point| (first + step * point as f64, value(point))).collect()
}

/// The control takes the value onto the actual position, and the axis goes as far to the other side. On the way back
/// it goes on by the backlash value, by which the encoder leads.
pub fn eec(files: &Files) -> Added {
    let text = files.named("siemens-eec.ini");
    assert!(text.starts_with("%_N_AX_EEC_INI\nCHANDATA(1)\n") && text.ends_with("M17\n"), "{text}");
    let table = table(text, "AA_ENC_COMP", 0, ",X");
    let note = files.notes.iter().find(|note| note.contains("MD38000")).unwrap();
    let after =
        |words: &str| note.split(words).nth(1).unwrap().split_whitespace().next().unwrap().parse::<f64>().unwrap();
    assert_eq!(after("MAX_POINTS to "), table.len() as f64);
    let backlash = after("MD32450 BACKLASH to ");
    Box::new(move |at, forward| -linear(&table, at) - if forward { 0.0 } else { backlash })
}

/// Two tables, each for one direction of the axis that is both base and compensated.
pub fn cec(files: &Files) -> Added {
    let text = files.named("siemens-cec.ini");
    assert!(text.starts_with("%_N_NC_CEC_INI\nCHANDATA(1)\n") && text.ends_with("M17\n"), "{text}");
    for t in [0, 1] {
        for what in ["INPUT", "OUTPUT"] {
            assert!(text.contains(&format!("$AN_CEC_{what}_AXIS[{t}]=(X)\n")), "{text}");
        }
    }
    let directions = [0, 1].map(|t| value_of(text, &format!("$AN_CEC_DIRECTION[{t}]")));
    assert_eq!(directions, [1.0, -1.0]);
    let tables = [0, 1].map(|t| table(text, "AN_CEC", t, ""));
    Box::new(move |at, forward| {
        let acts = |direction: f64| (direction > 0.0) == forward;
        tables.iter().zip(directions).filter(|(_, d)| acts(*d)).map(|(table, _)| -linear(table, at)).sum()
    })
}
