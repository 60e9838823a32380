//! Request bodies: JSON checked against its schema, uploads, multipart.

use super::problem::Problem;
use super::seams::SuggestAsked;
use super::state::App;
use crate::config::Limits;
use crate::fault::Fault;
use crate::fit::{self, Garment, Misshapen, Shape};
use crate::job::AvatarRecord;
use crate::scene::Fabric;
use crate::study::{self, StudyAsked};
use axum::body::{Body, Bytes};
use axum::extract::multipart::{MultipartError, MultipartRejection};
use axum::extract::{DefaultBodyLimit, FromRequest, Multipart, Request};
use axum::http::{HeaderMap, header};
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};
use std::sync::LazyLock;
use tokio_stream::StreamExt;

/// Bytes of a small thing as JSON.
const SMALL_BYTES: usize = 64 << 10;
/// Room for what a form puts round its parts \[bytes\].
const FORM_BYTES: usize = 64 << 10;
/// Bytes above a limit that are still read before the refusal: who cuts a client off while it sends keeps it from reading why.
const LINGER_BYTES: usize = 64 << 20;

/// A type that clients send as JSON.
pub(super) trait Asked: DeserializeOwned + Send + 'static {
    /// Reads one, telling all faults of its shape at once.
    fn read(bytes: &[u8]) -> Result<Self, Misshapen>;

    /// Bytes of it at most.
    fn most(limits: &Limits) -> usize;
}

impl Asked for Garment {
    fn read(bytes: &[u8]) -> Result<Self, Misshapen> {
        fit::read_garment(bytes)
    }

    fn most(limits: &Limits) -> usize {
        limits.json_bytes
    }
}

impl Asked for StudyAsked {
    fn read(bytes: &[u8]) -> Result<Self, Misshapen> {
        study::read_study(bytes)
    }

    fn most(limits: &Limits) -> usize {
        limits.json_bytes
    }
}

macro_rules! small {
    ($($type:ty),*) => {$(
        impl Asked for $type {
            fn read(bytes: &[u8]) -> Result<Self, Misshapen> {
                // Made from the type alone, once.
                static SHAPE: LazyLock<Shape> = LazyLock::new(Shape::of::<$type>);
                SHAPE.read(bytes)
            }

            fn most(_: &Limits) -> usize {
                SMALL_BYTES
            }
        }
    )*};
}
small!(AvatarRecord, Fabric, SuggestAsked);

impl From<Misshapen> for Problem {
    fn from(misshapen: Misshapen) -> Self {
        match misshapen {
            Misshapen::Syntax(fault) => Self::unreadable(fault),
            Misshapen::Shape(faults) => faults.into(),
        }
    }
}

/// A JSON body of the right shape.
pub(super) struct Checked<T>(pub(super) T);

impl<T: Asked> FromRequest<App> for Checked<T> {
    type Rejection = Problem;

    async fn from_request(request: Request, app: &App) -> Result<Self, Problem> {
        json_type(request.headers())?;
        let bytes = read(request, T::most(app.limits())).await?;
        let read = app.heavy(move |_| T::read(&bytes)).await?;
        Ok(Self(read?))
    }
}

/// The same with the SHA-256 of what was sent.
pub(super) struct Hashed<T>(pub(super) T, pub(super) [u8; 32]);

impl<T: Asked> FromRequest<App> for Hashed<T> {
    type Rejection = Problem;

    async fn from_request(request: Request, app: &App) -> Result<Self, Problem> {
        json_type(request.headers())?;
        let bytes = read(request, T::most(app.limits())).await?;
        let read = move |_: &_| Ok(Self(T::read(&bytes)?, Sha256::digest(&bytes).into()));
        app.heavy(read).await?
    }
}

/// A JSON body of the right shape, or none at all.
pub(super) struct CheckedOrNone<T>(pub(super) T);

impl<T: Asked + Default> FromRequest<App> for CheckedOrNone<T> {
    type Rejection = Problem;

    async fn from_request(request: Request, app: &App) -> Result<Self, Problem> {
        let typed = json_type(request.headers());
        let bytes = read(request, T::most(app.limits())).await?;
        if bytes.is_empty() {
            return Ok(Self(T::default()));
        }
        typed?;
        let read = app.heavy(move |_| T::read(&bytes)).await?;
        Ok(Self(read?))
    }
}

/// Refuses a body that is not said to be JSON.
pub(super) fn json_type(headers: &HeaderMap) -> Result<(), Problem> {
    let essence = content_type(headers);
    if essence == "application/json" || essence.ends_with("+json") {
        Ok(())
    } else {
        Err(Problem::unsupported_type(&essence, "application/json"))
    }
}

/// The type of the body in small letters, without parameters; empty if it has none.
pub(super) fn content_type(headers: &HeaderMap) -> String {
    let value = headers.get(header::CONTENT_TYPE);
    let value = value.and_then(|value| value.to_str().ok()).unwrap_or("");
    let essence = value.split(';').next().unwrap_or("");
    essence.trim().to_ascii_lowercase()
}

/// A file that was sent.
pub(super) struct Upload {
    /// Its bytes.
    pub(super) bytes: Bytes,
    /// Its name without folders and ending, if it came with one.
    pub(super) name: Option<String>,
}

impl FromRequest<App> for Upload {
    type Rejection = Problem;

    async fn from_request(request: Request, app: &App) -> Result<Self, Problem> {
        let essence = content_type(request.headers());
        let limits = app.limits();
        let most = if essence.ends_with("json") {
            limits.json_bytes
        } else {
            limits.dxf_bytes
        };
        let upload = if essence == "multipart/form-data" {
            let [file] = parts(request, most, ["file"]).await?;
            file.ok_or_else(|| missing_part("file"))?
        } else {
            Self {
                bytes: read(request, most).await?,
                name: None,
            }
        };
        upload.within(most)
    }
}

impl Upload {
    /// Refuses a file of more than `limit` bytes.
    pub(super) fn within(self, limit: usize) -> Result<Self, Problem> {
        if self.bytes.len() > limit {
            let detail = format!("The file is larger than {limit} bytes.");
            return Err(Problem::too_large(detail));
        }
        Ok(self)
    }
}

/// Reads a body of at most `limit` bytes.
pub(super) async fn read(request: Request, limit: usize) -> Result<Bytes, Problem> {
    let length = request.headers().get(header::CONTENT_LENGTH);
    let length = length.and_then(|length| length.to_str().ok()?.parse().ok());
    let asks_first = request.headers().contains_key(header::EXPECT);
    let reads_on = if asks_first { 0 } else { LINGER_BYTES };
    if length > Some(limit + reads_on) {
        return Err(above(limit));
    }
    let mut stream = request.into_body().into_data_stream();
    let (mut bytes, mut total) = (vec![], 0);
    while let Some(chunk) = stream.next().await {
        let chunk = chunk.map_err(broken)?;
        total += chunk.len();
        if total > limit + LINGER_BYTES {
            break;
        }
        if total <= limit {
            bytes.extend_from_slice(&chunk);
        }
    }
    if total > limit {
        return Err(above(limit));
    }
    Ok(bytes.into())
}

fn above(limit: usize) -> Problem {
    Problem::too_large(format!(
        "The body is larger than the {limit} bytes allowed here."
    ))
}

fn broken(why: impl ToString) -> Problem {
    Problem::unreadable(Fault::new("request/body", "", why.to_string()))
}

impl From<MultipartRejection> for Problem {
    fn from(rejection: MultipartRejection) -> Self {
        broken(rejection.body_text())
    }
}

impl From<MultipartError> for Problem {
    fn from(error: MultipartError) -> Self {
        broken(error.body_text())
    }
}

/// The parts of a form of `most` bytes by name; other and repeated parts are refused.
pub(super) async fn parts<const N: usize>(
    request: Request,
    most: usize,
    names: [&str; N],
) -> Result<[Option<Upload>; N], Problem> {
    let mut whole = Request::new(Body::empty());
    *whole.headers_mut() = request.headers().clone();
    *whole.body_mut() = read(request, most + FORM_BYTES).await?.into();
    let limit = DefaultBodyLimit::disable();
    limit.apply(&mut whole);
    let mut form = Multipart::from_request(whole, &()).await?;
    let mut found = [const { None }; N];
    while let Some(field) = form.next_field().await? {
        let name = field.name().unwrap_or_default().to_owned();
        let slot = names.iter().position(|known| *known == name);
        let Some(slot) = slot.filter(|slot| found[*slot].is_none()) else {
            return Err(unexpected_part(&name, &names));
        };
        let name = field.file_name().map(stem);
        let bytes = field.bytes().await?;
        found[slot] = Some(Upload { bytes, name });
    }
    Ok(found)
}

/// The fault of a form without a part that it needs.
pub(super) fn missing_part(name: &str) -> Problem {
    let detail = format!("the form has no part {name:?}");
    Fault::new("request/missing_part", format!("/{name}"), detail).into()
}

fn unexpected_part(name: &str, names: &[&str]) -> Problem {
    let detail = format!("the part {name:?} is not expected here, or came twice");
    Fault::new("request/unexpected_part", format!("/{name}"), detail)
        .fix(format!("the parts are {}", names.join(", ")))
        .into()
}

/// `C:\work\skirt.v2.dxf` -> `skirt.v2`.
fn stem(file_name: &str) -> String {
    let name = file_name.rsplit(['/', '\\']).next().unwrap_or_default();
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    stem.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shape_can_be_made() {
        assert!(Garment::read(br#"{"seams": []}"#).is_ok());
        assert!(AvatarRecord::read(b"[]").is_err());
        assert!(Fabric::read(b"[]").is_err());
        assert!(SuggestAsked::read(b"{}").is_ok());
        assert!(StudyAsked::read(br#"{"garment": {"seams": []}}"#).is_ok());
    }

    #[test]
    fn a_name_loses_its_folders_and_ending() {
        assert_eq!(stem("C:\\work\\skirt.v2.dxf"), "skirt.v2");
        assert_eq!(stem("../../etc/passwd"), "passwd");
        assert_eq!(stem("skirt"), "skirt");
    }
}
