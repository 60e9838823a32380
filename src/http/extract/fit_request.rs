//! The body of `POST /v1/fits`: a garment, or a form of a DXF and a garment.

use super::body::content_type;
use super::invalid::{missing_part, two_patterns};
use super::json::{JsonMemory, JsonWithDigest, measure_json};
use super::upload::{Upload, read_form};
use crate::fault::{Fault, Faults};
use crate::fit::{self, Garment, PatternRef, ReadError};
use crate::http::respond::Problem;
use crate::http::state::{App, AppState};
use crate::pattern::{self, ImportOptions, Pattern};
use axum::extract::{FromRequest, Request};
use sha2::{Digest, Sha256};

/// A garment of the right shape, whose meaning is not yet checked.
pub(in crate::http) struct FitRequest {
    /// The garment.
    pub(in crate::http) garment: Garment,
    /// SHA-256 of the body; of a form, of its parts: each client sets its own boundary every time.
    pub(in crate::http) digest: [u8; 32],
    /// The right to the memory of the garment.
    pub(in crate::http) memory: JsonMemory,
}

impl FromRequest<AppState> for FitRequest {
    type Rejection = Problem;

    async fn from_request(request: Request, state: &AppState) -> Result<Self, Problem> {
        if content_type(request.headers()) != "multipart/form-data" {
            let JsonWithDigest {
                value: garment,
                digest,
                memory,
            } = JsonWithDigest::from_request(request, state).await?;
            return Ok(Self {
                garment,
                digest,
                memory,
            });
        }
        let limits = state.limits();
        let max_bytes = limits.dxf_bytes + limits.json_bytes;
        let [pattern, garment] =
            read_form(state, request, max_bytes, ["pattern", "garment"]).await?;
        let pattern = pattern.ok_or_else(|| missing_part("pattern"))?;
        let garment = garment.ok_or_else(|| missing_part("garment"))?;
        let pattern = pattern.within(limits.dxf_bytes)?;
        let garment = garment.within(limits.json_bytes)?;
        let text = garment.bytes.clone();
        let measure = move |app: &App| measure_json::<Garment>(&text, app.limits());
        let measured = state.run_compute(measure).await?;
        let memory = match measured {
            Ok(bytes) => state.json_memory(bytes).await,
            Err(_) => None,
        };
        let read = move |app: &App| {
            let request = read_parts(app, pattern, &garment, measured)?;
            Ok(Self { memory, ..request })
        };
        state.run_compute(read).await?
    }
}

/// Reads both parts of a form, and returns the faults of both at once.
fn read_parts(
    app: &App,
    file: Upload,
    json: &Upload,
    measured: Result<usize, ReadError>,
) -> Result<FitRequest, Problem> {
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
    let garment = measured.and_then(|_| fit::garment_schema().read(&json.bytes));
    match (pattern, garment) {
        (Ok(pattern), Ok(garment)) => Ok(FitRequest {
            garment: with_pattern(garment, pattern)?,
            digest,
            memory: None,
        }),
        (Ok(_), Err(misshapen)) => Err(misshapen.into()),
        (Err(faults), Ok(_)) => Err(faults.into()),
        (Err(faults), Err(misshapen)) => Err(merged_problem(faults, misshapen)),
    }
}

fn with_pattern(garment: Garment, pattern: Pattern) -> Result<Garment, Fault> {
    if garment.pattern.is_some() {
        return Err(two_patterns());
    }
    Ok(Garment {
        pattern: Some(PatternRef::Whole(Box::new(pattern))),
        ..garment
    })
}

fn merged_problem(mut faults: Faults, misshapen: ReadError) -> Problem {
    match misshapen {
        ReadError::Syntax(fault) => {
            faults.0.push(fault);
            Problem::unreadable(faults)
        }
        ReadError::Schema(more) => {
            faults.0.extend(more.0);
            faults.into()
        }
        ReadError::Many(more) => {
            faults.0.extend(more.0);
            Problem::invalid_uncounted(faults)
        }
    }
}
