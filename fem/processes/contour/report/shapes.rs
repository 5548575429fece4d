//! The contour in the plane: for ParaView and for drawings.

use super::super::forward::Lap;
use super::super::machine::Machine;
use super::super::path::{Direction, Point, dot};
use super::super::rows::{ANGLE_OF_ROW, DIRECTION};
use super::super::setup::Setup;
use crate::process::{
    Animation, Body, Cell, Curve, Drawing, Ends, Field, Frame, Grid, Role, Rows, Skin, SkinPoint, Spot, View,
};
use crate::units::{ANGLE, FEED_RATE, LENGTH, MICRO, NUMBER};

/// Frames of a lap.
const STEPS: usize = 24;
/// Sizes in the picture, as parts of the contour's size: radius of a lap's thread, height from lap to lap, radius and
/// length of the tool.
const BAND: f64 = 0.005;
const HEIGHT: f64 = 0.02;
const TOOL: [f64; 2] = [0.025, 0.3];

/// A place of the contour on a lap.
#[derive(Clone, Copy)]
struct Place {
    point: Point,
    /// Where the tool is off to, m.
    off: [f64; 2],
    /// m.
    deviation: f64,
}

/// The places of each direction with their deviations (m), counter-clockwise and closed.
fn laps(setup: &Setup, rows: &Rows, deviations: &[f64]) -> Vec<(Direction, Vec<Place>)> {
    let of = |direction: &Direction| {
        let own = (0..rows.len()).filter(|row| Direction::at(rows.columns[DIRECTION][*row]) == *direction);
        let place = |row: usize| {
            let (point, deviation) = (setup.path.at(rows.columns[ANGLE_OF_ROW][row]), deviations[row]);
            Place { point, off: point.outward.map(|c| c * deviation), deviation }
        };
        let mut places: Vec<Place> = own.map(place).collect();
        places.sort_by(|a, b| a.point.travelled.total_cmp(&b.point.travelled));
        (*direction, closed(setup, places))
    };
    setup.directions.iter().map(of).collect()
}

/// A line through places that follow each other and back to the first. At a corner both sides as they come out meet:
/// each is stretched along itself by what its neighbours are off by.
fn closed(setup: &Setup, places: Vec<Place>) -> Vec<Place> {
    let sides = setup.path.sides();
    // What stands next to the begin and to the end of each side, m.
    let ends: Vec<[f64; 2]> = (0..sides.len())
        .map(|side| {
            let own = || places.iter().filter(|p| p.point.side == side).map(|p| p.deviation);
            [own().next().unwrap_or(0.0), own().next_back().unwrap_or(0.0)]
        })
        .collect();
    let around = |side: usize, by: usize| (side + by) % sides.len();
    let corner = |from: usize| {
        let to = around(from, 1);
        meeting([(ends[from][1], sides[from].outward), (ends[to][0], sides[to].outward)])
    };
    let mut line: Vec<Place> = Vec::new();
    for (i, place) in places.iter().enumerate() {
        let Some(side) = sides.get(place.point.side) else {
            line.push(*place);
            continue;
        };
        let number = place.point.side;
        let (begin, end) = (corner(around(number, sides.len() - 1)), corner(number));
        let share = place.point.from_ends[0] / side.length;
        let stretched = (1.0 - share) * dot(begin, side.along) + share * dot(end, side.along);
        let off = [0, 1].map(|c| place.off[c] + stretched * side.along[c]);
        line.push(Place { off, ..*place });
        let next = &places[(i + 1) % places.len()];
        if next.point.side != number {
            let larger = if place.deviation.abs() > next.deviation.abs() { place } else { next };
            let travelled = place.point.travelled + place.point.from_ends[1];
            let point = Point { at: side.to, travelled, ..place.point };
            line.push(Place { point, off: end, deviation: larger.deviation });
        }
    }
    line.extend(line.first().copied());
    line
}

/// Where two sides meet that are off by some (m) along the ways in which they face, from where they met, m: p·n₁ = d₁ and
/// p·n₂ = d₂; of sides that go on almost straight half of both.
fn meeting([(first, one), (second, other)]: [(f64, [f64; 2]); 2]) -> [f64; 2] {
    const STRAIGHT: f64 = 0.01;
    let cosine = dot(one, other);
    let square = 1.0 - cosine * cosine;
    let [a, b] = match square > STRAIGHT {
        true => [first - second * cosine, second - first * cosine].map(|part| part / square),
        false => [first, second].map(|part| 0.5 * part),
    };
    [0, 1].map(|c| a * one[c] + b * other[c])
}

/// The contour in every direction, deviations magnified.
pub fn drawing(setup: &Setup, rows: &Rows, deviations: &[f64]) -> Drawing {
    let spot = |place: &Place| {
        let outward = match place.deviation {
            0.0 => place.point.outward,
            deviation => place.off.map(|c| c / deviation),
        };
        Spot { at: place.point.at, outward, deviation: place.deviation }
    };
    let curve = |(family, (direction, places)): (usize, (Direction, Vec<Place>))| Curve {
        label: format!("predicted, {}", direction.word()),
        family,
        is_measured: false,
        pieces: vec![places.iter().map(spot).collect()],
    };
    Drawing {
        name: "contour",
        title: format!("{}, {}", setup.path.words(), FEED_RATE.format(setup.feed)),
        nominal: setup.path.drawn(),
        curves: laps(setup, rows, deviations).into_iter().enumerate().map(curve).collect(),
    }
}

/// A lap with where the tool is when each place is commanded.
struct Travelled {
    direction: Direction,
    places: Vec<Place>,
    /// Where the tool is less where it is commanded, m.
    behind: Vec<[f64; 2]>,
    /// The time of each place within the lap, s, and of the whole lap.
    times: Vec<f64>,
    period: f64,
}

/// The tool on its way round, lap after lap. Points are those of the path, of the laps before too, then the tool;
/// `displacement` is the deviation outwards (and along a side what moves its corners), `following_error` where the tool is when the point is commanded, the lag
/// along the path included.
pub fn animation(machine: &Machine, rows: &Rows, deviations: &[f64]) -> Animation {
    let setup = &machine.setup;
    let lap = |(direction, places): (Direction, Vec<Place>)| {
        let lap = Lap::new(machine, direction, setup.feed);
        let behind = |place: &Place| {
            let tool = lap.position(lap.time(&place.point)).0;
            [0, 1].map(|c| tool[c] - place.point.at[c])
        };
        let period = setup.path.length() / setup.feed;
        let last = places.len().saturating_sub(1);
        let time = |(i, place): (usize, &Place)| match (direction, i) {
            (Direction::CounterClockwise, i) if i == last => period + lap.time(&places[0].point),
            (Direction::Clockwise, 0) => period + lap.time(&places[last].point).min(0.0),
            _ => lap.time(&place.point),
        };
        let times = places.iter().enumerate().map(time).collect();
        let behind = places.iter().map(behind).collect();
        Travelled { direction, behind, times, period, places }
    };
    let laps: Vec<Travelled> = laps(setup, rows, deviations).into_iter().map(lap).collect();
    let (setup, frames) = (setup.clone(), STEPS * laps.len());
    Animation {
        name: "path",
        shown: "deviation",
        time: "time along the path, lap after lap, s",
        view: View::Front,
        telling: frames.saturating_sub(1),
        most_magnified: f64::INFINITY,
        frames,
        frame: Box::new(move |i| frame(&setup, &laps[..=i / STEPS], (i % STEPS + 1) as f64 / STEPS as f64)),
    }
}

/// The last of some laps, so much of it done.
fn frame(setup: &Setup, laps: &[Travelled], done: f64) -> Frame {
    let size = 2.0 * setup.path.reach();
    let mut grid = Grid::default();
    let (mut deviation, mut off, mut behind, mut number) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut bodies = vec![Body::new("as it should be", Role::Nominal, nominal(setup, -HEIGHT * size))];
    let mut caption = String::new();
    let mut begin = 0.0;
    for (k, lap) in laps.iter().enumerate() {
        let is_last = k + 1 == laps.len();
        let first = grid.points.len() as u32;
        for (j, place) in lap.places.iter().enumerate() {
            grid.points.push([place.point.at[0], place.point.at[1], 0.0]);
            deviation.push(place.deviation);
            off.push([place.off[0], place.off[1], 0.0]);
            behind.push([lap.behind[j][0], lap.behind[j][1], 0.0]);
            number.push((k + 1) as f64);
            if j > 0 {
                grid.push(Cell::Line, &[first + j as u32 - 1, first + j as u32]);
            }
        }
        let until = if is_last && done < 1.0 { done * lap.period } else { f64::INFINITY };
        let cut: Vec<usize> = (0..lap.places.len()).filter(|j| lap.times[*j] <= until * (1.0 + 1e-9)).collect();
        let floor = HEIGHT * size * k as f64;
        let thread = thread(&lap.places, &cut, first, floor, size);
        bodies.push(Body::thickened(if is_last { "contour" } else { "contour of a lap before" }, thread));
        if !is_last {
            begin += lap.period;
            continue;
        }
        bodies.push(Body::thickened("deviation", filled(&lap.places, &cut, first, floor, size)));
        // The tool stands at the last place that it has passed.
        let latest = cut.iter().copied().max_by(|a, b| lap.times[*a].total_cmp(&lap.times[*b])).unwrap_or(0);
        let place = &lap.places[latest];
        let node = grid.points.len() as u32;
        grid.push(Cell::Vertex, &[node]);
        grid.points.push([place.point.at[0], place.point.at[1], 0.0]);
        deviation.push(place.deviation);
        off.push([place.off[0], place.off[1], 0.0]);
        behind.push([lap.behind[latest][0], lap.behind[latest][1], 0.0]);
        number.push((k + 1) as f64);
        let [radius, length] = TOOL.map(|part| part * size);
        let meridian = [(0.0, 0.02 * radius), (1.2 * radius, radius), (length, radius)];
        let from = [0.0, 0.0, floor];
        bodies.push(Body::new("tool", Role::Tool, Skin::turned(Some(node), from, [0.0, 0.0, 1.0], &meridian)));
        let [x, y] = place.point.at;
        let angle = ANGLE.shown(y.atan2(x).rem_euclid(std::f64::consts::TAU));
        caption = format!(
            "{} at {angle:.0}: {:+.2} off the path, {:.3} behind the command",
            lap.direction.word(),
            MICRO.shown(place.deviation),
            LENGTH.shown(lap.behind[latest][0].hypot(lap.behind[latest][1]))
        );
        begin += done * lap.period;
    }
    grid.point_fields = vec![
        Field::scalar("deviation", MICRO, deviation),
        Field::vector("displacement", LENGTH, off),
        Field::vector("following_error", LENGTH, behind),
        Field::scalar("lap", NUMBER, number),
    ];
    Frame { time: begin, caption, grid, bodies, arrows: Vec::new() }
}

/// A thread along the places of a lap that are cut, which are points of the grid from `first` on, above a floor (m).
fn thread(places: &[Place], cut: &[usize], first: u32, floor: f64, size: f64) -> Skin {
    let ring = |j: &usize| {
        let [x, y] = places[*j].point.outward;
        // Askew, so that a jump outwards shows too.
        let mut ring = Skin::ring(Some(first + *j as u32), [x - y, x + y, 0.0], BAND * size);
        ring.iter_mut().for_each(|point| point.offset[2] += floor);
        ring
    };
    let rings: Vec<Vec<SkinPoint>> = cut.iter().map(ring).collect();
    if rings.len() < 2 { Skin::default() } else { Skin::lofted(&rings, Ends::Capped) }
}

/// Band between the nominal path and the actual one, in the same places.
fn filled(places: &[Place], cut: &[usize], first: u32, floor: f64, size: f64) -> Skin {
    let ring = |j: &usize| {
        let [x, y] = places[*j].point.at;
        let is = |z: f64| SkinPoint { node: Some(first + *j as u32), offset: [0.0, 0.0, z] };
        let meant = |z: f64| SkinPoint { node: None, offset: [x, y, z] };
        let [low, high] = [floor - 0.2 * BAND * size, floor + 0.2 * BAND * size];
        [meant(low), meant(high), is(high), is(low)].to_vec()
    };
    let rings: Vec<Vec<SkinPoint>> = cut.iter().map(ring).collect();
    if rings.len() < 2 { Skin::default() } else { Skin::lofted(&rings, Ends::Capped) }
}

/// The path as it should be, a flat band below the laps.
fn nominal(setup: &Setup, top: f64) -> Skin {
    let size = 2.0 * setup.path.reach();
    let mut rings = Vec::new();
    for spot in setup.path.drawn().concat() {
        let point = |side: f64, z: f64| {
            let [x, y] = [0, 1].map(|c| spot.at[c] + side * 0.6 * BAND * size * spot.outward[c]);
            SkinPoint { node: None, offset: [x, y, z] }
        };
        let floor = top - 0.2 * HEIGHT * size;
        rings.push([point(-1.0, floor), point(-1.0, top), point(1.0, top), point(1.0, floor)].to_vec());
    }
    rings.pop();
    Skin::lofted(&rings, Ends::Joined)
}
