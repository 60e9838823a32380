//! Tests of `http`: the service over its own socket.

mod over;
mod service;
mod studies;
