//! Stored patterns, avatars and fabrics, which garments refer to.

use super::store::{DocumentKind, Documents, Page, PageRequest, StoreError};
use crate::fit::AssetLibrary;
use crate::pattern::Pattern;
use crate::scene::{self, DressForm, DressFormCache, Fabric};
use jiff::Timestamp;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;
use utoipa::ToSchema;
use uuid::Uuid;

/// An avatar as it was requested.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct AvatarRecord {
    /// Name for a person.
    #[serde(default)]
    pub name: Option<String>,
    /// The measurements it is made from.
    pub form: DressForm,
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
    dress_forms: Arc<DressFormCache>,
}

impl Catalogue {
    /// Creates the catalogue of a document store.
    pub fn new(documents: Arc<dyn Documents>) -> Self {
        Self {
            documents,
            dress_forms: Arc::default(),
        }
    }

    /// Returns the dress forms made lately.
    pub fn dress_forms(&self) -> &Arc<DressFormCache> {
        &self.dress_forms
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

    /// Stores an avatar, checked before.
    ///
    /// # Errors
    /// If nothing could be written.
    pub fn add_avatar(&self, avatar: AvatarRecord) -> Result<Stored<AvatarRecord>, StoreError> {
        self.add(DocumentKind::Avatar, Uuid::now_v7(), avatar)
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

    /// Removes a pattern, an avatar or a fabric; returns true if it was there. Fits keep their own
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
            .map_err(|cause| StoreError::new(format!("writing {kind:?} {id}"), cause))?;
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

fn read<T: DeserializeOwned>(
    kind: DocumentKind,
    id: Uuid,
    body: &[u8],
) -> Result<Stored<T>, StoreError> {
    serde_json::from_slice(body)
        .map_err(|cause| StoreError::new(format!("reading {kind:?} {id}"), cause))
}

/// The store's errors are logged here: to a garment, what cannot be read is not there.
impl AssetLibrary for Catalogue {
    fn pattern(&self, id: Uuid) -> Option<Arc<Pattern>> {
        logged(self.find_pattern(id)).map(|stored| Arc::new(stored.value))
    }

    fn form(&self, id: Uuid) -> Option<DressForm> {
        logged(self.find_avatar(id)).map(|stored| stored.value.form)
    }

    fn fabric(&self, id: &str) -> Option<Fabric> {
        if let Some(fabric) = scene::library().remove(id) {
            return Some(fabric);
        }
        let id = Uuid::parse_str(id).ok()?;
        logged(self.find(DocumentKind::Fabric, id)).map(|stored| stored.value)
    }
}

/// Returns what was found; the error of the store is logged.
pub(super) fn logged<T>(found: Result<Option<T>, StoreError>) -> Option<T> {
    found.unwrap_or_else(|error| {
        tracing::error!(%error, "the catalogue cannot be read");
        None
    })
}
