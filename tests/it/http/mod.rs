//! Tests of `http`: the service over its own socket.

mod service;
mod studies;
