//! Files of instruments that are no tables of columns. The samples are made by hand from descriptions: of reports from
//! the public reports of ecmccfg, of K-fields from the samples of aqdef-tools and aqdefreader, of captures from what
//! rtx2csv reads.

use fem::input::{InputError, Source};
use fem::measure::{Measurements, Reading};
use fem::process::Process;
use fem::processes;

const REPORT: &str = "# motion system test report

* Author : somebody

# ISO 230-2 motion test

Setting | Value
--- | --- |
Position count | 3 (i=1..3)
Cycle count |2 (j=1..2)
Unit | mm

## Input data

### Data forward direction

i |tgt_pos(i) [mm]|ref_pos(i,1) [mm]|ref_pos(i,2) [mm]|
--- |--- |--- |--- |
1|-4.0|-3.9986|-3.9837|
2|0.0|0.0012|-0.0010|
3|4.0|4.0032|4.0040|

### Data backward direction

i |tgt_pos(i) [mm]|ref_pos(i,1) [mm]|ref_pos(i,2) [mm]|
--- |--- |--- |--- |
1|-4.0|-4.0021|-4.0160|
2|0.0|-0.0030|-0.0029|
3|4.0|3.9998|3.9981|

## ISO230-2 calculations:

#### Positioning deviation forward direction (unidirectional)

i |x(i,1) [mm]|x(i,2) [mm]|x_avg(i) [mm]|
--- |--- |--- |--- |
1|0.0014|0.0163|0.00885|
";

/// Deviations of the report, by hand.
const OF_REPORT: &str = "run,position [mm],direction,deviation [mm]
1,-4.0,+,0.0014\n2,-4.0,+,0.0163\n1,0.0,+,0.0012\n2,0.0,+,-0.0010\n1,4.0,+,0.0032\n2,4.0,+,0.0040
1,-4.0,-,-0.0021\n2,-4.0,-,-0.0160\n1,0.0,-,-0.0030\n2,0.0,-,-0.0029\n1,4.0,-,-0.0002\n2,4.0,-,-0.0019\n";

/// Two characteristics and one of counted faults, each value in a line of its own; the second value of the second
/// characteristic does not hold.
const K_FIELDS: &str = "K0100 3\nK1001/1 shaft\nK1002/1 stepped\nK2001/1 1\nK2002/1 Near\nK2142/1 um\nK2001/2 2\nK2002/2 Far\n\
                        K2142/2 um\nK2001/3 3\nK2002/3 Scratches\nK2004/3 1\nK0001/1 1,5\nK0002/1 0\nK0001/2 2,5\nK0002/2 0\n\
                        K0004/0 01.03.2026/10:00:00\nK0001/1 1,75\nK0001/2 9,9\nK0002/2 255\nK0004/0 01.03.2026/10:01:30\n";

/// The same in lines of all characteristics.
const K_LINES: &str = "K0100 3\nK1001/1 shaft\nK2001/1 1\nK2002/1 Near\nK2001/2 2\nK2002/2 Far\nK2142/0 um\nK2002/3 Scratches\n\
                       K2004/3 1\n1.5\u{14}0\u{14}01.03.2026/10:00:00\u{f}2.5\u{14}0\u{14}01.03.2026/10:00:00\u{f}50\u{14}2\n\
                       K0053/1 order\n1.75\u{14}0\u{14}01.03.2026/10:01:30\u{14}note\u{f}9.9\u{14}255\u{f}50\u{14}0\n";

const OF_K: &str = "part,time [s],x [mm],diameter_error [um]\n1,0,20,1.5\n1,0,180,2.5\n2,90,20,1.75\n";

const K_COLUMNS: &str = "Near=diameter_error@x=20 mm,Far=diameter_error@x=180 mm";

fn process(name: &str) -> &'static dyn Process {
    *processes::ALL.iter().find(|p| p.name() == name).unwrap()
}

fn read(text: &str, of: &str, columns: &str) -> Result<Measurements, InputError> {
    let columns = if columns.is_empty() { vec![] } else { vec![columns.to_string()] };
    let said = Reading::new(&columns, None).unwrap();
    Measurements::parse_as(Source::new("file", text), process(of), &said)
}

/// Whether what is read is the same to round-off of differences.
fn same(found: &Measurements, own: &Measurements) -> bool {
    let near = |a: &[f64], b: &[f64]| {
        a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12 || (a.is_nan() && b.is_nan()))
    };
    let mut columns = found.rows.columns.iter().zip(&own.rows.columns);
    near(&found.observed, &own.observed) && columns.all(|(a, b)| near(&a.to_vec(), &b.to_vec()))
}

#[test]
fn a_report_by_the_standard_is_read() {
    let found = read(REPORT, "axis", "").unwrap();
    let own = read(OF_REPORT, "axis", "").unwrap();
    assert!(same(&found, &own), "{found:#?}");
    // Rows know their lines: the first target forwards stands in line 19, the last backwards in line 29.
    assert_eq!((found.line(0), found.line(1), found.line(11)), (19, 19, 29));
    let notes = found.notes.join("\n");
    for words in ["a report by ISO 230-2", "computed again", "deviation = actual_position - position"] {
        assert!(notes.contains(words), "{words}: {notes}");
    }
    // The twin: another reading is another content.
    assert!(!same(&read(&REPORT.replace("4.0040", "4.0041"), "axis", "").unwrap(), &own));
}

/// As in every file, a reading that is not there is left out, and told with its line.
#[test]
fn a_reading_that_is_missing_is_left_out() {
    let found = read(&REPORT.replace("4.0032", ""), "axis", "").unwrap();
    assert_eq!(found.len(), 11);
    assert!(
        found.notes.join("\n").contains("1 row is left out, for nothing was observed: line 21"),
        "{:?}",
        found.notes
    );
}

/// The report of a test from one side says so.
#[test]
fn a_report_of_one_side_is_read() {
    let one = &REPORT[..REPORT.find("### Data backward").unwrap()];
    let found = read(one, "axis", "").unwrap();
    assert_eq!(found.len(), 6);
    assert!(found.notes.join("\n").contains("no table backward"), "{:?}", found.notes);
}

#[test]
fn reports_that_were_cut_or_changed_are_refused() {
    for (from, to, words) in [
        ("3|4.0|4.0032|4.0040|\n", "", "the table has 2 targets, and the report says 3"),
        ("Cycle count |2", "Cycle count |5", "the table has 2 cycles, and the report says 5"),
        ("3|4.0|4.0032|4.0040|", "3|4.0|4.0032|", "the row has 3 cells, and the header 4"),
        (
            "ref_pos(i,2) [mm]|\n--- |--- |--- |--- |\n1|-4.0|-3",
            "ref_pos(i,2) [um]|\n--- |--- |--- |--- |\n1|-4.0|-3",
            "different",
        ),
        ("### Data forward direction", "### Data", "under no direction"),
        ("### Data backward direction", "### Data forward direction", "a second table of the way forward"),
        ("4.0032", "NaN", "NaN"),
        ("4.0032", "1e999", "no finite number"),
        (
            "tgt_pos(i) [mm]|ref_pos(i,1) [mm]|ref_pos(i,2) [mm]|\n--- |--- |--- |--- |\n1|-4.0|-4.0021",
            "tgt_pos(i) [um]|ref_pos(i,1) [mm]|ref_pos(i,2) [mm]|\n--- |--- |--- |--- |\n1|-4.0|-4.0021",
            "different units",
        ),
    ] {
        assert!(REPORT.contains(from), "{from}");
        let error = read(&REPORT.replacen(from, to, 1), "axis", "").unwrap_err().to_string();
        assert!(error.contains(words), "{words}: {error}");
    }
}

#[test]
fn k_fields_are_read_in_either_notation() {
    let own = read(OF_K, "turning", "").unwrap();
    for text in [K_FIELDS, K_LINES] {
        let found = read(text, "turning", K_COLUMNS).unwrap_or_else(|e| panic!("{text}: {e}"));
        assert!(same(&found, &own), "{found:#?}");
        let notes = found.notes.join("\n");
        for words in [
            "2 sets of values, a row for each, of characteristics: 2",
            "(K0002), which are left out: 1",
            "without values, which are left out: 1",
        ] {
            assert!(notes.contains(words), "{words}: {notes}");
        }
    }
    let changed = read(&K_FIELDS.replace("1,75", "1,76"), "turning", K_COLUMNS).unwrap();
    assert!(!same(&changed, &own));
}

/// Two characteristics of one name are told apart by their numbers.
#[test]
fn characteristics_of_one_name_are_told_apart() {
    let text = K_FIELDS.replace("K2002/2 Far", "K2002/2 Near");
    let columns = "Near [um]=diameter_error@x=20 mm [um],Near no. 2=diameter_error@x=180 mm";
    let found = read(&text, "turning", columns).unwrap_or_else(|e| panic!("{e}"));
    assert!(same(&found, &read(OF_K, "turning", "").unwrap()));
}

#[test]
fn k_fields_that_were_cut_or_changed_are_refused() {
    for (text, from, to, words) in [
        (K_FIELDS, "K0100 3", "K0100 4", "K0100 says 4 characteristics, and 3 are described"),
        (K_FIELDS, "K0100 3", "K0100 many", "K0100 is `many`"),
        (K_FIELDS, "K0100 3", "K0100 99999999999999999999", "from 1 to 900"),
        (K_FIELDS, "K2002/2", "K2002/4000000000", "there is no characteristic 4000000000"),
        (K_FIELDS, "K2002/2", "K2002/x", "`K2002/x` is no K-field"),
        (K_FIELDS, "K0001/1 1,5", "K0001/1 nan", "nan"),
        (K_FIELDS, "K0001/1 1,5", "K0001/1 1e999", "1e999"),
        (K_FIELDS, "K0004/0 01.03.2026/10:00:00", "K0004/0 gestern", "`gestern` is no date and time"),
        (K_LINES, "\u{f}50\u{14}2", "\u{f}50\u{14}2\u{f}7", "characteristic 4, which is not described"),
        (K_LINES, "01.03.2026/10:00:00\u{f}", "99.99\u{f}", "`99.99` is no date and time"),
        (K_LINES, "01.03.2026/10:00:00\u{f}", "31.02.2026/10:00:00\u{f}", "`31.02.2026/10:00:00` is no date"),
    ] {
        assert!(text.contains(from), "{from}");
        let error = read(&text.replacen(from, to, 1), "turning", K_COLUMNS).unwrap_err().to_string();
        assert!(error.contains(words), "{words}: {error}");
    }
}

/// A capture: header, samples, end.
fn capture(samples: &[f64]) -> Vec<u8> {
    let header = "HEADER::\r\nOwner: Renishaw\r\nFile Type: Dynamic\r\nSample no: 4\r\nActual sample rate: 2.5\r\n\
                  USER-TEXT::Machine: mill\r\nData:\r\n";
    let samples = samples.iter().flat_map(|v| v.to_le_bytes());
    header.bytes().chain(samples).chain(*b"EOF::\r\n").collect()
}

fn load(bytes: &[u8], columns: &str) -> Result<Measurements, InputError> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("capture.rtx");
    std::fs::write(&path, bytes).unwrap();
    Measurements::load_as(&path, process("thermal"), &Reading::new(&[columns.to_string()], None).unwrap())
}

const ELONGATION: &str = "value=elongation [um]";

#[test]
fn a_capture_is_read() {
    let found = load(&capture(&[0.0, 0.25, -1.5e-3, 1e-17]), ELONGATION).unwrap();
    let own = read("time [s],elongation [um]\n0,0\n0.4,0.25\n0.8,-1.5e-3\n1.2,1e-17\n", "thermal", "").unwrap();
    assert!(same(&found, &own), "{found:#?}");
    let notes = found.notes.join("\n");
    assert!(
        notes.contains("4 samples at 2.5 a second") && notes.contains("beside the rate, which are left: 4"),
        "{notes}"
    );
}

#[test]
fn captures_that_were_cut_or_changed_are_refused() {
    let good = capture(&[0.5, 1.5]);
    for (bytes, words) in [
        (good[..good.len() - 3].to_vec(), "does not end with `EOF::`"),
        (good[..40].to_vec(), "no line `Data:`"),
        ([&good[..good.len() - 10], b"EOF::\r\n"].concat(), "no whole number of 8 bytes"),
        (capture(&[0.5, f64::NAN]), "sample 2 is NaN"),
        (capture(&[f64::INFINITY]), "sample 1 is inf"),
        (String::from_utf8_lossy(&capture(&[])).replace("2.5", "0").into_bytes(), "no number above zero"),
        (String::from_utf8_lossy(&capture(&[])).replace("Actual s", "S").into_bytes(), "no `Actual sample rate`"),
        (capture(&[]), "no rows"),
    ] {
        let error = load(&bytes, ELONGATION).unwrap_err().to_string();
        assert!(error.contains(words), "{words}: {error}");
    }
    // Nobody has said what the values are.
    assert!(load(&good, "time=time [s]").is_err());
}

/// A capture that is longer than what is read is refused before it is made into text.
#[test]
fn a_capture_that_is_too_long_is_refused() {
    let mut bytes = capture(&[]);
    let end = bytes.split_off(bytes.len() - 7);
    bytes.resize(bytes.len() + 8 * 5_000_001, 0);
    bytes.extend(end);
    let error = load(&bytes, ELONGATION).unwrap_err().to_string();
    assert!(error.contains("5000001 samples; at most 5000000"), "{error}");
}

/// Whatever is cut off, turned or doubled, an answer comes: rows or a message, and no panic.
#[test]
fn no_damage_makes_it_stop() {
    let good = capture(&[0.5, -1.5, 2.5]);
    for cut in 0..good.len() {
        let _ = load(&good[..cut], ELONGATION);
    }
    for (text, of, columns) in [(REPORT, "axis", ""), (K_FIELDS, "turning", K_COLUMNS), (K_LINES, "turning", K_COLUMNS)]
    {
        for (at, _) in text.char_indices().step_by(3) {
            let _ = read(&text[..at], of, columns);
            let _ = read(&format!("{}{}", &text[..at], &text[at / 2..]).replacen("K2", "K0", 1), of, columns);
            let (before, after) = text.split_at(at);
            for damage in ["|", "/", "\u{14}", "\u{f}", "0", "\n", "-", "é"] {
                let _ = read(&format!("{before}{damage}{after}"), of, columns);
            }
        }
    }
}
