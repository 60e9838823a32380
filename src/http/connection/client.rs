//! The client of a request, as far as it is known.

use axum::http::Extensions;

/// The client of a request, as far as it is known: clients share what they may hold by this.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(in crate::http) enum Client {
    /// Any client without a token of the service.
    #[default]
    Anonymous,
    /// The client whose token has this number.
    Token(usize),
}

impl Client {
    /// Returns the client that the middleware found for a request.
    pub(in crate::http) fn of(extensions: &Extensions) -> Self {
        extensions.get().copied().unwrap_or_default()
    }
}
