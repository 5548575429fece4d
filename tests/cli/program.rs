//! `fem correct --program`: the user's own program of a lathe or a mill.

use serde_json::Value as Json;

use super::fem::{Place, model};

/// A fenced block of the page, by the line that begins it; of several the first behind `after`.
fn shown(fence: &str, after: &str) -> String {
    let page = include_str!("../../docs/correction.md");
    let rest = &page[page.find(after).unwrap()..];
    let from = rest.find(&format!("```{fence}\n")).unwrap() + fence.len() + 4;
    rest[from..].split("```").next().unwrap().to_string()
}

fn place() -> Place {
    let place = Place::new();
    place.write("shaft.toml", model("correction/shaft.toml"));
    place.write("part.ngc", shown("ngc part.ngc", "## A lathe program"));
    place
}

#[test]
fn the_program_of_the_page_is_written_as_the_page_says() {
    let place = place();
    let answer = place.fem(&["correct", "shaft.toml", "--program", "part.ngc", "--add-blocks", "-o", "out", "--json"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert_eq!(place.read("out/part.ngc"), shown("text", "--add-blocks -o blocks"));
    let found: Json = serde_json::from_str(&answer.out).unwrap();
    let program = &found["program"];
    assert_eq!(
        (&program["file"], program["words_changed"].as_u64(), program["added"].as_u64()),
        (&"part.ngc".into(), Some(3), Some(6))
    );
    assert!(program["left"]["worst"].as_f64().unwrap() < 1.3e-6 && program["could_add_blocks"] == false);
    // Places of the contour are those of the correction; offsets beside it add up to nothing.
    let (contour, all) = (found["common_contour"].as_array().unwrap(), found["correction"].as_array().unwrap());
    assert_eq!(8 * contour.len(), all.len());
    let mean = |x: &Json| {
        let own = all.iter().filter(|own| own["x"] == *x).map(|own| own["radius_change"].as_f64().unwrap());
        own.sum::<f64>() / 8.0
    };
    assert!(contour.iter().all(|own| (own["radius_change"].as_f64().unwrap() - mean(&own["x"])).abs() < 1e-12));
    let offsets = found["common_offsets"].as_array().unwrap();
    let sum: f64 = offsets.iter().map(|own| own["radius_change"].as_f64().unwrap()).sum();
    assert!(offsets.len() == 8 && sum.abs() < 1e-12, "{sum}");
    let rms = |key: &str| found["rms"][key].as_f64().unwrap();
    assert!(rms("left") < rms("with_contour_and_offsets") && rms("with_contour_and_offsets") < rms("with_offsets"));
}

/// The contour that is written by itself is read as a program that has nothing left to correct beyond its own shape.
#[test]
fn the_contour_is_a_program() {
    let place = place();
    assert_eq!(place.fem(&["correct", "shaft.toml", "-o", "out"]).status, 0);
    let contour = place.read("out/contour.ngc");
    assert!(
        contour.starts_with("(SHAFT.TOML: CORRECTED FINISHING CONTOUR)\n(X AS A DIAMETER, MM, ABSOLUTE, Z0 AT 500 MM"),
        "{contour}"
    );
    assert!(contour.is_ascii() && contour.contains("\nG1 X39.9") && contour.contains("F0.150\n"), "{contour}");
    // The tool stands before it somewhere beyond the end of the shaft.
    place.write("own.ngc", contour.replace("G1 X", "G0 X39.9 Z1\nG1 X"));
    let again = place.fem(&["correct", "shaft.toml", "--program", "own.ngc"]);
    assert!(again.status == 0 && again.out.contains("smaller than that of the model"), "{}{}", again.out, again.err);
    // Another zero and radii, as the model says.
    let other = format!(
        "{}\n[program]\nzero = \"0 mm\"\nx = \"radius\"\nincrement = \"0.0001 mm\"\n",
        model("correction/shaft.toml")
    );
    place.write("other.toml", other);
    assert_eq!(place.fem(&["correct", "other.toml", "-o", "radius"]).status, 0);
    let radius = place.read("radius/contour.ngc");
    assert!(radius.contains("(X AS A RADIUS, MM, ABSOLUTE, Z0 AT 0 MM") && radius.contains("\nG1 X19.9"), "{radius}");
}

#[test]
fn what_cannot_be_done_with_a_program_is_said_and_nothing_is_written() {
    let place = place();
    place.write("ring.toml", model("ring.toml"));
    place.write("contour.ngc", "G1 X1\n");
    place.write("cycle.ngc", "G21\r\nN7 G71 P10 Q20 U0.4 F0.3\r\n");
    place.write("rough.ngc", "G0 X41. Z2.\nG1 Z-500. F.3\n");
    place.write("wrong.toml", format!("{}\n[program]\nx = \"both\"\n", model("correction/shaft.toml")));
    for (model, program, message, help) in [
        ("ring.toml", "part.ngc", "ring.toml models", "programs are corrected for turned shafts and milled tops"),
        ("shaft.toml", "contour.ngc", "has a file of this name itself", "another name"),
        ("shaft.toml", "none.ngc", "none.ngc: the file cannot be read", "check the path"),
        ("shaft.toml", "cycle.ngc", "cycle.ngc:2:4: `G71` is a cycle", "plain G1, G2 and G3"),
        (
            "shaft.toml",
            "rough.ngc",
            "rough.ngc:2:1: no block finishes the part; nearest, this one cuts at 41.000 mm",
            "[program]",
        ),
        ("wrong.toml", "part.ngc", "both", "radius"),
    ] {
        let answer = place.fem(&["correct", model, "--program", program, "-o", "out"]);
        let told = answer.err.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(answer.status == 2 && told.contains(message) && told.contains(help), "{model} {program}: {told}");
        assert!(!place.path("out").exists(), "{program}");
    }
    // The program itself is never replaced.
    let onto = place.fem(&["correct", "shaft.toml", "--program", "part.ngc", "-o", ".", "--force"]);
    assert!(onto.status == 2 && onto.err.contains("part.ngc is itself what is read"), "{}", onto.err);
    assert_eq!(place.read("part.ngc"), shown("ngc part.ngc", "## A lathe program"));
    let alone = place.fem(&["correct", "shaft.toml", "--add-blocks"]);
    assert!(alone.status == 2 && alone.err.contains("--program"), "{}", alone.err);
}

fn mill() -> Place {
    let place = Place::new();
    place.write("slide.toml", model("fixture.toml"));
    place.write("top.ngc", shown("ngc top.ngc", "## A milling program"));
    place
}

#[test]
fn the_milling_program_of_the_page_is_written_as_the_page_says() {
    let place = mill();
    let answer = place.fem(&["correct", "slide.toml", "--program", "top.ngc", "--add-blocks", "-o", "out", "--json"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert_eq!(place.read("out/top.ngc"), shown("text", "--add-blocks -o higher"));
    // Where tracks are is for the program to say: no contour stands alone.
    assert!(!place.path("out/contour.ngc").exists());
    let found: Json = serde_json::from_str(&answer.out).unwrap();
    let program = &found["program"];
    assert_eq!((&program["file"], program["words_changed"].as_u64()), (&"top.ngc".into(), Some(1)));
    let left = &program["left"];
    assert!(left["worst"].as_f64().unwrap() < 1.6e-6 && left["y"].is_f64(), "{left}");
    assert!(program["change"].as_array().unwrap().iter().all(|own| own.as_f64().unwrap() < 0.0), "{program}");
    assert!(program["deeper"]["reach"].as_f64() == Some(0.04) && program["could_add_blocks"] == false, "{program}");
    // What the model makes of it: as near as straight blocks and the increment are.
    let rms = |value: &Json| value.as_f64().unwrap();
    assert!(rms(&program["rms"]) < 0.6e-6 && rms(&found["rms"]["before"]) > 20e-6, "{program}");
}

#[test]
fn a_tilted_spindle_is_met_in_the_mean_and_what_is_left_is_told() {
    let place = mill();
    let tilted = model("fixture.toml").replace("[cutter]\n", "[cutter]\ndiameter = \"100 mm\"\n").replace(
        "[effects.locator-wear]",
        "[effects.cutter-tilt]\nalong = \"200 um/m\"\nacross = \"0 um/m\"\n\n[effects.locator-wear]",
    );
    place.write("tilted.toml", tilted);
    place.write("once.ngc", "G0 X-60 Y40 Z2\nG1 Z0 F800\nX660\nG0 Z50\nM2\n");
    let answer = place.fem(&["correct", "tilted.toml", "--program", "once.ngc", "--add-blocks", "-o", "out", "--json"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let found: Json = serde_json::from_str(&answer.out).unwrap();
    let program = &found["program"];
    // The edges are R - sqrt(R² - y²) = 20 mm of the circle higher by 200 um/m: 4 um, and the parabola's mean is a third of it.
    let left = 1e6 * program["left"]["worst"].as_f64().unwrap();
    assert!((left - 4.0 * 2.0 / 3.0).abs() < 1.6, "{program}");
    let said = place.fem(&["correct", "tilted.toml", "--program", "once.ngc", "--add-blocks"]).out;
    assert!(said.contains("what is left is across the tracks"), "{said}");
}

#[test]
fn what_cannot_be_done_with_a_milling_program_is_said_and_nothing_is_written() {
    let place = mill();
    let good = place.read("top.ngc");
    place.write("cycle.ngc", good.replace("N90 X-30.", "N90 G81 X-30. Z-5. R2."));
    place.write("aside.ngc", good.replace("N70 X630.", "N70 G41 D1 X630."));
    place.write("high.ngc", good.replace("Z0. F800", "Z0.5 F800"));
    place.write("zero.toml", format!("{}\n[program]\nzero = [\"0 mm\", \"0 mm\"]\n", model("fixture.toml")));
    for (model, program, message, help) in [
        ("slide.toml", "cycle.ngc", "cycle.ngc:11:5: `G81` is a cycle", "plain G1, G2 and G3"),
        ("slide.toml", "aside.ngc", "aside.ngc:9:1: this cut finishes the top beside its path", "with G40"),
        ("slide.toml", "high.ngc", "nearest, this one cuts at 0.500 mm of height", "where X, Y and Z are 0"),
        ("zero.toml", "top.ngc", "2 places do not tell X, Y and Z", "write zero ="),
    ] {
        let answer = place.fem(&["correct", model, "--program", program, "-o", "out"]);
        let told = answer.err.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(answer.status == 2 && told.contains(message) && told.contains(help), "{model} {program}: {told}");
        assert!(!place.path("out").exists(), "{program}");
    }
}
