//! Tests of `mesh`: panels triangulated.

mod triangulate;
