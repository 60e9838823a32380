//! The service: routes, access control, problems as RFC 9457, events, `OpenAPI` and the page.
//!
//! - [`router()`]: all routes with their middleware; `state`: what handlers share; `openapi`: the
//!   document, made of the routes.
//! - `extract`: requests, checked: a handler can only receive a valid value.
//! - `connection`: what slow clients may hold.
//! - `routes`: one file a resource. Handlers extract, call the domain and wrap.
//! - `respond`: answers: problems, representations with entity tags and ranges.
//! - `middleware`: access control, log, counters. `readiness`: the look behind the readiness probe.

mod connection;
mod extract;
mod middleware;
mod openapi;
mod readiness;
mod respond;
mod router;
mod routes;
mod serve;
mod state;

pub use openapi::openapi_json;
pub use respond::Problem;
pub use router::router;
pub use serve::{listen, serve};
