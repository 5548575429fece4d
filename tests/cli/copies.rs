//! Readings that stand there twice: a file under two names, a block pasted again, doubled rows; and files that are parted.

use serde_json::Value;

use super::fem::{Place, model};

/// A place with the story's machine and its measurements, of which every reading stands once.
fn story() -> (Place, Vec<String>) {
    let place = Place::new();
    place.write("rigid.toml", model("story/rigid.toml"));
    let text = model("story/measured.csv");
    let lines = text.lines().filter(|line| !line.starts_with('#')).map(str::to_string).collect();
    place.write("m.csv", text);
    (place, lines)
}

/// What a comparison tells of the model beside files, and the notes.
fn compared(place: &Place, files: &[&str]) -> (Value, Vec<String>) {
    let with: Vec<&str> = files.iter().flat_map(|file| ["--with", file]).collect();
    let answer = place.fem(&[&["compare", "rigid.toml", "--json"], &with[..]].concat());
    assert_eq!(answer.status, 0, "{files:?}: {}", answer.err);
    let all: Value = serde_json::from_str(&answer.out).unwrap();
    let mut found = all["models"][0].clone();
    // Where the worst row stands is another line.
    found["worst"] = found["worst"]["error"].clone();
    let notes = all["notes"].as_array().unwrap().iter().map(|note| note.as_str().unwrap().to_string()).collect();
    (found, notes)
}

/// Whether two answers are the same but for round-off.
fn are_alike(own: &Value, other: &Value) -> bool {
    match (own, other) {
        (Value::Number(a), Value::Number(b)) => {
            let (a, b) = (a.as_f64().unwrap(), b.as_f64().unwrap());
            (a - b).abs() <= 1e-9 * a.abs().max(b.abs()) || a.abs().max(b.abs()) < 1e-200
        }
        (Value::Array(a), Value::Array(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| are_alike(a, b)),
        (Value::Object(a), Value::Object(b)) => a.len() == b.len() && a.iter().all(|(k, v)| are_alike(v, &b[k])),
        _ => own == other,
    }
}

#[test]
fn copies_and_parted_files_tell_what_the_file_tells() {
    let (place, lines) = story();
    let (header, rows) = lines.split_first().unwrap();
    let write = |name: &str, rows: &[String]| place.write(name, format!("{header}\n{}\n", rows.join("\n")));
    let (whole, notes) = compared(&place, &["m.csv"]);
    assert!(notes.is_empty(), "{notes:?}");
    write("copy.csv", rows);
    write("first.csv", &rows[..rows.len() / 3]);
    write("rest.csv", &rows[rows.len() / 3..]);
    let block = [rows, &rows[10..40]].concat();
    write("pasted.csv", &block);
    let counted = format!("{0} of {0} rows are equal to the last digit", rows.len());
    for (files, note) in [
        (&["m.csv", "copy.csv"][..], &*counted),
        (&["first.csv", "rest.csv"], ""),
        (&["pasted.csv"], "30 rows in lines"),
        (&["first.csv", "pasted.csv"], "are counted once"),
    ] {
        let (found, notes) = compared(&place, files);
        assert!(are_alike(&found, &whole), "{files:?}: {found:#} {whole:#}");
        assert_eq!(notes.iter().any(|told| told.contains(note)), !note.is_empty(), "{files:?}: {notes:?}");
    }
}

#[test]
fn rows_that_were_pasted_with_their_u_are_counted_once() {
    let (place, lines) = story();
    let (header, rows) = lines.split_first().unwrap();
    let (whole, _) = compared(&place, &["m.csv"]);
    let twice: Vec<&String> = rows.iter().flat_map(|row| [row, row]).collect();
    let behind: Vec<&String> = rows.iter().chain(rows).collect();
    for doubled in [twice, behind] {
        let text: String = doubled.into_iter().map(|row| format!("{row}\n")).collect();
        place.write("doubled.csv", format!("{header}\n{text}"));
        let (found, notes) = compared(&place, &["doubled.csv"]);
        assert!(are_alike(&found, &whole), "{found:#} {whole:#}");
        assert!(notes.iter().any(|told| told.contains("counted once")), "{notes:?}");
    }
}

#[test]
fn doubled_rows_tell_together_what_one_tells() {
    let (place, lines) = story();
    let (header, rows) = lines.split_first().unwrap();
    let u = header.split(',').position(|cell| cell.starts_with("u ")).unwrap();
    let with = |row: &String, factor: f64| {
        let mut cells: Vec<String> = row.split(',').map(str::to_string).collect();
        cells[u] = (factor * cells[u].parse::<f64>().unwrap()).to_string();
        cells.join(",")
    };
    let (whole, _) = compared(&place, &["m.csv"]);
    // One of a pair may be known better: 1/u² = 1/(2u)² + 3/(2u)².
    for factors in [[2f64.sqrt(); 2], [2.0, 2.0 / 3f64.sqrt()]] {
        let doubled: Vec<String> = rows.iter().flat_map(|row| factors.map(|factor| with(row, factor))).collect();
        place.write("doubled.csv", format!("{header}\n{}\n", doubled.join("\n")));
        let (found, notes) = compared(&place, &["doubled.csv"]);
        assert!(are_alike(&found, &whole), "{found:#} {whole:#}");
        assert!(notes[0].contains("each reading stands there twice"), "{notes:?}");
    }
}

#[test]
fn coarse_readings_that_are_equal_by_chance_are_repeats() {
    // Two runs of a gauge of 0.01 mm that hardly scatters: most rows are equal, and both count.
    let place = Place::new();
    place.write("rigid.toml", model("story/rigid.toml"));
    let run = |run: u64| -> String {
        let reading = |i: u64| 10 * ((60 + 3 * i + (7 * i + 5 * run) % 4) / 10);
        (0..20).map(|i| format!("1,{},300,{},3\n", 20 + 20 * i, reading(i))).collect()
    };
    let header = "part,x [mm],radial_force [N],diameter_error [um],u [um]\n";
    for number in [0, 1] {
        place.write(&format!("{number}.csv"), format!("{header}{}", run(number)));
    }
    let (_, notes) = compared(&place, &["0.csv", "1.csv"]);
    assert!(notes.is_empty(), "{notes:?}");
    let answer = place.fem(&["compare", "rigid.toml", "--with", "0.csv", "--with", "1.csv"]);
    assert!(answer.out.contains("40 observations"), "{}", answer.out);
}
