//! A server of its own for a test: on a free port of loopback, with an empty data folder.

use seamster::config::{BlobKind, Config, Limits, StoreKind};
use seamster::http;
use seamster::job::{Queue, Sewing, WorkerPool};
use serde_json::Value;
use std::net::SocketAddr;
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::Duration;
use tempfile::TempDir;
use tokio::sync::oneshot;

/// A running server; it stops when dropped.
pub(crate) struct Server {
    /// Where it listens.
    pub(crate) address: SocketAddr,
    stop: Option<oneshot::Sender<()>>,
    thread: Option<JoinHandle<()>>,
    agent: ureq::Agent,
    _data: TempDir,
}

/// What was answered.
#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) status: u16,
    headers: ureq::http::HeaderMap,
    pub(crate) bytes: Vec<u8>,
}

impl Answer {
    /// A header, empty if absent.
    pub(crate) fn header(&self, name: &str) -> &str {
        let value = self.headers.get(name);
        value.map_or("", |value| value.to_str().unwrap())
    }

    pub(crate) fn text(&self) -> String {
        String::from_utf8_lossy(&self.bytes).into_owned()
    }

    pub(crate) fn json(&self) -> Value {
        serde_json::from_slice(&self.bytes)
            .unwrap_or_else(|error| panic!("{error}: {}", self.text()))
    }

    /// The answer, which must be a problem of this status with the body that RFC 9457 asks for.
    pub(crate) fn problem(&self, status: u16) -> Value {
        assert_eq!(self.status, status, "{}", self.text());
        assert_eq!(self.header("content-type"), "application/problem+json");
        let problem = self.json();
        assert_eq!(problem["status"], status);
        for field in ["type", "title", "detail"] {
            assert!(
                problem[field].as_str().is_some_and(|text| !text.is_empty()),
                "{problem}"
            );
        }
        assert!(problem["errors"].is_array(), "{problem}");
        problem
    }

    /// `code pointer` of each fault of a problem, sorted.
    pub(crate) fn faults(&self, status: u16) -> Vec<String> {
        let problem = self.problem(status);
        let faults = problem["errors"].as_array().unwrap().iter();
        let word = |value: &Value| value.as_str().unwrap().to_owned();
        let mut faults: Vec<_> = faults
            .map(|fault| format!("{} {}", word(&fault["code"]), word(&fault["pointer"])))
            .collect();
        faults.sort();
        faults
    }
}

/// Settings of a test server; each test changes what it is about.
pub(crate) fn config() -> Config {
    Config {
        listen: "127.0.0.1:0".parse().unwrap(),
        data: "unused".into(),
        store: StoreKind::Sqlite,
        blobs: BlobKind::File,
        workers: Some(1),
        tokens: vec![],
        hosts: vec![],
        limits: Limits::default(),
    }
}

impl Server {
    /// A server with one worker.
    pub(crate) fn start() -> Self {
        Self::with(config(), 1)
    }

    /// A server with these settings and so many workers.
    pub(crate) fn with(mut config: Config, workers: usize) -> Self {
        let data = tempfile::tempdir().unwrap();
        config.data = data.path().to_owned();
        let listener = std::net::TcpListener::bind(config.listen).unwrap();
        listener.set_nonblocking(true).unwrap();
        let address = listener.local_addr().unwrap();
        let (stop, stopped) = oneshot::channel();
        let thread = std::thread::spawn(move || run(&config, workers, listener, stopped));
        let agent = ureq::Agent::config_builder()
            .http_status_as_error(false)
            .timeout_global(Some(Duration::from_secs(120)))
            .build()
            .new_agent();
        Self {
            address,
            stop: Some(stop),
            thread: Some(thread),
            agent,
            _data: data,
        }
    }

    /// A request without a body.
    pub(crate) fn ask(&self, method: &str, path: &str, headers: &[(&str, &str)]) -> Answer {
        self.send(method, path, headers, &[])
    }

    pub(crate) fn get(&self, path: &str) -> Answer {
        self.ask("GET", path, &[])
    }

    pub(crate) fn post_json(&self, path: &str, body: &Value) -> Answer {
        let headers = [("content-type", "application/json")];
        self.send("POST", path, &headers, body.to_string().as_bytes())
    }

    /// A request.
    pub(crate) fn send(
        &self,
        method: &str,
        path: &str,
        headers: &[(&str, &str)],
        body: &[u8],
    ) -> Answer {
        let uri = format!("http://{}{path}", self.address);
        let mut request = ureq::http::Request::builder().method(method).uri(uri);
        for (name, value) in headers {
            request = request.header(*name, *value);
        }
        let request = request.body(body).unwrap();
        let response = self.agent.run(request).unwrap();
        let (head, mut body) = response.into_parts();
        Answer {
            status: head.status.as_u16(),
            headers: head.headers,
            bytes: body.with_config().limit(1 << 30).read_to_vec().unwrap(),
        }
    }
}

fn run(
    config: &Config,
    workers: usize,
    listener: std::net::TcpListener,
    stopped: oneshot::Receiver<()>,
) {
    let queue = Queue::open(config).unwrap();
    let sewing = Sewing {
        catalogue: Arc::clone(queue.catalogue()),
        limits: config.limits.clone(),
    };
    let pool = (workers > 0).then(|| WorkerPool::start(&queue, sewing, workers).unwrap());
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .worker_threads(2)
        .enable_all()
        .build()
        .unwrap();
    runtime.block_on(async {
        let listener = tokio::net::TcpListener::from_std(listener).unwrap();
        let router = http::router(config, Arc::clone(&queue));
        let stop = async {
            let _ = stopped.await;
        };
        let server = async { axum::serve(listener, router).await.unwrap() };
        tokio::select! {
            () = server => {}
            () = stop => {}
        }
    });
    queue.close();
    if let Some(pool) = pool {
        pool.shutdown(Duration::from_secs(5));
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        drop(self.stop.take());
        if let Some(thread) = self.thread.take() {
            let ended = thread.join();
            assert!(
                ended.is_ok() || std::thread::panicking(),
                "the server panicked"
            );
        }
    }
}
