//! The codes of avatars: their measurements, and surfaces of triangles.

use super::table::fault_codes;

fault_codes! {
    /// The codes of avatars: their measurements, and surfaces of triangles.
    AvatarCode in "avatar" {
        Degenerate = "degenerate":
            "A triangle of the body has no area.",
            "Merge its corners or leave the triangle out, keeping the surface closed.";
        Empty = "empty":
            "The surface of the body has no triangles.",
            "Give at least one closed surface.";
        Index = "index":
            "A triangle names a vertex that is not there.",
            "Number the vertices from 0.";
        InsideOut = "inside_out":
            "The triangles of the body run clockwise seen from outside.",
            "Turn every triangle round: `[a, b, c]` to `[a, c, b]`.";
        Measurement = "measurement":
            "A measurement is not that of a person.",
            "Give meters, within the range that the fault names.";
        NotManifold = "not_manifold":
            "An edge of the body is run along in the same direction by more than one triangle.",
            "Give all triangles the same sense and let two meet at each edge.";
        Open = "open":
            "An edge of the body has a triangle on one side only.",
            "Close the holes of the surface.";
        TooLarge = "too_large":
            "The body has more triangles than are taken.",
            "Simplify the surface.";
        Vertex = "vertex":
            "A vertex of the body is not a finite point near the origin.",
            "Correct it; positions are in meters.";
    }
}
