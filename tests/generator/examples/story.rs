//! Prints the measurements of the story.

fn main() {
    print!("{}", generator::story::measured());
}
