//! `fem report`: the page says what the other commands say, and a served one follows its files.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use super::fem::{Place, model};
use super::served::Served;

#[test]
fn the_page_says_what_the_other_commands_say() {
    let place = Place::new();
    place.write("rigid.toml", model("story/rigid.toml"));
    place.write("measured.csv", model("story/measured.csv"));
    let made = place.fem(&["report", "rigid.toml", "--with", "measured.csv", "-o", "report.html"]);
    assert_eq!((made.status, made.out.as_str()), (0, "written report.html\n"), "{}", made.err);
    let page = place.read("report.html");
    let json: serde_json::Value =
        serde_json::from_str(&place.fem(&["diagnose", "rigid.toml", "--with", "measured.csv", "--json"]).out).unwrap();
    let has = |text: &str| assert!(page.contains(text), "the page lacks {text}");
    for key in ["before", "after"] {
        has(&format!("{:.3}", json[key]["rms"].as_f64().unwrap()));
        has(&format!("{:.3}</td>", json[key]["chi2_per_dof"].as_f64().unwrap()));
    }
    let told: Vec<f64> =
        page.split("data-value=\"").skip(1).map(|v| v.split('"').next().unwrap().parse().unwrap()).collect();
    // A reader of JSON may be off in the last digit.
    let has_number = |v: &serde_json::Value| {
        let number = v.as_f64().unwrap();
        assert!(told.iter().any(|t| (t - number).abs() <= 1e-12 * number.abs()), "the page lacks {number}");
    };
    for cause in json["missing"].as_array().unwrap() {
        has(&format!("</span>{}</h3>", cause["effect"].as_str().unwrap()));
        for other in cause["indistinguishable_from"].as_array().unwrap() {
            has(other.as_str().unwrap());
        }
        for (name, value) in cause["parameters"].as_object().unwrap() {
            has(&format!("profile of \u{3c7}\u{b2} along {name}"));
            let ends = value["interval95"].as_array().unwrap();
            for number in [&value["value"], &ends[0], &ends[1]] {
                has_number(number);
            }
        }
    }
    let compared: serde_json::Value =
        serde_json::from_str(&place.fem(&["compare", "rigid.toml", "--with", "measured.csv", "--json"]).out).unwrap();
    has_number(&compared["models"][0]["bias"]);
    // What was read can be told from what was not.
    has(&place.sha256("measured.csv"));
    has("fem report rigid.toml --with measured.csv -o report.html");
}

/// A spring of 100 N/um, in more rows than a diagnosis uses; one row is off by a micrometre.
#[test]
fn a_page_of_several_models_shows_every_row_where_it_was_measured() {
    let place = Place::new();
    let spring = |stiffness: &str| {
        format!("process = \"stiffness\"\n[joint]\nstiffness = \"{stiffness} N/um\"\n[test]\nmax_force = \"3 kN\"\n")
    };
    place.write("first.toml", spring("90"));
    place.write("second.toml", spring("100"));
    let row = |i: usize| {
        let (force, noise) = (i as f64, [0.01, -0.01, 0.0][i % 3]);
        format!("{force},{},0.01\n", force / 100.0 + noise + if i == 1501 { 1.0 } else { 0.0 })
    };
    let rows: String = (1..=2500).map(row).collect();
    place.write("measured.csv", format!("force [N],displacement [um],u [um]\n{rows}"));
    let made = place.fem(&["report", "first.toml", "second.toml", "--with", "measured.csv", "-o", "report.html"]);
    assert_eq!(made.status, 0, "{}", made.err);
    assert!(made.err.contains("1250 of 2500 rows were used for the diagnosis"), "{}", made.err);
    let page = place.read("report.html");
    assert!(page.contains("The row farthest off is line 1502: 99 standard uncertainties."), "{page}");
}

#[test]
fn a_report_is_not_written_over_what_it_reads() {
    let place = Place::new();
    place.write("model.toml", model("stiffness.toml"));
    let answer = place.fem(&["report", "model.toml", "-o", "model.toml"]);
    assert!(answer.status == 2 && answer.err.contains("is itself what is read"), "{}", answer.err);
    assert_eq!(place.fem(&["report", "model.toml"]).status, 2);
}

/// A served page, ended with the test.
impl Served {
    fn get(&self, path: &str, host: &str) -> String {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        write!(stream, "GET {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n").unwrap();
        let mut answer = String::new();
        stream.read_to_string(&mut answer).unwrap();
        answer
    }

    /// Waits until the page holds a text.
    fn until(&self, text: &str) -> String {
        self.until_at("/", text)
    }

    fn until_at(&self, path: &str, text: &str) -> String {
        let start = Instant::now();
        loop {
            let page = self.get(path, &self.host);
            if page.contains(text) {
                return page;
            }
            assert!(start.elapsed() < Duration::from_secs(60), "no {text} in {page}");
            std::thread::sleep(Duration::from_millis(50));
        }
    }
}

#[test]
fn a_served_page_follows_its_files() {
    let place = Place::new();
    let text = model("stiffness.toml");
    place.write("model.toml", &text);
    let served = Served::of(&place, &["report", "model.toml", "--serve"]);
    assert!(served.host.starts_with("127.0.0.1:"));
    let first = served.until("</html>");
    let version = |page: &str| page.rsplit("live(").next().unwrap().split(')').next().unwrap().to_string();
    assert!(served.get("/version", &served.host).ends_with(&format!("\r\n\r\n{}", version(&first))));
    // A name that is not this computer's, as a page elsewhere could point to it.
    assert!(served.get("/", "evil.example").starts_with("HTTP/1.1 403"));
    assert!(served.get("/etc/passwd", &served.host).starts_with("HTTP/1.1 404"));
    // A mistake is told with its place and remedy, and mended again.
    let wrong = text.replacen("[joint]", "[joynt]", 1);
    assert_ne!(wrong, text);
    place.write("model.toml", &wrong);
    let told = served.until_at("/version", "joynt");
    assert!(told.contains("model.toml:") && told.contains("joint"), "{told}");
    // The last good page stays, with a place for what is wrong.
    let kept = served.get("/", &served.host);
    assert_eq!(version(&kept), version(&first));
    assert!(kept.contains("this is the last good page") && !kept.contains("joynt"), "{kept}");
    place.write("model.toml", format!("title = \"Mended\"\n{}", text.replacen("title", "# title", 1)));
    let mended = served.until("<h1>Mended</h1>");
    assert_ne!(version(&mended), version(&first));
    assert!(served.get("/version", &served.host).ends_with(&format!("\r\n\r\n{}", version(&mended))));
}

#[test]
fn a_served_page_of_a_wrong_file_says_so_and_comes_when_it_is_mended() {
    let place = Place::new();
    let text = model("stiffness.toml");
    place.write("model.toml", text.replacen("[joint]", "[joynt]", 1));
    let served = Served::of(&place, &["report", "model.toml", "--serve"]);
    let told = served.until("The page cannot be made");
    assert!(told.contains("model.toml:") && told.contains("joynt") && told.contains("joint"), "{told}");
    place.write("model.toml", &text);
    served.until("id=\"prediction\"");
}

#[test]
fn a_served_page_outlives_its_clients() {
    let place = Place::new();
    place.write("model.toml", model("stiffness.toml"));
    let served = Served::of(&place, &["report", "model.toml", "--serve"]);
    served.until("</html>");
    let open = |text: &str| {
        let mut stream = TcpStream::connect(&served.host).unwrap();
        // One that is refused while it sends is refused.
        let _ = stream.write_all(text.replace("HOST", &served.host).as_bytes());
        stream
    };
    let begun = |rest: &str| format!("GET /version HTTP/1.1\r\nHost: HOST\r\n{rest}");
    let lengths = [u64::MAX, 1 << 63, 1 << 62, 1_000_000_000_000, 5000];
    let mut held: Vec<TcpStream> = lengths
        .iter()
        .map(|length| open(&begun(&format!("Content-Length: {length}\r\n\r\nx")).replacen("GET", "POST", 1)))
        .collect();
    held.push(open(&begun("Content-Length: 18446744073709551616\r\n\r\n")));
    held.push(open(&begun("Content-Length: -1\r\n\r\n")));
    held.push(open(&begun("Transfer-Encoding: chunked\r\n\r\nffffffffffffffff\r\n")));
    held.push(open("GET / HTTP/1.1\r\nHost: evil.example\r\nContent-Length: 5000\r\n\r\n"));
    held.push(open(&begun("\r\n").repeat(500)));
    held.push(open(&begun(&format!("X: {}", "a".repeat(4_000_000)))));
    held.push(open("\0\u{1b}[2J\r\n\r\n"));
    held.extend((0..100).map(|_| open("GET / HT")));
    for _ in 0..300 {
        // Gone before the page is sent.
        open(&begun("\r\n"));
    }
    let mut stream = TcpStream::connect(&served.host).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
    write!(stream, "GET / HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n", served.host).unwrap();
    let mut page = String::new();
    stream.read_to_string(&mut page).unwrap();
    assert!(page.starts_with("HTTP/1.1 200") && page.contains("</html>"));
}

#[cfg(unix)]
#[test]
fn a_pipe_is_read_once_and_hashed_as_it_was_read() {
    let place = Place::new();
    place.write("rigid.toml", model("story/rigid.toml"));
    place.write("m.csv", model("story/measured.csv"));
    let made = std::process::Command::new("mkfifo").arg(place.path("pipe")).status().unwrap();
    assert!(made.success());
    let (from, to) = (place.path("m.csv"), place.path("pipe"));
    let writer = std::thread::spawn(move || std::fs::write(to, std::fs::read(from).unwrap()));
    let answer = place.fem(&["report", "rigid.toml", "--with", "pipe", "-o", "page.html", "--time-limit", "1 ms"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    writer.join().unwrap().unwrap();
    assert!(place.read("page.html").contains(&place.sha256("m.csv")));
}
