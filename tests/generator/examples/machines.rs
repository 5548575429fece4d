//! Writes ideal models of whole machines, their measurements, and the models of what they hide, into a folder: `machines
//! FOLDER PROCESS [HOW MANY]`.

use std::path::PathBuf;

use generator::BY_NAME;

fn main() -> std::io::Result<()> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let folder = PathBuf::from(args.first().map_or(".", |folder| folder));
    let count = args.get(2).and_then(|word| word.parse().ok()).unwrap_or(10);
    std::fs::create_dir_all(&folder)?;
    for (name, process) in BY_NAME.iter().filter(|(name, _)| args.get(1).is_none_or(|wanted| wanted == name)) {
        for seed in 0..count {
            let case = process.whole_machine(seed).case;
            let stem = folder.join(format!("{name}-{seed}"));
            std::fs::write(stem.with_extension("toml"), case.model)?;
            std::fs::write(stem.with_extension("csv"), case.data)?;
            std::fs::write(
                stem.with_extension("hidden"),
                format!("{}\n# noise {}\n", case.revealed, case.truth.sigma),
            )?;
        }
    }
    Ok(())
}
