//! The clock of a job.

use rustix::time::{ClockId, clock_gettime};

/// Returns the CPU time that this thread has used \[s\]: unlike the time of day it does not depend on what else the machine does.
pub fn thread_cpu_s() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    std::time::Duration::try_from(time)
        .expect("a thread has used no negative time")
        .as_secs_f64()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::hint::black_box;
    use std::time::{Duration, Instant};

    #[test]
    fn work_counts_and_sleep_does_not() {
        let (began, clock) = (thread_cpu_s(), Instant::now());
        std::thread::sleep(Duration::from_millis(200));
        let slept = thread_cpu_s() - began;
        assert!(slept < 0.1 * clock.elapsed().as_secs_f64());
        let sum = (0..20_000_000_u64).fold(0, |sum, n| black_box(sum ^ n));
        black_box(sum);
        assert!(thread_cpu_s() - began > slept + 1e-3);
    }
}
