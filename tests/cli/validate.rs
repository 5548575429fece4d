//! `fem validate` of some sources.

use super::fem::Place;

#[test]
fn rows_are_chosen_by_what_their_source_says() {
    let place = Place::new();
    let answer = place.fem(&["validate", "--source", "SEED-001"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    let mut lines = answer.out.lines().filter(|line| !line.is_empty());
    assert!(lines.next().is_some_and(|line| line.starts_with("case ")));
    let rows: Vec<&str> = lines.collect();
    let (last, rows) = rows.split_last().unwrap();
    assert!(rows.len() >= 20 && rows.iter().all(|row| row.contains("seed 001")), "{rows:#?}");
    assert!(last.starts_with(&format!("{} of ", rows.len())) && last.ends_with(" cases, 0 failed"), "{last}");
}

#[test]
fn an_unknown_source_is_refused_with_those_there_are() {
    let answer = Place::new().fem(&["validate", "--source", "seed 007"]);
    assert_eq!((answer.status, answer.out.as_str()), (2, ""));
    for part in ["no case has a source that says `seed 007`", "did you mean `seed 00", "NIST StRD (214)", "seed 002 ("]
    {
        assert!(answer.err.contains(part), "{part}: {}", answer.err);
    }
}
