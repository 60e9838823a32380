//! Readiness: looked at once for all who ask within a moment, so that asking costs nothing.

use super::state::AppState;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::Mutex;

/// Age up to which the last look is the answer.
const FRESH: Duration = Duration::from_secs(2);
/// Wait for a look: a disk that does not answer in this time is not ready.
const PATIENCE: Duration = Duration::from_secs(2);

/// The last look at the store: its time, and whether it could be used.
#[derive(Clone, Default)]
pub(super) struct Readiness(Arc<Mutex<Option<(Instant, bool)>>>);

impl AppState {
    /// Returns true if jobs could be kept and found a moment ago.
    pub(super) async fn is_ready(&self) -> bool {
        let looked = tokio::time::timeout(PATIENCE, self.look());
        looked.await.unwrap_or(false)
    }

    async fn look(&self) -> bool {
        let mut last = Arc::clone(&self.readiness.0).lock_owned().await;
        if let Some((at, is_ready)) = *last
            && at.elapsed() < FRESH
        {
            return is_ready;
        }
        let state = self.clone();
        // A task of its own: who gives up leaves the lock with it, and nobody begins another.
        let look = tokio::spawn(async move {
            let probed = state.run_unbounded(|app| app.queue.probe()).await;
            let is_ready = match probed {
                Ok(Ok(())) => true,
                Ok(Err(error)) => {
                    tracing::error!(%error, "not ready");
                    false
                }
                Err(_) => false,
            };
            *last = Some((Instant::now(), is_ready));
            is_ready
        });
        look.await.unwrap_or(false)
    }
}
