//! Tests of `http`: the service over its own socket.

mod api_examples;
mod service;
mod studies;
