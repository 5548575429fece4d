//! An SVG picture in the making: its elements, and the places at which a reader can ask for values.

use super::data::Axis;
use super::style::sheet;
use super::thin::{APART, Drawn, FROM, thinned};

/// A picture: a file of its own, or a part of a page.
#[derive(Clone, Debug, Default)]
pub struct Svg {
    /// Width and height, pixels.
    pub size: [f64; 2],
    /// Text alternative for those who do not see it, in a few words.
    pub title: String,
    /// The same, longer.
    pub about: String,
    /// Elements.
    body: String,
    /// Name and unit of each of the marks' values.
    pub axes: Vec<Axis>,
    /// Names of the series to which marks belong.
    pub series: Vec<String>,
    /// Where values can be asked for.
    pub marks: Vec<Mark>,
    /// How many more there are, within a few pixels of these.
    pub unmarked: usize,
}

/// A place of a picture at which something was drawn, and its values.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Pixel.
    pub at: [f64; 2],
    /// Number of the series.
    pub series: usize,
    /// A value for each axis.
    pub values: Vec<f64>,
}

impl Svg {
    /// A picture without elements.
    pub fn new(size: [f64; 2], title: &str, about: &str) -> Self {
        Self { size, title: title.into(), about: about.into(), ..Self::default() }
    }

    /// Adds an element.
    pub fn push(&mut self, element: impl AsRef<str>) {
        self.body.push_str(element.as_ref());
        self.body.push('\n');
    }

    /// Adds a text of a class, anchored at a pixel.
    pub fn text(&mut self, class: &str, [x, y]: [f64; 2], anchor: &str, text: &str) {
        let text = escaped(text);
        self.push(format!("<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{text}</text>"));
    }

    /// Adds a line through pixels; where one is not finite, it is broken.
    pub fn line(&mut self, class: &str, points: impl IntoIterator<Item = [f64; 2]>) {
        let points = thinned(points.into_iter().collect());
        let mut path = String::new();
        let (mut drawn, mut before) = (Drawn::default(), None);
        for [x, y] in &points {
            let is_there = x.is_finite() && y.is_finite();
            if is_there {
                // A line that goes to and fro a thousand times goes the same ways.
                let mut is_seen = |[a, b]: [f64; 2]| points.len() > FROM && !drawn.is_new(&[a, b, *x, *y]);
                let is_down = before.is_some_and(|before| !is_seen(before));
                path.push_str(&format!("{}{x:.1} {y:.1}", if is_down { "L" } else { "M" }));
            }
            before = is_there.then_some([*x, *y]);
        }
        if !path.is_empty() {
            self.push(format!("<path class=\"{class}\" d=\"{path}\"/>"));
        }
    }

    /// Lets a reader ask for values of the points of a series; of very many that lie within a few pixels the first.
    pub fn mark_all(&mut self, series: &str, points: impl IntoIterator<Item = ([f64; 2], Vec<f64>)>, count: usize) {
        let mut drawn = Drawn::default();
        for (at, values) in points {
            match count <= FROM || drawn.is_new(&at.map(|own| own / APART)) {
                true => self.mark(at, series, &values),
                false => self.unmarked += 1,
            }
        }
    }

    /// Lets a reader ask for values of a series.
    pub fn mark(&mut self, at: [f64; 2], series: &str, values: &[f64]) {
        if at.iter().any(|c| !c.is_finite()) {
            return;
        }
        if self.series.last().is_none_or(|last| last != series) {
            self.series.push(series.into());
        }
        self.marks.push(Mark { at, series: self.series.len() - 1, values: values.to_vec() });
    }

    /// The picture as a file.
    pub fn file(&self) -> String {
        let [width, height] = self.size;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fem\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
             height=\"{height}\" role=\"img\">\n<title>{}</title>\n<desc>{}</desc>\n<style>{}</style>\n{}</svg>\n",
            escaped(&self.title),
            escaped(&self.about),
            sheet(),
            self.body
        )
    }

    /// The picture as a part of a page that has the style sheet.
    pub fn inline(&self) -> String {
        let [width, height] = self.size;
        let words = [&*self.title, &*self.about].join(". ").replace('"', "\u{201d}");
        format!(
            "<svg class=\"fem\" viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{}\">\n{}</svg>",
            escaped(words.trim_end_matches(". ")),
            self.body
        )
    }
}

/// Text as XML has it.
pub fn escaped(text: &str) -> String {
    let text: String = text.chars().filter(|c| !c.is_control()).collect();
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
