//! Writes the files of `models/tailstock` into a folder: those of the story, or of a seed.

use std::path::PathBuf;

use generator::machine::{LATHE, Tailstock, Tests, drawn, story};

fn main() -> std::io::Result<()> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let folder = PathBuf::from(args.first().map_or(".", |folder| folder));
    let number = |i: usize| args.get(i).and_then(|word| word.parse::<f64>().ok());
    let Tests { shafts, turned, tailstock, loaded } = match number(1) {
        Some(seed) => {
            let contact = number(3).zip(number(4));
            let stiffness = number(2).unwrap_or(f64::INFINITY);
            drawn(Tailstock { stiffness, contact, is_known: args.len() == 6 }, seed as u64)
        }
        None => story(),
    };
    std::fs::create_dir_all(&folder)?;
    let files = [("lathe.toml", LATHE.into()), ("shafts.toml", shafts), ("shafts.csv", turned)];
    let files = files.into_iter().chain([("tailstock.toml", tailstock), ("tailstock.csv", loaded)]);
    files.into_iter().try_for_each(|(name, text)| std::fs::write(folder.join(name), text))
}
