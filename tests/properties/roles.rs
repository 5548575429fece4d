//! What tests of several processes share is one law in all of them.

use fem::input::Source;
use fem::model::Model;
use fem::process::{Active, Belongs, Description, Rows, UnitRole};
use fem::processes::ALL;

/// Every effect with a role, and the role.
fn with_roles() -> Vec<(UnitRole, Description)> {
    let role = |effect: Description| match effect.belongs {
        Belongs::Unit(_, role) | Belongs::Tested(role) => Some((role, effect)),
        Belongs::Test | Belongs::Machine => None,
    };
    ALL.iter().flat_map(|process| process.effects()).filter_map(role).collect()
}

#[test]
fn effects_of_a_role_have_the_same_parameters() {
    let all = with_roles();
    assert!(all.len() > 8);
    for (role, effect) in &all {
        for (_, other) in all.iter().filter(|(same, _)| same == role) {
            let of = |d: &Description| {
                d.parameters.iter().map(|p| (p.name.clone(), p.kind, p.neutral, p.bounds)).collect::<Vec<_>>()
            };
            assert_eq!(of(effect), of(other), "{} and {}", effect.name, other.name);
        }
    }
}

/// A quantity of the tables that has a role is the only parameter of the effects of that role.
#[test]
fn quantities_with_a_role_are_what_its_effects_are() {
    for process in ALL {
        let model = Model::parse(Source::new("model.toml", process.starting_model())).unwrap();
        for (path, role) in process.of_unit() {
            let quantity = model.quantities.iter().find(|q| q.path == *path).unwrap();
            for (_, effect) in with_roles().iter().filter(|(own, _)| own == role) {
                let [entry] = &effect.parameters[..] else { panic!("{} has several parameters", effect.name) };
                assert_eq!((entry.kind, entry.bounds), (quantity.kind, quantity.bounds), "{path} and {}", effect.name);
            }
        }
    }
}

/// The force of the cut at the tailstock is all borne there: the diameter is off by twice what a joint gives way
/// that is pushed as hard.
#[test]
fn a_tailstock_gives_way_alike_to_the_cut_and_to_a_test() {
    const FORCE: f64 = 300.0;
    let text = ALL[0].starting_model();
    let lathe = Model::parse(Source::new("lathe.toml", text)).unwrap();
    let joint = |stiffness: &str| {
        let tables = format!(
            "process = \"stiffness\"\n[joint]\nstiffness = \"{stiffness} N/um\"\n[test]\nmax_force = \"900 N\"\n"
        );
        Model::parse(Source::new("joint.toml", tables)).unwrap()
    };
    let process = &*lathe.process;
    let at = |name: &str| process.coordinates().iter().position(|c| c.name == name).unwrap();
    let end = lathe.system.programme().columns[at("x")].iter().copied().fold(0.0, f64::max);
    let mut columns = vec![vec![f64::NAN]; process.coordinates().len()];
    columns[at("x")] = vec![end];
    columns[at("radial_force")] = vec![FORCE];
    columns[at("part")] = vec![1.0];
    let row = Rows::new(columns, vec![0]);
    let turned = |effects: &[Active]| lathe.system.with_effects(effects).observe(&row).unwrap()[0];
    let pushed = Rows::new([vec![FORCE], vec![0.0]], vec![0]);
    let loaded = |model: &Model, effects: &[Active]| model.system.with_effects(effects).observe(&pushed).unwrap()[0];
    let effect = |model: &Model, name: &str, values: Vec<f64>| {
        model.process.effects().into_iter().find(|e| e.name == name).unwrap().with(values)
    };
    let spring = turned(&[effect(&lathe, "tailstock-compliance", vec![40e6])]) - turned(&[]);
    assert!((spring - 2.0 * loaded(&joint("40"), &[])).abs() < 1e-12, "{spring}");
    let stiff = joint("40");
    let law = vec![0.3e-6, 0.55];
    let contact = turned(&[effect(&lathe, "tailstock-contact", law.clone())]) - turned(&[]);
    let pushed = loaded(&stiff, &[effect(&stiff, "contact-joint", law)]) - loaded(&stiff, &[]);
    assert!((contact - 2.0 * pushed).abs() < 1e-12 && contact > 1e-6, "{contact} {pushed}");
}
