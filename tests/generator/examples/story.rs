//! Prints the measurements of the story; given a program and an offset of the radius for each part (um), those of the job that
//! is made again with them.

fn main() {
    let mut words = std::env::args().skip(1);
    let Some(program) = words.next() else { return print!("{}", generator::story::measured()) };
    let program = std::fs::read_to_string(program).expect("a program to read");
    let offsets: Vec<f64> = words.map(|word| word.parse().expect("an offset in um")).collect();
    print!("{}", generator::story::corrected(&program, &offsets));
}
