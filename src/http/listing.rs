//! Lists: which part of one is asked for, and how it is answered.

use super::problem::Problem;
use crate::fault::Fault;
use crate::job::{PageAsked, Status};
use axum::extract::rejection::{PathRejection, QueryRejection};
use axum::extract::{FromRequestParts, Path, Query};
use axum::http::request::Parts;
use serde::Deserialize;
use utoipa::IntoParams;
use uuid::Uuid;

/// Items of a page, unless asked otherwise.
const LIMIT: usize = 50;
/// Items of a page at most.
const LIMIT_MAX: usize = 200;

/// Which part of a list is wanted, newest first.
#[derive(Clone, Copy, Debug, Default, Deserialize, IntoParams)]
#[serde(default, deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct ListAsked {
    /// The most items wanted, 1 to 200; 50 if not given.
    pub limit: Option<usize>,
    /// `next_cursor` of the page before.
    pub cursor: Option<Uuid>,
}

/// Which fits or studies are wanted, newest first.
#[derive(Clone, Copy, Debug, Default, Deserialize, IntoParams)]
#[serde(default, deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct JobsAsked {
    /// The most items wanted, 1 to 200; 50 if not given.
    pub limit: Option<usize>,
    /// `next_cursor` of the page before.
    pub cursor: Option<Uuid>,
    /// Only those of this status.
    pub status: Option<Status>,
}

impl ListAsked {
    pub(super) fn page(self) -> Result<PageAsked, Problem> {
        let limit = self.limit.unwrap_or(LIMIT);
        if !(1..=LIMIT_MAX).contains(&limit) {
            let detail = format!("limit is {limit}; it must be from 1 to {LIMIT_MAX}");
            return Err(Fault::new("request/out_of_range", "/limit", detail).into());
        }
        Ok(PageAsked {
            limit,
            after: self.cursor,
            status: None,
        })
    }
}

impl JobsAsked {
    pub(super) fn page(self) -> Result<PageAsked, Problem> {
        let Self {
            limit,
            cursor,
            status,
        } = self;
        let page = ListAsked { limit, cursor }.page()?;
        Ok(PageAsked { status, ..page })
    }
}

/// The query of a request; unknown and wrong fields are refused.
pub(super) struct Asking<T>(pub(super) T);

impl<T: serde::de::DeserializeOwned, S: Send + Sync> FromRequestParts<S> for Asking<T> {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, Problem> {
        let Query(asked) = Query::from_request_parts(parts, state).await?;
        Ok(Self(asked))
    }
}

/// The id in the path of a request.
pub(super) struct Id(pub(super) Uuid);

impl<S: Send + Sync> FromRequestParts<S> for Id {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, Problem> {
        let Path(id) = Path::from_request_parts(parts, state).await?;
        Ok(Self(id))
    }
}

impl From<PathRejection> for Problem {
    fn from(rejection: PathRejection) -> Self {
        Self::not_found(format!("No such thing: {}.", rejection.body_text()))
    }
}

impl From<QueryRejection> for Problem {
    fn from(rejection: QueryRejection) -> Self {
        Fault::new("request/query", "", rejection.body_text()).into()
    }
}
