//! Good files from which cases are made, and the commands that read them.

use std::path::{Path, PathBuf};

use super::mutate;
use super::rng::Rng;
use super::run::Case;

/// A good model with measurements that belong to it.
struct Pair {
    model: String,
    measured: String,
}

pub struct Corpus {
    pairs: Vec<Pair>,
    budgets: Vec<String>,
    /// Plans of studies, each with its model and a table of measurements.
    studies: Vec<[String; 3]>,
    rings: Vec<String>,
    meshes: Vec<String>,
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_path_buf()
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap()
}

/// Rows of a table of which a few are enough.
fn thinned(text: &str) -> String {
    const MOST: usize = 120;
    let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with('#')).collect();
    let step = lines.len().div_ceil(MOST);
    let kept = lines[1..].iter().step_by(step.max(1));
    std::iter::once(&lines[0]).chain(kept).map(|line| format!("{line}\n")).collect()
}

impl Corpus {
    pub fn load() -> Self {
        let folders = ["tests/data/hidden", "tests/data/real"].map(|folder| root().join(folder));
        let mut places: Vec<PathBuf> =
            folders.iter().flat_map(|f| std::fs::read_dir(f).unwrap()).map(|entry| entry.unwrap().path()).collect();
        places.retain(|place| place.join("model.toml").exists());
        places.sort();
        let mut pairs: Vec<Pair> = places
            .iter()
            .map(|place| Pair {
                model: read(&place.join("model.toml")),
                measured: thinned(&read(&place.join("measured.csv"))),
            })
            .collect();
        let story = thinned(&read(&root().join("models/story/measured.csv")));
        for (name, measured) in [
            ("story/rigid.toml", story),
            (
                "rectangle.toml",
                "angle [deg],direction,deviation [um]\n20,ccw,3\n130,cw,4\n250,ccw,1\n340,cw,-2\n10,cw,2\n".into(),
            ),
            ("cam.toml", "angle [deg],deviation [um]\n0,1\n40,2\n90,0\n140,3\n200,1\n260,-1\n310,2\n350,1\n".into()),
            ("ground-plate.toml", "time [min],elongation [um]\n0.5,1\n1,2\n1.5,3\n2,4\n2.5,5\n3,5\n4,5\n".into()),
            (
                "lathe.toml",
                "part,x [mm],diameter_error [um]\n1,100,90\n1,300,105\n2,100,95\n2,300,110\n3,100,99\n3,300,130\n"
                    .into(),
            ),
            (
                "seat.toml",
                "part,x [mm],diameter_error [um]\n1,5,90\n1,10,105\n2,5,95\n2,10,110\n3,5,99\n3,10,130\n".into(),
            ),
            ("passes.toml", "part,x [mm],diameter_error [um]\n1,100,90\n1,300,105\n2,100,95\n2,300,110\n".into()),
            (
                "slender-shaft.toml",
                "part,x [mm],diameter_error [um]\n1,100,90\n1,300,105\n1,400,95\n1,200,110\n".into(),
            ),
        ] {
            pairs.push(Pair { model: read(&root().join("models").join(name)), measured });
        }
        let keyway = read(&root().join("models/keyway.toml")).replace("../meshes/keyway.msh", "mesh.msh");
        let plate = "process = \"thermal\"\nbody = { file = \"mesh.msh\", width = \"20 mm\", material = \"steel\" }\n\
                     boundary = [{ edge = \"bore\", flux = \"5 kW/m^2\" }]\nenvironment.temperature = \"20 degC\"\n\
                     time = { end = \"10 min\", step = \"1 min\" }\n";
        let lathe = pairs.iter().find(|pair| pair.model.contains("Stepped shaft between centres")).unwrap();
        let study = |plan: String| [plan, lathe.model.clone(), lathe.measured.clone()];
        let drawn = read(&root().join("models/study-lathe.toml"))
            .replace("lathe.toml\"", "model.toml\"")
            .replace("samples = 256", "samples = 8");
        let fitted = "model = \"model.toml\"\ntask = \"fit\"\ndata = \"m.csv\"\n\n[design]\ntype = \"grid\"\n\n\
                      [[input]]\nquantity = \"cut.depth\"\nvalues = [\"0.4 mm\", \"0.5 mm\"]\n\n\
                      [[input]]\nquantity = \"cut.feed\"\nfrom = \"0.1 mm/rev\"\nto = \"0.3 mm/rev\"\nsteps = 3\n";
        let studies = vec![study(drawn), study(fitted.into())];
        Self {
            studies,
            pairs,
            budgets: vec![
                read(&root().join("models/budget.toml")),
                "process = \"stiffness\"\n".to_string() + &read(&root().join("models/budget.toml")),
            ],
            rings: vec![keyway, plate.to_string()],
            meshes: ["keyway.msh", "ring-quad8.msh", "ring-tri6.msh"]
                .map(|name| read(&root().join("meshes").join(name)))
                .to_vec(),
        }
    }

    /// Makes the case of a seed. Searches are given no more than `limit`, a quantity of time, if any.
    pub fn case(&self, seed: u64, limit: Option<&str>) -> Case {
        let mut rng = Rng::new(seed);
        // Neighbouring seeds begin far apart.
        for _ in 0..3 {
            rng.next();
        }
        let words = |text: &str| text.split(' ').map(str::to_string).collect::<Vec<String>>();
        if rng.one_in(25) {
            let text = mutate::model(self.budgets[rng.below(self.budgets.len())].as_str(), &mut rng);
            return Case {
                files: vec![("budget.toml".into(), mangled(text, &mut rng))],
                command: words("budget budget.toml"),
            };
        }
        if rng.one_in(12) {
            let mesh = mutate::mesh(&self.meshes[rng.below(self.meshes.len())], &mut rng);
            let model = &self.rings[rng.below(self.rings.len())];
            let model = if rng.one_in(3) { mutate::model(model, &mut rng) } else { model.clone() };
            let files = vec![("model.toml".into(), model.into_bytes()), ("mesh.msh".into(), mangled(mesh, &mut rng))];
            return Case { files, command: words("run model.toml -o out") };
        }
        if rng.one_in(20) {
            let [plan, model, measured] = &self.studies[rng.below(self.studies.len())];
            let plan = mutate::model(plan, &mut rng);
            let model = if rng.one_in(3) { mutate::model(model, &mut rng) } else { model.clone() };
            let mut command = words("study plan.toml -o out");
            if let Some(limit) = limit {
                command.extend(["--time-limit".to_string(), limit.to_string()]);
            }
            let files = [("plan.toml", mangled(plan, &mut rng)), ("model.toml", model.into_bytes())];
            let measured = ("m.csv", measured.clone().into_bytes());
            let files = files.into_iter().chain([measured]).map(|(name, text)| (name.to_string(), text)).collect();
            return Case { files, command };
        }
        let pair = &self.pairs[rng.below(self.pairs.len())];
        let (mut model, mut measured) = (pair.model.clone(), pair.measured.clone());
        let which = rng.below(5);
        if which < 4 {
            model = mutate::model(&model, &mut rng);
        }
        if which > 1 {
            measured = mutate::table(&measured, &mut rng);
        }
        let mut command = words(match rng.below(25) {
            0..=6 => "run model.toml -o out",
            7..=13 => "compare model.toml --with m.csv -o out",
            14..=17 => "fit model.toml --with m.csv --add-to fitted.toml",
            18 | 19 => "compensate model.toml --with m.csv -o out",
            20 => "diagnose model.toml --with m.csv -o out --max-effects 2",
            21 => "plan model.toml",
            22 => "import m.csv --process turning -o taken.csv",
            23 => "set model.toml title=other test.steps=7 -o other.toml",
            _ => "compare model.toml --with m.csv --json",
        });
        if let (Some(limit), "fit" | "diagnose" | "plan") = (limit, command[0].as_str()) {
            command.extend(["--time-limit".to_string(), limit.to_string()]);
        }
        let files =
            vec![("model.toml".into(), mangled(model, &mut rng)), ("m.csv".into(), mangled(measured, &mut rng))];
        Case { files, command }
    }
}

/// Now and then, a file changed by bytes.
fn mangled(text: String, rng: &mut Rng) -> Vec<u8> {
    if rng.one_in(12) { mutate::bytes(text.into_bytes(), rng) } else { text.into_bytes() }
}
