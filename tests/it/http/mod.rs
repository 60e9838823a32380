//! Tests of `http`: the service over its own socket.

mod bounds;
mod manners;
mod over;
mod own_bodies;
mod readiness;
mod service;
mod slow_clients;
mod studies;
