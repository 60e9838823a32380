//! The codes of the form of requests.

use super::table::fault_codes;

fault_codes! {
    /// The codes of the form of requests.
    RequestCode in "request" {
        Body = "body":
            "The body breaks off, or its form cannot be read.",
            "Send it again.";
        EventId = "event_id":
            "The `Last-Event-ID` is not a whole number.",
            "Send the id of the last event that was read.";
        Format = "format":
            "A text does not have the required format.",
            "Write it as the schema says.";
        Host = "host":
            "The request has two `Host` headers.",
            "Send one.";
        Key = "key":
            "The `Idempotency-Key` is empty, too long or not visible ASCII.",
            "Send a shorter key, such as a UUID.";
        MissingField = "missing_field":
            "A required field is missing.",
            "Add it.";
        MissingPart = "missing_part":
            "The form lacks a part.",
            "Add it.";
        More = "more":
            "There are more faults than are listed.",
            "Mend the listed ones first.";
        NotAChoice = "not_a_choice":
            "A word is not one of the choices.",
            "Give one of the choices that the fault lists.";
        OutOfRange = "out_of_range":
            "A number is outside its range.",
            "Give a number within the range that the fault names.";
        Query = "query":
            "The query cannot be read.",
            "Write it as the document of the interface says.";
        Shape = "shape":
            "A value does not have the shape that the schema requires.",
            "Write it as the schema says.";
        Syntax = "syntax":
            "The body is not JSON.",
            "Mend it at the line and column that the fault names.";
        TooLarge = "too_large":
            "Reading the request takes more memory than one request may.",
            "Send less at once: a body of one's own is uploaded once and named by its id.";
        TooLong = "too_long":
            "A text, or the name of a field, is longer than its limit.",
            "Shorten it to the length that the fault names.";
        UnexpectedPart = "unexpected_part":
            "The form has a part that is not expected, or one twice.",
            "Leave it out.";
        UnknownField = "unknown_field":
            "There is no such field here.",
            "Correct its name or leave it out.";
        WrongLength = "wrong_length":
            "A list or an object has too few or too many entries.",
            "Give as many as the schema or the fault says.";
        WrongType = "wrong_type":
            "A value is of the wrong type.",
            "Give one of the types that the fault names.";
    }
}
