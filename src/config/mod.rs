//! Settings of the operator: one [`Config`], and the [`Limits`] on everything that comes from
//! outside.

mod limits;
mod settings;

pub use limits::Limits;
pub use settings::{BlobKind, Config, ConfigError, LogFormat, Logging, StoreKind};
