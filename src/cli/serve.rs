//! The command `serve`: serves over HTTP and runs jobs, until it is asked to end.

use super::child::ServiceRunner;
use super::exit::{fail, refuse};
use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
use seamster::config::Config;
use seamster::http;
use seamster::job::{Queue, SolverRunner, WorkerPool};
use std::io;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Duration;
use tokio::net::TcpListener;
use tokio::signal::unix::{SignalKind, signal};
use tokio::sync::oneshot;
use tokio::time::timeout;

/// Time that running work has to end; container engines kill after ten seconds.
const SHUTDOWN_TIMEOUT: Duration = Duration::from_secs(8);

/// Serves until SIGTERM or SIGINT.
pub(super) fn serve(config: Config) -> ExitCode {
    let config = match config.validated() {
        Ok(config) => config,
        Err(error) => return refuse(&error.to_string()),
    };
    match start(&config) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => fail(&error.to_string()),
    }
}

fn start(config: &Config) -> Result<(), Box<dyn std::error::Error>> {
    let queue = Queue::open(config)?;
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .enable_all()
        .build()?;
    let runner = ServiceRunner {
        solver: SolverRunner::of(&queue),
    };
    raise_file_limit();
    let listener = runtime.block_on(http::listen(config))?;
    let pool = WorkerPool::start(&queue, runner, config.worker_count())?;
    tracing::info!(workers = config.worker_count(), data = %config.data.display(), "started");
    let served = runtime.block_on(serve_until_signal(config, queue, (listener, pool)));
    // Threads that still wait for a client must not hold the process up.
    runtime.shutdown_timeout(Duration::from_millis(100));
    Ok(served?)
}

/// Serves until a signal, then gives running fits back while requests end.
async fn serve_until_signal(
    config: &Config,
    queue: Arc<Queue>,
    (listener, pool): (TcpListener, WorkerPool),
) -> io::Result<()> {
    let mut terminate = signal(SignalKind::terminate())?;
    let mut interrupt = signal(SignalKind::interrupt())?;
    let (end, ended) = oneshot::channel::<()>();
    let server = http::serve(listener, config, queue, async {
        // An error means that nobody can ask any more: then it is time too.
        let _ = ended.await;
    });
    tokio::pin!(server);
    tokio::select! {
        // Driven here: it cannot end before `end` is dropped.
        () = &mut server => {}
        _ = terminate.recv() => {}
        _ = interrupt.recv() => {}
    }
    tracing::info!("ending");
    drop(end);
    let workers = tokio::task::spawn_blocking(move || pool.shutdown(SHUTDOWN_TIMEOUT));
    // Requests that do not end in this time are cut off.
    let _ = timeout(SHUTDOWN_TIMEOUT, server).await;
    workers.await.map_err(io::Error::other)
}

/// Lets the process open as many files as the system allows it: each connection is one.
fn raise_file_limit() {
    let limit = getrlimit(Resource::Nofile);
    let raised = Rlimit {
        current: limit.maximum,
        ..limit
    };
    if let Err(error) = setrlimit(Resource::Nofile, raised) {
        tracing::warn!(%error, "the number of open files stays as it was");
    }
}
