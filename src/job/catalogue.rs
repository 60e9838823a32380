//! Stored patterns, avatars and fabrics, which garments refer to.

use super::store::{DocumentKind, Documents, Page, PageRequest, StoreError};
use crate::fault::Warning;
use crate::fit::AssetLibrary;
use crate::pattern::Pattern;
use crate::scene::{
    self, AvatarCache, BodyFormat, BodyImport, BodySource, BodyUnits, DressForm, Fabric, OwnBody,
};
use jiff::Timestamp;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use utoipa::ToSchema;
use uuid::Uuid;

/// A dress form as it is requested.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct AvatarRequest {
    /// Name for a person.
    #[serde(default)]
    pub name: Option<String>,
    /// The measurements it is made from.
    pub form: DressForm,
}

/// An avatar as it is kept: its form, or what is known of its file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AvatarRecord {
    /// Name for a person.
    #[serde(default)]
    pub name: Option<String>,
    /// The measurements it is made from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub form: Option<DressForm>,
    /// The file it was read from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<BodyFile>,
}

/// The file that a body was read from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct BodyFile {
    /// Its format.
    pub format: BodyFormat,
    /// Unit of its coordinates.
    pub units: BodyUnits,
    /// Rows of the map from its coordinates to those of the avatar \[m\]: three factors and an
    /// addend each.
    #[schema(value_type = Vec<Vec<f64>>)]
    pub from_file: [[f64; 4]; 3],
    /// Vertices of the body.
    pub vertex_count: usize,
    /// Triangles of the body.
    pub triangle_count: usize,
    /// Remarks: what was found, mended and left out.
    pub warnings: Vec<Warning>,
    /// Key of its surface, made of that.
    pub surface: Uuid,
}

/// A stored thing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stored<T> {
    /// `UUIDv7`.
    pub id: Uuid,
    /// Time at which it was stored.
    pub created_at: Timestamp,
    /// The thing.
    pub value: T,
}

/// Stored patterns, avatars and fabrics. All calls block.
pub struct Catalogue {
    documents: Arc<dyn Documents>,
    bodies: Arc<AvatarCache>,
    failed_reads: AtomicU64,
}

impl Catalogue {
    /// Creates the catalogue of a document store.
    pub fn new(documents: Arc<dyn Documents>) -> Self {
        Self {
            documents,
            bodies: Arc::default(),
            failed_reads: AtomicU64::new(0),
        }
    }

    /// Returns how often something could not be read that a garment refers to: where that grew, a
    /// refusal of the garment is not to be trusted.
    pub fn failed_reads(&self) -> u64 {
        self.failed_reads.load(Ordering::Relaxed)
    }

    /// Returns what was found; an error of the store is logged and counted.
    pub(super) fn noted<T>(&self, found: Result<Option<T>, StoreError>) -> Option<T> {
        found.unwrap_or_else(|error| {
            tracing::error!(%error, "the catalogue cannot be read");
            self.failed_reads.fetch_add(1, Ordering::Relaxed);
            None
        })
    }

    /// Returns the bodies made lately.
    pub fn bodies(&self) -> &Arc<AvatarCache> {
        &self.bodies
    }

    /// Stores a pattern, checked before, and gives it its id.
    ///
    /// # Errors
    /// If nothing could be written.
    pub fn add_pattern(&self, mut pattern: Pattern) -> Result<Stored<Pattern>, StoreError> {
        let id = Uuid::now_v7();
        pattern.id = Some(id);
        self.add(DocumentKind::Pattern, id, pattern)
    }

    /// Stores a dress form, checked before.
    ///
    /// # Errors
    /// If nothing could be written.
    pub fn add_form(&self, form: AvatarRequest) -> Result<Stored<AvatarRecord>, StoreError> {
        let record = AvatarRecord {
            name: form.name,
            form: Some(form.form),
            file: None,
        };
        self.add(DocumentKind::Avatar, Uuid::now_v7(), record)
    }

    /// Stores a body read from a file, checked before; its surface once, whatever avatars have it.
    ///
    /// # Errors
    /// If nothing could be written.
    pub fn add_body(
        &self,
        name: Option<String>,
        import: &BodyImport,
    ) -> Result<Stored<AvatarRecord>, StoreError> {
        let body = &import.body;
        let bytes = serde_json::to_vec(body)
            .map_err(|cause| StoreError::of_data("writing a body".to_owned(), cause))?;
        let surface = content_id(&bytes);
        if self.documents.get(DocumentKind::Body, surface)?.is_none() {
            self.documents.put(DocumentKind::Body, surface, &bytes)?;
        }
        let file = BodyFile {
            format: import.format,
            units: import.units,
            from_file: import.from_file,
            vertex_count: body.vertices.len(),
            triangle_count: body.triangles.len(),
            warnings: import.warnings.clone(),
            surface,
        };
        let record = AvatarRecord {
            name,
            form: None,
            file: Some(file),
        };
        self.add(DocumentKind::Avatar, Uuid::now_v7(), record)
    }

    /// Finds what an avatar is made from.
    ///
    /// # Errors
    /// If nothing could be read, or its surface is not there.
    pub fn source(&self, avatar: &AvatarRecord) -> Result<BodySource, StoreError> {
        if let Some(form) = avatar.form {
            return Ok(BodySource::Form(form));
        }
        let lost = || StoreError::of_data("reading an avatar".to_owned(), "it has no surface");
        let key = avatar.file.as_ref().ok_or_else(lost)?.surface;
        let bytes = self.documents.get(DocumentKind::Body, key)?;
        let body: OwnBody = serde_json::from_slice(&bytes.ok_or_else(lost)?)
            .map_err(|cause| StoreError::of_data(format!("reading the body {key}"), cause))?;
        Ok(BodySource::Own(Arc::new(body)))
    }

    /// Removes an avatar, and its surface if no other one has it; returns true if it was there.
    /// Fits keep their own copy.
    ///
    /// # Errors
    /// If nothing could be written.
    pub fn remove_avatar(&self, id: Uuid) -> Result<bool, StoreError> {
        let found = self.find_avatar(id)?;
        let removed = self.documents.delete(DocumentKind::Avatar, id)?;
        let Some(file) = found.and_then(|stored| stored.value.file) else {
            return Ok(removed);
        };
        let others = self.avatars(&PageRequest {
            limit: usize::MAX,
            ..PageRequest::default()
        })?;
        let has_it = |other: &Stored<AvatarRecord>| {
            let own = other.value.file.as_ref();
            own.is_some_and(|own| own.surface == file.surface)
        };
        if !others.items.iter().any(has_it) {
            self.documents.delete(DocumentKind::Body, file.surface)?;
        }
        Ok(removed)
    }

    /// Stores a fabric, checked before. Garments refer to it by its id in text.
    ///
    /// # Errors
    /// If nothing could be written.
    pub fn add_fabric(&self, fabric: Fabric) -> Result<Stored<Fabric>, StoreError> {
        self.add(DocumentKind::Fabric, Uuid::now_v7(), fabric)
    }

    /// Finds a pattern.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn find_pattern(&self, id: Uuid) -> Result<Option<Stored<Pattern>>, StoreError> {
        self.find(DocumentKind::Pattern, id)
    }

    /// Finds an avatar, as it was requested.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn find_avatar(&self, id: Uuid) -> Result<Option<Stored<AvatarRecord>>, StoreError> {
        self.find(DocumentKind::Avatar, id)
    }

    /// Returns patterns, newest first.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn patterns(&self, page: &PageRequest) -> Result<Page<Stored<Pattern>>, StoreError> {
        self.list(DocumentKind::Pattern, page)
    }

    /// Returns avatars, newest first.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn avatars(&self, page: &PageRequest) -> Result<Page<Stored<AvatarRecord>>, StoreError> {
        self.list(DocumentKind::Avatar, page)
    }

    /// Returns all fabrics by id: those shipped and those stored.
    ///
    /// # Errors
    /// If nothing could be read.
    pub fn fabrics(&self) -> Result<BTreeMap<String, Fabric>, StoreError> {
        let everything = PageRequest {
            limit: usize::MAX,
            ..PageRequest::default()
        };
        let own = self.list::<Fabric>(DocumentKind::Fabric, &everything)?;
        let mut fabrics = scene::library();
        fabrics.extend(
            own.items
                .into_iter()
                .map(|stored| (stored.id.to_string(), stored.value)),
        );
        Ok(fabrics)
    }

    /// Removes a pattern or a fabric; returns true if it was there. Fits keep their own
    /// copy.
    ///
    /// # Errors
    /// If nothing could be written.
    pub fn remove(&self, kind: DocumentKind, id: Uuid) -> Result<bool, StoreError> {
        self.documents.delete(kind, id)
    }

    fn add<T: Serialize>(
        &self,
        kind: DocumentKind,
        id: Uuid,
        value: T,
    ) -> Result<Stored<T>, StoreError> {
        let stored = Stored {
            id,
            created_at: Timestamp::now(),
            value,
        };
        let body = serde_json::to_vec(&stored)
            .map_err(|cause| StoreError::of_data(format!("writing {kind:?} {id}"), cause))?;
        self.documents.put(kind, id, &body)?;
        Ok(stored)
    }

    fn find<T: DeserializeOwned>(
        &self,
        kind: DocumentKind,
        id: Uuid,
    ) -> Result<Option<Stored<T>>, StoreError> {
        let body = self.documents.get(kind, id)?;
        body.map(|body| read(kind, id, &body)).transpose()
    }

    fn list<T: DeserializeOwned>(
        &self,
        kind: DocumentKind,
        page: &PageRequest,
    ) -> Result<Page<Stored<T>>, StoreError> {
        let page = self.documents.list(kind, page)?;
        let items = page
            .items
            .iter()
            .map(|(id, body)| read(kind, *id, body))
            .collect::<Result<_, _>>()?;
        Ok(Page {
            items,
            next: page.next,
        })
    }
}

/// The id of bytes by their SHA-256 (RFC 9562, version 8).
fn content_id(bytes: &[u8]) -> Uuid {
    let digest: [u8; 32] = Sha256::digest(bytes).into();
    let mut first = [0; 16];
    first.copy_from_slice(&digest[..16]);
    first[6] = (first[6] & 0x0f) | 0x80;
    first[8] = (first[8] & 0x3f) | 0x80;
    Uuid::from_bytes(first)
}

fn read<T: DeserializeOwned>(
    kind: DocumentKind,
    id: Uuid,
    body: &[u8],
) -> Result<Stored<T>, StoreError> {
    serde_json::from_slice(body)
        .map_err(|cause| StoreError::of_data(format!("reading {kind:?} {id}"), cause))
}

/// The store's errors are logged and counted: to a garment, what cannot be read is not there.
impl AssetLibrary for Catalogue {
    fn pattern(&self, id: Uuid) -> Option<Arc<Pattern>> {
        let found = self.noted(self.find_pattern(id));
        found.map(|stored| Arc::new(stored.value))
    }

    fn body(&self, id: Uuid) -> Option<BodySource> {
        let stored = self.noted(self.find_avatar(id))?;
        self.noted(self.source(&stored.value).map(Some))
    }

    fn fabric(&self, id: &str) -> Option<Fabric> {
        if let Some(fabric) = scene::library().remove(id) {
            return Some(fabric);
        }
        let id = Uuid::parse_str(id).ok()?;
        let found = self.noted(self.find(DocumentKind::Fabric, id));
        found.map(|stored| stored.value)
    }
}
