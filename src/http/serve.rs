//! The listening socket of the service.

use super::router::router;
use crate::config::Config;
use crate::job::Queue;
use std::io;
use std::sync::Arc;
use tokio::net::TcpListener;

/// Serves until `shutdown`, then lets requests end.
///
/// # Errors
/// If the address cannot be listened on.
pub async fn serve(
    config: &Config,
    queue: Arc<Queue>,
    shutdown: impl Future<Output = ()> + Send + 'static,
) -> io::Result<()> {
    let listener = TcpListener::bind(config.listen).await?;
    tracing::info!("listening on http://{}", listener.local_addr()?);
    let router = router(config, Arc::clone(&queue));
    let shutdown = async move {
        shutdown.await;
        queue.close();
    };
    axum::serve(listener, router)
        .with_graceful_shutdown(shutdown)
        .await
}
