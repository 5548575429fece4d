//! A cam of a base circle, a nose and the two straight flanks that touch both, told by its normal and by its
//! polar angle. It lies symmetrically about +x; lengths are in mm.

use std::f64::consts::{PI, TAU};

/// The cam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Profile {
    /// Radius of the circle about the cam's axis.
    pub base: f64,
    /// Radius of the nose.
    pub nose: f64,
    /// Distance of the nose's centre from the axis.
    pub lift: f64,
}

/// A point of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// mm.
    pub point: [f64; 2],
    /// Direction of the outward normal, rad.
    pub normal: f64,
    /// 1/mm.
    pub curvature: f64,
}

impl Place {
    /// Where the centre of a wheel of this radius (mm) stands that touches it here, mm.
    pub fn centre(&self, radius: f64) -> [f64; 2] {
        let (sine, cosine) = self.normal.sin_cos();
        [self.point[0] + radius * cosine, self.point[1] + radius * sine]
    }
}

impl Profile {
    /// Angle between the axis of the nose and the normal of a flank, rad.
    pub fn flank(&self) -> f64 {
        ((self.base - self.nose) / self.lift).acos()
    }

    /// Lengths of the base circle, the flank from it, the nose and the flank back, counter-clockwise.
    pub fn lengths(&self) -> [f64; 4] {
        let flank = self.lift * self.flank().sin();
        [self.base * (TAU - 2.0 * self.flank()), flank, self.nose * 2.0 * self.flank(), flank]
    }

    /// The place at a length into one of its four segments.
    pub fn on(&self, segment: usize, length: f64) -> Place {
        let turn = self.flank();
        let around = |centre: f64, radius: f64, normal: f64| {
            let (sine, cosine) = normal.sin_cos();
            Place { point: [centre + radius * cosine, radius * sine], normal, curvature: 1.0 / radius }
        };
        let straight = |from: Place| {
            let (sine, cosine) = from.normal.sin_cos();
            let point = [from.point[0] - length * sine, from.point[1] + length * cosine];
            Place { point, curvature: 0.0, ..from }
        };
        match segment {
            0 => around(0.0, self.base, turn + length / self.base),
            1 => straight(around(0.0, self.base, TAU - turn)),
            2 => around(self.lift, self.nose, TAU - turn + length / self.nose),
            _ => straight(around(self.lift, self.nose, turn)),
        }
    }

    /// The place at a polar angle, deg.
    pub fn at(&self, angle: f64) -> Place {
        let turn = self.flank();
        let polar = angle.to_radians().rem_euclid(TAU);
        // The cam is its own image about +x.
        let (upper, side) = if polar > PI { (TAU - polar, -1.0) } else { (polar, 1.0) };
        let (sine, cosine) = upper.sin_cos();
        let joint = (self.nose * turn.sin()).atan2(self.lift + self.nose * turn.cos());
        let (radius, normal, curvature) = if upper >= turn {
            (self.base, upper, 1.0 / self.base)
        } else if upper >= joint {
            // The flank is the line at `base` from the axis.
            (self.base / (upper - turn).cos(), turn, 0.0)
        } else {
            // The far one of where a ray from the axis meets the nose.
            let across = self.lift * sine;
            let radius = self.lift * cosine + (self.nose * self.nose - across * across).sqrt();
            (radius, (radius * sine).atan2(radius * cosine - self.lift), 1.0 / self.nose)
        };
        Place { point: [radius * cosine, side * radius * sine], normal: side * normal, curvature }
    }
}
