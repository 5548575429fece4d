//! Remedies as a table for spreadsheets and as a picture.

use super::chart::{Axis, Chart, Form, Plane, Point, Series};
use crate::remedy::{Change, Remedies, Remedy};
use crate::units::TIME;

/// Every list, a row a remedy.
pub fn table(found: &Remedies) -> String {
    let of = |name: &str| format!("{name} [{}]", found.kind.unit);
    let [rms, worst, gain] = ["rms", "worst", "gain"].map(of);
    let header = [
        "list",
        "change",
        &rms,
        &worst,
        &gain,
        "minutes",
        "tolerance used",
        "tolerance used with 95 %",
        "probability in",
    ];
    let lists = [
        ("now", std::slice::from_ref(&found.now)),
        ("alone", &found.alone[..]),
        ("together", &found.together[..]),
        ("front", &found.front[..]),
    ];
    let cell = |value: Option<f64>| value.map_or(String::new(), |value| format!("{}", value + 0.0));
    let mut text = header.join(",") + "\n";
    for (name, all) in lists {
        for own in all {
            let sizes = [own.left.rms, own.left.worst, found.gain(own)].map(|si| cell(Some(found.kind.from_si(si))));
            let further =
                [Some(TIME.from_si(own.time)), own.left.used, own.left.surely_used, own.probability].map(cell);
            let change = list(own).replace('"', "\"\"");
            text += &format!("{name},\"{change}\",{},{}\n", sizes.join(","), further.join(","));
        }
    }
    text
}

/// What is left over minutes: the front, every setting alone, and what is made now.
pub fn chart(found: &Remedies) -> Chart {
    let is_asked = found.now.left.used.is_some();
    let point = |own: &Remedy| {
        let left = own.left.surely_used.map_or(found.kind.from_si(own.left.rms), |used| 100.0 * used);
        Point::new(TIME.from_si(own.time), left)
    };
    let points = |all: &[Remedy]| all.iter().map(point).collect::<Vec<Point>>();
    let front = points(&found.front);
    let mut series = vec![
        Series::new("front", 0, Form::Line, front.clone()),
        Series::new("", 0, Form::Dots, front.clone()),
        Series::new("one setting", 1, Form::Dots, points(&found.alone)),
        Series::new("now", 2, Form::Dots, vec![point(&found.now)]),
    ];
    if is_asked {
        let all = || series.iter().flat_map(|own| &own.points).map(|own| own.x);
        let [low, high] = [all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)];
        series.insert(0, Series::new("within", 3, Form::Dashed, [low, high].map(|x| Point::new(x, 100.0)).to_vec()));
    }
    let y = match is_asked {
        true => Axis::new("part of the tolerance that is used", "%"),
        false => Axis::new("root mean square of the error", found.kind.unit),
    };
    Chart {
        name: "remedies".into(),
        title: "what minutes buy".into(),
        note: "nothing that was tried lies below the line; one setting changed, and what is made now".into(),
        plane: Plane::Curves { x: Axis::new("minutes beside what the parts take now", TIME.unit), y, series },
    }
}

/// A change as people read it.
pub fn words(own: &Change) -> String {
    format!("{} {}", own.setting, own.to.as_deref().unwrap_or_default()).trim_end().to_string()
}

/// Changes as people read them.
pub fn list(own: &Remedy) -> String {
    match own.changes.is_empty() {
        true => "as it is".into(),
        false => own.changes.iter().map(words).collect::<Vec<_>>().join(", "),
    }
}
