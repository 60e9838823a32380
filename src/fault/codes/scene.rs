//! The codes of raw scenes.

use super::table::fault_codes;

fault_codes! {
    /// The codes of raw scenes.
    SceneCode in "scene" {
        Body = "body":
            "A body of the scene has a number that is not finite, no radius or no direction.",
            "Correct it.";
        Drag = "drag":
            "The drag is outside its range.",
            "Give a number within the range that the fault names.";
        Friction = "friction":
            "The friction is outside its range.",
            "Give a number within the range that the fault names.";
        HeldAxis = "held_axis":
            "There is no such axis.",
            "Give 0 for x, 1 for y or 2 for z.";
        Itself = "itself":
            "A vertex is tied to itself.",
            "Tie two different vertices.";
        Length = "length":
            "A list has another number of entries than there are vertices.",
            "Give one entry per vertex.";
        NoVertex = "no_vertex":
            "There is no vertex of this number.",
            "Number the vertices from 0.";
        NoVertices = "no_vertices":
            "The scene has no vertices.",
            "Give at least one.";
        NotPositive = "not_positive":
            "A value is not above 0.",
            "Give a positive, finite number.";
        Number = "number":
            "A number is not finite or far too large.",
            "Correct it.";
        StitchTwice = "stitch_twice":
            "Two vertices are sewn by two stitches.",
            "Leave one of them out.";
        TooLarge = "too_large":
            "A list of the scene has more entries than are read.",
            "Split the scene.";
        Triangle = "triangle":
            "A triangle has no area or runs the wrong way round.",
            "Name its vertices counter-clockwise.";
    }
}
