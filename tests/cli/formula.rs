//! Formulas that name quantities of the model.

use serde_json::Value as Json;

use super::fem::{Place, model};

/// The models/axis.toml, without effects, and with a wave over each turn of the screw.
fn axis(lead: &str, wave: &str) -> String {
    let ideal = model("axis.toml");
    let ideal = ideal.split("[effects").next().unwrap_or_default().replace("lead = \"10 mm\"", lead);
    format!("{ideal}\n[effects.lead-wave]\nformula = \"{wave}\"\na = \"3 um\"\n")
}

/// Targets of one run every 3 mm, with a wave of 3 um and 8 mm and a noise of 0.1 um.
fn measured() -> String {
    let mut text = "run,position [mm],direction,deviation [um],u [um]\n".to_string();
    for k in 0..120 {
        let position = 3.0 * f64::from(k);
        let noise = 0.1 * f64::from(k % 5 - 2) / 2.0_f64.sqrt();
        let deviation = 3.0 * (std::f64::consts::TAU * position / 8.0).sin() + noise;
        text += &format!("1,{position},+,{deviation:.5},0.1\n");
    }
    text
}

#[test]
fn a_formula_follows_a_quantity_of_the_model() {
    let place = Place::new();
    place.write("axis.toml", axis("lead = \"? near 8.02 mm\"", "a*sin(2*pi*position/screw.lead)"));
    place.write("measured.csv", measured());
    let fitted: Json =
        serde_json::from_str(&place.fem(&["fit", "axis.toml", "--with", "measured.csv", "--json"]).out).unwrap();
    let lead = &fitted["parameters"][0];
    let [value, std] = ["value", "std"].map(|key| lead[key].as_f64().unwrap_or(f64::NAN));
    assert_eq!(lead["parameter"], "screw.lead", "{fitted}");
    assert!((value - 8.0).abs() < 4.0 * std && std < 0.01, "{fitted}");
}

#[test]
fn what_is_no_quantity_of_the_model_is_refused_at_its_place() {
    let place = Place::new();
    for (wave, said) in [
        ("a*sin(2*pi*position/screw.led)", "did you mean `screw.lead`?"),
        ("a*sin(2*pi*position/test.spacing)", "`test.spacing` is no quantity that stands in the model"),
        ("a*position/effects.lead-wave.a", "`effects.lead` belongs to an effect"),
        ("a*sin(2*pi*position*screw.lead)", "`sin` of a quantity in m^2"),
    ] {
        place.write("axis.toml", axis("lead = \"10 mm\"", wave));
        let refused = place.fem(&["run", "axis.toml"]);
        assert!(refused.status != 0 && refused.err.contains(said), "{wave}: {}", refused.err);
        assert!(refused.err.contains("axis.toml:") && refused.err.contains("formula = "), "{}", refused.err);
    }
}

/// A model whose only effect is a formula of unknowns, fitted to a straight line.
fn fitted_line(formula: &str, unknowns: &str) -> String {
    let place = Place::new();
    let ideal = model("axis.toml");
    let ideal = ideal.split("[effects").next().unwrap_or_default();
    place.write("axis.toml", format!("{ideal}\n[effects.line]\nformula = \"{formula}\"\n{unknowns}"));
    let row = |k: i32| {
        let position = 6.3 * f64::from(k);
        let noise = 0.1 * f64::from(k % 5 - 2) / 2.0_f64.sqrt();
        format!("1,{position},+,{:.5},0.1\n", 0.02 * position + noise)
    };
    let rows: String = (0..60).map(row).collect();
    place.write("measured.csv", format!("run,position [mm],direction,deviation [um],u [um]\n{rows}"));
    place.fem(&["fit", "axis.toml", "--with", "measured.csv"]).out
}

#[test]
fn an_unknown_on_which_nothing_depends_is_told() {
    let told = fitted_line("a*0", "a = \"? um\"\n");
    assert!(told.contains("no row depends on it, whatever its value"), "{told}");
    assert!(!told.contains("stands at its bound") && !told.contains("leave its interval open"), "{told}");
    let told = fitted_line("a*position/screw.lead", "a = \"? um\"\n");
    assert!(!told.contains("no row depends"), "{told}");
}

#[test]
fn unknowns_of_which_rows_hold_one_combination_are_told() {
    let said = |word: &str, other: &str| {
        format!("all rows depend on the {word} of effects.line.a and effects.line.{other} alone: give one of the two")
    };
    for (formula, unknowns, word) in [
        ("a*position/b", "a = \"? um\"\nb = \"? mm\"\n", "quotient"),
        ("a*b*position/screw.lead", "a = \"? um\"\nb = \"?\"\n", "product"),
        ("a + b", "a = \"? um\"\nb = \"? um\"\n", "sum"),
    ] {
        let told = fitted_line(formula, unknowns);
        assert!(told.contains(&said(word, "b")) && !told.contains("the data cannot see it"), "{formula}: {told}");
    }
    let told = fitted_line("a*position/screw.lead + b", "a = \"? um\"\nb = \"? um\"\n");
    assert!(!told.contains("all rows depend"), "{told}");
}
