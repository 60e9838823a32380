//! The body of `POST /v1/avatars`: measurements, or the file of a body, alone or in a form with its
//! landmarks.

use super::body::{content_type, read_body};
use super::invalid::missing_part;
use super::json::ValidatedJson;
use super::upload::{Upload, read_form};
use crate::fault::{AvatarCode, Fault};
use crate::http::respond::Problem;
use crate::http::state::AppState;
use crate::job::AvatarRequest;
use crate::scene::{BodyImportOptions, BodyUnits, FileAxis};
use axum::extract::{FromRequest, Request};
use serde::Deserialize;
use std::collections::BTreeMap;
use utoipa::IntoParams;

/// Types of the file of a body; what it is, its first bytes tell.
const FILES: [&str; 5] = [
    "model/obj",
    "model/gltf-binary",
    "model/ply",
    "model/x-ply",
    "application/octet-stream",
];
/// Most bytes of the landmarks of a body.
const LANDMARK_BYTES: usize = 64 << 10;

/// Facts about the file of a body that its shape would tell else.
#[derive(Clone, Debug, Default, Deserialize, IntoParams)]
#[serde(default, deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(in crate::http) struct BodyQuery {
    /// Unit of the coordinates; by the height of a person if absent.
    #[param(inline)]
    pub(in crate::http) units: Option<BodyUnits>,
    /// Axis of the file that points up, `y` or `-z`; from feet to head if absent.
    #[param(inline)]
    pub(in crate::http) up: Option<FileAxis>,
    /// Axis of the file that the body faces; as the feet point if absent.
    #[param(inline)]
    pub(in crate::http) facing: Option<FileAxis>,
}

impl BodyQuery {
    /// Returns the options of the import of a file with these landmarks.
    pub(in crate::http) fn options(
        self,
        landmarks: BTreeMap<String, [f64; 3]>,
    ) -> BodyImportOptions {
        BodyImportOptions {
            units: self.units,
            up: self.up,
            facing: self.facing,
            landmarks,
        }
    }
}

/// The file of a body.
pub(in crate::http) struct BodyUpload {
    /// The file.
    pub(in crate::http) file: Upload,
    /// Landmarks in the file's coordinates.
    pub(in crate::http) landmarks: BTreeMap<String, [f64; 3]>,
}

/// An avatar that is to be kept.
pub(in crate::http) enum AvatarUpload {
    /// A dress form.
    Form(AvatarRequest),
    /// A body from a file.
    Body(BodyUpload),
}

impl FromRequest<AppState> for AvatarUpload {
    type Rejection = Problem;

    async fn from_request(request: Request, state: &AppState) -> Result<Self, Problem> {
        let essence = content_type(request.headers());
        let max_bytes = state.limits().body_bytes;
        if FILES.contains(&&*essence) {
            let file = Upload {
                bytes: read_body(state, request, max_bytes).await?,
                name: None,
            };
            return Ok(Self::Body(BodyUpload {
                file,
                landmarks: BTreeMap::new(),
            }));
        }
        if essence != "multipart/form-data" {
            let ValidatedJson(form, _) = ValidatedJson::from_request(request, state).await?;
            return Ok(Self::Form(form));
        }
        let names = ["file", "landmarks"];
        let [file, landmarks] =
            read_form(state, request, max_bytes + LANDMARK_BYTES, names).await?;
        let file = file.ok_or_else(|| missing_part("file"))?;
        let landmarks = landmarks.map_or(Ok(BTreeMap::new()), |part| read_landmarks(&part));
        Ok(Self::Body(BodyUpload {
            file: file.within(max_bytes)?,
            landmarks: landmarks?,
        }))
    }
}

fn read_landmarks(part: &Upload) -> Result<BTreeMap<String, [f64; 3]>, Fault> {
    let wrong = |detail: String| {
        let fault = Fault::new(AvatarCode::Landmark, "/landmarks", detail);
        fault.fix(
            "give an object of points in the file's own coordinates: {\"crotch\": [0, 0.78, 0.02]}",
        )
    };
    if part.bytes.len() > LANDMARK_BYTES {
        return Err(wrong(format!(
            "the part has more than {LANDMARK_BYTES} bytes"
        )));
    }
    serde_json::from_slice(&part.bytes)
        .map_err(|error| wrong(format!("the part is no object of points: {error}")))
}
