//! A scene without a garment: particles, springs, stitches and pins as another simulator would
//! state them.
//!
//! SI units. Springs are linear, energy k/2 (|xa - xb| - rest)², and are all the membrane there is:
//! where there are triangles they only say how much of the body a vertex covers and where
//! penetration and strain are measured.

mod check;
mod convert;
mod raw_scene;

pub use raw_scene::RawScene;
