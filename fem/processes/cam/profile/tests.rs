//! Places of a profile found by angle, by nearness and by length.

use std::f64::consts::PI;

use super::curve::Curve;
use super::*;

/// Two noses of 20 mm about (±30, 0) mm, joined by hollows of 50 mm; counter-clockwise, or mirrored and
/// clockwise.
fn hollow(sense: f64) -> Profile {
    let (r, c, h) = (20e-3, 30e-3, (70e-3f64 * 70e-3 - 30e-3 * 30e-3).sqrt());
    let half = (h / c).atan();
    let (over, about) = (PI - 2.0 * half, 2.0 * (PI - half));
    let arcs = [
        (Vector::new(0.0, h), 50e-3, -half, -over),
        (Vector::new(-c, 0.0), r, half, about),
        (Vector::new(0.0, -h), 50e-3, PI - half, -over),
        (Vector::new(c, 0.0), r, half - PI, about),
    ];
    let mut curves = Vec::new();
    for (i, (centre, radius, from, sweep)) in arcs.into_iter().enumerate() {
        let centre = Vector::new(centre.x, centre.y * sense);
        curves.extend(Curve::arcs(centre, radius, from * sense, sweep * sense).into_iter().map(|c| (i, c)));
    }
    Profile::new(curves, sense)
}

#[test]
fn the_curve_closes_and_its_normals_turn_with_it() {
    for sense in [1.0, -1.0] {
        let profile = hollow(sense);
        let length = profile.length();
        assert!((profile.at(0.0).point - profile.at((1.0 - 1e-15) * length).point).norm() < 1e-15);
        for i in 0..200 {
            let s = length * (f64::from(i) + 0.3) / 200.0;
            let (a, b, middle) = (profile.at(s - 1e-7), profile.at(s + 1e-7), profile.at(s));
            let along = (b.point - a.point) / 2e-7;
            assert!((along.norm() - 1.0).abs() < 1e-6 && along.dot(&middle.normal).abs() < 1e-5);
            assert!(middle.point.dot(&middle.normal) > 0.0);
            let turned = ((b.normal - a.normal) / 2e-7).dot(&along);
            let at_joint = profile.segment(s - 1e-7) != profile.segment(s + 1e-7);
            assert!(at_joint || (turned - middle.curvature).abs() < 1e-4, "{turned} {}", middle.curvature);
        }
        assert!((profile.tightest_hollow() - 50e-3).abs() < 1e-15);
    }
}

#[test]
fn every_direction_finds_its_point() {
    for sense in [1.0, -1.0] {
        let profile = hollow(sense);
        for i in 0..360 {
            let angle = f64::from(i).to_radians();
            let found = profile.at(profile.at_angle(angle)).point;
            assert!(direction(angle).perp(&found).abs() < 1e-15 && found.dot(&direction(angle)) > 0.0, "{i}");
        }
    }
}

#[test]
fn the_nearest_point_is_found_from_either_side() {
    let profile = hollow(1.0);
    for i in 0..60 {
        let s = profile.length() * f64::from(i) / 60.0;
        let place = profile.at(s);
        for guess in [s - 4e-3, s, s + 4e-3] {
            let (found, distance) = profile.nearest(&(place.point + place.normal * 0.03), guess);
            assert!((found - s).abs() < 1e-12 && (distance - 0.03).abs() < 1e-15, "{s} {found}");
        }
    }
}
