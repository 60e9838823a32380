//! Readiness: looked at once for all who ask within a moment, so that asking costs nothing.

use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::Mutex;
use tokio::time::timeout;

/// Age up to which the last look is the answer.
const FRESH: Duration = Duration::from_secs(2);
/// Wait for a look: a disk that does not answer in this time is not ready.
const PATIENCE: Duration = Duration::from_secs(2);

/// The last look at the store: its time, and whether it could be used.
#[derive(Clone, Default)]
pub(super) struct Readiness(Arc<Mutex<Option<(Instant, bool)>>>);

impl Readiness {
    /// Returns true if `probe`, or the last one a moment ago, found that the store can be used.
    pub(super) async fn is_ready(
        &self,
        probe: impl Future<Output = bool> + Send + 'static,
    ) -> bool {
        let looked = timeout(PATIENCE, self.look(probe));
        looked.await.unwrap_or(false)
    }

    async fn look(&self, probe: impl Future<Output = bool> + Send + 'static) -> bool {
        let mut last = Arc::clone(&self.0).lock_owned().await;
        if let Some((at, is_ready)) = *last
            && at.elapsed() < FRESH
        {
            return is_ready;
        }
        // A task of its own: who gives up leaves the lock with it, and nobody begins another.
        let look = tokio::spawn(async move {
            let is_ready = probe.await;
            *last = Some((Instant::now(), is_ready));
            is_ready
        });
        look.await.unwrap_or(false)
    }
}
