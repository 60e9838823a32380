//! The codes of fits: of requests, and of fits that failed.

use super::table::fault_codes;

fault_codes! {
    /// The codes of fits: of requests, and of fits that failed.
    FitCode in "fit" {
        Abandoned = "abandoned":
            "The processes that ran the fit died, one after the other.",
            "Use a coarser mesh; look into the log of the service.";
        Canceled = "canceled":
            "The fit was stopped on request.";
        KeyReused = "key_reused":
            "The `Idempotency-Key` was used before for another request.",
            "Send a new key with a new request.";
        NotConverged = "not_converged":
            "The shape did not come to rest; its report says why.",
            "Allow more time, or use a larger tolerance or a coarser mesh.";
        Panicked = "panicked":
            "The program has a defect that this garment brings out.",
            "Report it, with the garment.";
        Refused = "refused":
            "The stored garment has faults; `errors` lists them.",
            "Mend them and submit the garment again.";
        Storage = "storage":
            "The garment or the result could not be read or written.",
            "Look into the log of the service.";
        TimeLimit = "time_limit":
            "The fit used all the CPU time that it may use.",
            "Use a coarser mesh or a larger tolerance.";
        TwoPatterns = "two_patterns":
            "The pattern comes beside the garment and in the garment too.",
            "Leave it out of the garment.";
    }
}
