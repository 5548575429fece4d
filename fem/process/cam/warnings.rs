//! Where a prediction of a cam should not be taken at its word.

use super::job::Cam;
use super::report::Report;

/// What should not be overlooked.
pub fn warnings(cam: &Cam, report: &Report) -> Vec<String> {
    let (setup, profile) = (cam.setup(), &cam.setup().profile);
    let mut warnings = Vec::new();
    let tightest = profile.tightest_hollow();
    if tightest < setup.wheel_radius {
        warnings.push(format!(
            "the tightest hollow of the profile has a radius of {:.3} mm, and the wheel one of {:.3} mm: the wheel undercuts its neighbourhood, and no programme avoids it; take a wheel below {:.3} mm",
            1e3 * tightest,
            1e3 * setup.wheel_radius,
            1e3 * tightest
        ));
    }
    if let Some((depth, cut, ground)) = report.collision {
        let degrees = |s: f64| profile.angle(s).to_degrees();
        warnings.push(format!(
            "where the wheel grinds the cam at {:.1} deg it cuts {:.1} um into it at {:.1} deg",
            degrees(ground),
            -1e6 * depth,
            degrees(cut)
        ));
    }
    if let Some(stock) = setup.stock {
        let waves = report.blocks.iter().map(|b| b.thickest.0 - b.thinnest.0).fold(0.0, f64::max);
        if waves > stock {
            warnings.push(format!(
                "within a block the cam waves by {:.1} um, more than the layer of {:.1} um that is taken off: shorten the blocks",
                1e6 * waves,
                1e6 * stock
            ));
        }
    }
    warnings
}
