//! The documents of the catalogue: [`Documents`] in `SQLite`.

use super::paging::{id_bound, into_page, row_limit};
use super::store::SqliteStore;
use crate::job::store::{DocumentKind, Documents, Page, PageRequest, StoreError};
use rusqlite::params;
use uuid::Uuid;

impl Documents for SqliteStore {
    fn put(&self, kind: DocumentKind, id: Uuid, body: &[u8]) -> Result<(), StoreError> {
        self.write("storing a document", |transaction| {
            transaction.execute(
                "INSERT INTO documents (kind, id, body) VALUES (?1, ?2, ?3)",
                params![kind_name(kind), id.as_bytes(), body],
            )?;
            Ok(())
        })
    }

    fn get(&self, kind: DocumentKind, id: Uuid) -> Result<Option<Vec<u8>>, StoreError> {
        let query = "SELECT body FROM documents WHERE kind = ?1 AND id = ?2";
        let which = params![kind_name(kind), id.as_bytes()];
        let mut found = self.read("reading a document", (query, which), |row| row.get(0))?;
        Ok(found.pop())
    }

    fn delete(&self, kind: DocumentKind, id: Uuid) -> Result<bool, StoreError> {
        self.write("removing a document", |transaction| {
            let count = transaction.execute(
                "DELETE FROM documents WHERE kind = ?1 AND id = ?2",
                params![kind_name(kind), id.as_bytes()],
            )?;
            Ok(count == 1)
        })
    }

    fn list(
        &self,
        kind: DocumentKind,
        page: &PageRequest,
    ) -> Result<Page<(Uuid, Vec<u8>)>, StoreError> {
        let query =
            "SELECT id, body FROM documents WHERE kind = ?1 AND id < ?2 ORDER BY id DESC LIMIT ?3";
        let which = params![kind_name(kind), id_bound(page), row_limit(page)];
        let found = self.read("listing documents", (query, which), |row| {
            Ok((Uuid::from_bytes(row.get(0)?), row.get(1)?))
        })?;
        Ok(into_page(found, page, |(id, _)| *id))
    }
}

fn kind_name(kind: DocumentKind) -> &'static str {
    match kind {
        DocumentKind::Pattern => "pattern",
        DocumentKind::Avatar => "avatar",
        DocumentKind::Fabric => "fabric",
        DocumentKind::Body => "body",
    }
}
