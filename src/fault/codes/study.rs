//! The codes of studies: of requests, and of studies that failed.

use super::table::fault_codes;

fault_codes! {
    /// The codes of studies: of requests, and of studies that failed.
    StudyCode in "study" {
        Abandoned = "abandoned":
            "The study ran in a process of its own, which died twice, or with which the service died ten times; the detail says of what.",
            "Use a coarser mesh; look into the log of the service.";
        Field = "field":
            "A field does not go with what is studied.",
            "Leave it out.";
        KeyReused = "key_reused":
            "The `Idempotency-Key` was used before for another request.",
            "Send a new key with a new request.";
        NotStarted = "not_started":
            "The study is to run in a process of its own, and none could be started.",
            "Submit it again later; the log of the service says why.";
        NothingRan = "nothing_ran":
            "No run of the study was made.",
            "Allow more time, or ask for coarser meshes.";
        Number = "number":
            "A number is outside its range.",
            "Give a number within the range that the fault names.";
        Panicked = "panicked":
            "The program has a defect that this garment brings out.",
            "Report it, with the study.";
        Refused = "refused":
            "The stored study has faults; `errors` lists them.",
            "Mend them and submit the study again.";
        Repeated = "repeated":
            "An item is in a list twice.",
            "Leave it out.";
        Storage = "storage":
            "The study or its result could not be read or written.",
            "Look into the log of the service.";
        TimeLimit = "time_limit":
            "The study used all the CPU time that it may use.",
            "Use a coarser mesh or a larger tolerance.";
        TooLong = "too_long":
            "A list has too many items.",
            "Give as many as the fault allows.";
        TooManyRuns = "too_many_runs":
            "The study asks for too many runs.",
            "Ask for fewer methods, settings or meshes.";
    }
}
