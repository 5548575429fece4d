//! Odds that a model gives itself.

use super::fem::{Place, model};

/// The story's rigid model with a table of odds.
fn rigid(odds: &str) -> Place {
    let place = Place::new();
    place.write("measured.csv", model("story/measured.csv"));
    place.write("rigid.toml", format!("{}\n[odds]\n{odds}\n", model("story/rigid.toml")));
    place
}

/// Probability that a diagnosis gives an effect.
fn probability(place: &Place, effect: &str) -> f64 {
    let answer = place.fem(&["diagnose", "rigid.toml", "--with", "measured.csv", "--json"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let json: serde_json::Value = serde_json::from_str(&answer.out).unwrap();
    let all = json["candidates"].as_array().unwrap();
    all.iter().find(|c| c["effect"] == effect).unwrap()["probability"].as_f64().unwrap()
}

#[test]
fn odds_decide_where_the_data_do_not() {
    // A spring and a contact of the headstock fit alike.
    let plain = probability(&rigid(""), "headstock-contact");
    let told = probability(&rigid("headstock-contact = 1000"), "headstock-contact");
    assert!(plain < 0.5 && told > 0.9, "{plain} by the catalogue, {told} by the model");
}

#[test]
fn odds_do_not_hide_what_is_plainly_there() {
    let told = probability(&rigid("tool-wear = 0.001"), "tool-wear");
    assert!(told > 0.9, "{told}");
}

#[test]
fn a_diagnosis_tells_that_odds_are_of_the_model() {
    let place = rigid("headstock-compliance = 20\nvalues = 0.01");
    let answer = place.fem(&["diagnose", "rigid.toml", "--with", "measured.csv"]);
    let words = answer.out.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("20 to one for headstock-compliance, 0.01 to one for values"), "{}", answer.out);
}

#[test]
fn wrong_odds_are_refused_with_their_place() {
    let cases = [
        ("headstock-complience = 2", "headstock-complience", "did you mean `headstock-compliance`?"),
        ("headstock-compliance = 0", "`headstock-compliance` is 0", "it must be above"),
        ("headstock-compliance = 1e9", "`headstock-compliance` is 1000000000", "at most 1000000"),
        ("headstock-compliance = \"often\"", "`often` does not begin with a number", "write a number"),
        ("headstock-compliance = \"2 +- 1\"", "is chosen", "write headstock-compliance"),
    ];
    for (odds, message, help) in cases {
        let answer = rigid(odds).fem(&["run", "rigid.toml"]);
        assert_eq!(answer.status, 2, "{odds}");
        assert!(answer.err.contains(message) && answer.err.contains(help), "{odds}: {}", answer.err);
        assert!(answer.err.contains("rigid.toml:"), "{odds}: {}", answer.err);
    }
}
