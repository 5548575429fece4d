//! The page of materials says what the program knows.

use std::path::Path;

use fem::material::catalogue::{ALL, Entry};

/// Cells of the page's tables, a row for each line.
fn rows() -> Vec<Vec<String>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/materials.md");
    let text = std::fs::read_to_string(path).unwrap();
    let cells = |line: &str| line.trim_matches('|').split('|').map(|cell| cell.trim().to_string()).collect();
    text.lines().filter(|line| line.starts_with("| `")).map(cells).collect()
}

#[test]
fn the_page_of_materials_is_the_catalogue() {
    let rows = rows();
    let (properties, forces): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row.len() == 9);
    assert_eq!(properties.len(), ALL.len());
    let numbers = |row: &[String]| -> Vec<f64> { row.iter().map(|cell| cell.parse().unwrap()).collect() };
    for (row, Entry { names, material: own, spread, source, .. }) in properties.iter().zip(ALL) {
        let written: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
        assert_eq!(row[0], written.join(", "));
        let known = [
            own.youngs_modulus / 1e9,
            own.poisson_ratio,
            own.density,
            own.expansion * 1e6,
            own.conductivity,
            own.specific_heat,
        ];
        for (written, known) in numbers(&row[1..7]).iter().zip(known) {
            assert!((written - known).abs() <= 1e-12 * known.abs(), "{}: {written} for {known}", names[0]);
        }
        let spread_written: Vec<f64> = row[7].split(", ").map(|own| own.parse().unwrap()).collect();
        assert_eq!(spread_written, spread, "{}", names[0]);
        assert_eq!(row[8], source.replace('|', "/"), "{}", names[0]);
    }
    let cutting: Vec<_> = ALL.iter().filter_map(|entry| Some((entry.names[0], entry.cutting?))).collect();
    assert_eq!(forces.len(), cutting.len());
    for (row, (name, own)) in forces.iter().zip(cutting) {
        assert_eq!(row[0], format!("`{name}`"));
        assert_eq!(numbers(&row[1..4]), [own.specific_force / 1e6, own.exponent, own.scatter], "{name}");
        assert_eq!(row[4], own.source.replace('|', "/"), "{name}");
    }
}
