//! The server of the page: for this computer alone, under a token that only who started it knows.

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::io;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use axum::Router;
use axum::body::to_bytes;
use axum::extract::{Request, State};
use axum::http::header::{CONTENT_DISPOSITION, CONTENT_LENGTH};
use axum::http::request::Parts;
use axum::http::{HeaderValue, Method, StatusCode};
use axum::response::sse::{Event, Sse};
use axum::response::{IntoResponse, Response};
use percent_encoding::percent_decode_str;
use serde_json::{Value as Json, json};

use super::assets::asset;
use super::edits::Row;
use super::folder::LARGEST;
use super::gate::{Gate, guarded};
use super::job::{Job, Work};
use super::refusal::Refusal;
use super::session::Session;
use crate::measure::Reading;
use crate::output::files::digits;

/// Longest time in which a question has to come.
const LONGEST: Duration = Duration::from_secs(60);
/// Time between two looks at the state and at the files.
const LOOK: Duration = Duration::from_millis(250);
/// Nothing is run, read or asked for but what comes from here.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; connect-src 'self'; \
                      img-src 'self' data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// What all connections share.
#[derive(Clone)]
struct Shared {
    session: Arc<Mutex<Session>>,
    token: Arc<str>,
    gate: Gate,
}

impl Shared {
    fn session(&self) -> MutexGuard<'_, Session> {
        // A step is put in whole: a panic elsewhere leaves what was before it.
        self.session.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Serves the page until the program is stopped; `told` gets its address.
///
/// # Errors
/// The port cannot be had.
pub fn serve(session: Session, port: u16, told: impl FnOnce(&str)) -> io::Result<()> {
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
    runtime.block_on(async {
        let (listener, gate, port) = Gate::open(port).await?;
        let mut session = session;
        session.served_at(port);
        let token = digits()?;
        let shared = Shared { session: Arc::new(Mutex::new(session)), token: token.as_str().into(), gate };
        told(&format!("http://127.0.0.1:{port}/{token}/"));
        let looks = shared.clone();
        std::thread::spawn(move || {
            loop {
                std::thread::sleep(LOOK);
                let mut session = looks.session();
                session.look();
                session.keep();
            }
        });
        let router = Router::new().fallback(answer).with_state(shared);
        axum::serve(listener, router).await
    })
}

/// Answers a browser.
async fn answer(State(shared): State<Shared>, request: Request) -> Response {
    let (Parts { method, uri, headers, .. }, body) = request.into_parts();
    let length = headers.get(CONTENT_LENGTH).and_then(|value| value.to_str().ok()?.parse::<usize>().ok());
    let path = uri.path().strip_prefix('/').unwrap_or_default();
    let (token, path) = path.split_once('/').unwrap_or((path, ""));
    if !shared.gate.admits(&headers) || !is_same(token, &shared.token) {
        return plain(StatusCode::FORBIDDEN, "this page is for the one who started it\n");
    }
    // What says that it is too large is not waited for, nor is what never comes.
    let is_too_large = length.is_some_and(|length| length > LARGEST);
    let read = async { if is_too_large { None } else { to_bytes(body, LARGEST).await.ok() } };
    let Some(body) = tokio::time::timeout(LONGEST, read).await.ok().flatten() else {
        let refusal = Refusal::new("that is too large", "a file of measurements may have 64 MB: thin it out first");
        return refused(&refusal);
    };
    let query = uri.query().unwrap_or_default().to_string();
    match (method, path) {
        (Method::GET, "events") => events(shared).into_response(),
        (Method::GET, "export") => blocking(move || export(&shared, &query)).await,
        (Method::GET, "state") => blocking(move || told(&shared.session().state())).await,
        (Method::GET, "rows") => {
            let rows = move || shared.session().rows();
            blocking(move || rows().map_or_else(|refusal| refused(&refusal), |rows| told(&rows))).await
        }
        (Method::GET, "preview") => {
            let [name, header, sheet] = ["file=", "header=", "sheet="].map(|key| named(&query, key));
            let line = header.parse::<usize>().ok().map(|line| (line > 0).then_some(line));
            let said = Reading::default().within(line, Some(sheet).filter(|name| !name.is_empty()));
            blocking(move || {
                // The page goes on while a file is read.
                let asked = shared.session().to_preview(&name, said);
                asked.and_then(|asked| asked.read()).map_or_else(|refusal| refused(&refusal), |own| told(&own))
            })
            .await
        }
        (Method::GET, "") => file("index.html"),
        (Method::GET, name) => file(name),
        (Method::POST, verb) => {
            let verb = verb.to_string();
            blocking(move || post(&shared, &verb, &query, &body).map_or_else(|r| refused(&r), |own| told(&own))).await
        }
        _ => plain(StatusCode::METHOD_NOT_ALLOWED, "ask with GET or POST\n"),
    }
}

/// Whether two texts are the same, in a time that does not tell how much of them is.
fn is_same(a: &str, b: &str) -> bool {
    a.len() == b.len() && a.bytes().zip(b.bytes()).fold(0, |other, (a, b)| other | (a ^ b)) == 0
}

/// Does what takes a moment beside the connections.
async fn blocking(work: impl FnOnce() -> Response + Send + 'static) -> Response {
    let none = |_| plain(StatusCode::INTERNAL_SERVER_ERROR, "that went wrong; what was open stays\n");
    tokio::task::spawn_blocking(work).await.unwrap_or_else(none)
}

fn plain(status: StatusCode, text: &'static str) -> Response {
    guarded(status, "text/plain; charset=utf-8", POLICY, text)
}

fn told(json: &Json) -> Response {
    guarded(StatusCode::OK, "application/json", POLICY, json.to_string())
}

fn refused(refusal: &Refusal) -> Response {
    guarded(StatusCode::UNPROCESSABLE_ENTITY, "application/json", POLICY, refusal.json().to_string())
}

fn file(name: &str) -> Response {
    match asset(name) {
        Some((kind, bytes)) => guarded(StatusCode::OK, kind, POLICY, bytes),
        None => plain(StatusCode::NOT_FOUND, "there is no such thing here\n"),
    }
}

/// What a question names.
fn named(query: &str, key: &str) -> String {
    let own = query.split('&').find_map(|part| part.strip_prefix(key));
    percent_decode_str(own.unwrap_or_default()).decode_utf8_lossy().into_owned()
}

/// New states and the work that runs, as they come.
fn events(shared: Shared) -> impl IntoResponse {
    let next = |(shared, before, first): (Shared, (u64, Json), bool)| async move {
        loop {
            let now = {
                let session = shared.session();
                (session.version(), session.job().map_or(Json::Null, Job::json))
            };
            if first || now.0 != before.0 {
                let event = Event::default().event("state").data(now.0.to_string());
                let seen = (now.0, before.1);
                return Some((Ok::<_, Infallible>(event), (shared, seen, false)));
            }
            if now.1 != before.1 {
                return Some((Ok(Event::default().event("job").data(now.1.to_string())), (shared, now, false)));
            }
            tokio::time::sleep(LOOK).await;
        }
    };
    Sse::new(futures_util::stream::unfold((shared, (0, Json::Null), true), next))
}

/// Gives something away as a file.
fn export(shared: &Shared, query: &str) -> Response {
    let session = shared.session();
    let (name, kind, made) = match query {
        "what=page" => ("report.html", "text/html; charset=utf-8", session.report()),
        "what=csv" => ("rows.csv", "text/csv; charset=utf-8", session.table()),
        "what=notebook" => ("session.ipynb", "application/x-ipynb+json", Ok(session.notebook())),
        _ => return plain(StatusCode::NOT_FOUND, "there is no such thing here\n"),
    };
    match made {
        Ok(text) => {
            let mut response = guarded(StatusCode::OK, kind, POLICY, text);
            let as_file = HeaderValue::from_str(&format!("attachment; filename=\"{name}\""));
            as_file.into_iter().for_each(|value| drop(response.headers_mut().insert(CONTENT_DISPOSITION, value)));
            response
        }
        Err(refusal) => refused(&refusal),
    }
}

/// Does what the page asks for.
fn post(shared: &Shared, verb: &str, query: &str, body: &[u8]) -> Result<Json, Refusal> {
    if verb == "file" {
        let name = named(query, "name=");
        let mut session = shared.session();
        let name = session.store(&name, body)?;
        return Ok(json!({ "name": name, "version": session.version() }));
    }
    let said: Json = match body.is_empty() {
        true => Json::Null,
        false => serde_json::from_slice(body)
            .map_err(|error| Refusal::new(format!("the question is no JSON: {error}"), "ask as the page does"))?,
    };
    let text = |key: &str| {
        let none = || Refusal::new(format!("`{key}` is missing"), "ask as the page does");
        said[key].as_str().ok_or_else(none)
    };
    let list = |key: &str| said[key].as_array().cloned().unwrap_or_default();
    match verb {
        "try" => {
            let values: BTreeMap<String, f64> = said["values"].as_object().map_or_else(BTreeMap::new, |own| {
                own.iter().filter_map(|(path, value)| Some((path.clone(), value.as_f64()?))).collect()
            });
            let trial = shared.session().on_trial(&values)?;
            // The page goes on while it is computed.
            return trial.predict();
        }
        "run" => {
            let (job, material) = shared.session().begin(Work::of(&said)?)?;
            let shared = shared.clone();
            std::thread::spawn(move || {
                let outcome = material.work(&job.work, &job.progress);
                shared.session().end(outcome);
            });
        }
        "open" => shared.session().open_model(text("model")?)?,
        "data" => {
            let names: Vec<String> = list("files").iter().filter_map(|own| own.as_str().map(str::to_string)).collect();
            let of_reading = ["columns", "decimal", "header", "sheet", "as_typed"];
            let is_said = of_reading.iter().any(|key| said.get(key).is_some());
            let reading = is_said.then(|| Session::reading(&said)).transpose()?;
            shared.session().open_data(&names, reading)?;
        }
        "set" => shared.session().set(text("path")?, text("text")?)?,
        "add" => shared.session().add(text("effect")?)?,
        "row" => {
            let cells = said["cells"].as_object().into_iter().flatten();
            let cells: Vec<(String, String)> =
                cells.filter_map(|(key, own)| Some((key.clone(), own.as_str()?.to_string()))).collect();
            let number = || said["number"].as_u64().map(|own| own as usize);
            let row = match (text("what")?, number()) {
                ("copy", Some(number)) => Row::Copy(number),
                ("remove", Some(number)) => Row::Remove(number),
                ("add", _) => Row::Add(&cells),
                _ => return Err(Refusal::new("that is nothing to be done with a list", "copy, remove or add")),
            };
            shared.session().row(text("path")?, row)?;
        }
        "write" => {
            let names = shared.session().write_correction(text("as")?)?;
            return Ok(json!({ "names": names, "version": shared.session().version() }));
        }
        "remove" => shared.session().remove(text("effect")?)?,
        "strike" => {
            let rows: Vec<usize> = list("rows").iter().filter_map(|own| Some(own.as_u64()? as usize)).collect();
            shared.session().strike(&rows, said["is_struck"].as_bool().unwrap_or(true))?;
        }
        "readings" => shared.session().readings(text("csv")?)?,
        "resume" => shared.session().resume()?,
        "forget" => shared.session().forget()?,
        "undo" => shared.session().undo()?,
        "redo" => shared.session().redo()?,
        "stop" => shared.session().stop()?,
        "save" => {
            let name = shared.session().save(said["as"].as_str())?;
            return Ok(json!({ "name": name, "version": shared.session().version() }));
        }
        _ => return Err(Refusal::new(format!("`{verb}` is nothing to be asked for"), "ask as the page does")),
    }
    // What was answered is kept.
    let mut session = shared.session();
    session.keep();
    Ok(json!({ "version": session.version() }))
}
