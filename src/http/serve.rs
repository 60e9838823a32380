//! The listening socket of the service, and its connections.

use super::connection::{Patience, PatientStream};
use super::router::router;
use crate::config::{Config, Limits};
use crate::job::Queue;
use axum::Router;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::server::graceful::{GracefulShutdown, Watcher};
use hyper_util::service::TowerToHyperService;
use std::io;
use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};

/// Wait after a connection could not be taken: there is no file handle left.
const ACCEPT_DELAY: Duration = Duration::from_millis(100);

/// Size of the buffer of a connection, and the longest head of a request \[bytes\]; one that is
/// longer is answered by 431. Not configurable: heads of browsers and proxies are far shorter, and
/// [`Limits::connections`] of these buffers take 256 MiB by default.
const BUFFER_BYTES: usize = 64 << 10;

/// Listens where the settings say.
///
/// # Errors
/// If the address cannot be listened on.
pub async fn listen(config: &Config) -> io::Result<TcpListener> {
    let listener = TcpListener::bind(config.listen).await?;
    tracing::info!("listening on http://{}", listener.local_addr()?);
    Ok(listener)
}

/// Serves until `shutdown`, then lets requests end.
pub async fn serve(
    listener: TcpListener,
    config: &Config,
    queue: Arc<Queue>,
    shutdown: impl Future<Output = ()> + Send,
) {
    let router = router(config, Arc::clone(&queue));
    let limits = queue.limits();
    let permits = Arc::new(Semaphore::new(limits.connections));
    let http = http_builder(limits);
    let open = GracefulShutdown::new();
    let mut shutdown = pin!(shutdown);
    loop {
        let accepted = tokio::select! {
            accepted = accept(&listener, &permits) => accepted,
            () = &mut shutdown => break,
        };
        match accepted {
            Ok((stream, permit)) => {
                let connection = Connection {
                    http: http.clone(),
                    patience: Patience::new(limits.stall_timeout_s),
                    router: router.clone(),
                    watcher: open.watcher(),
                    _permit: permit,
                };
                tokio::spawn(connection.serve(stream));
            }
            Err(error) => {
                tracing::warn!(%error, "a connection is not taken");
                tokio::time::sleep(ACCEPT_DELAY).await;
            }
        }
    }
    drop(listener);
    queue.close();
    open.shutdown().await;
}

/// Takes the next connection once there is a permit for it.
async fn accept(
    listener: &TcpListener,
    permits: &Arc<Semaphore>,
) -> io::Result<(TcpStream, OwnedSemaphorePermit)> {
    let permit = Arc::clone(permits).acquire_owned().await;
    let permit = permit.map_err(io::Error::other)?;
    let (stream, _) = listener.accept().await?;
    Ok((stream, permit))
}

/// Returns the protocol of all connections.
fn http_builder(limits: &Limits) -> http1::Builder {
    let mut http = http1::Builder::new();
    http.timer(TokioTimer::new());
    http.max_buf_size(BUFFER_BYTES);
    // The buffer alone lets through what comes with the read that fills it.
    http.max_header_size(BUFFER_BYTES);
    http.header_read_timeout(Duration::from_secs_f64(limits.head_timeout_s));
    http
}

/// An open connection.
struct Connection {
    http: http1::Builder,
    patience: Patience,
    router: Router,
    watcher: Watcher,
    _permit: OwnedSemaphorePermit,
}

impl Connection {
    async fn serve(self, stream: TcpStream) {
        // Answers are written whole; events are small and must not wait for each other.
        if let Err(error) = stream.set_nodelay(true) {
            tracing::debug!(%error, "a connection delays small packets");
        }
        let stream = PatientStream::new(stream, self.patience);
        let service = TowerToHyperService::new(self.router);
        let connection = self.http.serve_connection(TokioIo::new(stream), service);
        if let Err(error) = self.watcher.watch(connection).await {
            tracing::debug!(%error, "a connection ended");
        }
    }
}
