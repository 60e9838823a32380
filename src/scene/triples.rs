//! JSON Schema of lists of points and of triangles: the derive knows no lengths of rows.

use utoipa::openapi::schema::{Array, ArrayBuilder, ObjectBuilder, Type};

/// Schema of positions of vertices \[m\]; `#V`.
pub(crate) fn positions_schema() -> Array {
    let length = ObjectBuilder::new().schema_type(Type::Number);
    triples_of(length, "Positions [m], y up; `#V`.")
}

/// Schema of triangles by the indices of their corners; `#T`.
pub(crate) fn triangles_schema() -> Array {
    let index = ObjectBuilder::new().schema_type(Type::Integer);
    let index = index.minimum(Some(0)).maximum(Some(u32::MAX));
    triples_of(index, "Corners of its triangles; `#T`.")
}

fn triples_of(item: ObjectBuilder, description: &str) -> Array {
    let triple = ArrayBuilder::new().items(item);
    let triple = triple.min_items(Some(3)).max_items(Some(3));
    let triples = ArrayBuilder::new().items(triple);
    triples.description(Some(description)).build()
}
