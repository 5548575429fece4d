//! Who gets in, and what every answer carries: a page that is served to this computer alone.

use std::io;
use std::net::{Ipv4Addr, SocketAddr};

use axum::body::Bytes;
use axum::http::header::{
    CACHE_CONTROL, CONTENT_SECURITY_POLICY, CONTENT_TYPE, HOST, HeaderName, ORIGIN, REFERRER_POLICY,
    X_CONTENT_TYPE_OPTIONS, X_FRAME_OPTIONS,
};
use axum::http::{HeaderMap, HeaderValue, StatusCode};
use axum::response::{IntoResponse, Response};
use tokio::net::TcpListener;

/// Names by which a browser of this computer asks for the page.
#[derive(Clone)]
pub struct Gate([String; 2]);

impl Gate {
    /// Begins to listen, on any free port where that is 0.
    ///
    /// # Errors
    /// The port cannot be had.
    pub async fn open(port: u16) -> io::Result<(TcpListener, Self, u16)> {
        let listener = TcpListener::bind(SocketAddr::from((Ipv4Addr::LOCALHOST, port))).await?;
        let port = listener.local_addr()?.port();
        Ok((listener, Self(["127.0.0.1", "localhost"].map(|name| format!("{name}:{port}"))), port))
    }

    /// Whether a question comes from a page of this server, or from nobody's. A page of another site that sends its
    /// readers here, by whatever name, gets nothing.
    pub fn admits(&self, headers: &HeaderMap) -> bool {
        let text = |name: HeaderName| headers.get(name).map(|value| value.to_str().unwrap_or_default());
        let is_own = |host: &str| self.0.iter().any(|own| own == host);
        let is_from_here = text(ORIGIN).is_none_or(|from| from.strip_prefix("http://").is_some_and(is_own));
        // Of two names nobody says which one others on the way have gone by.
        let is_one = headers.get_all(HOST).iter().count() == 1;
        is_one && text(HOST).is_some_and(is_own) && is_from_here
    }
}

/// An answer of a kind, under a policy of what a page of it may ask for.
pub fn guarded(status: StatusCode, kind: &'static str, policy: &'static str, body: impl Into<Bytes>) -> Response {
    let mut response = (status, [(CONTENT_TYPE, kind)], body.into()).into_response();
    for (name, value) in [
        (CONTENT_SECURITY_POLICY, policy),
        (CACHE_CONTROL, "no-store"),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (X_FRAME_OPTIONS, "DENY"),
        (REFERRER_POLICY, "no-referrer"),
    ] {
        response.headers_mut().insert(name, HeaderValue::from_static(value));
    }
    response
}
