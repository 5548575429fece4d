//! A finishing contour as a small program.

use super::axes::Across;
use super::knots::knots;
use super::number::like;
use super::wanted::{Course, SAME, Wanted};
use super::workpiece::{MM, Workpiece};

/// The contour of a turned part with a change of its radius: straight lines within the chord tolerance, in the way of
/// the pass. `about` goes into its first comment. None of a part that has a breadth: where tracks lie beside each other
/// is for its own program to say.
pub fn contour(work: &Workpiece, course: &Course, about: &str) -> Option<String> {
    let feed = work.feed.filter(|_| work.breadth.is_none())?;
    let wanted = Wanted::new(&[*course], &work.stretches);
    let spots = spots(work, &wanted);
    let (increment, unit) = (work.increment(MM), MM);
    let scale = unit * work.across.share();
    let (across, along) = (char::from(work.axes.letters[0]), char::from(work.axes.letters[1]));
    let written: Vec<(String, String)> = spots
        .iter()
        .map(|(x, r)| {
            let place = increment.round((x - work.zero.x) / unit);
            (like("0.0", increment.round(r / scale), increment), like("0.0", place, increment))
        })
        .collect();
    let mut text = format!(
        "({})\n({across} AS A {}, MM, ABSOLUTE, {along}0 AT {} MM FROM THE HEADSTOCK, F PER REVOLUTION)\n\
         (POINT OF THE NOSE, NO COMPENSATION; STRAIGHT SHOULDERS: CHAMFERS AND FILLETS ARE NOT IN IT)\n",
        comment(about),
        if work.across == Across::Diameter { "DIAMETER" } else { "RADIUS" },
        like("0", increment.round(work.zero.x / unit), increment),
    );
    let mut last: Option<&(String, String)> = None;
    for words in &written {
        let is_new = |which: fn(&(String, String)) -> &String| last.is_none_or(|last| which(last) != which(words));
        let x = is_new(|words| &words.0).then(|| format!("{across}{}", words.0));
        let z = is_new(|words| &words.1).then(|| format!("{along}{}", words.1));
        let head = if last.is_none() { "G1 " } else { "" };
        let feed = if last.is_none() { format!(" F{:.3}", feed / unit) } else { String::new() };
        let line: Vec<String> = x.into_iter().chain(z).collect();
        if !line.is_empty() {
            text.push_str(&format!("{head}{}{feed}\n", line.join(" ")));
        }
        last = Some(words);
    }
    Some(text)
}

/// Corners of the contour, (place, radius), in the way of the tool.
fn spots(work: &Workpiece, wanted: &Wanted) -> Vec<(f64, f64)> {
    let (low, high) = work.ends();
    let mut all = Vec::new();
    for stretch in &work.stretches {
        let (from, to) = (stretch.from.max(low), stretch.to.min(high));
        if to - from < SAME {
            continue;
        }
        let points: Vec<(f64, f64)> =
            wanted.between(from, to, 0.0).into_iter().map(|(x, change)| (x, stretch.level + change)).collect();
        all.extend(knots(&points, work.fineness.chord_tolerance).into_iter().map(|at| points[at]));
    }
    if work.pass[1] < work.pass[0] {
        all.reverse();
    }
    all
}

/// A text that fits into a comment of any control: ASCII without parentheses.
fn comment(text: &str) -> String {
    let plain =
        |c: char| if c.is_ascii() && !c.is_ascii_control() && !matches!(c, '(' | ')' | ';' | '%') { c } else { ' ' };
    text.chars().map(plain).collect::<String>().to_ascii_uppercase()
}
