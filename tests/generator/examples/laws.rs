//! Writes models and measurements with laws that are in no catalogue into a folder: `laws FOLDER PROCESS FIRST LAST`.

use std::path::PathBuf;

use generator::{BY_NAME, Beside};

/// Amplitude, in standard uncertainties.
const SIZE: f64 = 8.0;

fn main() -> std::io::Result<()> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let folder = PathBuf::from(args.first().map_or(".", |folder| folder));
    let number = |i: usize, other| args.get(i).and_then(|word| word.parse::<u64>().ok()).unwrap_or(other);
    std::fs::create_dir_all(&folder)?;
    for (name, process) in BY_NAME.iter().filter(|(name, _)| args.get(1).is_none_or(|wanted| wanted == name)) {
        for seed in number(2, 1)..=number(3, 1) {
            let case = process.hidden_law(Beside::Law, SIZE, seed);
            let stem = folder.join(format!("{name}-{seed}"));
            std::fs::write(stem.with_extension("toml"), case.model)?;
            std::fs::write(stem.with_extension("csv"), case.data)?;
            std::fs::write(stem.with_extension("fresh.csv"), case.fresh)?;
            std::fs::write(stem.with_extension("far.csv"), case.far)?;
            println!("{name} {seed}: {}", case.law);
        }
    }
    Ok(())
}
