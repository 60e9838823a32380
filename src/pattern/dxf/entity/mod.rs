//! Records to entities: cleaned for the `dxf` crate, read by it, and given as points and polylines
//! of the drawing plane.

pub(super) mod affine;
mod convert;
mod fit_spline;
pub(super) mod geometry;
pub(super) mod load;
mod plane;
mod polyline;
mod sanitize;
mod spline;
mod validate;
