//! Play in the feed of the slide.

/// The motion over a turn of a slide with play.
///
/// A slide that is driven through play of width `gap` stands anywhere within half of it of its command, and
/// moves only when it is pushed: y = clamp(y, x − gap/2, x + gap/2). `commands` are (time, place) at which
/// the command bends, over one turn that begins and ends alike; between them it goes linearly. Gives the same
/// of the slide, as it does after turns without number, with the bends that taking up the play adds.
pub fn play(commands: &[(f64, f64)], gap: f64) -> Vec<(f64, f64)> {
    let half = 0.5 * gap;
    let Some(first) = commands.first() else { return Vec::new() };
    let mut at = first.1;
    // One turn brings the slide to where every later turn begins.
    let mut bends = Vec::new();
    for _ in 0..2 {
        bends = vec![(first.0, at)];
        for w in commands.windows(2) {
            let ((t, x), (next_t, next_x)) = (w[0], w[1]);
            // Where the command must be to push the slide from where it is.
            let pushes = if next_x > x { at + half } else { at - half };
            let after = at.min(next_x + half).max(next_x - half);
            let part = (pushes - x) / (next_x - x);
            if part > 1e-12 && part < 1.0 {
                bends.push((t + part * (next_t - t), at));
            }
            at = after;
            bends.push((next_t, at));
        }
    }
    bends
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slide_with_play_lags_by_half_of_it_and_stands_at_reversals() {
        let command = [(0.0, 0.0), (1.0, 10.0), (2.0, 10.0), (4.0, 0.0)];
        let slide = play(&command, 2.0);
        // It begins where falling has left it, stands until the command has crossed the play, and follows
        // half of it behind.
        let expected = [(0.0, 1.0), (0.2, 1.0), (1.0, 9.0), (2.0, 9.0), (2.4, 9.0), (4.0, 1.0)];
        assert_eq!(slide.len(), expected.len());
        for (a, b) in slide.iter().zip(expected) {
            assert!((a.0 - b.0).abs() < 1e-12 && (a.1 - b.1).abs() < 1e-12, "{slide:?}");
        }
        assert_eq!(play(&command, 0.0), command);
    }
}
