//! Figures of runs and comparisons, and what a terminal shows of them.

use super::fem::{Place, model};

/// The figures of a run alone.
fn drawn(name: &str) -> (Place, Vec<String>) {
    let place = Place::new();
    place.write("model.toml", model(&format!("{name}.toml")));
    let answer = place.fem(&["run", "model.toml", "--plot", "figures"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let files = place.files().into_iter().filter(|f| f.starts_with("figures/") && f.ends_with(".svg")).collect();
    (place, files)
}

#[test]
fn every_process_has_the_figures_of_its_field() {
    let expected = [
        ("slender-shaft", &["machine.svg", "parts.svg", "profile.svg"][..]),
        ("lathe", &["machine.svg", "map.svg", "parts.svg", "profile.svg"]),
        ("ring", &["bore.svg", "machine.svg", "parts.svg", "polar.svg", "profile.svg"]),
        ("thermal", &["map-temperature.svg", "profile-elongation.svg", "profile-temperature.svg"]),
        ("fixture", &["machine.svg", "parts.svg", "profile.svg"]),
        ("stiffness", &["loop.svg"]),
        ("axis", &["machine.svg", "parts.svg", "positioning.svg"]),
        ("rotary", &["machine.svg", "parts.svg", "positioning.svg"]),
        ("contour", &["contour.svg", "parts.svg", "polar.svg", "profile.svg"]),
    ];
    for (name, figures) in expected {
        let (place, files) = drawn(name);
        let named: Vec<String> = figures.iter().map(|f| format!("figures/{f}")).collect();
        assert_eq!(files, named, "{name}");
        for file in &files {
            let text = place.read(file);
            assert!(text.starts_with("<svg") && text.trim_end().ends_with("</svg>"), "{name}: {file}");
            assert!(!text.contains("NaN") && !text.contains("inf ") && text.contains("<title>"), "{name}: {file}");
            // Axes name their units, and drawings their magnification.
            assert!(
                text.contains("[um]")
                    || text.contains("[arcsec]")
                    || text.contains("[degC]")
                    || text.contains("magnified")
                    || text.contains("to scale"),
                "{name}: {file}"
            );
        }
    }
}

#[test]
fn a_loop_is_drawn_with_the_force_upwards() {
    let (place, _) = drawn("stiffness");
    let text = place.read("figures/loop.svg");
    let at = |word: &str| text.find(word).unwrap_or_else(|| panic!("no {word}"));
    // The name of the abscissa is written before that of the ordinate.
    assert!(at("displacement [um]") < at("force [N]"));
    assert!(at(">load<") > 0 && at(">unload<") > 0);
}

#[test]
fn a_comparison_draws_measured_rows_and_residuals() {
    let place = Place::new();
    place.write("rigid.toml", model("story/rigid.toml"));
    place.write("measured.csv", model("story/measured.csv"));
    let answer = place.fem(&["compare", "rigid.toml", "--with", "measured.csv", "--plot", "figures"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let files: Vec<String> =
        place.files().into_iter().filter(|f| f.starts_with("figures/") && f.ends_with(".svg")).collect();
    let expected = [
        "agreement",
        "measured",
        // A part was turned under one force: over the two there is no plane.
        "residual-map-x-part",
        "residual-map-x-radial-force",
        "residual-part",
        "residual-radial-force",
        "residual-x",
    ];
    assert_eq!(files, expected.map(|f| format!("figures/{f}.svg")));
    // With -o they stand beside the residuals.
    assert_eq!(place.fem(&["compare", "rigid.toml", "--with", "measured.csv", "-o", "all"]).status, 0);
    assert_eq!(place.read("all/residual-x.svg"), place.read("figures/residual-x.svg"));
    assert!(place.read("all/residuals.csv").contains("residual [um]"));
}

#[test]
fn a_locale_without_unicode_gets_ascii() {
    let place = Place::new();
    place.write("model.toml", model("stiffness.toml"));
    let mut command = place.command(&["run", "model.toml"]);
    let out = command.env("LC_ALL", "C").output().unwrap().stdout;
    assert!(out.is_ascii(), "{}", String::from_utf8_lossy(&out));
    let mut wrong = place.command(&["run", "model.toml", "--json"]);
    place.write("model.toml", "process = \"stiffnes\"\n");
    let err = wrong.env("LC_ALL", "C").output().unwrap().stderr;
    assert!(err.is_ascii(), "{}", String::from_utf8_lossy(&err));
}
