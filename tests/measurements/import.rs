//! What instruments and spreadsheets write is read as if it had been written in the program's own form.

use fem::input::Source;
use fem::measure::{Decimal, Measurements, Reading};
use fem::process::{Process, Values};
use fem::processes;

/// A file as somebody writes it.
struct Case {
    name: &'static str,
    process: &'static str,
    columns: &'static str,
    decimal: Option<Decimal>,
    written: &'static str,
    /// The same in the program's own form.
    own: &'static str,
    /// Part of what is told of the reading; empty where nothing is.
    told: &'static str,
}

/// Nothing said, and nothing to be told.
const PLAIN: Case =
    Case { name: "", process: "turning", columns: "", decimal: None, written: "", own: SHAFT, told: "" };

const SHAFT: &str = "x [mm],part,diameter_error [um],u [um]\n20.5,1,-29.737,1\n77,2,3.5,1\n";
const AXIS: &str = "position [mm],direction,deviation [um]\n10,+,1.5\n10,-,-2.5\n";
const ROD: &str = "time [s],x [m],temperature [degC]\n0,0.1,20.5\n0,0.2,21\n60,0.1,22.5\n60,0.2,23\n";

const CASES: &[Case] = &[
    Case { name: "the program's own form", written: SHAFT, ..PLAIN },
    Case {
        name: "semicolons",
        written: "x [mm];part;diameter_error [um];u [um]\n20.5;1;-29.737;1\n77;2;3.5;1\n",
        told: "columns parted by semicolons",
        ..PLAIN
    },
    Case {
        name: "semicolons, decimal commas and a byte order mark",
        written: "\u{feff}x [mm];part;diameter_error [um];u [um]\r\n20,5;1;-29,737;1\r\n77;2;3,5;1\r\n",
        told: "columns parted by semicolons; a decimal comma",
        ..PLAIN
    },
    Case {
        name: "tabs, and a line that names them",
        written: "sep=\t\nx [mm]\tpart\tdiameter_error [um]\tu [um]\n20,5\t1\t-29,737\t1\n77\t2\t3,5\t1\n",
        told: "columns parted by tabs; a decimal comma",
        ..PLAIN
    },
    Case {
        name: "commas in quotes",
        decimal: Some(Decimal::Comma),
        written: "x [mm],part,diameter_error [um],u [um]\n\"20,5\",1,\"-29,737\",1\n77,2,\"3,5\",1\n",
        told: "a decimal comma",
        ..PLAIN
    },
    Case {
        name: "points that group thousands",
        decimal: Some(Decimal::Comma),
        written: "x [um];part;diameter_error [um];u [um]\n20.500;1;-29,737;1\n77.000;2;3,5;1\n",
        told: "a decimal comma",
        own: "x [um],part,diameter_error [um],u [um]\n20500,1,-29.737,1\n77000,2,3.5,1\n",
        ..PLAIN
    },
    Case {
        name: "commas that group thousands",
        decimal: Some(Decimal::Point),
        written: "x [um];part;diameter_error [um];u [um]\n20,500;1;-29.737;1\n77,000;2;3.5;1\n",
        told: "columns parted by semicolons",
        own: "x [um],part,diameter_error [um],u [um]\n20500,1,-29.737,1\n77000,2,3.5,1\n",
        ..PLAIN
    },
    Case {
        name: "units in brackets, behind a slash and behind `in`; capitals, blanks and hyphens",
        written: "X (mm),Part,Diameter-Error / um,u in µm\n20.5,1,-29.737,1\n77,2,3.5,1\n",
        told: "`Diameter-Error / um` as diameter_error [um]",
        ..PLAIN
    },
    Case {
        name: "units in a row of their own",
        written: "x;part;Diameter Error;u\n[mm];;um;(um)\n20,5;1;-29,737;1\n77;2;3,5;1\n",
        told: "units from line 2",
        ..PLAIN
    },
    Case {
        name: "a first row of whole numbers, which are no units",
        written: "X (mm),part,diameter_error [um]\n20,1,3\n77,2,4\n",
        own: "x [mm],part,diameter_error [um]\n20,1,3\n77,2,4\n",
        told: "`X (mm)` as x [mm]",
        ..PLAIN
    },
    Case {
        name: "comments between, empty columns behind",
        written: "# a\nx [mm];part;diameter_error [um];u [um];;\n# b\n20.5;1;-29.737;1;;\n77;2;3.5;1;;\n",
        told: "columns parted by semicolons",
        ..PLAIN
    },
    Case {
        name: "names of the user's own",
        columns: "Ort=x [mm],Nr=part,Abw.=diameter_error [um],s=u [um],Prüfer=-",
        written: "Ort,Nr,Abw.,s,Prüfer\n20.5,1,-29.737,1,me\n77,2,3.5,1,you\n",
        told: "`Abw.` as diameter_error [um]",
        ..PLAIN
    },
    Case {
        name: "a name with a comma, units from the file",
        columns: "Ort, links=x,Nr=part,Abw.=diameter_error,s=u",
        written: "\"Ort, links (mm)\",Nr,Abw. [um],s/um\n20.5,1,-29.737,1\n77,2,3.5,1\n",
        told: "`Ort, links (mm)` as x [mm]",
        ..PLAIN
    },
    Case {
        name: "rows without an observed value, and empty rows",
        written: "x [mm];part;diameter_error [um];u [um]\n20,5;1;-29,737;1\n30;1;;\n;;;\n77;2;3,5;1\n",
        told: "2 rows are left out, for nothing was observed: lines 3, 4",
        ..PLAIN
    },
    Case {
        name: "directions in words",
        process: "axis",
        written: "position [mm],direction,deviation [um]\n10,Forward,1.5\n10,BACKWARD,-2.5\n",
        own: AXIS,
        told: "direction `BACKWARD` as -; direction `Forward` as +",
        ..PLAIN
    },
    Case {
        name: "directions as numbers",
        process: "axis",
        written: "position [mm],direction,deviation [um]\n10,+1,1.5\n10,-1,-2.5\n",
        own: AXIS,
        told: "direction `+1` as +; direction `-1` as -",
        ..PLAIN
    },
    Case {
        name: "directions as pos and neg, up and down",
        process: "axis",
        written: "position [mm],direction,deviation [um]\n10,up,1.5\n10,neg,-2.5\n",
        own: AXIS,
        told: "direction `neg` as -; direction `up` as +",
        ..PLAIN
    },
    Case {
        name: "words of other processes in capitals",
        process: "stiffness",
        written: "force [N],branch,displacement [um]\n10,Load,1.5\n10,UNLOADING,2.5\n",
        own: "force [N],branch,displacement [um]\n10,load,1.5\n10,unload,2.5\n",
        told: "branch `Load` as load; branch `UNLOADING` as unload",
        ..PLAIN
    },
    Case {
        name: "actual positions",
        process: "axis",
        written: "position [mm],direction,actual [mm]\n10,+,10.0015\n10,-,9.9975\n",
        own: "position [mm],direction,deviation [mm]\n10,+,0.0015\n10,-,-0.0025\n",
        told: "deviation = actual - position",
        ..PLAIN
    },
    Case {
        name: "actual positions in another unit, by another name",
        process: "axis",
        columns: "Ist=actual_position",
        written: "Position [m];Direction;Ist [mm]\n0,25;+;250,5\n0,25;-;249,5\n",
        own: "position [mm],direction,deviation [mm]\n250,+,0.5\n250,-,-0.5\n",
        told: "deviation = actual_position - position",
        ..PLAIN
    },
    Case {
        name: "times of day",
        process: "thermal",
        written: "time,x [m],temperature [degC]\n09:59:30,0.1,20.5\n09:59:30,0.2,21\n10:00:30,0.1,22.5\n10:00:30,0.2,23\n",
        own: ROD,
        told: "`time` is counted from 09:59:30, its first (line 2)",
        ..PLAIN
    },
    Case {
        name: "dates with a zone, over the end of a leap February",
        process: "thermal",
        written: "Time;x [m];Temperature [°C]\n2024-02-29T23:59:30Z;0,1;20,5\n2024-03-01 00:59:30+01:00;0,2;21\n\
                  2024-03-01T00:00:30.000Z;0,1;22,5\n2024-02-29T19:00:30-0500;0,2;23\n",
        own: ROD,
        told: "`time` is counted from 2024-02-29T23:59:30Z, its first (line 2)",
        ..PLAIN
    },
    Case {
        name: "times since a moment that was said",
        process: "thermal",
        columns: "time=time since 2026-03-01T10:00:00",
        written: "time,x [m],temperature [degC]\n2026-03-01T10:00,0.1,20.5\n2026-03-01T10:00,0.2,21\n\
                  2026-03-01T10:01,0.1,22.5\n2026-03-01T10:01,0.2,23\n",
        own: ROD,
        told: "`time` is counted from 2026-03-01T10:00:00, as was said",
        ..PLAIN
    },
    Case {
        name: "a column for every sensor",
        process: "thermal",
        written: "time [s],temperature@x=0.1 m [degC],temperature@x=0.2m [degC]\n0,20.5,21\n60,22.5,23\n",
        own: ROD,
        told: "a row for each of 2 places in the header",
        ..PLAIN
    },
    Case {
        name: "a column for every sensor in the user's own words, places in two units",
        process: "thermal",
        columns: "Zeit=time [s],T1=temperature@x=0.1 m [degC],T2=temperature@x=200 mm",
        written: "Zeit;T1;T2 (°C)\n0;20,5;21\n60;22,5;23\n",
        own: ROD,
        told: "a row for each of 2 places in the header",
        ..PLAIN
    },
    Case {
        name: "sensors of which some were read, beside an elongation, each with its uncertainty",
        process: "thermal",
        written: "time [s];elongation [um];u_elongation [um];temperature@x=0,1 m [degC];u_temperature@x=0,1 m [K];\
                  temperature@x=0,2 m [degC];u_temperature@x=0,2 m [K]\n0;1,5;0,1;20,5;0,2;21;0,3\n60;2,5;0,1;;;23;0,3\n",
        own: "time [s],elongation [um],u_elongation [um],x [m],temperature [degC],u_temperature [K]\n0,1.5,0.1,,,\n\
              0,,,0.1,20.5,0.2\n0,,,0.2,21,0.3\n60,2.5,0.1,,,\n60,,,0.2,23,0.3\n",
        told: "a row for each of 2 places in the header",
        ..PLAIN
    },
    Case {
        name: "traces of roundness, a column for each, units in the row below",
        process: "ring",
        columns: "Winkel=angle,Spur 1=deviation@run=1,Spur 2=deviation@run=2",
        written: "Winkel;Spur 1;Spur 2\ndeg;um;um\n0;1,5;2,5\n0,5;-1,25;0\n",
        own: "angle [deg],run,deviation [um]\n0,1,1.5\n0,2,2.5\n0.5,1,-1.25\n0.5,2,0\n",
        told: "a row for each of 2 places in the header",
        ..PLAIN
    },
    Case {
        name: "a column for every run and direction",
        process: "axis",
        written: "position [mm];deviation@run=1@direction=up [um];deviation@run=1@direction=down [um]\n10;1,5;-2,5\n",
        own: AXIS,
        told: "a row for each of 2 places in the header",
        ..PLAIN
    },
    Case {
        name: "German",
        process: "axis",
        written: "Sollposition [mm];Richtung;Abweichung [um]\n10;vor;1,5\n10;zur\u{fc}ck;-2,5\n",
        own: AXIS,
        told: "`Sollposition [mm]` as position [mm]; `Richtung` as direction",
        ..PLAIN
    },
    Case {
        name: "French",
        written: "Position (mm);Pi\u{e8}ce;\u{c9}cart de diam\u{e8}tre (um);Incertitude-type (um)\n20,5;1;-29,737;1\n77;2;3,5;1\n",
        told: "`Position (mm)` as x [mm]; `Pi\u{e8}ce` as part",
        ..PLAIN
    },
    Case {
        name: "Italian",
        process: "axis",
        written: "posizione [mm];direzione;scostamento [um]\n10;avanti;1,5\n10;indietro;-2,5\n",
        own: AXIS,
        told: "`posizione [mm]` as position [mm]",
        ..PLAIN
    },
    Case {
        name: "Spanish",
        process: "thermal",
        written: "tiempo [s];posici\u{f3}n [m];temperatura [degC]\n0;0,1;20,5\n0;0,2;21\n60;0,1;22,5\n60;0,2;23\n",
        own: ROD,
        told: "`temperatura [degC]` as temperature [degC]",
        ..PLAIN
    },
    Case {
        name: "Russian",
        process: "axis",
        written: "\u{43f}\u{43e}\u{43b}\u{43e}\u{436}\u{435}\u{43d}\u{438}\u{435} [mm];\u{43d}\u{430}\u{43f}\u{440}\u{430}\u{432}\u{43b}\u{435}\u{43d}\u{438}\u{435};\u{43e}\u{442}\u{43a}\u{43b}\u{43e}\u{43d}\u{435}\u{43d}\u{438}\u{435} [um]\n10;\u{432}\u{43f}\u{435}\u{440}\u{451}\u{434};1,5\n10;\u{43d}\u{430}\u{437}\u{430}\u{434};-2,5\n",
        own: AXIS,
        told: "as direction",
        ..PLAIN
    },
    Case {
        name: "a column for each run and direction, in words",
        process: "axis",
        written: "Sollposition [mm];Lauf 1 vor [um];Lauf1 zur\u{fc}ck [um];Run 2 forward / um;Abweichung 2 r\u{fc}ckw\u{e4}rts [um]\n\
                  10;1,5;2,5;3,5;4,5\n",
        own: "position [mm],run,direction,deviation [um]\n10,1,+,1.5\n10,1,-,2.5\n10,2,+,3.5\n10,2,-,4.5\n",
        told: "`Lauf 1 vor [um]` as deviation@run=1@direction=+ [um]",
        ..PLAIN
    },
    Case {
        name: "runs side by side, each under its group",
        process: "axis",
        written: ";Lauf 1;;Lauf 2;\nRichtung;Position [mm];Abweichung [um];Position [mm];Abweichung [um]\n\
                  +;10;1,5;10,5;2,5\n+;20;3,5;;\n",
        own: "run,position [mm],direction,deviation [um]\n1,10,+,1.5\n1,20,+,3.5\n2,10.5,+,2.5\n",
        told: "2 tables side by side",
        ..PLAIN
    },
    Case {
        name: "a word of another language beside the column that it would be",
        process: "axis",
        written: "position [mm],direction,deviation [um],Fehler\n10,+,1.5,7\n10,-,-2.5,8\n",
        own: AXIS,
        told: "`Fehler`",
        ..PLAIN
    },
];

fn process(name: &str) -> &'static dyn Process {
    *processes::ALL.iter().find(|p| p.name() == name).unwrap()
}

fn read(case: &Case, text: &str) -> Measurements {
    let columns = if case.columns.is_empty() { vec![] } else { vec![case.columns.to_string()] };
    let said = if text == case.own { Reading::default() } else { Reading::new(&columns, case.decimal).unwrap() };
    let read = Measurements::parse_as(Source::new("data.csv", text), process(case.process), &said);
    read.unwrap_or_else(|error| panic!("{}: {error}", case.name))
}

/// What is read, bit for bit.
fn content(m: &Measurements) -> Vec<Vec<u64>> {
    let values = [m.observed.clone(), m.uncertainty.as_ref().map(Values::to_vec).unwrap_or_default()];
    let columns = m.rows.columns.iter().map(Values::to_vec).chain(values);
    columns.map(|column| column.iter().map(|v| v.to_bits()).collect()).collect()
}

#[test]
fn other_forms_are_read_as_the_programs_own() {
    for case in CASES {
        let (found, own) = (read(case, case.written), read(case, case.own));
        assert_eq!(content(&found), content(&own), "{}: {found:#?}", case.name);
        assert_eq!(found.rows.observable, own.rows.observable, "{}", case.name);
        let notes = found.notes.join("\n");
        assert!(notes.contains(case.told) && notes.is_empty() == case.told.is_empty(), "{}: {notes}", case.name);
    }
}

/// The twin of every case: another value is another content.
#[test]
fn another_value_is_told_apart() {
    let own = read(&PLAIN, SHAFT);
    assert_ne!(content(&read(&PLAIN, &SHAFT.replace("3.5", "3.6"))), content(&own));
    assert_ne!(content(&read(&PLAIN, &SHAFT.replace("77,2", "77,3"))), content(&own));
}

/// Rows keep the lines in which they stand, whatever comments, blank lines and units stand between, and count
/// what is left out.
#[test]
fn rows_know_their_lines() {
    let text = "\u{feff}sep=;\n# a\nx;diameter_error\n# b\nmm;um\n\n1;2\n# c\n2;\n\n3;4\n";
    let found = Measurements::parse(Source::new("data.csv", text), process("turning")).unwrap();
    assert_eq!([0, 1].map(|row| (found.line(row), found.record(row))), [(7, 1), (11, 3)]);
}

/// Days of known distance, by the calendar: 1972-2000 has 7 leap years of 28, 2000 is one, 1900 is none.
#[test]
fn dates_follow_the_calendar() {
    for (from, to, days) in [
        ("1972-01-01", "2000-01-01", 28 * 365 + 7),
        ("2000-02-28", "2000-03-01", 2),
        ("1900-02-28", "1900-03-01", 1),
        ("2024-12-31", "2025-01-01", 1),
    ] {
        let text = format!("time,x [m],temperature [degC]\n{from}T00:00,0,1\n{to}T00:00,0,1\n");
        let found = Measurements::parse(Source::new("data.csv", text), process("thermal")).unwrap();
        assert_eq!(found.rows.columns[0].to_vec(), [0.0, 86_400.0 * f64::from(days)], "{from} to {to}");
    }
}

/// What spreadsheets save as "Unicode text" and as CSV, and what is no text at all.
#[test]
fn files_in_other_encodings_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let text = "x [mm],part,diameter_error [\u{b5}m]\n20.5,1,-29.737\n";
    let little: Vec<u8> = "\u{feff}".chars().chain(text.chars()).flat_map(|c| (c as u16).to_le_bytes()).collect();
    let big: Vec<u8> = "\u{feff}".chars().chain(text.chars()).flat_map(|c| (c as u16).to_be_bytes()).collect();
    let page: Vec<u8> = text.chars().map(|c| c as u8).collect();
    for (name, bytes) in
        [("utf-8", text.as_bytes()), ("utf-16, low byte first", &little), ("high", &big), ("page", &page)]
    {
        let path = folder.path().join("measured.csv");
        std::fs::write(&path, bytes).unwrap();
        let read = Measurements::load(&path, process("turning")).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert!((read.observed[0] + 29.737e-6).abs() < 1e-18, "{name}: {:?}", read.observed);
    }
    let path = folder.path().join("measured.xlsx");
    std::fs::write(&path, b"PK\x03\x04\x14\x00\xff\xfe\x00").unwrap();
    let error = Measurements::load(&path, process("turning")).unwrap_err().to_string();
    assert!(error.contains("the workbook cannot be read"), "{error}");
}
