//! The files of an animation: `NAME.pvd` with true geometry, `NAME-magnified.pvd` as people look at it, and the
//! script that opens it.

use super::field_data::{self, Datum};
use super::survey::Survey;
use super::view;
use super::{VtkError, bodies, picture, si_unit, vtu};
use crate::process::{Animation, Frame};

/// An animation with what its files say of themselves.
pub struct Series<'a> {
    animation: &'a Animation,
    title: String,
    model: String,
    survey: Survey,
}

/// A frame as two files.
pub struct Files {
    /// See [`Animation::time`].
    pub time: f64,
    /// Of the `.vtu` with true geometry.
    pub real: Vec<u8>,
    /// Of the `.vtp` with displacements magnified; `None` where the animation has no bodies.
    pub magnified: Option<Vec<u8>>,
}

impl<'a> Series<'a> {
    /// Looks at all frames; `title` and `model` are the model's title and the name of its file.
    pub fn new(animation: &'a Animation, title: &str, model: &str) -> Self {
        Self { animation, title: title.into(), model: model.into(), survey: Survey::of(animation) }
    }

    /// Makes the files of frame number i.
    ///
    /// # Errors
    /// See [`vtu`].
    pub fn frame(&self, i: usize) -> Result<Files, VtkError> {
        let frame = (self.animation.frame)(i);
        let grid = bodies::dressed(&frame, self.survey.magnification);
        let fields = grid.point_fields.iter().chain(&grid.cell_fields);
        let units: Vec<String> = fields.map(|f| format!("{} {}", f.name, si_unit(f.kind))).collect();
        let data = [self.data(&frame), vec![Datum::Text("units", units.join("; "))]].concat();
        let real = field_data::put(vtu(&grid)?, &data);
        let magnified = match frame.bodies.is_empty() {
            true => None,
            false => {
                let bytes = picture::vtp(&frame, self.animation.shown, &self.survey)?;
                Some(field_data::put(bytes, &self.data(&frame)))
            }
        };
        Ok(Files { time: frame.time, real, magnified })
    }

    /// Field data of every file: title, model, version, time, caption, bodies, magnification, largest force.
    fn data(&self, frame: &Frame) -> Vec<Datum> {
        let bodies = (1..).zip(&frame.bodies).map(|(number, body): (usize, _)| format!("{number} {}", body.name));
        vec![
            Datum::Text("title", self.title.clone()),
            Datum::Text("model", self.model.clone()),
            Datum::Text("version", view::VERSION.into()),
            Datum::Text("time", self.animation.time.into()),
            Datum::Text("caption", frame.caption.clone()),
            Datum::Text("bodies", bodies.collect::<Vec<_>>().join("; ")),
            Datum::Number("magnification", self.survey.magnification),
            Datum::Number("largest_force_N", self.survey.force),
        ]
    }

    /// The script that opens the magnified series; `None` where there is none.
    pub fn view(&self) -> Option<String> {
        let is_drawn = self.animation.frames > 0 && !(self.animation.frame)(0).bodies.is_empty();
        is_drawn.then(|| view::script(self.animation, &self.title, &self.model, &self.survey))
    }
}
