//! The codes of seams.

use super::table::fault_codes;

fault_codes! {
    /// The codes of seams.
    SeamCode in "seam" {
        BadFraction = "bad_fraction":
            "A fraction of an edge is not from 0 to 1.",
            "Give 0 for its start, 1 for its end.";
        DirectionContradicts = "direction_contradicts":
            "The stated direction of a run contradicts the order of its ends.",
            "Leave `direction` out, or swap the ends.";
        DirectionNeeded = "direction_needed":
            "It is not plain which way a run goes.",
            "State its `direction`.";
        DuplicateId = "duplicate_id":
            "Two seams have the same name.",
            "Give each seam a name of its own.";
        Ease = "ease":
            "The two sides of a seam differ in length; the longer is eased in.";
        EaseTooLarge = "ease_too_large":
            "The two sides of a seam differ too much in length.",
            "Check the picked edges; set `gather` if the longer side is to be gathered.";
        EmptySide = "empty_side":
            "A side of a seam has no run.",
            "Pick at least one edge for each side, or take the seam out.";
        FaceChosen = "face_chosen":
            "The side of panels that is out was chosen by where they start, or as most of the cloth is drawn.",
            "State `face` of a panel to choose it.";
        FileFaces = "file_faces":
            "The faces that the pattern's file states contradict its seams, whose faces are taken.";
        LeftOut = "left_out":
            "Panels without a suggested seam were left out of the garment.",
            "Name them in a seam to have them.";
        LikelyReversed = "likely_reversed":
            "A side of a seam is likely picked in the wrong order.",
            "Swap the ends of the side, or take the corrected seam.";
        LoosePanel = "loose_panel":
            "A panel is sewn to nothing.",
            "Sew it, or leave it out.";
        NoneSuggested = "none_suggested":
            "No seam, or none that is sure enough to be sewn unasked, can be suggested for the pattern.",
            "List the seams, offered ones among them, or give the panels telling names (front, back, sleeve).";
        NotSuggested = "not_suggested":
            "No seam is suggested for a panel.",
            "List its seams.";
        NothingToCheck = "nothing_to_check":
            "The request has no list of seams to check.",
            "Give the list of seams; `POST seams/suggest` finds one.";
        OfferNotSewn = "offer_not_sewn":
            "Suggested seams of a confidence below 0.5 were not sewn.",
            "List them in `seams` with the others to have them.";
        Overlap = "overlap":
            "A stretch of outline is sewn twice.",
            "Sew each stretch once, or let each run begin where the one before it ends.";
        PlacesApart = "places_apart":
            "The two ends of a run are not on the same outline, hole or line.",
            "Pick both on the outline, on the same hole or on the same internal line.";
        PointsWelded = "points_welded":
            "Two points of one edge that lie apart are sewn to the same point, where two seams meet.",
            "Pick the ends of one side in the other order, so that the cloth folds over there.";
        Reversed = "reversed":
            "A side of a seam is sewn in the other order than picked.";
        SewnToItself = "sewn_to_itself":
            "A seam sews a stretch to itself.",
            "Pick a different edge for side b, or the two halves of the edge.";
        TooLong = "too_long":
            "The seams go over too many edges in all.",
            "Take out runs that lie over one another.";
        TooMany = "too_many":
            "The garment has more seams than it may have.",
            "Join seams along neighboring edges into lists of runs, or split the garment.";
        TwistAllowed = "twist_allowed":
            "A seam makes the surface one-sided, as `allow_twist` allows.";
        Twisted = "twisted":
            "Seams or stated faces would sew the outer side of the cloth to the inner one.",
            "Swap the ends of one side, change the stated faces, or set `allow_twist`.";
        UnknownCorner = "unknown_corner":
            "A panel has no corner of this number.",
            "Give one of its corners, counted from 0.";
        UnknownEdge = "unknown_edge":
            "A panel has no edge of this number.",
            "Give one of its edges, counted from 0.";
        UnknownHole = "unknown_hole":
            "A panel has no hole of this number.",
            "Give one of its holes, counted from 0.";
        UnknownLine = "unknown_line":
            "A panel has no internal line of this number.",
            "Give one of its internal lines, counted from 0.";
        UnknownNotch = "unknown_notch":
            "A panel has no notch of this number.",
            "Give one of its notches, counted from 0.";
        UnknownPanel = "unknown_panel":
            "The pattern has no panel of this name.",
            "Give the id of a panel of the pattern.";
        ZeroLength = "zero_length":
            "A run has no length.",
            "Pick two corners that lie apart.";
    }
}
