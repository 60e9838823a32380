//! Rectangles of cloth meshed as garments are.
#![allow(
    dead_code,
    unreachable_pub,
    reason = "each test program takes this file in as its own and uses some of it"
)]

use crate::panels::{pattern, rectangle};
use seamster::config::Limits;
use seamster::mesh::{ClothMesh, triangulate};
use seamster::progress::CancelToken;
use seamster::seam::{Face, SeamSet};

/// The mesh of a rectangle as the service would cut it, from the origin, with edges of about `edge_length` \[m\].
pub fn rectangle_mesh(size: [f64; 2], edge_length: f64) -> ClothMesh {
    let pattern = pattern(vec![rectangle("a", size[0], size[1])]);
    let seams = SeamSet {
        seams: vec![],
        faces: vec![Face::Up],
    };
    let limits = Limits {
        edge_length_m: [1e-4, 1.0],
        ..Limits::default()
    };
    triangulate(&pattern, &seams, edge_length, &limits, &CancelToken::new())
        .expect("a rectangle has a mesh")
}
