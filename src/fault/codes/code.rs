//! The code of a fault or a warning.

use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fmt;

/// The code of a fault or a warning, `area/kind`.
///
/// It is made of a variant of the enum of its area, such as
/// [`SeamCode::Twisted`](super::SeamCode::Twisted), or read from a stored record, where a code of
/// an older version is kept as it is.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct FaultCode(Cow<'static, str>);

impl FaultCode {
    /// Makes the code of an entry of a table.
    pub(super) const fn from_table(code: &'static str) -> Self {
        Self(Cow::Borrowed(code))
    }

    /// Returns the code on the wire.
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

impl fmt::Display for FaultCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl fmt::Debug for FaultCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&self.0, f)
    }
}

impl PartialEq<str> for FaultCode {
    fn eq(&self, code: &str) -> bool {
        self.0 == code
    }
}

impl PartialEq<&str> for FaultCode {
    fn eq(&self, code: &&str) -> bool {
        self.0 == *code
    }
}

#[cfg(test)]
mod tests {
    use super::super::SeamCode;
    use super::*;

    #[test]
    fn codes_are_texts_on_the_wire_those_of_older_versions_too() {
        let code = FaultCode::from(SeamCode::Twisted);
        assert_eq!(serde_json::to_string(&code).unwrap(), "\"seam/twisted\"");
        for text in ["\"seam/twisted\"", "\"seam/of_an_older_version\""] {
            let read: FaultCode = serde_json::from_str(text).unwrap();
            assert_eq!(serde_json::to_string(&read).unwrap(), text);
        }
        assert!(code == SeamCode::Twisted && code != SeamCode::Reversed);
    }
}
