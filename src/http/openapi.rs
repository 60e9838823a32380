//! The `OpenAPI` 3.1 document, made of the routes.

use super::routes;
use utoipa::openapi::schema::AdditionalProperties;
use utoipa::openapi::security::{Http, HttpAuthScheme, SecurityScheme};
use utoipa::openapi::{RefOr, Schema};
use utoipa::{Modify, OpenApi};
use utoipa_axum::router::OpenApiRouter;

/// The document without its routes.
#[derive(OpenApi)]
#[openapi(
    info(
        title = "Seamster",
        description = "Garment sewing without a screen: patterns (DXF, GarmentCode) and seams in, a garment draped on a body out.\n\nLengths are in metres, times in seconds, angles in degrees. Every answer that is no success is a `Problem` (RFC 9457) that lists all faults at once.",
        license(name = "MIT", identifier = "MIT")
    ),
    components(schemas(crate::progress::Progress, crate::export::View)),
    security(("token" = []), ())
)]
struct Document;

/// Returns the `OpenAPI` document, as `api/openapi.json` has it.
pub fn openapi_json() -> String {
    let mut document = OpenApiRouter::with_openapi(Document::openapi())
        .merge(routes::resources())
        .merge(routes::probes())
        .merge(routes::metrics())
        .into_openapi();
    let modifiers: [&dyn Modify; 4] = [
        &TokenScheme,
        &ClosedPlaces,
        &FlatSuggestedSeam,
        &PrefixedOperationIds,
    ];
    for modifier in modifiers {
        modifier.modify(&mut document);
    }
    let json = document.to_pretty_json();
    json.expect("a document of strings always serializes") + "\n"
}

/// Adds the security scheme; a service without tokens needs none.
struct TokenScheme;

impl Modify for TokenScheme {
    fn modify(&self, document: &mut utoipa::openapi::OpenApi) {
        let scheme = SecurityScheme::Http(Http::new(HttpAuthScheme::Bearer));
        let components = document.components.get_or_insert_default();
        components.add_security_scheme("token", scheme);
    }
}

/// Forbids further fields of places, which are told apart by their fields. The derive does so for
/// structs, not for variants.
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

/// Writes the schema of a suggested seam in one piece: it has the fields of a seam and more, but a
/// seam is closed.
struct FlatSuggestedSeam;

impl Modify for FlatSuggestedSeam {
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

/// Puts the resource before the names of operations, which must differ: handlers of different
/// resources have the same.
struct PrefixedOperationIds;

impl Modify for PrefixedOperationIds {
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
