//! The hosts and tokens that requests are accepted with.

use crate::http::connection::Client;
use axum::http::HeaderMap;
use headers::HeaderMapExt;
use headers::authorization::{Authorization, Bearer};
use sha2::{Digest, Sha256};
use std::net::IpAddr;

/// The hosts and tokens that requests are accepted with.
#[derive(Debug)]
pub(in crate::http) struct AccessPolicy {
    hosts: Vec<String>,
    /// SHA-256 of each token: digests have one length, so that comparing them takes one time.
    tokens: Vec<[u8; 32]>,
}

impl AccessPolicy {
    /// Accepts loopback and `hosts`; without `tokens` every request is accepted.
    pub(in crate::http) fn new(hosts: &[String], tokens: &[String]) -> Self {
        Self {
            hosts: hosts.iter().map(|host| host.to_lowercase()).collect(),
            tokens: tokens.iter().map(|token| digest(token)).collect(),
        }
    }

    /// Returns true if `host`, with or without a port, is a name of this service.
    pub(super) fn is_own_host(&self, host: &str) -> bool {
        let name = host_name(host).to_lowercase();
        let bare = name.trim_start_matches('[').trim_end_matches(']');
        let is_loopback = |ip: IpAddr| ip.to_canonical().is_loopback();
        bare == "localhost"
            || bare.parse().is_ok_and(is_loopback)
            || self.hosts.contains(&name)
            || self.hosts.contains(&host.to_lowercase())
    }

    /// Returns true if a client may call: any may if the service has no tokens.
    pub(super) fn is_authorized(&self, client: Client) -> bool {
        self.tokens.is_empty() || client != Client::Anonymous
    }

    /// Returns the client whose token the headers carry.
    pub(super) fn client(&self, headers: &HeaderMap) -> Client {
        let Some(authorization) = headers.typed_get::<Authorization<Bearer>>() else {
            return Client::Anonymous;
        };
        let given = digest(authorization.token().trim());
        // Every token is compared to its last byte: the time says nothing about how near a guess
        // was.
        let tokens = self.tokens.iter().enumerate();
        tokens.fold(Client::Anonymous, |found, (number, known)| {
            let differing = known.iter().zip(given).fold(0, |sum, (a, b)| sum | (a ^ b));
            if differing == 0 {
                Client::Token(number)
            } else {
                found
            }
        })
    }
}

fn digest(token: &str) -> [u8; 32] {
    Sha256::digest(token).into()
}

/// Returns a host without its port.
fn host_name(host: &str) -> &str {
    match host.rsplit_once(':') {
        Some((name, port)) if port.bytes().all(|byte| byte.is_ascii_digit()) => name,
        _ => host,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use axum::http::{HeaderValue, header};

    #[test]
    fn loopback_and_configured_names_are_own_hosts() {
        let policy = AccessPolicy::new(&["Sew.example".to_owned()], &[]);
        for host in [
            "localhost",
            "LOCALHOST:80",
            "127.0.0.1:1",
            "127.1.2.3",
            "[::1]:8737",
            "sew.example:443",
            "[::ffff:127.0.0.1]:1",
        ] {
            assert!(policy.is_own_host(host), "{host}");
        }
        for host in [
            "",
            "evil.example",
            "localhost.evil.example",
            "sew.example.evil",
            "10.0.0.1",
            "127.0.0.1.evil",
        ] {
            assert!(!policy.is_own_host(host), "{host}");
        }
    }

    #[test]
    fn only_the_whole_token_is_authorized() {
        let policy = AccessPolicy::new(&[], &["secret".to_owned(), "other".to_owned()]);
        let client = |value: &str| {
            let mut headers = HeaderMap::new();
            headers.insert(header::AUTHORIZATION, HeaderValue::from_str(value).unwrap());
            policy.client(&headers)
        };
        for (value, number) in [("Bearer secret", 0), ("bearer other", 1)] {
            assert_eq!(client(value), Client::Token(number));
            assert!(policy.is_authorized(client(value)));
        }
        for wrong in [
            "Bearer secre",
            "Bearer secrets",
            "Bearer ",
            "Basic secret",
            "secret",
        ] {
            assert!(!policy.is_authorized(client(wrong)), "{wrong}");
        }
        assert_eq!(policy.client(&HeaderMap::new()), Client::Anonymous);
        assert!(AccessPolicy::new(&[], &[]).is_authorized(Client::Anonymous));
    }
}
