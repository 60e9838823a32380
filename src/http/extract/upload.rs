//! Files that are sent: as the whole body, or as parts of a form.

use super::body::{content_type, keep_part, read_body};
use super::invalid::{missing_part, unexpected_part};
use crate::http::connection::Client;
use crate::http::respond::Problem;
use crate::http::state::AppState;
use axum::body::{Body, Bytes};
use axum::extract::{DefaultBodyLimit, FromRequest, Multipart, Request};

/// Bytes for what a form puts round its parts.
const FORM_BYTES: usize = 64 << 10;

/// A file that was sent.
pub(in crate::http) struct Upload {
    /// Its bytes.
    pub(in crate::http) bytes: Bytes,
    /// Its name without folders and ending, if it came with one.
    pub(in crate::http) name: Option<String>,
}

/// A pattern file, and the grade rule table beside it.
pub(in crate::http) struct PatternUpload {
    /// The pattern.
    pub(in crate::http) file: Upload,
    /// The table, if one was sent.
    pub(in crate::http) grading: Option<Upload>,
}

impl FromRequest<AppState> for PatternUpload {
    type Rejection = Problem;

    async fn from_request(request: Request, state: &AppState) -> Result<Self, Problem> {
        let essence = content_type(request.headers());
        let limits = state.limits();
        let max_bytes = if essence.ends_with("json") {
            limits.json_bytes
        } else {
            limits.dxf_bytes
        };
        let [file, grading] = if essence == "multipart/form-data" {
            read_form(state, request, 2 * max_bytes, ["file", "grading"]).await?
        } else {
            let bytes = read_body(state, request, max_bytes).await?;
            [Some(Upload { bytes, name: None }), None]
        };
        let file = file.ok_or_else(|| missing_part("file"))?;
        Ok(Self {
            file: file.within(max_bytes)?,
            grading: grading.map(|part| part.within(max_bytes)).transpose()?,
        })
    }
}

impl Upload {
    /// Refuses a file of more than `limit` bytes.
    pub(super) fn within(self, limit: usize) -> Result<Self, Problem> {
        if self.bytes.len() > limit {
            return Err(Problem::file_too_large(limit));
        }
        Ok(self)
    }
}

/// Reads the parts of a form by name, together at most `max_bytes`; other and repeated parts are
/// refused.
pub(super) async fn read_form<const N: usize>(
    state: &AppState,
    request: Request,
    max_bytes: usize,
    names: [&str; N],
) -> Result<[Option<Upload>; N], Problem> {
    let mut whole = Request::new(Body::empty());
    *whole.headers_mut() = request.headers().clone();
    let client = Client::of(request.extensions());
    *whole.body_mut() = read_body(state, request, max_bytes + FORM_BYTES)
        .await?
        .into();
    DefaultBodyLimit::disable().apply(&mut whole);
    let mut form = Multipart::from_request(whole, &()).await?;
    let mut parts = [const { None }; N];
    while let Some(field) = form.next_field().await? {
        let name = field.name().unwrap_or_default().to_owned();
        let slot = names.iter().position(|known| *known == name);
        let Some(slot) = slot.filter(|slot| parts[*slot].is_none()) else {
            return Err(unexpected_part(&name, &names).into());
        };
        let name = field.file_name().map(file_stem);
        let bytes = keep_part(state, client, field.bytes().await?)?;
        parts[slot] = Some(Upload { bytes, name });
    }
    Ok(parts)
}

/// Returns a file name without its folders and ending: `C:\work\skirt.v2.dxf` -> `skirt.v2`.
fn file_stem(file_name: &str) -> String {
    let name = file_name.rsplit(['/', '\\']).next().unwrap_or_default();
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    stem.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_loses_its_folders_and_ending() {
        assert_eq!(file_stem("C:\\work\\skirt.v2.dxf"), "skirt.v2");
        assert_eq!(file_stem("../../etc/passwd"), "passwd");
        assert_eq!(file_stem("skirt"), "skirt");
    }
}
