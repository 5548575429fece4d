//! Draws charts.

use super::data::{Chart, Plane};
use super::svg::Svg;
use super::{curves, map, polar};

/// Draws a chart.
pub fn draw(chart: &Chart) -> Svg {
    match &chart.plane {
        Plane::Curves { x, y, series } => curves::draw(chart, x, y, series),
        Plane::Polar { y, series } => polar::draw(chart, y, series),
        Plane::Map { x, y, value, cells } => map::draw(chart, [x, y, value], cells),
    }
}

/// Draws a chart, behind its name.
pub fn named(chart: &Chart) -> (String, Svg) {
    (chart.name.clone(), draw(chart))
}

#[cfg(test)]
mod tests {
    use super::super::data::{Axis, Form, Point, Series};
    use super::*;

    fn series(form: Form, points: Vec<Point>) -> Series {
        Series { label: "part 1 < 2".into(), colour: 0, form, points }
    }

    fn chart(plane: Plane) -> Chart {
        Chart { name: "profile".into(), title: "R & D".into(), note: "dots: measured".into(), plane }
    }

    #[test]
    fn every_value_can_be_asked_for_where_it_was_drawn() {
        let points = vec![Point { x: 0.0, y: -10.0, u: 2.0 }, Point::new(100.0, 30.0), Point::new(50.0, f64::NAN)];
        let curves = Plane::Curves {
            x: Axis::new("x", "mm"),
            y: Axis::new("error", "um"),
            series: vec![series(Form::Dots, points)],
        };
        let svg = draw(&chart(curves));
        assert_eq!(svg.series, ["part 1 < 2"]);
        let values: Vec<&[f64]> = svg.marks.iter().map(|m| &m.values[..2]).collect();
        assert_eq!(values, [[0.0, -10.0], [100.0, 30.0]]);
        assert!(svg.marks[0].values[2] == 2.0 && svg.marks[1].values[2].is_nan());
        // Up is less in pixels, and 42 um of 45.36 lie between the two ends of what is drawn.
        let height = svg.marks[0].at[1] - svg.marks[1].at[1];
        assert!((height / (328.0 - 78.0) - 40.0 / (42.0 * 1.08)).abs() < 1e-9, "{height}");
        for text in [svg.file(), svg.inline()] {
            assert!(text.contains("R &amp; D") && !text.contains("NaN") && !text.contains("inf\""), "{text}");
        }
    }

    #[test]
    fn a_map_has_a_cell_for_each_pair_and_colours_about_zero() {
        let cells = vec![[0.0, 1.0, -4.0], [10.0, 1.0, 4.0], [0.0, 2.0, 0.0], [10.0, 2.0, f64::NAN], [10.0, 1.0, 2.0]];
        let value = Axis { limits: Some((-4.0, 4.0)), ..Axis::new("residual", "um") };
        let svg = draw(&chart(Plane::Map { x: Axis::new("x", "mm"), y: Axis::new("part", ""), value, cells }));
        assert_eq!(svg.marks.len(), 3);
        let text = svg.inline();
        // The least is the first step, nothing the middle one, and a mean of 3 at (4 + 3)/8 of 25 steps the 21st.
        for class in ["class=\"q0\" d", "class=\"q12\" d", "class=\"q21\" d"] {
            assert!(text.contains(class), "{class}");
        }
        assert!(svg.marks.iter().any(|m| m.values == [10.0, 1.0, 3.0]), "{:?}", svg.marks);
    }

    #[test]
    fn an_angle_of_a_quarter_is_up() {
        let ring = |y| (0..36).map(|i| Point::new(10.0 * f64::from(i), y)).collect::<Vec<_>>();
        let polar = Plane::Polar { y: Axis::new("deviation", "um"), series: vec![series(Form::Line, ring(5.0))] };
        let svg = draw(&chart(polar));
        let (right, up) = (svg.marks[0].at, svg.marks[9].at);
        assert!((right[1] - up[1] - (right[0] - up[0])).abs() < 1e-9 && up[1] < right[1]);
        assert!(svg.inline().contains("30\u{b0}"));
    }

    #[test]
    fn nothing_can_be_drawn_too() {
        let planes = [
            Plane::Curves { x: Axis::default(), y: Axis::default(), series: vec![series(Form::Band, Vec::new())] },
            Plane::Polar { y: Axis::default(), series: vec![series(Form::Dots, Vec::new())] },
            Plane::Map { x: Axis::default(), y: Axis::default(), value: Axis::default(), cells: Vec::new() },
        ];
        for plane in planes {
            assert!(!draw(&chart(plane)).file().contains("NaN"));
        }
    }
}
