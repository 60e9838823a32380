//! The memory that the process takes, as the system tells it.

/// Returns the largest resident memory of the process so far \[bytes\]; none where the system does
/// not tell.
pub fn peak_bytes() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let peak = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = peak.split_whitespace().next()?.parse().ok()?;
    Some(1024 * kibibytes)
}
