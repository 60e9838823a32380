//! `/v1/patterns/{id}/pattern.dxf` and `specification.json`: patterns as files of other programs.

use super::patterns::find;
use crate::export::{PatternFile, pattern_dxf, pattern_specification};
use crate::http::extract::PathId;
use crate::http::respond::{Problem, Representation};
use crate::http::state::AppState;
use crate::pattern::Pattern;
use axum::extract::State;
use axum::http::{HeaderMap, HeaderName, HeaderValue};
use axum::response::Response;
use uuid::Uuid;

/// Header that tells what of a pattern its file leaves out.
const LEFT_OUT: HeaderName = HeaderName::from_static("seamster-left-out");

/// Characters of that header at most; a client may refuse more.
const MOST_CHARS: usize = 2_000;

/// End of a header that was cut.
const CUT: &str = " ...";

/// The pattern as DXF after ANSI/AAMA-292, in millimeters
///
/// A block a piece, with cut and sew line, corners, notches, grain, fold, lines, cut-outs and drill
/// holes on their layers, in the size that was imported. What DXF has no place for is named in
/// comments of the file and in the header `Seamster-Left-Out`.
#[utoipa::path(get, path = "/v1/patterns/{id}/pattern.dxf", tag = "patterns", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The file", content_type = "image/vnd.dxf", body = String,
        headers(("Seamster-Left-Out" = String, description = "What the pattern holds and the file does not; absent where all is written"))),
    (status = 304, description = "It is the one in `If-None-Match`"),
    (status = 404, description = "There is no such pattern", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn aama(
    State(state): State<AppState>,
    PathId(id): PathId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    respond(&state, id, &headers, (pattern_dxf, "image/vnd.dxf")).await
}

/// The pattern as a `GarmentCode` specification, in the unit of its file or in centimeters
///
/// Panels with their curves, stitches and placements where the pattern came with them. What a
/// specification has no place for is named in the header `Seamster-Left-Out`.
#[utoipa::path(get, path = "/v1/patterns/{id}/specification.json", tag = "patterns", params(("id" = Uuid, Path)), responses(
    (status = 200, description = "The file", content_type = "application/json", body = serde_json::Value,
        headers(("Seamster-Left-Out" = String, description = "What the pattern holds and the file does not; absent where all is written"))),
    (status = 304, description = "It is the one in `If-None-Match`"),
    (status = 404, description = "There is no such pattern", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn specification(
    State(state): State<AppState>,
    PathId(id): PathId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    respond(
        &state,
        id,
        &headers,
        (pattern_specification, "application/json"),
    )
    .await
}

/// Writes a pattern by `write`, and answers with what the headers ask for of the file.
async fn respond(
    state: &AppState,
    id: Uuid,
    request: &HeaderMap,
    (write, content_type): (fn(&Pattern) -> PatternFile, &'static str),
) -> Result<Response, Problem> {
    let pattern = find(state, id).await?;
    let make = move |_: &_| {
        let file = write(&pattern);
        let left_out = header_value(&file.left_out);
        (Representation::new(file.text, content_type), left_out)
    };
    let (file, left_out) = state.run_compute(make).await?;
    let mut response = file.respond(request)?;
    if let Some(left_out) = left_out {
        response.headers_mut().insert(LEFT_OUT, left_out);
    }
    Ok(response)
}

/// Returns the sentences as one line of printable ASCII, other characters as `?`; a line that is
/// cut ends with ` ...`.
fn header_value(left_out: &[String]) -> Option<HeaderValue> {
    let ascii = |c: char| if matches!(c, ' '..='~') { c } else { '?' };
    let line = left_out.join("; ");
    let is_cut = line.chars().nth(MOST_CHARS).is_some();
    let taken = MOST_CHARS - if is_cut { CUT.len() } else { 0 };
    let mut line: String = line.chars().take(taken).map(ascii).collect();
    if is_cut {
        line += CUT;
    }
    let value = HeaderValue::from_str(&line).ok();
    value.filter(|_| !left_out.is_empty())
}
