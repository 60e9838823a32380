//! The codes of avatars: their measurements, and surfaces of triangles.

use super::table::fault_codes;

fault_codes! {
    /// The codes of avatars: their measurements, and surfaces of triangles.
    AvatarCode in "avatar" {
        Crossing = "crossing":
            "The surface of the body crosses itself in too many places.",
            "Make it one skin, or leave out clothes that lie on it.";
        Degenerate = "degenerate":
            "A triangle of the body has no area.",
            "Merge its corners or leave the triangle out, keeping the surface closed.";
        Empty = "empty":
            "The surface of the body has no triangles.",
            "Give at least one closed surface.";
        File = "file":
            "The file of a body cannot be read.",
            "Export the body again, as an OBJ, a binary glTF 2.0 or a PLY file.";
        Index = "index":
            "A triangle names a vertex that is not there.",
            "Number the vertices from 0.";
        InsideOut = "inside_out":
            "The triangles of the body run clockwise seen from outside.",
            "Turn every triangle round: `[a, b, c]` to `[a, c, b]`.";
        Landmark = "landmark":
            "A landmark of the body was not found, or is given where it cannot be.",
            "Give it in the file's own coordinates, in the part `landmarks`.";
        LeftOut = "left_out":
            "Separate small pieces of the file of a body were left out.";
        Measurement = "measurement":
            "A measurement is not that of a person.",
            "Give meters, within the range that the fault names.";
        Mended = "mended":
            "Something of the surface of a body was mended: a hole, a flat cut.";
        NotManifold = "not_manifold":
            "An edge of the body is run along in the same direction by more than one triangle.",
            "Give all triangles the same sense and let two meet at each edge.";
        Open = "open":
            "An edge of the body has a triangle on one side only.",
            "Close the holes of the surface.";
        Pose = "pose":
            "The way up, the way ahead or a limb of a body was found without being sure.",
            "Look at the body; state `up` and `facing`, or give its landmarks.";
        TooLarge = "too_large":
            "The body has more bytes, vertices or triangles than are taken.",
            "Simplify the surface.";
        Units = "units":
            "The unit of a body's file was taken from its height, or none makes a person of it.",
            "State the unit with `units`.";
        Vertex = "vertex":
            "A vertex of the body is not a finite point near the origin.",
            "Correct it; positions are in meters.";
    }
}
