//! Tests of `export`: meshes and drawings as files.

mod drawing;
mod meshes;
mod picture;
