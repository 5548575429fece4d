//! Writes model and measurements of every pair of effects of a process, in every scene, into a folder: `meetings
//! FOLDER PROCESS [SEED]`.

use std::path::PathBuf;

use generator::BY_NAME;

fn main() -> std::io::Result<()> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let folder = PathBuf::from(args.first().map_or(".", |folder| folder));
    let seed = args.get(2).and_then(|word| word.parse().ok()).unwrap_or(1);
    std::fs::create_dir_all(&folder)?;
    for (_, process) in BY_NAME.iter().filter(|(name, _)| args.get(1).is_none_or(|wanted| wanted == name)) {
        for [one, other] in process.pairs() {
            for scene in 0..process.scenes.len() {
                let Some(met) = process.meeting(&[one, other], scene, seed) else { continue };
                let stem = folder.join(format!("{one}+{other}+{scene}"));
                std::fs::write(stem.with_extension("toml"), met.model)?;
                std::fs::write(stem.with_extension("csv"), met.data)?;
            }
        }
    }
    Ok(())
}
