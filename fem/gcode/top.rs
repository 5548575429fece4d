//! Which track of a mill makes its top at a place.
//!
//! A face mill leaves the height at which its middle runs on all that it covers, and neighbouring tracks cover each
//! other in part. The height at a place is that of the nearest track: each answers for the places that are nearest to
//! it, half way to its neighbours, and at its ends for as far as the cutter reaches. Tracks at the height of the top
//! come first, and of those such as are the lowest over more than half of what they cover: what lies above is cut away
//! again, what lies below is a pocket or a hole.

use super::arc::{polar, turned};
use super::sample::{EQUAL, Made, Sample, even, weighed};
use super::spot::Spot;
use super::steps::{Cut, Shape, Step};
use super::wanted::SAME;
use super::workpiece::{Breadth, Workpiece};

/// Most different places of tracks by which places are put; programs of more have evenly spaced ones.
const MOST: usize = 60;
/// Rows of places at least across the breadth.
const LEAST: usize = 8;

/// What a step does to the top.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// It finishes it.
    Finish,
    /// It cuts at another height, or what it leaves is cut away.
    Other,
}

/// The tracks that are looked at.
#[derive(Clone, Debug, PartialEq)]
pub struct Tracks {
    /// Of each step what it does; `None` where it does not cut along the top.
    kinds: Vec<Option<Kind>>,
    /// How far beside its middle the cutter reaches, m.
    reach: f64,
}

/// Places all over the top, two rows of them between any two tracks, the middles between them and the edges.
pub fn samples(steps: &[Step], mut along: Vec<f64>, (low, high): (f64, f64), half: f64) -> Vec<Sample> {
    let cuts = || steps.iter().filter_map(|step| step.cut);
    along.extend(borders(cuts().flat_map(|cut| [cut.from.x, cut.to.x]), (low, high)));
    let mut across = borders(cuts().flat_map(|cut| [cut.from.y, cut.to.y]), (-half, half));
    across.extend(even(-half, half, if across.len() > 3 { 1 } else { LEAST }));
    let rows = weighed(across, (-half, half));
    let row = |(x, weight, interval): (f64, f64, [f64; 2])| {
        let place = move |(y, part, _): &(f64, f64, [f64; 2])| Sample {
            x,
            y: *y,
            weight: weight * part / (2.0 * half),
            interval,
        };
        rows.iter().map(place).collect::<Vec<_>>()
    };
    weighed(along, (low, high)).into_iter().flat_map(row).collect()
}

/// Where tracks lie between two ends, and half way between them; evenly spaced places where there are too many.
fn borders(places: impl Iterator<Item = f64>, (low, high): (f64, f64)) -> Vec<f64> {
    let mut own: Vec<f64> = places.collect();
    own.sort_unstable_by(f64::total_cmp);
    own.dedup_by(|a, b| *a - *b < SAME);
    if own.iter().filter(|place| (low..=high).contains(*place)).count() > MOST {
        return even(low, high, MOST).collect();
    }
    let middles: Vec<f64> = own.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
    own.into_iter().chain(middles).filter(|place| (low..=high).contains(place)).collect()
}

/// What of a cut is nearest to a place.
#[derive(Clone, Copy)]
struct Foot {
    share: f64,
    distance: f64,
}

impl Foot {
    fn of(cut: &Cut, [x, y]: [f64; 2]) -> Self {
        // Of millions of places; lengths of parts neither overflow nor vanish when they are squared.
        let end =
            |spot: Spot, share: f64| Self { share, distance: ((x - spot.x).powi(2) + (y - spot.y).powi(2)).sqrt() };
        match cut.shape {
            Shape::Line => {
                let (dx, dy) = (cut.to.x - cut.from.x, cut.to.y - cut.from.y);
                let share = ((x - cut.from.x) * dx + (y - cut.from.y) * dy) / (dx * dx + dy * dy);
                let share = share.clamp(0.0, 1.0);
                end(cut.at(share), share)
            }
            Shape::Arc { is_clockwise, centre, .. } => {
                let [from, to] = [cut.from, cut.to].map(|spot| polar([spot.x, spot.y], centre));
                let (angle, radius) = polar([x, y], centre);
                let whole = turned(from.0, to.0, is_clockwise);
                let share = turned(from.0, angle, is_clockwise) / whole;
                if share <= 1.0 {
                    return Self { share, distance: (radius - from.1).abs() };
                }
                let ends = [end(cut.from, 0.0), end(cut.to, 1.0)];
                if ends[0].distance <= ends[1].distance { ends[0] } else { ends[1] }
            }
        }
    }

    fn level(self, cut: &Cut) -> f64 {
        cut.at(self.share).r
    }
}

/// The lowest level of a cut that comes within reach of a place, as long as it is; a round one lies at one level.
fn lowest(cut: &Cut, [x, y]: [f64; 2], reach: f64) -> f64 {
    let way = cut.way().max(SAME);
    let [dx, dy] = [cut.to.x - cut.from.x, cut.to.y - cut.from.y].map(|own| own / way);
    let (along, aside) = ((x - cut.from.x) * dx + (y - cut.from.y) * dy, (x - cut.from.x) * dy - (y - cut.from.y) * dx);
    let half = (reach * reach - aside * aside).max(0.0).sqrt();
    let level = |at: f64| cut.at((at / way).clamp(0.0, 1.0)).r;
    level(along - half).min(level(along + half))
}

/// Whether a cut runs along the top at all.
fn runs(cut: &Cut) -> bool {
    cut.way() >= SAME || matches!(cut.shape, Shape::Arc { .. })
}

/// The box in which the middle of the cutter stays, grown by a length: from, to in x, and in y.
fn bounds(cut: &Cut, by: f64) -> [[f64; 2]; 2] {
    let sides = [[cut.from.x, cut.to.x], [cut.from.y, cut.to.y]];
    let around = match cut.shape {
        Shape::Line => sides.map(|[a, b]| [a.min(b), a.max(b)]),
        Shape::Arc { centre, .. } => {
            let radius = polar([cut.from.x, cut.from.y], centre).1;
            centre.map(|own| [own - radius, own + radius])
        }
    };
    around.map(|[low, high]| [low - by, high + by])
}

impl Tracks {
    /// The tracks that make the top, as far as some places show it.
    pub fn of(steps: &[Step], places: &[[f64; 2]], (work, breadth): (&Workpiece, Breadth)) -> Self {
        let top = work.stretches.first().map_or(0.0, |own| own.level);
        let is_high = |r: f64| (r - top).abs() <= work.agreement;
        let mut tracks = Self { kinds: Vec::new(), reach: breadth.reach };
        let kind = |step: &Step| {
            let cut = step.cut.as_ref().filter(|cut| runs(cut))?;
            match is_high(cut.from.r) && is_high(cut.to.r) {
                true => Some(Kind::Finish),
                // Beside a path that the control moves nobody knows what is cut.
                false => (!cut.is_aside).then_some(Kind::Other),
            }
        };
        tracks.kinds = steps.iter().map(kind).collect();
        let sorted = Sorted::of(places);
        let mut lowest = vec![f64::INFINITY; places.len()];
        tracks.each(steps, &sorted, Kind::Finish, |_, at, _, r| lowest[at] = lowest[at].min(r));
        let (mut covered, mut kept) = (vec![0_usize; steps.len()], vec![0_usize; steps.len()]);
        tracks.each(steps, &sorted, Kind::Finish, |step, at, _, r| {
            covered[step] += 1;
            kept[step] += usize::from(r <= lowest[at] + EQUAL);
        });
        for (step, kind) in tracks.kinds.iter_mut().enumerate() {
            let is_cut_away = *kind == Some(Kind::Finish) && 2 * kept[step] <= covered[step];
            *kind = if is_cut_away { Some(Kind::Other) } else { *kind };
        }
        tracks
    }

    /// The same of steps of which each comes of one of these, by their positions.
    pub fn of_written(&self, origins: &[usize]) -> Self {
        Self { kinds: origins.iter().map(|origin| self.kinds.get(*origin).copied().flatten()).collect(), ..*self }
    }

    /// Lays the top at some places: by the nearest of the tracks that finish it, of those that pass alike the lowest,
    /// of equal ones the last; where none does, by the deepest cut that there is.
    pub fn lay(&self, steps: &[Step], places: &[[f64; 2]], made: &mut [Option<Made>]) {
        let sorted = Sorted::of(places);
        let mut nearest = vec![f64::INFINITY; places.len()];
        self.each(steps, &sorted, Kind::Finish, |step, at, foot, r| {
            let is_nearer = foot.distance < nearest[at] - SAME;
            let is_lower = made[at].is_none_or(|other| r <= other.r + EQUAL);
            if is_nearer || (foot.distance <= nearest[at] + SAME && is_lower) {
                nearest[at] = foot.distance.min(nearest[at]);
                made[at] = Some(Made { step, share: foot.share, r });
            }
        });
        self.each(steps, &sorted, Kind::Other, |step, at, foot, r| {
            let is_free = nearest[at] == f64::INFINITY;
            if is_free && made[at].is_none_or(|other| r <= other.r + EQUAL) {
                made[at] = Some(Made { step, share: foot.share, r });
            }
        });
    }

    /// How much lower (m) than the height at some places a flat cutter stands while it is over them: it takes as much
    /// more there.
    pub fn deeper(&self, steps: &[Step], places: &[[f64; 2]], made: &[Option<Made>]) -> Vec<f64> {
        let mut low = vec![f64::INFINITY; places.len()];
        self.each(steps, &Sorted::of(places), Kind::Finish, |step, at, _, _| {
            if let Some(cut) = &steps[step].cut {
                low[at] = low[at].min(lowest(cut, places[at], self.reach));
            }
        });
        let deeper = |(lowest, made): (f64, &Option<Made>)| made.map_or(0.0, |own| (own.r - lowest).max(0.0));
        low.into_iter().zip(made).map(deeper).collect()
    }

    /// Calls with each step of a kind and each place that it covers: the step, the place, by their positions, what of
    /// the cut is nearest, and the level there.
    fn each(&self, steps: &[Step], places: &Sorted, kind: Kind, mut call: impl FnMut(usize, usize, Foot, f64)) {
        let own = |(number, step): (usize, &Step)| {
            let is_own = self.kinds.get(number) == Some(&Some(kind));
            step.cut.filter(|_| is_own).map(|cut| (number, cut))
        };
        for (number, cut) in steps.iter().enumerate().filter_map(own) {
            for (at, place) in places.within(bounds(&cut, self.reach + SAME)) {
                let foot = Foot::of(&cut, place);
                if foot.distance <= self.reach + SAME {
                    call(number, at, foot, foot.level(&cut));
                }
            }
        }
    }
}

/// Places in the order of x, each with its position.
struct Sorted {
    places: Vec<(usize, [f64; 2])>,
}

impl Sorted {
    fn of(places: &[[f64; 2]]) -> Self {
        let mut places: Vec<(usize, [f64; 2])> = places.iter().copied().enumerate().collect();
        places.sort_by(|a, b| a.1[0].total_cmp(&b.1[0]));
        Self { places }
    }

    fn within(&self, [[from, to], [low, high]]: [[f64; 2]; 2]) -> impl Iterator<Item = (usize, [f64; 2])> {
        let first = self.places.partition_point(|(_, [x, _])| *x < from);
        let reached = self.places[first..].iter().take_while(move |(_, [x, _])| *x <= to);
        reached.filter(move |(_, [_, y])| (low..=high).contains(y)).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::super::axes::{Across, MILL};
    use super::super::fineness::Fineness;
    use super::super::steps::Centre;
    use super::super::workpiece::Stretch;
    use super::*;

    /// A top of 10 by 4 m at height 0, under a cutter that reaches 1.5 m.
    fn work() -> Workpiece {
        Workpiece {
            axes: MILL,
            zero: Spot::default(),
            across: Across::Height,
            fineness: Fineness::default(),
            agreement: 0.1,
            stretches: vec![Stretch { from: 0.0, to: 10.0, level: 0.0 }],
            breadth: Some(Breadth { half: 2.0, reach: 1.5 }),
            pass: [0.0, 10.0],
            feed: None,
        }
    }

    fn cut(from: [f64; 3], to: [f64; 3], shape: Shape) -> Step {
        let [from, to] = [from, to].map(|[x, y, r]| Spot { x, y, r });
        let cut = Some(Cut { from, to, shape, is_aside: false });
        Step { block: 0, word: None, is_on: false, unit: 1e-3, scale: 1e-3, r: Some(to.r), cut, is_plain: true }
    }

    #[test]
    fn the_nearest_track_at_the_height_of_the_top_makes_it() {
        let line = |from, to| cut(from, to, Shape::Line);
        let turn = Shape::Arc { is_clockwise: false, centre: [10.0, 0.0], written: Centre::FromStart };
        let steps = [
            line([-2.0, 0.0, 1.0], [12.0, 0.0, 1.0]),   // roughing
            line([-2.0, 0.5, 0.05], [12.0, 0.5, 0.05]), // what is left for finishing is cut away
            line([-2.0, -1.0, 5.0], [-2.0, -1.0, 0.0]), // down
            line([-2.0, -1.0, 0.0], [10.0, -1.0, 0.0]), // finishing
            cut([10.0, -1.0, 0.0], [10.0, 1.0, 0.0], turn),
            line([10.0, 1.0, 0.0], [4.0, 1.0, 0.0]),
            line([4.0, 1.0, 0.0], [6.0, 1.0, -1.0]), // a ramp into a pocket
        ];
        let places = [[5.0, -1.9], [5.0, -0.1], [5.0, 0.1], [10.3, 0.1], [3.0, 1.0], [1.0, 1.0], [9.0, 2.0]];
        let work = work();
        let mut made = vec![None; places.len()];
        Tracks::of(&steps, &places, (&work, work.breadth.unwrap())).lay(&steps, &places, &mut made);
        let found: Vec<_> = made.iter().map(|own| own.map(|own| (own.step, own.r))).collect();
        let finish = |step| Some((step, 0.0));
        assert_eq!(found, [finish(3), finish(3), finish(5), finish(4), finish(5), Some((1, 0.05)), finish(5)]);
        assert!((made[2].unwrap().share - 5.0 / 6.0).abs() < 1e-12, "{:?}", made[2]);
        assert_eq!(made[4].unwrap().share, 1.0);
    }
}
