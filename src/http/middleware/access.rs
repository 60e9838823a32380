//! Access control: the `Host` of a request, the `Origin` of a page, the bearer token.

use crate::http::connection::Client;
use crate::http::respond::Problem;
use crate::http::state::AppState;
use axum::extract::{Request, State};
use axum::http::{Method, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

/// Refuses hosts that are not of this service (a page that had its own name point here), and
/// writing calls from foreign pages.
pub(in crate::http) async fn require_own_site(
    State(state): State<AppState>,
    request: Request,
    next: Next,
) -> Response {
    if request.headers().get_all(header::HOST).iter().count() > 1 {
        return Problem::two_hosts().into_response();
    }
    let host = requested_host(&request);
    if !state.access.is_own_host(host) {
        return Problem::misdirected(host).into_response();
    }
    let writes = !matches!(
        *request.method(),
        Method::GET | Method::HEAD | Method::OPTIONS
    );
    let origin = request.headers().get(header::ORIGIN);
    if let Some(origin) = origin.map(|origin| origin.to_str().unwrap_or("?"))
        && writes
        && !is_same_origin(origin, host)
    {
        return Problem::foreign_origin(origin).into_response();
    }
    next.run(request).await
}

/// Finds the client of a request, once for all who need to know it.
pub(in crate::http) async fn identify_client(
    State(state): State<AppState>,
    mut request: Request,
    next: Next,
) -> Response {
    let client = state.access.client(request.headers());
    request.extensions_mut().insert(client);
    next.run(request).await
}

/// Refuses calls without a token, if the service has any.
pub(in crate::http) async fn require_token(
    State(state): State<AppState>,
    request: Request,
    next: Next,
) -> Response {
    if state.access.is_authorized(Client::of(request.extensions())) {
        next.run(request).await
    } else {
        Problem::unauthorized().into_response()
    }
}

/// Returns the host that a request names.
fn requested_host(request: &Request) -> &str {
    // HTTP/1.1 with an absolute target names the host there, and that goes before the header (RFC
    // 9112, 3.2.2).
    let target = request
        .uri()
        .authority()
        .map(|authority| authority.as_str());
    let header = || request.headers().get(header::HOST)?.to_str().ok();
    target.or_else(header).unwrap_or_default()
}

/// Returns true if `origin` is a page of `host`. The scheme is not compared: a proxy may speak TLS
/// for us.
fn is_same_origin(origin: &str, host: &str) -> bool {
    origin
        .split_once("://")
        .is_some_and(|(_, authority)| authority.eq_ignore_ascii_case(host))
}

#[cfg(test)]
mod tests {
    use super::*;

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
