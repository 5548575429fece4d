//! What a mill's program must not have.

use super::{carry, top};

const GOOD: &str = "G17 G21\nG0 X-14. Y10. Z5.\nG1 Z0. F300\nX114.\nY30.\nX-14.\nG0 Z50.\nM30\n";

#[test]
fn what_cannot_be_followed_is_refused_where_it_stands() {
    assert!(carry(&top(), GOOD.as_bytes(), false).is_ok());
    for (from, to, place, message) in [
        ("Y30.", "G81 Y30. Z-5. R2.", "5:1", "`G81` is a cycle"),
        ("Y30.", "G73 Y30. Z-5. Q1.", "5:1", "`G73` is a cycle"),
        ("Y30.", "M98 P100", "5:1", "`M98` calls a subprogram"),
        ("Y30.", "G65 P9000", "5:1", "`G65` calls a macro"),
        ("Y30.", "Y#100", "5:1", "`Y` has no number"),
        ("Y30.", "WHILE X1", "5:1", "`WHILE` is no word"),
        ("Y30.", "G68 X0. Y0. R30.", "5:1", "`G68` turns or mirrors"),
        ("Y30.", "G51 X0. Y0. P2", "5:1", "`G51` scales"),
        ("Y30.", "G52 X1.", "5:1", "`G52` moves the zero"),
        ("Y30.", "G92 X0.", "5:5", "moves the zero"),
        ("Y30.", "G16", "5:1", "polar"),
        ("Y30.", "G12.1", "5:1", "polar"),
        ("Y30.", "G7", "5:1", "what `G7` does is not known"),
        ("Y30.", "G41.1 D12.", "5:1", "takes the cutter's radius"),
        ("Y30.", "Y30. A30.", "5:6", "another axis"),
        ("Y30.", "U30.", "5:1", "what `U30` does"),
        ("Y30.", "G2 Y30. I0. J10. K1.", "5:18", "what `K1` does"),
        ("Y30.", "G2 X114. Y30. Z-1. J10.", "5:1", "climbs"),
        ("Y30.", "G18 G2 X114. Y30. R10.", "5:1", "other than G17"),
        ("Y30.", "G2 Y30. J3.", "5:1", "not on one circle"),
        ("Y30.", "G2 Y30.", "5:1", "no centre, or two"),
        ("Y30.", "G2 Y10. R10.", "5:1", "not on one circle"),
        ("Y30.", "Y30. R2.", "5:6", "a corner that the control computes"),
        ("Y30.", "Y30.,R2.", "5:5", "a corner after a comma"),
        ("Y30.", "G93 Y30.", "5:1", "inverse time"),
        ("Y30.", "M6 T2\nY30.", "6:1", "nobody can tell where this cut begins"),
        ("Y30.", "G43 H2\nY30.", "6:1", "nobody can tell where this cut begins"),
        ("Y30.", "/G91\nY30.", "", ""),
        ("Y30.", "O200\nY30.", "5:1", "`O200` begins a further program"),
        ("Y30.", "G41 D1 Y30.", "6:1", "beside its path"),
    ] {
        let text = GOOD.replacen(from, to, 1);
        match carry(&top(), text.as_bytes(), false) {
            Err(error) => {
                assert!(error.contains(&format!("top.ngc:{place}: ")) && error.contains(message), "{to}: {error}")
            }
            Ok(_) => assert!(place.is_empty(), "{to} is taken"),
        }
    }
    // Several problems are told at once.
    let error = carry(&top(), GOOD.replace("Y30.", "G81 Y3.\nG65 P1").as_bytes(), false).unwrap_err();
    assert!(error.contains("G81") && error.contains("G65"), "{error}");
}

/// What belongs to mills and changes no height is taken.
#[test]
fn what_changes_nothing_is_taken() {
    for head in [
        "G00 G17 G21 G40 G49 G50 G69 G80 G90 G94 G98",
        "G15\nG64 P0.01\nG61",
        "T1 M06\nT2",
        "G53 G0 Z0.",
        "G91 G28 Z0.\nG90",
        "G4 P500\nM8\nS1200 M3",
        "G55",
    ] {
        let text = format!("{head}\n{GOOD}");
        assert!(
            carry(&top(), text.as_bytes(), false).is_ok(),
            "{head}: {:?}",
            carry(&top(), text.as_bytes(), false).err()
        );
    }
}
