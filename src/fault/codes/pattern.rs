//! The codes of patterns and their files: DXF and GarmentCode.

use super::table::fault_codes;

fault_codes! {
    /// The codes of patterns and their files: DXF and GarmentCode.
    PatternCode in "pattern" {
        Allowance = "allowance":
            "A seam allowance cannot be cut away.",
            "Give a smaller allowance, or 0.";
        AllowanceMixed = "allowance_mixed":
            "Only some pieces of the file show a seam allowance.",
            "State the allowance of the panels in the garment.";
        BadNumber = "bad_number":
            "Something else stands where a number must.",
            "Export the file again; the line is damaged.";
        Binary = "binary":
            "A binary DXF is damaged.",
            "Export the file again, as ASCII DXF.";
        BlockJoined = "block_joined":
            "A block without labels lies in the box of another and was taken as a part of it.",
            "Give it a label (`Piece Name:`), or insert it beside the other.";
        BlockNotInserted = "block_not_inserted":
            "A piece is in a block that is not inserted; it was taken all the same.";
        Bulge = "bulge":
            "A vertex of a polyline has an impossible bulge.",
            "Draw the arc anew.";
        Corner = "corner":
            "A corner of a panel is misnumbered or has impossible coordinates.",
            "Number corners from 0 and give meters.";
        DanglingLine = "dangling_line":
            "A group code stands at the end of the file without its value.",
            "Export the file again if something is missing.";
        DrawnDarts = "drawn_darts":
            "Darts are drawn as lines inside an outline; they were cut into the panel, to be sewn.",
            "State darts=lines where they are lines drawn on the cloth.";
        DrawnNotches = "drawn_notches":
            "Notches are drawn into an outline; they were taken out of it, as marks.",
            "State notches=cloth where they are the course of the cloth.";
        DuplicateId = "duplicate_id":
            "Two panels have the same id.",
            "Give every panel its own id.";
        DuplicateOutline = "duplicate_outline":
            "An outline is drawn twice in the same place; it was taken once.";
        DuplicatePoint = "duplicate_point":
            "A point repeats the one before it.",
            "Leave it out.";
        Edge = "edge":
            "An edge is misnumbered, or does not exist.",
            "Number edges like the corners that they leave.";
        EncodingAssumed = "encoding_assumed":
            "The file does not say the code page of its names; one was taken by their bytes.",
            "State it with `encoding`.";
        EncodingConflict = "encoding_conflict":
            "The names of the file are not written in the encoding that its header says.",
            "State the right one with `encoding`.";
        EncodingUnknown = "encoding_unknown":
            "The names of the file are written in a code page that is not read.",
            "State another with `encoding`, or write the file as UTF-8.";
        EntityIgnored = "entity_ignored":
            "Entities of a kind that patterns do not use were left out.",
            "Export what belongs to the pattern as lines, polylines, arcs or splines.";
        Field = "field":
            "A field of a GarmentCode specification has a wrong value.",
            "Write it as GarmentCode does.";
        FoldAssumed = "fold_assumed":
            "A sew line is open along a straight edge of its cut line and was closed there: a fold, where a note says so.",
            "Draw the fold on layer 6, or state unfold=none where it is none.";
        FoldIgnored = "fold_ignored":
            "A fold line of a piece is not an edge of it, or one more than it can be unfolded about.",
            "Draw fold lines along edges, at right angles to each other.";
        Frame = "frame":
            "An outline about others was taken as the frame of the sheet and left out.",
            "State outlines=lines or holes where it is a piece.";
        GapClosed = "gap_closed":
            "An outline has a small gap, which was closed.";
        GradeRule = "grade_rule":
            "A point of a piece names a grade rule that the table does not have.",
            "Give the table that was exported with the file.";
        GradeTable = "grade_table":
            "A grade rule table cannot be read, or is not that of the file.",
            "Export it again, or leave it out to read the sample size.";
        GrainIgnored = "grain_ignored":
            "A piece has grain lines in several directions; the longest was taken.",
            "Draw one grain line.";
        GroupCode = "group_code":
            "Something else stands where a group code must.",
            "Export the file again; a line is missing or damaged.";
        Id = "id":
            "The id of a panel is missing, too long or not allowed here.",
            "Give another id.";
        ImplausibleSize = "implausible_size":
            "A panel is too small or too large to be read.",
            "Check the units.";
        LineTooLong = "line_too_long":
            "A line of the file has too many bytes.",
            "Shorten the text in the CAD program.";
        LoopCutOff = "loop_cut_off":
            "An outline crosses itself in a small loop, which was cut off.";
        LostEntity = "lost_entity":
            "An entity could not be read whole.",
            "Export the file again.";
        MalformedEntity = "malformed_entity":
            "An entity lacks a value, or has one twice.",
            "Export the file again, or draw the curve anew.";
        MissingBlock = "missing_block":
            "A block that is inserted is not in the file.",
            "Export the file with all its blocks.";
        MissingField = "missing_field":
            "A field of a GarmentCode specification is missing.",
            "Add it.";
        More = "more":
            "There are more findings than are listed.",
            "Mend the listed ones first.";
        Moved = "moved":
            "The drawing lies far from the origin and was moved there.";
        NameTooLong = "name_too_long":
            "The name of a panel has too many characters.",
            "Shorten it.";
        NegativeRadius = "negative_radius":
            "An arc has a negative radius.",
            "Draw the arc anew.";
        NestedSizes = "nested_sizes":
            "Outlines that lie one in the other were taken as the sizes of a piece.",
            "State size= to choose one, or outlines=allowance or lines where they are none.";
        Nesting = "nesting":
            "Blocks are nested too deep, or a block inserts itself.",
            "Explode the blocks before export.";
        NoArea = "no_area":
            "An outline encloses no area.",
            "Draw it anew.";
        NoEndsec = "no_endsec":
            "A section of the file has no ENDSEC.";
        NoEof = "no_eof":
            "The file ends without EOF.",
            "Check that it is complete.";
        NoOutline = "no_outline":
            "The file holds no closed outline, or a panel has none.",
            "Export the pieces as closed polylines, in blocks on layer 1 (AAMA or ASTM).";
        NoPanels = "no_panels":
            "The pattern has no panels.",
            "Give at least one.";
        NoSeqend = "no_seqend":
            "A POLYLINE has no SEQEND.";
        NotDxf = "not_dxf":
            "The file is not a DXF.",
            "Export the pattern as ASCII DXF.";
        NotFinite = "not_finite":
            "A number is not finite or is far too large.",
            "Correct it.";
        NotFlat = "not_flat":
            "Entities are not flat: they were seen from above, or cannot be read.",
            "Draw the pattern flat.";
        NotGarmentcode = "not_garmentcode":
            "The JSON is not a GarmentCode specification.",
            "Upload a specification with `/pattern/panels`.";
        NotJson = "not_json":
            "The file is not JSON.",
            "Upload a GarmentCode specification as it was written.";
        NotMirrored = "not_mirrored":
            "A panel is not the mirrored copy that its id says.",
            "Leave the copy out: naming it in a seam makes it.";
        Notch = "notch":
            "A notch lies on no edge, or outside of its edge.",
            "Correct it.";
        NotchIgnored = "notch_ignored":
            "A notch of a piece lies on no edge and was left out.",
            "Draw the notch on the outline.";
        NulByte = "nul_byte":
            "A line of the file holds a NUL byte.",
            "Export the file again; it was damaged on its way or is binary.";
        OpenOutline = "open_outline":
            "An outline does not close.",
            "Close it: begin and end each edge at its corners.";
        OpenSewLine = "open_sew_line":
            "The sew line of a piece does not close; its cut line was taken as the outline.",
            "Close the sew line.";
        Orientation = "orientation":
            "An outline runs the wrong way round.",
            "Reverse corners and edges.";
        Outline = "outline":
            "A panel does not have one edge for each corner.",
            "Give one edge from each corner to the next.";
        OutlineInside = "outline_inside":
            "An outline inside another was taken as a sew line, a hole or a drawn line, by its course.",
            "State outlines= where it is something else, or draw it on the layer of its kind.";
        ParametersIgnored = "parameters_ignored":
            "The parameters of a GarmentCode specification are not applied: panels are read as \
            they are drawn.";
        PieceLeftOut = "piece_left_out":
            "A piece of the file cannot be read and was left out; the others are there.",
            "Mend it in the CAD program, or state strict=true to refuse such files.";
        Quantity = "quantity":
            "A piece is to be cut more than once; it was taken once or mirrored.",
            "Name the mirrored copy `ID~mirror` in a seam to have it.";
        SampleSize = "sample_size":
            "The file does not say which of its sizes is the sample, or has not that size; the first was \
            taken.",
            "Choose one with `size`.";
        SelfIntersecting = "self_intersecting":
            "An outline crosses or touches itself.",
            "Mend the outline.";
        SharedEdge = "shared_edge":
            "An outline was closed along the edge that it shares with another.",
            "Draw each piece as a closed outline of its own.";
        SizeMissing = "size_missing":
            "A piece does not exist in the size that is imported, and was left out.",
            "State another size.";
        Spline = "spline":
            "A spline cannot be read.",
            "Export curves as polylines, or draw this one anew.";
        Stitch = "stitch":
            "A stitch of a GarmentCode specification is not well formed.",
            "Give two edges.";
        TooLarge = "too_large":
            "The file, or a panel of it, has more than is read.",
            "Draw curves with fewer points, or split the file.";
        TooManyPanels = "too_many_panels":
            "The pattern has more panels than are read.",
            "Leave some out, or split the garment.";
        TooManySeams = "too_many_seams":
            "The pattern has more seams than are read.",
            "Leave some out.";
        Truncated = "truncated":
            "The file ends inside a section: it was cut off.",
            "Export or upload it again.";
        Ungraded = "ungraded":
            "No point of a piece has a grade rule; it is the same in all sizes.";
        UnitsAssumed = "units_assumed":
            "The file does not say its units; millimeters or centimeters were taken.",
            "State them with `units`.";
        UnitsConflict = "units_conflict":
            "The file states two different units; one was taken.",
            "State the right one with `units`.";
        UnitsImplausible = "units_implausible":
            "The panels have an implausible size in these units.",
            "State the right units with `units`.";
        UnitsUnknown = "units_unknown":
            "The file states a unit that is not known.",
            "State the unit with `units`.";
        UnknownField = "unknown_field":
            "A GarmentCode specification has a field that is not known.",
            "Correct the name or leave it out.";
        UnknownPanel = "unknown_panel":
            "There is no panel of this name.",
            "Name a panel of this pattern.";
        UnknownSection = "unknown_section":
            "A section of the file is not known and was not read.";
        UnknownSize = "unknown_size":
            "The file does not have this size.",
            "Choose one of its sizes.";
        Unreadable = "unreadable":
            "The entities of the file cannot be read.",
            "Export the file again.";
        VertexCount = "vertex_count":
            "A polyline states another number of vertices than it has.";
        VertexIgnored = "vertex_ignored":
            "A vertex of a GarmentCode panel is on no edge and was left out.";
        ZeroRadius = "zero_radius":
            "An arc of radius 0 was left out.";
    }
}
