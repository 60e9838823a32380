//! The codes of meshing.

use super::table::fault_codes;

fault_codes! {
    /// The codes of meshing.
    MeshCode in "mesh" {
        Crossing = "crossing":
            "The outline of a panel crosses or touches itself once it is divided into mesh \
            edges.",
            "Use shorter mesh edges, or mend the outline.";
        EdgeLength = "edge_length":
            "The mesh edge length is outside the limits.",
            "Give a length within the limits that the fault names.";
        EndlessBreaks = "endless_breaks":
            "Seams share stretches of outline in a way that divides them without end.",
            "Sew each stretch to one other, or let layered seams begin and end at the same \
            places.";
        LineCrossing = "line_crossing":
            "An internal line that a seam names crosses an outline, a hole, another such line \
            or itself.",
            "Mend the line, or take the seam out.";
        LineOutside = "line_outside":
            "An internal line that a seam names leaves the cloth.",
            "Mend the line, or take the seam out.";
        Outline = "outline":
            "An outline is not a ring of finite polylines.",
            "Give every edge a length and finite points, one edge per corner.";
        StrayHole = "stray_hole":
            "A hole of a panel is not inside it.",
            "Move the hole, or leave it out.";
        TooFine = "too_fine":
            "The garment needs more vertices than are allowed.",
            "Use longer mesh edges.";
    }
}
