//! `fem open`: the loop over the wire, and who tries to get in.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use serde_json::{Value as Json, json};

use super::fem::{Answer, Place, answer, model, words};
use super::served::Served;

/// A workbench that runs, by its host and its token.
struct Bench {
    host: String,
    token: String,
    _served: Served,
}

impl Bench {
    fn open(place: &Place, what: &str) -> Self {
        let served = Served::of(place, &["open", what]);
        let token = served.path.trim_end_matches('/').to_string();
        Self { host: served.host.clone(), token, _served: served }
    }

    /// Sends a question as it stands; status, head and body of the answer.
    fn raw(&self, question: &[u8]) -> (u16, String, Vec<u8>) {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        // Who is refused early is not read to the end.
        let _ = stream.write_all(question);
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer);
        let end = answer.windows(4).position(|own| own == b"\r\n\r\n").unwrap_or(answer.len());
        let head = String::from_utf8_lossy(&answer[..end]).into_owned();
        let status = head.split(' ').nth(1).and_then(|own| own.parse().ok()).unwrap_or(0);
        (status, head, answer.get(end + 4..).unwrap_or_default().to_vec())
    }

    fn ask(&self, method: &str, path: &str, more: &str, body: &[u8]) -> (u16, String, Vec<u8>) {
        let head = format!(
            "{method} /{}/{path} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\nContent-Length: {}\r\n{more}\r\n",
            self.token,
            self.host,
            body.len()
        );
        self.raw(&[head.as_bytes(), body].concat())
    }

    fn get(&self, path: &str) -> Json {
        let (status, head, body) = self.ask("GET", path, "", b"");
        assert_eq!(status, 200, "{path}: {head}");
        serde_json::from_slice(&body).unwrap()
    }

    fn state(&self) -> Json {
        self.get("state")
    }

    fn post(&self, verb: &str, said: &Json) -> (u16, Json) {
        let (status, _, body) = self.ask("POST", verb, "", said.to_string().as_bytes());
        (status, serde_json::from_slice(&body).unwrap_or(Json::Null))
    }

    fn done(&self, verb: &str, said: &Json) -> Json {
        let (status, answer) = self.post(verb, said);
        assert_eq!(status, 200, "{verb} {said}: {answer}");
        answer
    }

    /// The state as soon as it is as wanted.
    fn until(&self, is_wanted: impl Fn(&Json) -> bool) -> Json {
        let began = Instant::now();
        loop {
            let state = self.state();
            if is_wanted(&state) {
                return state;
            }
            assert!(began.elapsed() < Duration::from_secs(60), "{}", state["trouble"]);
            std::thread::sleep(Duration::from_millis(50));
        }
    }

    fn run(&self, what: &str) -> Json {
        self.done("run", &json!({ "what": what }));
        self.until(|state| state["job"].is_null())
    }
}

fn story() -> Place {
    let place = Place::new();
    std::fs::create_dir(place.path("shop")).unwrap();
    place.write("shop/rigid.toml", model("story/rigid.toml"));
    place.write("shop/measured.csv", model("story/measured.csv"));
    place
}

/// Answer of a command in the folder of the shop.
fn within_shop(place: &Place, args: &[&str]) -> Answer {
    answer(place.command(args).current_dir(place.path("shop")).output().unwrap())
}

#[test]
fn the_error_falls_by_what_the_diagnosis_adds_and_comes_back() {
    let place = story();
    let bench = Bench::open(&place, "shop/rigid.toml");
    let first = bench.state();
    assert_eq!((&first["model"]["file"], &first["data"]), (&json!("rigid.toml"), &Json::Null));
    assert_eq!((&first["models"], &first["measurements"]), (&json!(["rigid.toml"]), &json!(["measured.csv"])));
    bench.done("data", &json!({ "files": ["measured.csv"] }));
    let told = bench.run("diagnose")["diagnosis"]["verdict"].clone();
    assert!(told.as_str().unwrap().contains("the error falls from 43.211 to 0.896 um"), "{told}");
    for effect in ["tool-wear", "headstock-compliance", "guideway-wear"] {
        bench.done("add", &json!({ "effect": effect }));
    }
    let state = bench.state();
    let left: Vec<String> =
        state["steps"].as_array().unwrap().iter().map(|s| format!("{:.2}", s["rms"].as_f64().unwrap())).collect();
    assert_eq!(left, ["43.21", "8.79", "3.96", "0.90"]);
    assert!(state["comparison"]["is_adequate"] == true && state["model"]["is_saved"] == false);
    // What was done by clicks is done by the commands that it tells.
    run_history(&place, &state);
    let last = "rigid-tool-wear-headstock-compliance-guideway-wear.toml";
    let again = within_shop(&place, &["compare", last, "--with", "measured.csv", "--json"]);
    let again: Json = serde_json::from_str(&again.out).unwrap();
    assert!((again["models"][0]["rms"].as_f64().unwrap() - state["comparison"]["rms"].as_f64().unwrap()).abs() < 1e-9);
    // Back and forth.
    bench.done("undo", &Json::Null);
    assert_eq!(bench.state()["steps"].as_array().unwrap().len(), 3);
    bench.done("redo", &Json::Null);
    assert_eq!(bench.state()["steps"], state["steps"]);
    assert_eq!(bench.post("redo", &Json::Null).0, 422);
    // A value on trial is no estimate, and stays nowhere.
    let tried = bench.done("try", &json!({ "values": { "effects.tool-wear.rate": 8 } }));
    assert!(tried["rms"].as_f64().unwrap() > 2.0, "{}", tried["rms"]);
    // With nothing on trial it is what the comparison says.
    let same = bench.done("try", &json!({ "values": {} }));
    assert!((same["rms"].as_f64().unwrap() - state["comparison"]["rms"].as_f64().unwrap()).abs() < 1e-9, "{same}");
    assert_eq!(bench.state()["model"], state["model"]);
    // Corrected, by the very command.
    let state = bench.run("correct");
    assert!(state["correction"]["html"].as_str().unwrap().contains("Offset of the programmed radius"));
    // Saved with its comments, under its own name or another.
    bench.done("save", &json!({ "as": "better.toml" }));
    let better = place.read("shop/better.toml");
    assert!(better.starts_with("# Twelve shafts") && better.contains("[effects.guideway-wear]"), "{better}");
    assert_eq!(place.read("shop/rigid.toml"), model("story/rigid.toml"));
    assert_eq!(bench.post("save", &json!({ "as": "rigid.toml" })).0, 422);
    assert_eq!(bench.state()["model"]["is_saved"], true);
}

#[test]
fn what_is_refused_is_said_at_its_place_and_changes_nothing() {
    let place = story();
    place.write("shop/spring.toml", model("stiffness.toml"));
    place.write("shop/broken.toml", "process = \"turning\"\n");
    place.write("shop/prose.csv", "this is no table\nat all\n");
    place.write("elsewhere.csv", "time [s],force [N]\n0,1\n");
    let bench = Bench::open(&place, "shop/rigid.toml");
    bench.done("data", &json!({ "files": ["measured.csv"] }));
    let before = bench.state();
    let elsewhere = json!({ "path": "cut.radial_force", "text": "450 mm" });
    for (verb, said, told) in [
        ("set", elsewhere, "measures a length"),
        ("set", json!({ "path": "cut.radial_force" }), "`text` is missing"),
        ("set", json!({ "path": "no.such", "text": "1" }), "no table"),
        ("add", json!({ "effect": "no-such-effect" }), "no-such-effect"),
        ("remove", json!({ "effect": "tool-wear" }), "tool-wear"),
        ("open", json!({ "model": "broken.toml" }), "broken.toml"),
        ("open", json!({ "model": "missing.toml" }), "there is no file"),
        ("open", json!({ "model": "../elsewhere.csv" }), "no name of a file here"),
        ("data", json!({ "files": ["prose.csv"] }), "prose.csv"),
        ("data", json!({ "files": ["/etc/passwd"] }), "no name of a file here"),
        ("strike", json!({ "rows": [4000] }), "no such row"),
        ("try", json!({ "values": { "cut.radial_force": -1e9 } }), "beyond what may be"),
        ("run", json!({ "what": "dance" }), "nothing to be done"),
        ("stop", Json::Null, "nothing runs"),
        ("undone", Json::Null, "nothing to be asked for"),
        ("save", json!({ "as": "../better.toml" }), "no name of a file here"),
        ("save", json!({ "as": "measured.csv" }), "measured.csv"),
        ("readings", json!({ "csv": "x\n1\n" }), "readings.csv"),
    ] {
        let (status, answer) = bench.post(verb, &said);
        assert!(
            status == 422 && answer["problem"].as_str().unwrap().contains(told),
            "{verb} {said}: {status} {answer}"
        );
    }
    // A model of another process takes its own measurements.
    let after = bench.state();
    assert_eq!(after, before);
    assert_eq!(place.read("shop/measured.csv"), model("story/measured.csv"));
    assert!(!place.files().contains(&"shop/readings.csv".to_string()));
    bench.done("open", &json!({ "model": "spring.toml" }));
    assert!(bench.state()["data"].is_null());
    bench.done("undo", &Json::Null);
    assert_eq!(bench.state()["data"], before["data"]);
    // A step back to a model that its file has is a saved one.
    assert_eq!(bench.state()["model"]["is_saved"], true);
}

/// The history of a workbench, run as commands in its folder; the last answer.
fn run_history(place: &Place, state: &Json) -> Answer {
    let mut last = None;
    for command in state["history"].as_array().unwrap() {
        let words = words(command.as_str().unwrap());
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let answer = within_shop(place, &words[1..]);
        assert_eq!(answer.status, 0, "{command}: {}", answer.err);
        last = Some(answer);
    }
    last.unwrap()
}

fn value<'s>(state: &'s Json, path: &str) -> &'s Json {
    state["model"]["values"].as_array().unwrap().iter().find(|own| own["path"] == path).unwrap()
}

#[test]
fn every_key_of_a_model_is_told_and_lists_grow_and_shrink() {
    let place = story();
    let bench = Bench::open(&place, "shop/rigid.toml");
    let state = bench.state();
    assert_eq!(value(&state, "workholding.type")["choices"], json!(["centres", "chuck", "chuck-and-centre"]));
    assert_eq!(value(&state, "batch.parts")["kind"], "number");
    assert_eq!(value(&state, "cut.depth")["about"], "set depth of cut");
    let list = |state: &Json, path: &str| {
        let lists = state["model"]["lists"].as_array().unwrap();
        lists.iter().find(|own| own["path"] == path).unwrap()["rows"].clone()
    };
    assert_eq!([list(&state, "workpiece.segments"), list(&state, "workholding.steady_rests")], [json!(1), json!(0)]);
    let rest = json!({ "at": "250 mm", "stiffness": "60 N/um" });
    let row = |path: &str, what: &str, more: Json| {
        let mut said = json!({ "path": path, "what": what });
        said.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        said
    };
    bench.done("row", &row("workholding.steady_rests", "add", json!({ "cells": rest })));
    bench.done("row", &row("workholding.steady_rests", "copy", json!({ "number": 0 })));
    bench.done("set", &json!({ "path": "workholding.steady_rests[1].at", "text": "300 mm" }));
    bench.done("row", &row("workholding.steady_rests", "remove", json!({ "number": 0 })));
    bench.done("row", &row("batch.pauses", "add", json!({ "cells": { "after": "9", "duration": "10 min" } })));
    bench.done("set", &json!({ "path": "workpiece.material", "text": "brass" }));
    bench.done(
        "set",
        &json!({ "path": "tool", "text": "{ overhang = \"40 mm\", width = \"25 mm\", height = \"25 mm\", material = \"steel\" }" }),
    );
    let state = bench.state();
    let text = state["model"]["text"].as_str().unwrap();
    for line in [
        "steady_rests = [{ at = \"300 mm\", stiffness = \"60 N/um\" }]\n",
        "pauses = [{ after = 6, duration = \"30 min\" }, { after = 9, duration = \"10 min\" }]\n",
        "[tool]\noverhang = \"40 mm\"\nwidth = \"25 mm\"\nheight = \"25 mm\"\nmaterial = \"steel\"\n",
        "material = \"brass\"\n",
        "# ISO 286-1: 50 mm within 8 um either way\n",
    ] {
        assert!(text.contains(line), "{line} is not in\n{text}");
    }
    assert_eq!(value(&state, "tool.overhang")["text"], "40 mm");
    // The same by commands.
    bench.done("data", &json!({ "files": ["measured.csv"] }));
    let state = bench.state();
    let told: Json = {
        let mut all = state.clone();
        let last = all["history"].as_array().unwrap().len() - 1;
        all["history"][last] = json!(format!("{} --json", all["history"][last].as_str().unwrap()));
        serde_json::from_str(&run_history(&place, &all).out).unwrap()
    };
    let here = state["comparison"]["rms"].as_f64().unwrap();
    assert!((told["models"][0]["rms"].as_f64().unwrap() - here).abs() < 1e-9 * here, "{here} {told}");
    // What is no list, no table of one, or makes no model, changes nothing.
    for (said, told) in [
        (row("workpiece.segments", "copy", json!({ "number": 7 })), "no table of a list"),
        (row("workpiece.segments", "remove", json!({ "number": 7 })), "no table 7"),
        (row("workpiece.segments", "remove", json!({ "number": 0 })), "segments"),
        (row("workpiece", "copy", json!({ "number": 0 })), "no table of a list"),
        (row("workpiece.segments", "add", json!({ "cells": { "length": "x" } })), "length"),
        (row("workpiece.segments", "turn", json!({})), "nothing to be done"),
    ] {
        let (status, answer) = bench.post("row", &said);
        assert!(status == 422 && answer["problem"].as_str().unwrap().contains(told), "{said}: {status} {answer}");
    }
    let after = bench.state();
    // The commands have written files beside it.
    assert!(["model", "history", "comparison"].iter().all(|key| after[key] == state[key]));
}

#[test]
fn a_file_with_other_headings_is_explained_by_hand() {
    let place = story();
    let measured = model("story/measured.csv");
    let rows: Vec<String> =
        measured.lines().filter(|line| !line.starts_with('#')).skip(1).map(str::to_string).collect();
    let foreign = |line: &String| line.replace(',', ";").replace('.', ",");
    let rows: Vec<String> = rows.iter().map(foreign).collect();
    place.write("shop/foreign.csv", format!("Nr;Ort;Kraft;Wert;Anm\n{}\n", rows.join("\n")));
    let bench = Bench::open(&place, "shop/rigid.toml");
    let (status, answer) = bench.post("data", &json!({ "files": ["foreign.csv"] }));
    assert!(status == 422 && answer["problem"].as_str().unwrap().contains("no column holds"), "{answer}");
    let seen = bench.get("preview?file=foreign.csv");
    assert_eq!(seen["headings"], json!(["Nr", "Ort", "Kraft", "Wert", "Anm"]));
    assert_eq!(seen["meant"], json!([null, "x", "radial_force", null, null]));
    assert_eq!((&seen["rows"][0], &seen["lines"]), (&json!(["1", "20,0", "450,0", "29,737", "1"]), &json!(108)));
    let names: Vec<Json> =
        bench.state()["model"]["columns"].as_array().unwrap().iter().map(|c| c["name"].clone()).collect();
    assert!(
        ["part", "x", "radial_force", "diameter_error", "u"].iter().all(|own| names.contains(&json!(own))),
        "{names:?}"
    );
    let columns = json!([
        ["Nr", "part"],
        ["Ort", "x [mm]"],
        ["Kraft", "radial_force [N]"],
        ["Wert", "diameter_error [um]"],
        ["Anm", "-"]
    ]);
    let said = json!({ "files": ["foreign.csv"], "columns": columns, "decimal": "comma" });
    bench.done("data", &said);
    let state = bench.state();
    let reading = |columns: Json, decimal: Json| json!({ "columns": columns, "decimal": decimal, "header": null, "sheet": null, "as_typed": false });
    assert_eq!(state["data"]["reading"], reading(columns, json!("comma")));
    assert_eq!(format!("{:.2}", state["comparison"]["rms"].as_f64().unwrap()), "43.21");
    run_history(&place, &state);
    // It holds for that file as long as it is open, and no longer.
    bench.done("set", &json!({ "path": "cut.depth", "text": "0.6 mm" }));
    bench.done("data", &json!({ "files": ["measured.csv"] }));
    assert_eq!(bench.state()["data"]["reading"], reading(json!([]), Json::Null));
    for (said, told) in [
        (json!({ "files": ["foreign.csv"], "columns": [["Nr", "part"], ["Nr", "x [mm]"]] }), "two things"),
        (json!({ "files": ["foreign.csv"], "columns": [["Ort", "colour"]] }), "no column of turning"),
        (json!({ "files": ["foreign.csv"], "columns": [["No", "part"]] }), "no column `No`"),
        (json!({ "files": ["foreign.csv"], "decimal": "dash" }), "no decimal mark"),
    ] {
        let (status, answer) = bench.post("data", &said);
        assert!(status == 422 && answer["problem"].as_str().unwrap().contains(told), "{said}: {status} {answer}");
    }
}

#[test]
fn deviations_from_nominal_are_shown_with_what_the_drawing_allows() {
    let place = story();
    let size = |line: &str| {
        let mut cells: Vec<String> = line.split(',').map(str::to_string).collect();
        cells[3] = format!("{:.6}", 50.0 + cells[3].parse::<f64>().unwrap() / 1000.0);
        cells.join(",")
    };
    let measured = model("story/measured.csv");
    let rows: Vec<String> = measured.lines().filter(|line| !line.starts_with('#')).skip(1).map(size).collect();
    place.write("shop/sizes.csv", format!("part,x [mm],radial_force [N],diameter [mm],u [um]\n{}\n", rows.join("\n")));
    let bench = Bench::open(&place, "shop/rigid.toml");
    bench.done("data", &json!({ "files": ["measured.csv"] }));
    let errors = bench.get("rows");
    bench.done("data", &json!({ "files": ["sizes.csv"] }));
    let sizes = bench.get("rows");
    assert_eq!(sizes["observables"][0], json!({ "name": "diameter less nominal", "unit": "um" }));
    for key in ["observed", "predicted"] {
        let numbers =
            |rows: &Json| -> Vec<f64> { rows[key].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect() };
        let (a, b) = (numbers(&errors), numbers(&sizes));
        assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-6), "{key}");
    }
    let limits = sizes["limits"][0].as_array().unwrap().iter().map(|v| v.as_f64().unwrap());
    assert!(limits.zip([-8.0, 8.0]).all(|(a, b)| (a - b).abs() < 1e-6), "{}", sizes["limits"][0]);
    // A trial is shown alike; what every row states itself moves nothing.
    let tried = bench.done("try", &json!({ "values": { "workpiece.segments[0].diameter": 49 } }));
    assert_eq!(tried["moves"], true);
    // Measured and tried are shown from one nominal: what is drawn between them is what is told to be left.
    let numbers = |of: &Json| -> Vec<f64> { of.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect() };
    let left = numbers(&sizes["observed"]).into_iter().zip(numbers(&tried["predicted"])).map(|(a, b)| (a - b).powi(2));
    let drawn = (left.sum::<f64>() / sizes["observed"].as_array().unwrap().len() as f64).sqrt();
    let told = tried["rms"].as_f64().unwrap();
    assert!(told > 900.0 && (drawn - told).abs() < 1e-6 * told, "{drawn} {told}");
    assert_eq!(bench.done("try", &json!({ "values": { "cut.radial_force": 500 } }))["moves"], false);
}

#[test]
fn what_is_to_be_done_is_written_into_a_folder_of_its_own() {
    let place = story();
    let part = "G0 X60 Z5\nG1 X50 Z0 F0.2\nG1 Z-500\nG0 X60\nM30\n";
    place.write("shop/part.ngc", part);
    place.write("shop/stiff.toml", model("story/rigid.toml"));
    let bench = Bench::open(&place, "shop/rigid.toml");
    assert_eq!(bench.state()["programs"], json!(["part.ngc"]));
    assert!(bench.state()["model"]["has_settings"] == true);
    assert!(
        bench.post("write", &json!({ "as": "out" })).1["problem"].as_str().unwrap().contains("nothing was corrected")
    );
    let state = bench.run("correct");
    assert!(state["correction"]["is_current"] == true && !state["tolerance"].as_array().unwrap().is_empty(), "{state}");
    let names = bench.done("write", &json!({ "as": "out" }))["names"].clone();
    for name in names.as_array().unwrap() {
        assert!(place.files().contains(&format!("shop/{}", name.as_str().unwrap())), "{name}");
    }
    assert!(names.as_array().unwrap().contains(&json!("out/correction.csv")), "{names}");
    for (name, told) in
        [("out", "already"), ("../out", "no name"), ("rigid.toml", "already"), ("a/b", "no name"), (".git", "no name")]
    {
        let (status, answer) = bench.post("write", &json!({ "as": name }));
        assert!(status == 422 && answer["problem"].as_str().unwrap().contains(told), "{name}: {answer}");
    }
    // The command that it tells writes the same.
    let written = place.read("shop/out/correction.csv");
    std::fs::remove_dir_all(place.path("shop/out")).unwrap();
    run_history(&place, &bench.state());
    assert_eq!(place.read("shop/out/correction.csv"), written);
    // What the shop can change, and what it may cost.
    bench.done("run", &json!({ "what": "remedies", "minutes": 30 }));
    let state = bench.until(|state| state["job"].is_null());
    assert!(state["trouble"].is_null(), "{}", state["trouble"]);
    assert!(state["remedies"]["html"].as_str().unwrap().contains("steady rest"), "{}", state["remedies"]);
    let last = state["history"].as_array().unwrap().last().unwrap().clone();
    assert_eq!(last, "fem correct rigid.toml --remedies --minutes 30");
    // By the shop's own program.
    bench.done("run", &json!({ "what": "correct", "program": "part.ngc", "add_blocks": true }));
    let state = bench.until(|state| state["job"].is_null());
    assert!(state["trouble"].is_null(), "{}", state["trouble"]);
    bench.done("write", &json!({ "as": "by-program" }));
    let own = place.read("shop/by-program/part.ngc");
    assert!(own != part && own.contains("M30"), "{own}");
    assert_eq!(place.read("shop/part.ngc"), part);
    assert_eq!(bench.post("run", &json!({ "what": "correct", "program": "../part.ngc" })).0, 422);
}

#[test]
fn nobody_else_gets_in_and_nothing_else_gets_out() {
    let place = story();
    place.write("secret.csv", "part,x [mm],diameter_error [um]\n1,20,3\n");
    #[cfg(unix)]
    std::os::unix::fs::symlink(place.path("secret.csv"), place.path("shop/link.csv")).unwrap();
    let outward = model("story/rigid.toml").replace("\"450 N\"", "{ file = \"../secret.csv\" }");
    place.write("shop/outward.toml", outward);
    let bench = Bench::open(&place, "shop");
    let question = |path: &str, host: &str, more: &str| {
        format!("GET {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n{more}\r\n").into_bytes()
    };
    let (own, token) = (bench.host.clone(), bench.token.clone());
    let state = format!("/{token}/state");
    let port = own.split_once(':').unwrap().1;
    for (path, host, more, expected) in [
        (&*state, &*own, "", 200),
        (&state, &format!("localhost:{port}"), "", 200),
        (&state, &own, &format!("Origin: http://{own}\r\n"), 200),
        ("/state", &own, "", 403),
        ("/", &own, "", 403),
        (&format!("/{}/state", "0".repeat(token.len())), &own, "", 403),
        (&format!("/{}x/state", token), &own, "", 403),
        (&state, "attacker.example", "", 403),
        (&state, &format!("attacker.example:{port}"), "", 403),
        (&state, &own, "Origin: http://attacker.example\r\n", 403),
        (&state, &own, "Origin: null\r\n", 403),
        (&state, &own, "Host: attacker.example\r\n", 403),
        (&state, &own, &format!("Host: {own}\r\n"), 403),
        (&format!("/{token}/../../etc/passwd"), &own, "", 404),
        (&format!("/{token}/%2e%2e/Cargo.toml"), &own, "", 404),
        (&format!("/{token}/no-such.js"), &own, "", 404),
    ] {
        let (status, head, _) = bench.raw(&question(path, host, more));
        assert_eq!(status, expected, "{path} of {host} {more}: {head}");
        assert!(
            head.to_lowercase().contains("content-security-policy: default-src 'none'; script-src 'self';"),
            "{head}"
        );
    }
    assert_eq!(bench.ask("DELETE", "state", "", b"").0, 405);
    for name in ["a%0Ab.csv", "a%1B[2Jb.csv", "a%7Fb.csv"] {
        let (status, _, answer) = bench.ask("POST", &format!("file?name={name}"), "", b"part,x [mm]\n");
        assert!(status == 422 && !answer.contains(&0x1b), "{name}: {status}");
    }
    // Neither by a link nor by a model.
    let listed = bench.state()["measurements"].clone();
    assert!(!listed.as_array().unwrap().contains(&json!("link.csv")), "{listed}");
    let (status, answer) = bench.post("open", &json!({ "model": "outward.toml" }));
    assert!(status == 422 && answer["problem"].as_str().unwrap().contains("not in this folder"), "{answer}");
    assert!(!answer.to_string().contains("diameter_error"), "{answer}");
    bench.done("open", &json!({ "model": "rigid.toml" }));
    let (status, answer) = bench.post("set", &json!({ "path": "cut.radial_force", "text": "../secret.csv" }));
    assert!(status == 422 && answer["problem"].as_str().unwrap().contains("not in this folder"), "{answer}");
    let table = json!({ "path": "cut.radial_force", "text": "{ file = \"../secret.csv\" }" });
    let list = json!({ "path": "workpiece.lobes", "text": "[{ lobes = 3, amplitude = \"../secret.csv\" }]" });
    let row =
        json!({ "path": "batch.corrections", "what": "add", "cells": { "after": "1", "diameter": "../secret.csv" } });
    for (verb, said) in [("set", table), ("set", list), ("row", row)] {
        let (status, answer) = bench.post(verb, &said);
        assert!(
            status == 422 && answer["problem"].as_str().unwrap().contains("not in this folder"),
            "{said}: {answer}"
        );
    }
    for name in ["..%2Fsecret.csv", "link.csv", "%2Fetc%2Fpasswd", "none.csv"] {
        let (status, _, body) = bench.ask("GET", &format!("preview?file={name}"), "", b"");
        assert!(status == 422 && !String::from_utf8_lossy(&body).contains("diameter_error"), "{name}: {status}");
    }
    // What is too large is refused, and what is dropped takes no other file's place.
    let head = format!(
        "POST /{token}/file?name=big.csv HTTP/1.1\r\nHost: {own}\r\nConnection: close\r\nContent-Length: {}\r\n\r\n",
        100 << 20
    );
    let (status, _, body) = bench.raw(head.as_bytes());
    assert!(status == 422 && String::from_utf8_lossy(&body).contains("too large"), "{status}");
    let (status, _, body) = bench.ask("POST", "file?name=measured.csv", "", b"x\n1\n");
    let stored: Json = serde_json::from_slice(&body).unwrap();
    assert_eq!((status, &stored["name"]), (200, &json!("measured-2.csv")));
    assert_eq!(place.read("shop/measured.csv"), model("story/measured.csv"));
    // Nor is what lies there too large.
    std::fs::File::create(place.path("shop/huge.csv")).unwrap().set_len(100 << 20).unwrap();
    for (verb, path) in [("GET", "preview?file=huge.csv"), ("POST", "data")] {
        let (status, _, body) = bench.ask(verb, path, "", b"{\"files\":[\"huge.csv\"]}");
        assert!(status == 422 && String::from_utf8_lossy(&body).contains("too large for a page"), "{verb} {status}");
    }
    // The same file dropped again is the same file.
    let own = model("story/measured.csv");
    let (status, _, body) = bench.ask("POST", "file?name=measured.csv", "", own.as_bytes());
    assert_eq!((status, &serde_json::from_slice::<Json>(&body).unwrap()["name"]), (200, &json!("measured.csv")));
    for name in ["..%2Fout.csv", "%2Ftmp%2Fout.csv", ".hidden.csv", "", "a%5Cb.csv", "a%00.csv"] {
        assert_eq!(bench.ask("POST", &format!("file?name={name}"), "", b"x").0, 422, "{name}");
    }
}

#[test]
fn the_file_is_the_truth_and_a_wrong_one_keeps_what_was() {
    let place = story();
    let bench = Bench::open(&place, "shop/rigid.toml");
    bench.done("data", &json!({ "files": ["measured.csv"] }));
    let text = model("story/rigid.toml");
    place.write("shop/rigid.toml", text.replace("\"450 N\"", "\"500 N\""));
    let force = |state: &Json| {
        let values = state["model"]["values"].as_array().unwrap().clone();
        values.into_iter().find(|own| own["path"] == "cut.radial_force").unwrap()["text"].clone()
    };
    bench.until(|state| force(state) == "500 N");
    place.write("shop/rigid.toml", text.replace("\"450 N\"", "\"450 m\""));
    let state = bench.until(|state| state["trouble"].is_string());
    assert!(state["trouble"].as_str().unwrap().contains("what was open stays") && force(&state) == "500 N", "{state}");
    place.write("shop/rigid.toml", &text);
    let state = bench.until(|state| force(state) == "450 N");
    assert!(state["trouble"].is_null());
    // Changed on both sides: neither is lost without a word.
    bench.done("set", &json!({ "path": "cut.depth", "text": "0.7 mm" }));
    let elsewhere = text.replace("\"450 N\"", "\"510 N\"");
    place.write("shop/rigid.toml", &elsewhere);
    bench.until(|state| state["trouble"].as_str().is_some_and(|told| told.contains("something is not saved here")));
    let (status, answer) = bench.post("save", &Json::Null);
    assert!(status == 422 && answer["problem"].as_str().unwrap().contains("changed elsewhere"), "{answer}");
    assert_eq!(place.read("shop/rigid.toml"), elsewhere);
    bench.done("undo", &Json::Null);
    bench.until(|state| force(state) == "510 N" && state["trouble"].is_null());
    // Emptied or gone: what is open is not said to be saved, and can be written again.
    for is_gone in [false, true] {
        match is_gone {
            true => std::fs::remove_file(place.path("shop/rigid.toml")).unwrap(),
            false => place.write("shop/rigid.toml", ""),
        }
        let state = bench.until(|state| state["trouble"].is_string());
        assert!(state["model"]["is_saved"] == false && state["data"]["rows"] == 108, "{}", state["trouble"]);
        bench.done("save", &Json::Null);
        let state = bench.until(|state| state["trouble"].is_null());
        assert!(state["model"]["is_saved"] == true && place.read("shop/rigid.toml") == elsewhere);
    }
    place.write("shop/rigid.toml", &text);
    bench.until(|state| force(state) == "450 N");
    // What was measured is followed as well.
    let measured = model("story/measured.csv");
    let few: Vec<&str> = measured.lines().take(40).collect();
    place.write("shop/measured.csv", few.join("\n") + "\n");
    bench.until(|state| state["data"]["rows"] == 38);
    place.write("shop/measured.csv", "x\n");
    let state = bench.until(|state| state["trouble"].is_string());
    assert!(state["data"]["rows"] == 38 && state["trouble"].as_str().unwrap().contains("measured.csv"), "{state:.300}");
    place.write("shop/measured.csv", &measured);
    bench.until(|state| state["data"]["rows"] == 108 && state["trouble"].is_null());
    // Wrong, and just as it was before.
    place.write("shop/rigid.toml", text.replace("\"450 N\"", "\"450 m\""));
    bench.until(|state| state["trouble"].is_string());
    place.write("shop/rigid.toml", &text);
    bench.until(|state| state["trouble"].is_null());
}

#[test]
fn what_is_not_saved_outlives_the_program() {
    let place = story();
    let bench = Bench::open(&place, "shop/rigid.toml");
    bench.done("data", &json!({ "files": ["measured.csv"] }));
    bench.done("set", &json!({ "path": "cut.radial_force", "text": "500 N" }));
    bench.done("strike", &json!({ "rows": [3], "is_struck": true }));
    let kept = "shop/.fem-session.json".to_string();
    let until = |is_there: bool, has: &str| {
        let began = Instant::now();
        while place.files().contains(&kept) != is_there || (is_there && !place.read(&kept).contains(has)) {
            assert!(began.elapsed() < Duration::from_secs(60), "{kept}");
            std::thread::sleep(Duration::from_millis(20));
        }
    };
    until(true, "\"struck\":[3]");
    let before = bench.state();
    // Killed, as by -9.
    drop(bench);
    assert_eq!(place.read("shop/rigid.toml"), model("story/rigid.toml"));
    let bench = Bench::open(&place, "shop/rigid.toml");
    assert_eq!(bench.state()["session"], json!({ "steps": 4 }));
    bench.done("resume", &Json::Null);
    let after = bench.state();
    for key in ["model", "data", "comparison", "history"] {
        assert!(after[key] == before[key], "{key}: {:.400} and {:.400}", after[key], before[key]);
    }
    assert!(after["session"].is_null() && bench.post("resume", &Json::Null).0 == 422);
    // What was taken up is not read anew at the first look at its files, which has come when the next edit is told.
    place.write("shop/rigid.toml", model("story/rigid.toml").replace("\"0.5 mm\"", "\"0.6 mm\""));
    let state = bench.until(|state| state["trouble"].is_string());
    assert_eq!((&state["undo"], &state["data"]["struck"]), (&json!("take up the last session"), &json!([3])));
    place.write("shop/rigid.toml", model("story/rigid.toml"));
    bench.until(|state| state["trouble"].is_null());
    // Saved, nothing need be kept any more.
    bench.done("save", &json!({ "as": "mine.toml" }));
    until(false, "");
    bench.done("set", &json!({ "path": "cut.radial_force", "text": "510 N" }));
    until(true, "510 N");
    drop(bench);
    let bench = Bench::open(&place, "shop");
    bench.done("forget", &Json::Null);
    assert!(bench.state()["session"].is_null() && !place.files().contains(&kept));
    // What somebody else has put there is nothing that is taken up, nor does it lead out of the folder.
    place.write("secret.csv", "x\n1\n");
    place.write(
        "shop/.fem-session-9.json",
        "{\"schema\":\"fem-session/1\",\"steps\":1,\"file\":\"../secret.csv\",\"text\":\"\"}",
    );
    place.write("shop/.fem-session-8.txt", "no session");
    drop(bench);
    let bench = Bench::open(&place, "shop");
    let (status, answer) = bench.post("resume", &Json::Null);
    assert!(status == 422 && answer["problem"].as_str().unwrap().contains("no name of a file here"), "{answer}");
}

#[test]
fn work_is_stopped_and_goes_on_beside_the_page() {
    let place = story();
    let bench = Bench::open(&place, "shop/rigid.toml");
    assert_eq!(bench.post("run", &json!({ "what": "diagnose" })).0, 422);
    bench.done("data", &json!({ "files": ["measured.csv"] }));
    bench.done("run", &json!({ "what": "diagnose" }));
    let (status, answer) = bench.post("run", &json!({ "what": "fit" }));
    assert!(status == 422 || status == 200, "{answer}");
    let _ = bench.post("stop", &Json::Null);
    let state = bench.until(|state| state["job"].is_null());
    assert_eq!(state["model"]["file"], "rigid.toml");
    // Rows that are struck out by hand no longer count, and come back.
    bench.done("strike", &json!({ "rows": [0, 1], "is_struck": true }));
    let rows = bench.get("rows");
    assert!(rows["predicted"][0].is_null() && rows["predicted"][2].is_number());
    let last = bench.state()["history"].as_array().unwrap().last().unwrap().clone();
    assert_eq!(last, "# struck out by hand, to be left out of the file: lines 3, 4");
    bench.done("strike", &json!({ "rows": [0, 1], "is_struck": false }));
    assert!(bench.get("rows")["predicted"][0].is_number());
}

#[test]
fn every_file_of_the_page_is_served() {
    let place = story();
    let bench = Bench::open(&place, "shop");
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("templates/workbench");
    let mut names = Vec::new();
    for entry in std::fs::read_dir(&root).unwrap().map(Result::unwrap) {
        let name = entry.file_name().into_string().unwrap();
        match entry.path().is_dir() {
            true => names.extend(
                std::fs::read_dir(entry.path())
                    .unwrap()
                    .map(|own| format!("{name}/{}", own.unwrap().file_name().to_str().unwrap())),
            ),
            false => names.push(name),
        }
    }
    assert!(names.len() > 10);
    for name in names {
        let (status, _, body) = bench.ask("GET", &name, "", b"");
        assert_eq!((status, body), (200, std::fs::read(root.join(&name)).unwrap()), "{name}");
    }
    assert_eq!(bench.ask("GET", "", "", b"").2, std::fs::read(root.join("index.html")).unwrap());
    for shared in ["figures.css", "figures.js"] {
        assert_eq!(bench.ask("GET", shared, "", b"").0, 200, "{shared}");
    }
}
