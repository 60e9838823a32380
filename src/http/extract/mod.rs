//! Requests, checked: bodies, queries, paths and headers become types that cannot be wrong.

mod accept;
mod avatar_upload;
mod body;
mod fit_request;
mod idempotency_key;
mod invalid;
mod json;
mod last_event_id;
mod path;
mod prefer;
mod query;
mod upload;

pub(super) use accept::preferred_type;
pub(super) use avatar_upload::{AvatarUpload, BodyQuery, BodyUpload};
pub(super) use fit_request::FitRequest;
pub(super) use idempotency_key::idempotency_key;
pub(super) use json::{JsonBody, JsonMemory, JsonWithDigest, OptionalJson, ValidatedJson};
pub(super) use last_event_id::last_event_id;
pub(super) use path::PathId;
pub(super) use prefer::{preference_applied, preferred_wait};
pub(super) use query::{JobListQuery, ListQuery, PictureQuery, ValidatedQuery};
pub(super) use upload::PatternUpload;
