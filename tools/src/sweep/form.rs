//! The body that a sweep sews on.

use seamster::config::Limits;
use seamster::fit::AvatarRef;
use seamster::scene::{self, BodyImportOptions, BodySource, DressForm};
use std::convert::Infallible;
use std::error::Error;
use std::fmt::{self, Display, Formatter};
use std::fs;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::Arc;

/// Body of a sweep.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// The form of each garment's own size.
    Own,
    /// The service's default form for all.
    Default,
    /// The body of a file for all.
    Body(PathBuf),
}

impl FromStr for Form {
    type Err = Infallible;

    fn from_str(word: &str) -> Result<Self, Infallible> {
        Ok(match word {
            "own" => Self::Own,
            "default" => Self::Default,
            file => Self::Body(file.into()),
        })
    }
}

impl Display for Form {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Own => f.write_str("own"),
            Self::Default => f.write_str("default"),
            Self::Body(file) => file.display().fmt(f),
        }
    }
}

impl Form {
    /// Returns the body for a garment that was drafted for the form `own`.
    ///
    /// # Errors
    /// A file of a body that cannot be read.
    pub(super) fn avatar(&self, own: DressForm) -> Result<AvatarRef, Box<dyn Error>> {
        Ok(match self {
            Self::Own => AvatarRef::form(own),
            Self::Default => AvatarRef::form(DressForm::default()),
            Self::Body(file) => AvatarRef::whole(read_body(file)?),
        })
    }
}

fn read_body(file: &Path) -> Result<BodySource, Box<dyn Error>> {
    let (options, limits) = (BodyImportOptions::default(), Limits::default());
    let import = scene::import_body(&fs::read(file)?, &options, &limits)?;
    Ok(BodySource::Own(Arc::new(import.body)))
}
