//! The `OpenAPI` 3.1 document, made from the code.

use super::answer::Answer;
use super::problem::Problem;
use super::state::App;
use super::{avatars, events, fabrics, fits, health, metrics, patterns, results, seams, studies};
use crate::fit::Garment;
use axum::Router;
use axum::http::HeaderMap;
use axum::response::Response;
use axum::routing::get;
use std::sync::LazyLock;
use utoipa::openapi::schema::AdditionalProperties;
use utoipa::openapi::security::{Http, HttpAuthScheme, SecurityScheme};
use utoipa::openapi::{RefOr, Schema};
use utoipa::{Modify, OpenApi, ToSchema};

pub(super) fn router() -> Router<App> {
    Router::new().route("/openapi.json", get(openapi))
}

#[derive(OpenApi)]
#[openapi(
    info(
        title = "Seamster",
        description = "Garment sewing without a screen: patterns (DXF, GarmentCode) and seams in, a garment draped on a body out.\n\nLengths are in metres, times in seconds, angles in degrees. Every answer that is no success is a `Problem` (RFC 9457) that lists all faults at once.",
        license(name = "MIT", identifier = "MIT")
    ),
    paths(
        patterns::create, patterns::list, patterns::show, patterns::drawing, patterns::remove, seams::check, seams::suggest,
        fabrics::list, fabrics::create, fabrics::show,
        avatars::create, avatars::list, avatars::show, avatars::remove, avatars::mesh,
        fits::create, fits::list, fits::show, fits::cancel, events::fit_events,
        results::mesh, results::mesh_glb, results::mesh_obj, results::mesh_json,
        results::report, results::scene, results::garment,
        studies::create, studies::list, studies::show, studies::cancel, studies::plot, studies::asked, events::study_events,
        health::live, health::ready, metrics::metrics,
    ),
    components(schemas(crate::progress::Progress)),
    security(("token" = []), ()),
    modifiers(&Token, &ClosedPlaces, &WholeSuggestedSeam, &OwnNames)
)]
struct Document;

/// The security scheme; a service without tokens needs none.
struct Token;

impl Modify for Token {
    fn modify(&self, document: &mut utoipa::openapi::OpenApi) {
        let scheme = SecurityScheme::Http(Http::new(HttpAuthScheme::Bearer));
        let components = document.components.get_or_insert_default();
        components.add_security_scheme("token", scheme);
    }
}

/// Places are told apart by their fields: each has these and no others. The derive says so of structs, not of variants.
struct ClosedPlaces;

impl Modify for ClosedPlaces {
    fn modify(&self, document: &mut utoipa::openapi::OpenApi) {
        let schemas = document.components.as_mut().map(|all| &mut all.schemas);
        let place = schemas.and_then(|all| all.get_mut("Place"));
        let Some(RefOr::T(Schema::OneOf(places))) = place else {
            return;
        };
        for item in &mut places.items {
            if let RefOr::T(Schema::Object(object)) = item
                && !object.properties.is_empty()
            {
                object.additional_properties =
                    Some(Box::new(AdditionalProperties::FreeForm(false)));
            }
        }
    }
}

/// A suggested seam has the fields of a seam and more, but a seam is closed: it has to be said in one piece.
struct WholeSuggestedSeam;

impl Modify for WholeSuggestedSeam {
    fn modify(&self, document: &mut utoipa::openapi::OpenApi) {
        let Some(all) = document.components.as_mut().map(|all| &mut all.schemas) else {
            return;
        };
        let pair = all.get("SeamPair").cloned();
        let suggested = all.get_mut("SuggestedSeam");
        let (Some(RefOr::T(Schema::Object(pair))), Some(RefOr::T(Schema::AllOf(parts)))) =
            (pair, suggested.as_deref().cloned())
        else {
            return;
        };
        let mut whole = pair;
        whole.description = parts.description;
        for part in parts.items {
            if let RefOr::T(Schema::Object(own)) = part {
                whole.properties.extend(own.properties);
                whole.required.extend(own.required);
            }
        }
        if let Some(suggested) = suggested {
            *suggested = RefOr::T(Schema::Object(whole));
        }
    }
}

/// The names of operations must differ, and handlers of different resources have the same: the resource goes before.
struct OwnNames;

impl Modify for OwnNames {
    fn modify(&self, document: &mut utoipa::openapi::OpenApi) {
        for calls in document.paths.paths.values_mut() {
            let calls = [&mut calls.get, &mut calls.post, &mut calls.delete];
            for call in calls.into_iter().flatten() {
                let resource = call.tags.iter().flatten().next();
                let names = resource.zip(call.operation_id.as_ref());
                call.operation_id = names.map(|(resource, name)| format!("{resource}_{name}"));
            }
        }
    }
}

/// A form with a pattern file.
#[derive(ToSchema)]
#[expect(dead_code, reason = "only its description is used")]
pub(super) struct PatternForm {
    /// The DXF or the `GarmentCode` specification.
    #[schema(value_type = String, format = Binary)]
    file: Vec<u8>,
}

/// A form with a pattern file and a garment.
#[derive(ToSchema)]
#[expect(dead_code, reason = "only its description is used")]
pub(super) struct FitForm {
    /// The DXF.
    #[schema(value_type = String, format = Binary)]
    pattern: Vec<u8>,
    /// The garment, without `pattern`.
    garment: Garment,
}

/// The `OpenAPI` document, as `api/openapi.json` has it.
pub fn openapi_json() -> String {
    let json = Document::openapi().to_pretty_json();
    json.expect("a document of strings always serialises") + "\n"
}

async fn openapi(headers: HeaderMap) -> Result<Response, Problem> {
    // Made from the code alone, once.
    static JSON: LazyLock<String> = LazyLock::new(openapi_json);
    Answer::new(JSON.as_bytes(), "application/json").to(&headers)
}
