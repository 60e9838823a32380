//! The time for which a client may keep the service waiting.

use std::time::Duration;

/// Bytes that give a second of patience back.
const BYTES_PER_SECOND: f64 = 4_096.0;

/// The time for which a client may still keep the service waiting. Waiting uses it up, bytes that
/// get through give it back: who is slow on average is as bad as who stands still.
#[derive(Clone, Copy, Debug)]
pub(in crate::http) struct Patience {
    left_s: f64,
    most_s: f64,
}

impl Patience {
    /// Creates the patience with a client of whom nothing is known yet.
    pub(in crate::http) fn new(most_s: f64) -> Self {
        Self {
            left_s: most_s,
            most_s,
        }
    }

    /// Returns the time that is left.
    pub(in crate::http) fn left(&self) -> Duration {
        Duration::from_secs_f64(self.left_s)
    }

    /// Takes account of bytes that came or went after a wait.
    pub(in crate::http) fn note(&mut self, waited: Duration, bytes: usize) {
        #[expect(
            clippy::cast_precision_loss,
            reason = "a buffer is far below 2^53 bytes"
        )]
        let earned_s = bytes as f64 / BYTES_PER_SECOND;
        let left_s = self.left_s - waited.as_secs_f64() + earned_s;
        self.left_s = left_s.clamp(0.0, self.most_s);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_a_byte_a_second_is_too_slow_and_a_modem_is_not() {
        let (mut drip, mut modem) = (Patience::new(20.0), Patience::new(20.0));
        for _ in 0..11 {
            drip.note(Duration::from_secs(2), 1);
            modem.note(Duration::from_secs(2), 10_000);
        }
        assert!(drip.left() < Duration::from_millis(10), "{drip:?}");
        assert_eq!(modem.left(), Duration::from_secs(20));
    }
}
