//! `/openapi.json`: the `OpenAPI` document.

use crate::http::openapi::openapi_json;
use crate::http::respond::{Problem, Representation};
use crate::http::state::AppState;
use axum::Router;
use axum::http::HeaderMap;
use axum::response::Response;
use axum::routing::get;
use std::sync::LazyLock;

/// Returns the route of the document, which does not list itself.
pub(in crate::http) fn router() -> Router<AppState> {
    Router::new().route("/openapi.json", get(document))
}

async fn document(headers: HeaderMap) -> Result<Response, Problem> {
    // Made of the code alone, once.
    static DOCUMENT: LazyLock<Representation> =
        LazyLock::new(|| Representation::new(openapi_json(), "application/json"));
    DOCUMENT.clone().respond(&headers)
}
