//! The settings of the service, from flags and the environment; nothing else reads the environment.

use super::limits::Limits;
use clap::{Args, ValueEnum};
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr};
use std::path::PathBuf;
use std::str::FromStr;

/// Settings of the service.
#[derive(Args, Clone, Debug)]
pub struct Config {
    /// Address to listen on; a public one needs tokens
    #[arg(long, env = "SEAMSTER_LISTEN", default_value = "127.0.0.1:8737")]
    pub listen: SocketAddr,
    /// Folder of everything that is kept
    #[arg(long, env = "SEAMSTER_DATA", default_value = "./data")]
    pub data: PathBuf,
    /// Storage of records and the queue: sqlite
    #[arg(long, env = "SEAMSTER_STORE", default_value = "sqlite")]
    pub store: StoreKind,
    /// Storage of results: file
    #[arg(long, env = "SEAMSTER_BLOBS", default_value = "file")]
    pub blobs: BlobKind,
    /// Fits and studies run at the same time; one less than the cores if not given
    #[arg(long, env = "SEAMSTER_WORKERS")]
    pub workers: Option<usize>,
    /// Bearer tokens that may call, separated by commas
    #[arg(
        long,
        env = "SEAMSTER_TOKENS",
        value_delimiter = ',',
        hide_env_values = true
    )]
    pub tokens: Vec<String>,
    /// Further names that clients may call the service by, separated by commas
    #[arg(long, env = "SEAMSTER_HOSTS", value_delimiter = ',')]
    pub hosts: Vec<String>,
    /// Bounds on what one input may ask for.
    #[arg(skip)]
    pub limits: Limits,
}

/// Settings of the log.
#[derive(Args, Clone, Debug)]
pub struct Logging {
    /// Level of the log on stderr: error, warn, info, debug, or target=level, separated by commas
    #[arg(long, env = "SEAMSTER_LOG", default_value = "info", global = true)]
    pub log: String,
    /// Form of the log: text, or json with one object a line
    #[arg(
        long,
        env = "SEAMSTER_LOG_FORMAT",
        default_value = "text",
        global = true
    )]
    pub log_format: LogFormat,
}

/// Form of the log.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum LogFormat {
    /// Lines for a person.
    Text,
    /// An object a line, for programs.
    Json,
}

/// Settings that cannot be served.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ConfigError {
    /// The address is public and no token is set: anyone could call.
    #[error(
        "{0} can be reached from other machines: set SEAMSTER_TOKENS (or --tokens), or listen on 127.0.0.1"
    )]
    PublicWithoutTokens(SocketAddr),
    /// There are no workers: nothing would ever run.
    #[error("SEAMSTER_WORKERS (or --workers) must be at least 1")]
    NoWorkers,
}

impl Config {
    /// Drops empty tokens and hosts, and checks that the settings go together.
    ///
    /// # Errors
    /// A public address without tokens, no workers.
    pub fn validated(mut self) -> Result<Self, ConfigError> {
        for list in [&mut self.tokens, &mut self.hosts] {
            *list = list.iter().map(|item| item.trim().to_owned()).collect();
            list.retain(|item| !item.is_empty());
        }
        if self.tokens.is_empty() && !self.listen.ip().to_canonical().is_loopback() {
            return Err(ConfigError::PublicWithoutTokens(self.listen));
        }
        if self.workers == Some(0) {
            return Err(ConfigError::NoWorkers);
        }
        Ok(self)
    }

    /// Returns the number of jobs run at the same time: as set, else one less than the cores so
    /// that requests are still answered.
    pub fn worker_count(&self) -> usize {
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        self.workers.unwrap_or(cores.saturating_sub(1)).max(1)
    }

    /// Returns the address by which the service is reached from this machine.
    pub fn local_address(&self) -> SocketAddr {
        let ip = match self.listen.ip() {
            IpAddr::V4(ip) if ip.is_unspecified() => Ipv4Addr::LOCALHOST.into(),
            IpAddr::V6(ip) if ip.is_unspecified() => Ipv6Addr::LOCALHOST.into(),
            ip => ip,
        };
        SocketAddr::new(ip, self.listen.port())
    }
}

/// Storage of records and the queue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StoreKind {
    /// In a file of the data folder, for one process.
    Sqlite,
}

impl FromStr for StoreKind {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "sqlite" => Ok(Self::Sqlite),
            _ => Err(format!(
                "`{text}` is not a store of this version: only `sqlite` is"
            )),
        }
    }
}

/// Storage of results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlobKind {
    /// In files of the data folder.
    File,
}

impl FromStr for BlobKind {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "file" => Ok(Self::File),
            _ => Err(format!(
                "`{text}` is no place for results in this version: only `file` is"
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    #[derive(Parser)]
    struct ServeArguments {
        #[command(flatten)]
        config: Config,
    }

    fn parse(flags: &[&str]) -> Result<Config, clap::Error> {
        ServeArguments::try_parse_from([&["seamster"], flags].concat())
            .map(|arguments| arguments.config)
    }

    #[test]
    fn public_address_without_tokens_is_refused() {
        for listen in [
            "0.0.0.0:80",
            "[::]:80",
            "192.0.2.1:80",
            "[::ffff:10.0.0.1]:80",
        ] {
            let config = parse(&["--listen", listen]).unwrap();
            assert!(
                matches!(config.validated(), Err(ConfigError::PublicWithoutTokens(_))),
                "{listen}"
            );
        }
    }

    #[test]
    fn empty_tokens_are_no_tokens() {
        let config = parse(&["--listen", "0.0.0.0:80", "--tokens", " ,,"]).unwrap();
        assert!(config.validated().is_err());
        let config = parse(&["--listen", "0.0.0.0:80", "--tokens", ", a , "]).unwrap();
        assert_eq!(config.validated().unwrap().tokens, ["a"]);
    }

    #[test]
    fn loopback_needs_no_tokens() {
        for listen in ["127.0.0.1:0", "[::1]:0", "[::ffff:127.0.0.1]:0"] {
            assert!(parse(&["--listen", listen]).unwrap().validated().is_ok());
        }
    }

    #[test]
    fn service_on_all_addresses_is_reached_by_loopback() {
        let at = |listen: &str| parse(&["--listen", listen]).unwrap().local_address();
        assert_eq!(at("0.0.0.0:80").to_string(), "127.0.0.1:80");
        assert_eq!(at("[::]:80").to_string(), "[::1]:80");
        assert_eq!(at("192.0.2.1:80").to_string(), "192.0.2.1:80");
    }

    #[test]
    fn stores_of_later_versions_are_refused() {
        for flags in [["--store", "nats://localhost"], ["--blobs", "s3://bucket"]] {
            let error = parse(&flags).unwrap_err().to_string();
            assert!(error.contains("in this version") || error.contains("of this version"));
        }
    }

    #[test]
    fn there_is_always_a_worker() {
        assert!(parse(&[]).unwrap().worker_count() >= 1);
        assert!(parse(&["--workers", "0"]).unwrap().validated().is_err());
    }
}
