//! `/v1/patterns/{id}/seams`: checks a set of seams, and suggests one.

use super::patterns;
use crate::fault::{Fault, Faults, RequestCode, SeamCode};
use crate::fit::{self, Garment, Misshapen, SeamsAsked, Shape};
use crate::http::extract::{JsonBody, OptionalJson, PathId, ValidatedJson};
use crate::http::respond::Problem;
use crate::http::state::{App, AppState};
use crate::pattern::{Pattern, SeamPair};
use crate::seam::SeamCheck;
use crate::seam::suggest::{self, Suggestion};
use axum::Json;
use axum::extract::State;
use serde::Deserialize;
use std::sync::LazyLock;
use utoipa::ToSchema;

/// The wishes for suggestions: there are none yet.
#[derive(Clone, Copy, Debug, Default, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
#[schema(as = SuggestAsked)]
pub(super) struct SuggestRequest {}

impl JsonBody for SuggestRequest {
    fn read(bytes: &[u8]) -> Result<Self, Misshapen> {
        // Made of the type alone, once.
        static SHAPE: LazyLock<Shape> = LazyLock::new(Shape::of::<SuggestRequest>);
        SHAPE.read(bytes)
    }
}

/// Check seams against a pattern: every fault of every seam, and how to mend it
#[utoipa::path(post, path = "/v1/patterns/{id}/seams/check", tag = "patterns", params(("id" = Uuid, Path)),
    request_body(content = Garment, description = "`{\"seams\": [...]}`, or a whole garment (its `pattern` is not read)"),
    responses(
        (status = 200, description = "What was found, right or wrong", body = SeamCheck),
        (status = 404, description = "There is no such pattern", body = Problem, content_type = "application/problem+json"),
        (status = 422, description = "The request is not a set of seams", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn check(
    State(state): State<AppState>,
    PathId(id): PathId,
    ValidatedJson(garment): ValidatedJson<Garment>,
) -> Result<Json<SeamCheck>, Problem> {
    let pattern = patterns::find(&state, id).await?;
    let checked = state
        .run_compute(move |app| check_garment(app, &pattern, &garment))
        .await?;
    Ok(Json(checked?))
}

/// Suggest the seams of a pattern and where its panels start, each seam with how sure it is and why
///
/// The seams are what a garment takes, as they are, and `panels` is what its `panels` takes.
#[utoipa::path(post, path = "/v1/patterns/{id}/seams/suggest", tag = "patterns", params(("id" = Uuid, Path)),
    request_body(content = Option<SuggestRequest>, description = "`{}`, or nothing"),
    responses(
        (status = 200, description = "What was found; no seams where no panel was recognised", body = Suggestion),
        (status = 404, description = "There is no such pattern", body = Problem, content_type = "application/problem+json"),
        (status = 422, description = "The request has fields that are not known", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn suggest(
    State(state): State<AppState>,
    PathId(id): PathId,
    OptionalJson(SuggestRequest {}): OptionalJson<SuggestRequest>,
) -> Result<Json<Suggestion>, Problem> {
    let pattern = patterns::find(&state, id).await?;
    let found = state.run_compute(move |app| suggest::suggest(&pattern, app.limits()));
    Ok(Json(found.await?))
}

fn check_garment(app: &App, pattern: &Pattern, garment: &Garment) -> Result<SeamCheck, Faults> {
    let pairs = pairs(garment)?;
    let edge_length = edge_length(app, garment)?;
    let whole = fit::with_copies(garment, pattern);
    let pattern = fit::without_allowances(garment, whole)?;
    let (check, set) = fit::check_seams(garment, &pattern, pairs, (edge_length, app.limits()));
    match set {
        // Faults that are in no finding concern the request as a whole.
        Err(faults) if check.seams.iter().all(|seam| seam.errors.is_empty()) => Err(faults),
        _ => Ok(check),
    }
}

fn pairs(garment: &Garment) -> Result<&[SeamPair], Fault> {
    match &garment.seams {
        SeamsAsked::Pairs(pairs) => Ok(pairs),
        SeamsAsked::Word(_) => {
            let detail = "suggested seams have nothing to check";
            Err(Fault::new(SeamCode::NothingToCheck, "/seams", detail)
                .fix("give the list of seams; POST seams/suggest finds one"))
        }
    }
}

fn edge_length(app: &App, garment: &Garment) -> Result<f64, Fault> {
    let [low, high] = app.limits().edge_length_m;
    let length = garment.simulate.edge_length_m;
    if (low..=high).contains(&length) {
        return Ok(length);
    }
    let detail = format!("the edge length is {length} m; it must be from {low} to {high} m");
    Err(Fault::new(
        RequestCode::OutOfRange,
        "/simulate/edge_length_m",
        detail,
    ))
}
