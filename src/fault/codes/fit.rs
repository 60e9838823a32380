//! The codes of fits: of requests, and of fits that failed.

use super::table::fault_codes;

fault_codes! {
    /// The codes of fits: of requests, and of fits that failed.
    FitCode in "fit" {
        Abandoned = "abandoned":
            "The fit ran in a process of its own, which died twice, or with which the service died ten times; the detail says of what.",
            "Use a coarser mesh; look into the log of the service.";
        Body = "body":
            "The garment came to rest, but passes through the body; its report says where.",
            "Give a body of its size or place its panels further out.";
        Canceled = "canceled":
            "The fit was stopped on request.";
        Crossings = "crossings":
            "The garment came to rest, but cloth passes through cloth; its report says where.",
            "Place the panels so that they start apart, or allow it by `self_contact` `off`.";
        Gap = "gap":
            "The garment came to rest, but a seam is open.",
            "Look for seams of very unlike sides, or give a larger `simulate.seam_eps_m`.";
        KeyReused = "key_reused":
            "The `Idempotency-Key` was used before for another request.",
            "Send a new key with a new request.";
        Layers = "layers":
            "The garment came to rest, but a layer lies beyond one that belongs on it.",
            "Place the panels in their order, or give them other `layer` numbers.";
        NoGarment = "no_garment":
            "A pattern was given where a garment must be: the garment file is missing.",
            "Give the garment file after the pattern; it says what is sewn to what.";
        NotConverged = "not_converged":
            "The shape did not come to rest; its report says why.",
            "Allow more time, or use a larger tolerance or a coarser mesh.";
        NotStarted = "not_started":
            "The fit is to run in a process of its own, and none could be started.",
            "Submit it again later; the log of the service says why.";
        Panicked = "panicked":
            "The program has a defect that this garment brings out.",
            "Report it, with the garment.";
        Refused = "refused":
            "The stored garment has faults; `errors` lists them.",
            "Mend them and submit the garment again.";
        Storage = "storage":
            "What the service keeps of the fit is gone or cannot be read.",
            "Submit it again; the log of the service says why.";
        Strain = "strain":
            "The garment came to rest, but is stretched further than any cloth bears.",
            "Look for seams of very unlike sides and a garment too small for the body.";
        TimeLimit = "time_limit":
            "The fit used all the CPU time that it may use.",
            "Use a coarser mesh or a larger tolerance.";
        TooLarge = "too_large":
            "The opening that is to carry the garment is wider than the body there: it would slide down.",
            "Give it a band, darts or elastic, a smaller size, or a body of its size.";
        TooSmall = "too_small":
            "The garment measures less than the body, by more than its cloth gives.",
            "Give a larger size, a cloth that stretches, or a body of its size.";
        TwoPatterns = "two_patterns":
            "The pattern comes beside the garment and in the garment too.",
            "Leave it out of the garment.";
        Worn = "worn":
            "The garment came to rest, but the body does not carry it; its report says why.",
            "Place its panels higher, give a body of its size or pin a corner.";
    }
}
