//! Tests of `export`: meshes and drawings as files.

mod aama;
mod drawing;
mod garmentcode;
mod meshes;
mod picture;
