//! The codes of garments.

use super::table::fault_codes;

fault_codes! {
    /// The codes of garments.
    GarmentCode in "garment" {
        AvatarUnknown = "avatar_unknown":
            "No stored avatar has this id.",
            "Make it first: `POST /v1/avatars`.";
        CornerUnknown = "corner_unknown":
            "A panel has no corner of this number.",
            "Give one of its corners, counted from 0.";
        FabricUnknown = "fabric_unknown":
            "No fabric has this id.",
            "See `GET /v1/fabrics`, or add it under `fabrics`.";
        Field = "field":
            "A field does not go with the chosen method.",
            "Leave it out, or choose a method that uses it.";
        NotAvailable = "not_available":
            "A wish of the garment is not available in this version.",
            "Leave the field out.";
        Number = "number":
            "A number is outside its range.",
            "Give a number within the range that the fault names.";
        OverAvatar = "over_avatar":
            "The garment that this one is to be worn over is worn on another avatar, or either on none.",
            "Give both garments the same avatar, and sew the inner one on it first.";
        OverSurface = "over_surface":
            "The surface of the garment that this one is to be worn over is not one of cloth.",
            "Give the id of a fit that has succeeded, or `over` of a saved file as it is.";
        OverUnfinished = "over_unfinished":
            "The fit that this garment is to be worn over has not succeeded.",
            "Wait for its end, or give the id of a fit that has succeeded.";
        OverUnknown = "over_unknown":
            "No fit has the id of the garment that this one is to be worn over.",
            "Sew it first: `POST /v1/fits`.";
        PanelUnknown = "panel_unknown":
            "The pattern has no panel of this id.",
            "Give the id of a panel of the pattern.";
        PatternMissing = "pattern_missing":
            "The garment has no pattern.",
            "Give the id of a stored pattern, a whole pattern, or the DXF beside the garment.";
        PatternUnknown = "pattern_unknown":
            "No stored pattern has this id.",
            "Upload it first: `POST /v1/patterns`.";
        StartAvatar = "start_avatar":
            "The fit that this garment is to start from is worn on a body of another kind or pose.",
            "Leave `start_from` out, or give the id of a fit on a body of this kind and pose.";
        StartLeft = "start_left":
            "The garment was sewn from flat panels, not from the shape in `start_from`.",
            "Nothing need be done: the detail says why.";
        StartShape = "start_shape":
            "`start_from` holds no surface of cloth with pattern coordinates.",
            "Give the id of a fit that has succeeded, or `start_from` of a saved file as it is.";
        StartUnfinished = "start_unfinished":
            "The fit that this garment is to start from has not succeeded.",
            "Wait for its end, or give the id of a fit that has succeeded.";
        StartUnknown = "start_unknown":
            "No fit has the id of the shape that this garment is to start from.",
            "Leave it out, or give the id of a fit that has succeeded.";
        Schema = "schema":
            "The garment is of a format that this service does not read.",
            "Give the format that the fault names.";
    }
}
