//! Models on which every effect of a process can act, one or the other: what effects need of a set-up is there.

use fem::input::Source;
use fem::model::Model;
use fem::process::Process;

/// What stands under a shaft.
const REST: &str = "steady_rests = [{ at = \"150 mm\", stiffness = \"40 N/um\" }]";

/// The shaft, and one with a shoulder that the pass climbs.
const SEGMENT: &str = "{ length = \"500 mm\", diameter = \"40 mm\" }";
const STEPPED: &str = "{ length = \"200 mm\", diameter = \"50 mm\" }, { length = \"300 mm\", diameter = \"40 mm\" }";

/// The model that `fem new` writes, and variants of it with what further effects need.
pub fn models(process: &dyn Process) -> Result<Vec<Model>, fem::input::InputError> {
    let start = process.starting_model();
    let further = match process.name() {
        "turning" => vec![
            start.replace("\"centres\"", "\"chuck-and-centre\""),
            start.replace("type = \"centres\"", "type = \"centres\"\nguideway_spacing = \"300 mm\""),
            start.replace("type = \"centres\"", &format!("type = \"centres\"\n{REST}")),
            start.replace(SEGMENT, STEPPED),
            format!("{start}\n[edge]\nclearance_angle = \"8 deg\"\nwear_land = \"0.1 mm\"\n"),
        ],
        "ring" => {
            vec![start.replace("\"least-squares-circle\"", "\"absolute\""), start.replace("jaws = 3 ", "jaws = 4 ")]
        }
        "contour" => vec![equipped(start)],
        "fixture" => vec![
            start.replace("# depth = \"1 mm\"", "depth = \"20 um\""),
            start.replace("# diameter = \"80 mm\"", "diameter = \"80 mm\""),
            BENT.replace("\nfriction = \"0.15\"", ""),
        ],
        "rotary" => vec![tilting(start), JOINT.to_string()],
        _ => Vec::new(),
    };
    let texts = std::iter::once(start.to_string()).chain(further);
    texts.map(|text| Model::parse(Source::new("model.toml", text))).collect()
}

/// A part bent between its supports, as a plane body: of the friction on its pads nothing is in the model yet.
const BENT: &str = include_str!("../../models/bracket.toml");

/// A joint of a robot behind gears, on which a torque acts: rigid but for what effects make of it.
const JOINT: &str = "process = \"rotary\"\naxis = { range = \"180 deg\" }\n\
    drive = { type = \"gears\", stages = [{ driving = 18, driven = 72 }, { driving = 20, driven = 100 }] }\n\
    test = { spacing = \"staggered\", torque = \"40 N*m\" }\n";

/// A rotary axis that lies, with a scale.
fn tilting(start: &str) -> String {
    start.replace("\"vertical\"", "\"horizontal\"") + "\n[scale]\nradius = \"60 mm\"\nlines = 9000\n"
}

/// A contour with what some effects need: screws, a frequency, and the force of a cut.
fn equipped(start: &str) -> String {
    let screw = "{ screw = { material = \"steel\", diameter = \"32 mm\", fixed_at = \"-400 mm\" } }";
    let drives = format!("[drives]\nfrequency = \"3 Hz\"\nx = {screw}\ny = {screw}");
    start.replace("[drives]", &drives) + "\n[cut]\nnormal_force = \"200 N\"\ntangential_force = \"120 N\"\n"
}
