//! Who may call: the `Host` that is asked for, the `Origin` of a page, the bearer token.

use super::problem::Problem;
use super::state::App;
use axum::extract::{Request, State};
use axum::http::{HeaderMap, Method, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use sha2::{Digest, Sha256};
use std::net::IpAddr;

/// What is known of those who may call.
#[derive(Debug)]
pub(super) struct Guard {
    hosts: Vec<String>,
    /// SHA-256 of each token: digests have one length, so that comparing them takes one time.
    tokens: Vec<[u8; 32]>,
}

impl Guard {
    /// Answers for loopback and `hosts`; without `tokens` everyone may call.
    pub(super) fn new(hosts: &[String], tokens: &[String]) -> Self {
        Self {
            hosts: hosts.iter().map(|host| host.to_lowercase()).collect(),
            tokens: tokens.iter().map(|token| digest(token)).collect(),
        }
    }

    fn answers_for(&self, host: &str) -> bool {
        let name = host_name(host).to_lowercase();
        let bare = name.trim_start_matches('[').trim_end_matches(']');
        bare == "localhost"
            || bare
                .parse()
                .is_ok_and(|ip: IpAddr| ip.to_canonical().is_loopback())
            || self
                .hosts
                .iter()
                .any(|known| *known == name || *known == host.to_lowercase())
    }

    fn lets_in(&self, headers: &HeaderMap) -> bool {
        if self.tokens.is_empty() {
            return true;
        }
        let Some(token) = bearer(headers) else {
            return false;
        };
        let asked = digest(token);
        // Every token is compared to its last byte: the time says nothing about how near a guess was.
        self.tokens.iter().fold(false, |found, known| {
            let differing = known.iter().zip(asked).fold(0, |sum, (a, b)| sum | (a ^ b));
            found | (differing == 0)
        })
    }
}

fn digest(token: &str) -> [u8; 32] {
    Sha256::digest(token).into()
}

fn bearer(headers: &HeaderMap) -> Option<&str> {
    let value = headers.get(header::AUTHORIZATION)?.to_str().ok()?;
    let (scheme, token) = value.split_once(' ')?;
    scheme
        .eq_ignore_ascii_case("bearer")
        .then_some(token.trim())
}

/// A host without its port.
fn host_name(host: &str) -> &str {
    match host.rsplit_once(':') {
        Some((name, port)) if port.bytes().all(|byte| byte.is_ascii_digit()) => name,
        _ => host,
    }
}

fn host(request: &Request) -> &str {
    // HTTP/1.1 with an absolute target names the host there, and that goes before the header (RFC 9112, 3.2.2).
    let target = request
        .uri()
        .authority()
        .map(|authority| authority.as_str());
    let header = || request.headers().get(header::HOST)?.to_str().ok();
    target.or_else(header).unwrap_or_default()
}

/// Refuses hosts that are not this service's (a page that had its own name point here), and writing calls from foreign pages.
pub(super) async fn same_site(State(app): State<App>, request: Request, next: Next) -> Response {
    let host = host(&request);
    if !app.guard.answers_for(host) {
        return Problem::misdirected(host).into_response();
    }
    let writes = !matches!(
        *request.method(),
        Method::GET | Method::HEAD | Method::OPTIONS
    );
    if let Some(origin) = request.headers().get(header::ORIGIN)
        && writes
        && !is_same_origin(origin.to_str().unwrap_or("?"), host)
    {
        return Problem::foreign_origin(origin.to_str().unwrap_or("?")).into_response();
    }
    next.run(request).await
}

/// Whether `origin` is a page of `host`. The scheme is not compared: a proxy may speak TLS for us.
fn is_same_origin(origin: &str, host: &str) -> bool {
    origin
        .split_once("://")
        .is_some_and(|(_, authority)| authority.eq_ignore_ascii_case(host))
}

/// Refuses calls without a token, if there are any.
pub(super) async fn token(State(app): State<App>, request: Request, next: Next) -> Response {
    if app.guard.lets_in(request.headers()) {
        next.run(request).await
    } else {
        Problem::unauthorized().into_response()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use axum::http::HeaderValue;

    #[test]
    fn loopback_and_configured_names_are_answered_for() {
        let guard = Guard::new(&["Sew.example".to_owned()], &[]);
        for host in [
            "localhost",
            "LOCALHOST:80",
            "127.0.0.1:1",
            "127.1.2.3",
            "[::1]:8737",
            "sew.example:443",
            "[::ffff:127.0.0.1]:1",
        ] {
            assert!(guard.answers_for(host), "{host}");
        }
        for host in [
            "",
            "evil.example",
            "localhost.evil.example",
            "sew.example.evil",
            "10.0.0.1",
            "127.0.0.1.evil",
        ] {
            assert!(!guard.answers_for(host), "{host}");
        }
    }

    #[test]
    fn only_the_whole_token_lets_in() {
        let guard = Guard::new(&[], &["secret".to_owned(), "other".to_owned()]);
        let lets_in = |value: &str| {
            let mut headers = HeaderMap::new();
            headers.insert(header::AUTHORIZATION, HeaderValue::from_str(value).unwrap());
            guard.lets_in(&headers)
        };
        assert!(lets_in("Bearer secret"));
        assert!(lets_in("bearer other"));
        for wrong in [
            "Bearer secre",
            "Bearer secrets",
            "Bearer ",
            "Basic secret",
            "secret",
        ] {
            assert!(!lets_in(wrong), "{wrong}");
        }
        assert!(!guard.lets_in(&HeaderMap::new()));
    }

    #[test]
    fn an_origin_is_the_same_with_the_same_port_only() {
        assert!(is_same_origin("http://localhost:8737", "localhost:8737"));
        for foreign in [
            "http://localhost:1",
            "https://evil.example",
            "null",
            "http://localhost:8737.evil",
        ] {
            assert!(!is_same_origin(foreign, "localhost:8737"), "{foreign}");
        }
    }
}
