//! The page, the API's own page, and the files they need, embedded: they work with no internet.

use crate::http::respond::{Problem, Representation};
use crate::http::state::AppState;
use axum::Router;
use axum::extract::Request;
use axum::http::{HeaderMap, HeaderValue, Method, StatusCode, Uri, header};
use axum::middleware::{Next, from_fn};
use axum::response::{IntoResponse, Response};
use rust_embed::{Embed, EmbeddedFile};
use sha2::{Digest, Sha256};
use utoipa_swagger_ui::{Config, SwaggerUi};

/// Files of the page itself. A star matches across folders.
#[derive(Embed)]
#[folder = "static/"]
#[include = "*.html"]
#[include = "*.js"]
#[include = "*.css"]
#[include = "*.svg"]
#[include = "samples/*"]
#[exclude = "node_modules/*"]
struct PageFiles;

/// The page's one dependency: only what it loads.
#[derive(Embed)]
#[folder = "static/node_modules/three/"]
#[include = "LICENSE"]
#[include = "build/three.module.min.js"]
#[include = "build/three.core.min.js"]
#[include = "examples/jsm/controls/OrbitControls.js"]
#[include = "examples/jsm/loaders/GLTFLoader.js"]
#[include = "examples/jsm/utils/BufferGeometryUtils.js"]
#[include = "examples/jsm/utils/SkeletonUtils.js"]
#[allow_missing = true]
struct ThreeFiles;

fn embedded(path: &str) -> Option<EmbeddedFile> {
    match path.strip_prefix("node_modules/three/") {
        Some(path) => ThreeFiles::get(path),
        None => PageFiles::get(path),
    }
}

/// Returns the route of the API's page at `/docs`. Swagger UI sets styles from its script.
pub(in crate::http) fn docs_router() -> Router<AppState> {
    Router::new()
        .merge(SwaggerUi::new("/docs").config(Config::from("/openapi.json")))
        .layer(from_fn(docs_policy))
}

async fn docs_policy(request: Request, next: Next) -> Response {
    let policy = "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; \
                  img-src 'self' data:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
    let path = request.uri().path().to_owned();
    let mut response = next.run(request).await;
    if response.status() == StatusCode::NOT_FOUND {
        response = Problem::unknown_path(&path).into_response();
    }
    let policy = HeaderValue::from_static(policy);
    response
        .headers_mut()
        .insert(header::CONTENT_SECURITY_POLICY, policy);
    response
}

/// Returns a file of the page, else that there is nothing here.
pub(in crate::http) async fn file(
    method: Method,
    uri: Uri,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let path = uri.path().trim_start_matches('/');
    let path = if path.is_empty() { "index.html" } else { path };
    let file = embedded(path).ok_or_else(|| Problem::unknown_path(uri.path()))?;
    if method != Method::GET && method != Method::HEAD {
        return Err(Problem::method_not_allowed(method.as_str(), uri.path()));
    }
    let content_type = content_type(path, file.metadata.mimetype());
    let digest = file.metadata.sha256_hash();
    let bytes = file.data.clone().into_owned();
    let mut response =
        Representation::with_digest(bytes, content_type, digest).respond(&headers)?;
    if path.ends_with(".html") {
        let policy = page_policy(&String::from_utf8_lossy(&file.data));
        response
            .headers_mut()
            .insert(header::CONTENT_SECURITY_POLICY, policy);
    }
    Ok(response)
}

fn content_type(path: &str, guessed: &str) -> String {
    if path.ends_with(".dxf") {
        "image/vnd.dxf".to_owned()
    } else if guessed.starts_with("text/") {
        format!("{guessed}; charset=utf-8")
    } else {
        guessed.to_owned()
    }
}

/// Returns the policy that allows what the page uses. An inline import map runs only by its hash.
fn page_policy(html: &str) -> HeaderValue {
    let hashes: String = import_maps(html)
        .map(|map| format!(" 'sha256-{}'", base64(&Sha256::digest(map))))
        .collect();
    let policy = format!(
        "default-src 'none'; script-src 'self'{hashes}; style-src 'self'; img-src 'self' data: blob:; \
         connect-src 'self' blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    );
    policy
        .parse()
        .expect("ASCII without line breaks is a header value")
}

fn import_maps(html: &str) -> impl Iterator<Item = &str> {
    html.split("<script type=\"importmap\">")
        .skip(1)
        .filter_map(|rest| rest.split("</script>").next())
}

/// Encodes bytes by RFC 4648, as policies write hashes.
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for group in bytes.chunks(3) {
        let bits = group
            .iter()
            .fold(0_usize, |bits, byte| bits << 8 | usize::from(*byte))
            << (8 * (3 - group.len()));
        for i in 0..4 {
            let letter = char::from(LETTERS[bits >> (18 - 6 * i) & 63]);
            text.push(if i <= group.len() { letter } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_that_of_the_standard() {
        for (plain, text) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base64(plain.as_bytes()), text);
        }
    }

    #[test]
    fn only_what_the_page_loads_is_embedded() {
        let parts: Vec<_> = ThreeFiles::iter().collect();
        assert_eq!(parts.len(), 7, "{parts:?}");
        for path in &parts {
            assert!(embedded(&format!("node_modules/three/{path}")).is_some());
        }
        assert!(!PageFiles::iter().any(|path| path.contains("node_modules")));
        for path in ["package.json", "node_modules/three/src/utils.js"] {
            assert!(embedded(path).is_none(), "{path}");
        }
    }

    #[test]
    fn an_import_map_is_allowed_by_its_hash_alone() {
        let html = "<script type=\"importmap\">{}</script><script>alert(1)</script>";
        let policy = page_policy(html);
        // printf '{}' | openssl dgst -sha256 -binary | base64
        assert!(
            policy.to_str().unwrap().contains(
                "script-src 'self' 'sha256-RBNvo1WzZ4oRRq0W9+hknpT7T8If536DEMBg9hyq/4o=';"
            )
        );
    }
}
