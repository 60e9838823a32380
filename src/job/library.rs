//! Assets that a garment refers to by id, the fits of the queue among them.

use super::kind::JobKind;
use super::queue::Queue;
use super::result::ResultFile;
use super::status::JobStatus;
use super::store::StoreError;
use crate::fit::{AssetLibrary, FinishedFit, NoFinishedFit};
use crate::pattern::Pattern;
use crate::scene::{BodySource, Fabric};
use std::sync::Arc;
use uuid::Uuid;

/// The store's errors are logged and counted: to a garment, what cannot be read is not there.
impl AssetLibrary for Queue {
    fn pattern(&self, id: Uuid) -> Option<Arc<Pattern>> {
        self.catalogue().pattern(id)
    }

    fn body(&self, id: Uuid) -> Option<BodySource> {
        self.catalogue().body(id)
    }

    fn fabric(&self, id: &str) -> Option<Fabric> {
        self.catalogue().fabric(id)
    }

    fn finished_fit(&self, id: Uuid) -> Result<FinishedFit, NoFinishedFit> {
        let record = self.catalogue().noted(self.job(JobKind::Fit, id));
        let record = record.ok_or(NoFinishedFit::Unknown)?;
        if record.status != JobStatus::Succeeded {
            return Err(NoFinishedFit::NotSucceeded(record.status.as_str()));
        }
        let read = || -> Result<Option<FinishedFit>, StoreError> {
            let garment = self.request(JobKind::Fit, id)?;
            let mesh = self.file(&record, ResultFile::Mesh)?;
            let Some((garment, mesh)) = garment.zip(mesh) else {
                return Ok(None);
            };
            let unreadable = |cause| StoreError::of_data(format!("reading fit {id}"), cause);
            Ok(Some(FinishedFit {
                garment: serde_json::from_slice(&garment).map_err(unreadable)?,
                mesh: serde_json::from_slice(&mesh).map_err(unreadable)?,
            }))
        };
        self.catalogue().noted(read()).ok_or(NoFinishedFit::Unknown)
    }
}
