//! `/v1/patterns/{id}/seams`: checks a set of seams, and suggests one.

use super::patterns;
use crate::fault::Faults;
use crate::fit::{self, AssetLibrary, Garment, RequestSchema};
use crate::http::extract::{JsonBody, OptionalJson, PathId, ValidatedJson};
use crate::http::respond::Problem;
use crate::http::state::AppState;
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
    fn schema() -> &'static RequestSchema {
        // Made of the type alone, once.
        static SCHEMA: LazyLock<RequestSchema> = LazyLock::new(RequestSchema::of::<SuggestRequest>);
        &SCHEMA
    }
}

/// Check seams against a pattern: every fault of every seam, and how to mend it
///
/// With an `avatar` it also warns of a garment that is too small for that body.
#[utoipa::path(post, path = "/v1/patterns/{id}/seams/check", tag = "patterns", params(("id" = Uuid, Path)),
    request_body(content = Garment, description = "`{\"seams\": [...]}`, or a whole garment (its `pattern` is not read)"),
    responses(
        (status = 200, description = "What was found, right or wrong", body = SeamCheck),
        (status = 404, description = "There is no such pattern", body = Problem, content_type = "application/problem+json"),
        (status = 422, description = "The request is not a set of seams", body = Problem, content_type = "application/problem+json")))]
pub(super) async fn check(
    State(state): State<AppState>,
    PathId(id): PathId,
    ValidatedJson(garment, memory): ValidatedJson<Garment>,
) -> Result<Json<SeamCheck>, Problem> {
    let pattern = patterns::find(&state, id).await?;
    let checked = state
        .run_compute(move |app| {
            let _memory = memory;
            let mut check = fit::check_seams(&garment, &pattern, app.limits())?;
            if check.ok {
                let assets = (&*app.queue as &dyn AssetLibrary, app.catalogue().bodies());
                let sizes = fit::size_warnings(garment, &pattern, assets, app.limits());
                check.warnings.extend(sizes);
            }
            Ok::<_, Faults>(check)
        })
        .await?;
    Ok(Json(checked?))
}

/// Suggest the seams of a pattern and where its panels start, each seam with how sure it is and why
///
/// The seams are what a garment takes, as they are, and `panels` is what its `panels` takes. Seams
/// of a confidence below 0.5 are offers: `"seams": "suggest"` leaves them out and warns of them,
/// and refuses a garment that has nothing but offers (`seam/none_suggested`). List them to accept
/// them.
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
