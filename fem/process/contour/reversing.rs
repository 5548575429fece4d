//! What stays on the contour where an axis turns round, and how to turn round off the work [seed 000, fig. 4].

use serde_json::json;

use super::findings::stacked;
use super::job::Contouring;
use super::machine::Lap;
use super::model::AXES;
use super::path::Path;
use crate::process::Finding;

/// Time constants after which nothing of a lag or of a spike is left to speak of.
const LAG_FADES: f64 = 10.0;
const SPIKE_FADES: f64 = 5.0;

/// Where the axes turn round on a circle, and what step and spike they leave there.
pub fn reversals(contouring: &Contouring) -> Finding {
    let (setup, machine) = (contouring.setup(), &contouring.machine);
    let (mut lines, mut list) = (Vec::new(), Vec::new());
    for direction in &setup.directions {
        let lap = Lap::new(machine, *direction, setup.feed);
        for (axis, name) in AXES.iter().enumerate() {
            let (gap, height) = (machine.gaps[axis], machine.spikes[axis].height);
            let mut angles = Vec::new();
            for time in lap.axes[axis].reversals() {
                let rest = lap.axes[axis].rest();
                let point = setup.path.at(lap.angle(time));
                let behind = setup.path.at(lap.angle(time + rest));
                let step = if gap > 0.0 { 1e6 * (lap.offset(&behind) - lap.offset(&point)) } else { 0.0 };
                let flat = (lap.angle(rest)).to_degrees();
                let flat = flat.min(360.0 - flat);
                let spike = 1e6 * height * point.outward[axis].abs();
                let angle = lap.angle(time).to_degrees();
                angles.push(format!("{angle:.2}"));
                list.push(json!({ "axis": name, "direction": direction.word(), "angle": angle, "step": step, "flat": flat, "spike": spike }));
                let mut left = Vec::new();
                if gap > 0.0 {
                    left.push(format!("a step of {step:+.3} um over a flat of {flat:.2} deg"));
                }
                if height > 0.0 {
                    left.push(format!("a spike of {spike:+.3} um"));
                }
                if !left.is_empty() {
                    lines.push(format!("{name} at {angle:>6.2} deg: {}, {}", left.join(", "), direction.word()));
                }
            }
            if gap == 0.0 && height == 0.0 {
                lines.push(format!("{name} at {} deg: nothing stays, {}", angles.join(" and "), direction.word()));
            }
        }
    }
    Finding {
        key: "reversals",
        label: "reversals",
        text: stacked(&lines),
        json: json!({ "unit": "um", "angle_unit": "deg", "list": list }),
    }
}

/// Where to turn round instead of on the work, if anything would stay there.
pub fn advice(contouring: &Contouring) -> Option<Finding> {
    let (setup, machine) = (contouring.setup(), &contouring.machine);
    let marks = |axis: &usize| machine.gaps[*axis] > 0.0 || machine.spikes[*axis].height > 0.0;
    let axes: Vec<usize> = (0..2).filter(marks).collect();
    let names = axes.iter().map(|axis| AXES[*axis]).collect::<Vec<_>>().join(" and ");
    let fading = machine.spikes.iter().filter(|s| s.height > 0.0).map(|s| SPIKE_FADES * s.time_constant);
    let run_in = setup.feed * (LAG_FADES / setup.gain + fading.fold(0.0, f64::max));
    let gap = 1e6 * machine.gaps.iter().copied().fold(0.0, f64::max);
    let text = match setup.path {
        _ if axes.is_empty() => return None,
        Path::Circle { .. } => {
            let at = if axes.len() > 1 {
                "0, 90, 180 and 270 deg"
            } else if axes[0] == 0 {
                "0 and 180 deg"
            } else {
                "90 and 270 deg"
            };
            let mut way_in = format!("{:.3} mm", 1e3 * run_in);
            if gap > 0.0 {
                way_in.push_str(&format!(", of which {gap:.1} um take up the play"));
            }
            stacked(&[
                format!("leave the circle along its tangent at {at} and turn {names} round off the work;"),
                format!("come back from outside on an arc, {names} already heading inwards for {way_in}"),
            ])
        }
        Path::Rectangle { .. } => format!(
            "overrun each corner along its side, turn {names} round off the work, and run into the next side over at least {:.3} mm",
            1e3 * run_in
        ),
    };
    Some(Finding {
        key: "reversing",
        label: "to reverse off the work",
        text,
        json: json!({ "axes": axes.iter().map(|a| AXES[*a]).collect::<Vec<_>>(), "run_in": 1e3 * run_in, "run_in_unit": "mm", "gap": gap, "gap_unit": "um" }),
    })
}
