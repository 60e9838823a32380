//! The contract of [`Documents`], as tests that each implementation runs.

use super::store::{DocumentKind, Documents, PageRequest};
use uuid::Uuid;

/// Runs every test of [`Documents`].
pub(super) fn documents_contract(store: &dyn Documents) {
    let ids: Vec<Uuid> = (0..4).map(|_| Uuid::now_v7()).collect();
    for id in &ids {
        store
            .put(DocumentKind::Pattern, *id, id.as_bytes())
            .unwrap();
    }
    store.put(DocumentKind::Avatar, ids[0], b"body").unwrap();
    let get = |kind, id| store.get(kind, id).unwrap();
    assert_eq!(get(DocumentKind::Avatar, ids[0]), Some(b"body".to_vec()));
    assert_eq!(get(DocumentKind::Fabric, ids[0]), None);
    assert!(store.put(DocumentKind::Avatar, ids[0], b"other").is_err());
    let page = |after| PageRequest {
        limit: 3,
        after,
        status: None,
    };
    let first = store.list(DocumentKind::Pattern, &page(None)).unwrap();
    let found: Vec<Uuid> = first.items.iter().map(|(id, _)| *id).collect();
    assert_eq!(found, [ids[3], ids[2], ids[1]]);
    let second = store
        .list(DocumentKind::Pattern, &page(first.next))
        .unwrap();
    assert_eq!(second.items, [(ids[0], ids[0].as_bytes().to_vec())]);
    assert_eq!(second.next, None);
    assert!(store.delete(DocumentKind::Pattern, ids[0]).unwrap());
    assert!(!store.delete(DocumentKind::Pattern, ids[0]).unwrap());
    assert_eq!(get(DocumentKind::Pattern, ids[0]), None);
    assert!(get(DocumentKind::Avatar, ids[0]).is_some());
}
