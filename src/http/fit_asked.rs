//! What `POST /v1/fits` reads: a garment, or a form of a DXF and a garment.

use super::body::{self, Hashed, Upload};
use super::problem::Problem;
use super::state::{App, Shared};
use crate::fault::{Fault, Faults};
use crate::fit::{self, Garment, Misshapen, PatternAsked};
use crate::pattern::{self, ImportOptions, Pattern};
use axum::extract::{FromRequest, Request};
use sha2::{Digest, Sha256};

/// A garment of the right shape, whose meaning is not yet checked.
pub(super) struct FitAsked {
    /// The garment.
    pub(super) garment: Garment,
    /// SHA-256 of what was sent; of a form, of its parts: each client sets its own boundary every time.
    pub(super) digest: [u8; 32],
}

impl FromRequest<App> for FitAsked {
    type Rejection = Problem;

    async fn from_request(request: Request, app: &App) -> Result<Self, Problem> {
        if body::content_type(request.headers()) == "multipart/form-data" {
            let most = app.limits().dxf_bytes + app.limits().json_bytes;
            let [pattern, garment] = body::parts(request, most, ["pattern", "garment"]).await?;
            let pattern = pattern.ok_or_else(|| body::missing_part("pattern"))?;
            let garment = garment.ok_or_else(|| body::missing_part("garment"))?;
            let pattern = pattern.within(app.limits().dxf_bytes)?;
            let garment = garment.within(app.limits().json_bytes)?;
            return app
                .heavy(move |app| of_form(app, pattern, &garment))
                .await?;
        }
        let Hashed(garment, digest) = Hashed::from_request(request, app).await?;
        Ok(Self { garment, digest })
    }
}

/// Reads both parts and tells the faults of both at once.
fn of_form(app: &Shared, file: Upload, json: &Upload) -> Result<FitAsked, Problem> {
    let digest = Sha256::new()
        .chain_update(Sha256::digest(&file.bytes))
        .chain_update(Sha256::digest(&json.bytes))
        .finalize()
        .into();
    let options = ImportOptions {
        name: file.name,
        ..ImportOptions::default()
    };
    let pattern = pattern::import(&file.bytes, &options, app.limits());
    let garment = fit::read_garment(&json.bytes);
    match (pattern, garment) {
        (Ok(pattern), Ok(garment)) => Ok(FitAsked {
            garment: with_pattern(garment, pattern)?,
            digest,
        }),
        (Ok(_), Err(misshapen)) => Err(misshapen.into()),
        (Err(faults), Ok(_)) => Err(faults.into()),
        (Err(faults), Err(misshapen)) => Err(both(faults, misshapen)),
    }
}

fn with_pattern(garment: Garment, pattern: Pattern) -> Result<Garment, Fault> {
    if garment.pattern.is_some() {
        let detail = "the pattern comes as a part of the form and in the garment too";
        return Err(
            Fault::new("fit/two_patterns", "/pattern", detail).fix("leave it out of the garment")
        );
    }
    Ok(Garment {
        pattern: Some(PatternAsked::Whole(Box::new(pattern))),
        ..garment
    })
}

fn both(mut faults: Faults, misshapen: Misshapen) -> Problem {
    match misshapen {
        Misshapen::Syntax(fault) => {
            faults.0.push(fault);
            Problem::unreadable(faults)
        }
        Misshapen::Shape(more) => {
            faults.0.extend(more.0);
            faults.into()
        }
    }
}
