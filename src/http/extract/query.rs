//! The query of a request; unknown and wrong fields are refused.

use super::invalid::{limit_out_of_range, unreadable_query};
use crate::export::View;
use crate::http::respond::Problem;
use crate::job::{JobStatus, PageRequest};
use axum::extract::{FromRequestParts, Query};
use axum::http::request::Parts;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use utoipa::IntoParams;
use uuid::Uuid;

/// Items of a page, unless requested otherwise.
const DEFAULT_LIMIT: usize = 50;
/// Most items of a page.
const MAX_LIMIT: usize = 200;

/// The query of a request.
pub(in crate::http) struct ValidatedQuery<T>(pub(in crate::http) T);

impl<T: DeserializeOwned, S: Send + Sync> FromRequestParts<S> for ValidatedQuery<T> {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, Problem> {
        let query = Query::from_request_parts(parts, state).await;
        let Query(query) = query.map_err(|rejection| unreadable_query(rejection.body_text()))?;
        Ok(Self(query))
    }
}

/// A part of a list, newest first.
#[derive(Clone, Copy, Debug, Default, Deserialize, IntoParams)]
#[serde(default, deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(in crate::http) struct ListQuery {
    /// Most items of the page, 1 to 200; 50 if not given.
    pub limit: Option<usize>,
    /// `next_cursor` of the page before.
    pub cursor: Option<Uuid>,
}

/// A part of the fits or studies, newest first.
#[derive(Clone, Copy, Debug, Default, Deserialize, IntoParams)]
#[serde(default, deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(in crate::http) struct JobListQuery {
    /// Most items of the page, 1 to 200; 50 if not given.
    pub limit: Option<usize>,
    /// `next_cursor` of the page before.
    pub cursor: Option<Uuid>,
    /// Only those of this status.
    pub status: Option<JobStatus>,
}

/// A picture of a garment.
#[derive(Clone, Copy, Debug, Default, Deserialize, IntoParams)]
#[serde(default, deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(in crate::http) struct PictureQuery {
    /// Side that it shows; four of them beside each other if not given.
    pub view: Option<View>,
    /// Width \[pixels\]; 1200 for one side, 2000 for four if not given.
    pub width: Option<u32>,
}

impl ListQuery {
    /// Returns the page that is requested.
    pub(in crate::http) fn page(self) -> Result<PageRequest, Problem> {
        let limit = self.limit.unwrap_or(DEFAULT_LIMIT);
        if !(1..=MAX_LIMIT).contains(&limit) {
            return Err(limit_out_of_range(limit, MAX_LIMIT).into());
        }
        Ok(PageRequest {
            limit,
            after: self.cursor,
            status: None,
        })
    }
}

impl JobListQuery {
    /// Returns the page that is requested.
    pub(in crate::http) fn page(self) -> Result<PageRequest, Problem> {
        let Self {
            limit,
            cursor,
            status,
        } = self;
        let page = ListQuery { limit, cursor }.page()?;
        Ok(PageRequest { status, ..page })
    }
}
