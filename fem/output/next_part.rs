//! The answer of `fem next`: the offset of the next part, what to expect, what to measure, when to change the insert.

use serde_json::{Value as Json, json};

use super::answer::Answer;
use super::block::{Block, Cell, Column, Table};
use super::chart::{Axis, Chart, Form, Plane, Point, Series, Svg, named};
use super::json::finite;
use super::number;
use super::page::{Head, answered};
use super::text::titled;
use crate::compare::rms;
use crate::next::{History, Insert, Measure, Next};
use crate::units::{MICRO, TIME};

/// Fewest measured parts on which the record says something.
const FEW: usize = 4;

/// Most places that are named.
const MOST_PLACES: usize = 6;

/// The next part of a machine.
pub struct NextAnswer<'a>(pub &'a History, pub &'a Next);

impl Answer for NextAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        let Self(history, next) = *self;
        let job = &history.jobs[next.part.job];
        let title = titled(history.title.as_deref(), &history.source.name);
        let mut blocks = vec![Block::Sentence(title)];
        blocks.extend(self.cautions().into_iter().map(Block::Caution));
        blocks.push(Block::Entries(vec![
            (format!("part {}", next.part.number), format!("{}{}", self.offset(&job.name), self.plan())),
            (String::new(), self.expected()),
            ("measure".into(), self.measure()),
            ("insert".into(), self.insert()),
        ]));
        blocks.extend(self.record());
        blocks
    }

    /// What was left of each part, one part ahead and by what shops do instead, and what is expected of the next.
    fn figures(&self) -> Vec<(String, Svg)> {
        let Self(_, next) = *self;
        if next.measured < FEW {
            return Vec::new();
        }
        let point = |(number, left): (&usize, &f64)| Point::new(*number as f64, um(*left));
        let points = |left: &[f64]| next.numbers[1..].iter().zip(left).map(point).collect::<Vec<_>>();
        let rivals = next.rivals.iter().enumerate();
        let label = |key: &str| key.replace('-', " ").replace("ewma", "EWMA");
        let rivals = rivals.map(|(i, own)| Series::new(label(own.key), i + 1, Form::Dashed, points(&own.left[1..])));
        let [low, high] = next.interval.map(|end| um(end - next.aim));
        let coming = Point { x: next.part.number as f64, y: 0.5 * (low + high), u: 0.5 * (high - low) };
        let own = [
            Series::new("this model", 0, Form::Line, points(&next.left)),
            Series::new("", 0, Form::Dots, vec![coming]),
        ];
        let chart = Chart {
            name: "left".into(),
            title: "mean error left, one part ahead".into(),
            note: "dot with bar: what is expected of the next part, 95 %".into(),
            plane: Plane::Curves {
                x: Axis::new("part", ""),
                y: Axis::new("mean error", MICRO.unit),
                series: rivals.chain(own).collect(),
            },
        };
        vec![named(&chart)]
    }

    /// `fem next --json`: `fem-next/1`; SI.
    fn json(&self) -> Json {
        let Self(history, next) = *self;
        let job = &history.jobs[next.part.job];
        let left = |values: &[f64]| json!({ "rms": (!values.is_empty()).then(|| rms(values)), "parts": values });
        let rival = |own: &crate::next::Rival| json!({ "name": own.key, "words": own.words, "left": left(&own.left[own.left.len().min(1)..]), "next": { job.commanded.key: own.next } });
        let suspect = |(part, own): &(usize, crate::next::Suspect)| json!({ "part": part, "by": finite(own.by), "machine_changed": own.is_change });
        let Measure { part, place, halves, is_for_tolerance } = &next.measure;
        json!({
            "schema": "fem-next/1",
            "log": &*history.source.name,
            "part": next.part.number,
            "job": if job.name.is_empty() { Json::Null } else { json!(job.name) },
            "insert": next.part.insert,
            "set_up": next.part.set_up,
            "pause": next.part.pause,
            "offset": { job.commanded.key: next.part.offset, "before": next.before },
            "expected": { "mean": finite(next.expected), "interval95": next.interval.map(finite), "aim": finite(next.aim), "places": next.places },
            "probability_in": next.probability,
            "measure": {
                "part": part,
                "place": place,
                "half_interval95_after": { "without": halves[0], "with": halves[1], "at_the_worst_place": halves[2] },
                "for_tolerance": is_for_tolerance,
            },
            "insert_change": { "after_part": next.insert.after, "looked_up_to": next.insert.looked, "growth": finite(next.insert.growth) },
            "noise": finite(next.noise),
            "measured_parts": next.measured,
            "far_off": next.suspects.iter().map(suspect).collect::<Vec<_>>(),
            "record": { "model": left(&next.left), "others": next.rivals.iter().map(rival).collect::<Vec<_>>() },
            "advised_by": next.better.map_or("model", |own| next.rivals[own].key),
        })
    }
}

impl NextAnswer<'_> {
    /// The answer as a page of its own.
    pub fn page(&self) -> String {
        let Self(history, next) = *self;
        let verdict = format!("part {}: {}", next.part.number, self.offset(&history.jobs[next.part.job].name));
        let head = Head::new("fem next", history.title.as_deref(), &history.source.name, verdict);
        answered(head, self)
    }

    fn cautions(&self) -> Vec<String> {
        let Self(_, next) = *self;
        let mut all = Vec::new();
        for (part, suspect) in &next.suspects {
            let by = format!("part {part} measures {} um other than was expected", signed(suspect.by));
            all.push(match suspect.is_change {
                Some(true) => format!("{by}, and so do those behind it: something changed there that the log does not tell"),
                Some(false) => format!("{by}, and those behind it do not: it counts as measured wrongly"),
                None => format!("{by}: a chip under the gauge, or something changed that the log does not tell; measure it again, or the next part, before the offset is trusted"),
            });
        }
        if let Some(better) = next.better {
            let rival = &next.rivals[better];
            all.push(format!(
                "on this history the model does worse than {}: {} um were left against {} um, more than chance; the offset \
                 is that of the better one. `fem diagnose` with these measurements looks for what the model lacks",
                rival.words,
                number::fixed(um(rms(&next.left)), 1),
                number::fixed(um(rms(&rival.left[1..])), 1)
            ));
        }
        all
    }

    fn offset(&self, job: &str) -> String {
        let Self(history, next) = *self;
        let words = history.jobs[next.part.job].commanded.words;
        let of = if job.is_empty() { String::new() } else { format!(" of {job}") };
        let change = next.part.offset - next.before;
        let change = match number::signed(um(change), 1).as_str() {
            "+0.0" => "as it is".to_string(),
            change => format!("a change of {change} um"),
        };
        format!("set the offset of the {words}{of} to {} um ({change})", signed(next.part.offset))
    }

    /// What is to happen before the part.
    fn plan(&self) -> String {
        let Self(history, next) = *self;
        let last = history.part(next.part.number - 1);
        let mut all = Vec::new();
        if next.measured > 0 && last.insert != next.part.insert {
            all.push(format!("with the new insert {}", next.part.insert));
        }
        if next.measured > 0 && last.set_up != next.part.set_up {
            all.push("after the new set-up".to_string());
        }
        if next.part.pause > 0.0 {
            all.push(format!("after a rest of {}", TIME.format(next.part.pause)));
        }
        if all.is_empty() { String::new() } else { format!(", {}", all.join(", ")) }
    }

    fn expected(&self) -> String {
        let Self(history, next) = *self;
        let job = &history.jobs[next.part.job];
        let words = &job.model.process.observables()[job.commanded.observable].words;
        let aim = if next.aim == 0.0 {
            String::new()
        } else {
            format!(" (the middle of the limits is {})", signed(next.aim))
        };
        let within = match next.probability {
            Some(p) => format!("; within all that the drawing asks with {:.0} %", 100.0 * p),
            None => "; the model says nothing of what the drawing asks: [tolerance]".into(),
        };
        let [low, high] = next.interval.map(signed);
        let over = match next.measured {
            0 => "along the part".to_string(),
            _ if next.places.len() > MOST_PLACES => "over the places that are measured".into(),
            _ => {
                let along = &job.model.process.coordinates()[job.commanded.along].name;
                let places: Vec<String> = next.places.iter().map(|place| number::mm(*place, 1)).collect();
                format!("at {along} = {} mm", places.join(", "))
            }
        };
        format!(
            "expected mean error of {words} {over} {} um, 95 % from {low} to {high}{aim}{within}",
            signed(next.expected)
        )
    }

    fn measure(&self) -> String {
        let Self(history, next) = *self;
        let Measure { part, place, halves, is_for_tolerance } = &next.measure;
        let job = &history.jobs[next.part.job];
        let along = &job.model.process.coordinates()[job.commanded.along].name;
        let [without, with, worst] = halves.map(|half| number::fixed(um(half), 1));
        let why = match (is_for_tolerance, *part == next.part.number) {
            (true, true) => "it may come out of tolerance",
            (true, false) => "with this offset the next one after it may come out of tolerance",
            (false, true) => "what is known wears off fast",
            (false, false) => "until then what is known stays about as good",
        };
        format!(
            "part {part} at the latest, at {along} = {} mm: {why}. The part after it is then known to ±{with} um instead of \
             ±{without} um; at the place that tells the least, to ±{worst} um",
            number::mm(*place, 1)
        )
    }

    fn insert(&self) -> String {
        let Insert { after, looked, growth, is_asked } = &self.1.insert;
        let grown = format!("{} um since it was new", signed(*growth));
        match (after, is_asked) {
            (Some(part), _) => {
                format!(
                    "change it after part {part}: later on no offset keeps parts in tolerance; the mean of the diameter has then moved by {grown}"
                )
            }
            (None, true) => format!(
                "nothing that the model knows asks for a new one up to part {looked}; the mean of the diameter moves by {grown}, which the offset takes up"
            ),
            (None, false) => format!(
                "how long it may cut depends on what the drawing asks: [tolerance]; up to part {looked} the mean of the diameter moves by {grown}"
            ),
        }
    }

    /// What would have been left one part ahead.
    fn record(&self) -> Vec<Block> {
        let next = self.1;
        if next.measured < FEW {
            let told = format!(
                "{} parts were measured: from {FEW} on the model is held against what shops do instead",
                next.measured
            );
            return vec![Block::Paragraph(told)];
        }
        let row = |words: &str, left: &[f64]| {
            let largest = left.iter().fold(0.0f64, |most, own| most.max(own.abs()));
            vec![Cell::Text(words.into()), Cell::number(um(rms(left))), Cell::number(um(largest))]
        };
        let mut rows = vec![row("this model, one part ahead", &next.left)];
        rows.extend(next.rivals.iter().map(|own| row(&format!("{} (tuned in hindsight)", own.words), &own.left[1..])));
        let columns = [
            Column::wide("mean error left on parts that were measured"),
            Column::new("rms", 10),
            Column::new("largest", 10),
        ];
        let columns = columns.into_iter().chain([Column::remark(MICRO.unit.to_string(), 0)]);
        vec![Block::Table(Table::new(columns, rows))]
    }
}

fn um(si: f64) -> f64 {
    MICRO.from_si(si)
}

fn signed(si: f64) -> String {
    number::signed(um(si), 1)
}
