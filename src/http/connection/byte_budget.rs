//! Bytes in flight: how many may be held at the same time, in all and by one client.

use super::client::Client;
use axum::body::Bytes;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};

/// Bytes that one permit stands for.
const UNIT: usize = 4 << 10;
/// Bytes that are not counted: what nearly every request has.
const FREE: usize = 64 << 10;
/// Share of all bytes that one client may hold, in percent: the largest body must fit.
const SHARE_PERCENT: u64 = 83;

/// The right to hold bytes, given back when it is dropped.
#[derive(Debug)]
pub(in crate::http) struct HeldBytes {
    client: Client,
    bytes: usize,
    /// Permits of the share of the client.
    own: Option<OwnedSemaphorePermit>,
    /// Permits of all there is.
    all: Option<OwnedSemaphorePermit>,
}

impl HeldBytes {
    /// Creates the right of a client to hold nothing yet.
    pub(in crate::http) fn new(client: Client) -> Self {
        Self {
            client,
            bytes: 0,
            own: None,
            all: None,
        }
    }

    /// Returns true if the bytes are too few to be counted.
    pub(in crate::http) fn is_free(&self) -> bool {
        self.bytes <= FREE
    }
}

/// The bytes that may be held at the same time, in all and by one client.
pub(in crate::http) struct ByteBudget {
    units: u32,
    share: u32,
    all: Arc<Semaphore>,
    // A std mutex: held for one look, never over an await. Clients are few: one a token.
    by_client: Mutex<HashMap<Client, Arc<Semaphore>>>,
}

impl ByteBudget {
    /// Creates the budget of so many bytes.
    pub(in crate::http) fn new(bytes: usize) -> Self {
        let units = units_of(bytes).max(1);
        let share = u64::from(units) * SHARE_PERCENT / 100;
        Self {
            units,
            share: u32::try_from(share).unwrap_or(units).max(1),
            all: Arc::new(Semaphore::new(units as usize)),
            by_client: Mutex::default(),
        }
    }

    /// Returns the right of a client to hold `bytes`, if there is room. What is larger than all
    /// there is takes all of it.
    pub(in crate::http) fn take(&self, client: Client, bytes: usize) -> Option<HeldBytes> {
        let mut held = HeldBytes::new(client);
        self.extend(&mut held, bytes).then_some(held)
    }

    /// Makes the right to hold bytes one to hold `bytes`; returns false if there is no room.
    pub(in crate::http) fn extend(&self, held: &mut HeldBytes, bytes: usize) -> bool {
        if bytes <= held.bytes {
            return true;
        }
        let counted = |bytes: usize, most: u32| units_of(bytes.saturating_sub(FREE)).min(most);
        let more = |most| counted(bytes, most).saturating_sub(counted(held.bytes, most));
        let (of_client, of_all) = (more(self.share), more(self.units));
        let own = self
            .semaphore(held.client)
            .try_acquire_many_owned(of_client);
        let all = Arc::clone(&self.all).try_acquire_many_owned(of_all);
        let (Ok(own), Ok(all)) = (own, all) else {
            return false;
        };
        held.bytes = bytes;
        merge(&mut held.own, own);
        merge(&mut held.all, all);
        true
    }

    fn semaphore(&self, client: Client) -> Arc<Semaphore> {
        let mut by_client = self
            .by_client
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        let make = || Arc::new(Semaphore::new(self.share as usize));
        Arc::clone(by_client.entry(client).or_insert_with(make))
    }
}

/// Adds permits of one semaphore to those that are held of it.
fn merge(held: &mut Option<OwnedSemaphorePermit>, more: OwnedSemaphorePermit) {
    match held {
        Some(held) => held.merge(more),
        None => *held = Some(more),
    }
}

fn units_of(bytes: usize) -> u32 {
    u32::try_from(bytes.div_ceil(UNIT)).unwrap_or(u32::MAX)
}

/// Bytes with the right to hold them.
struct Owned {
    bytes: Bytes,
    _held: Arc<HeldBytes>,
}

impl AsRef<[u8]> for Owned {
    fn as_ref(&self) -> &[u8] {
        &self.bytes
    }
}

/// Ties the right to hold bytes to them: it is given back with the last part of them.
pub(in crate::http) fn held(bytes: Bytes, held: &Arc<HeldBytes>) -> Bytes {
    Bytes::from_owner(Owned {
        bytes,
        _held: Arc::clone(held),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const ONE: Client = Client::Token(0);
    const OTHER: Client = Client::Anonymous;

    #[test]
    fn all_and_each_client_have_their_bounds() {
        let budget = ByteBudget::new(10 << 20);
        let first = budget.take(ONE, 8 << 20).expect("there is room");
        assert!(budget.take(ONE, 1 << 20).is_none(), "its share is used up");
        let small = budget.take(ONE, FREE);
        assert!(small.is_some(), "what is small is free");
        let second = budget
            .take(OTHER, 1 << 20)
            .expect("another client has room");
        assert!(budget.take(OTHER, 4 << 20).is_none(), "all is used up");
        drop((first, second));
        assert!(
            budget.take(OTHER, 100 << 20).is_some(),
            "the largest takes all"
        );
    }

    #[test]
    fn the_right_goes_with_the_last_part() {
        let budget = ByteBudget::new(1 << 20);
        let right = Arc::new(budget.take(ONE, 800 << 10).expect("there is room"));
        let whole = held(Bytes::from(vec![0; 800 << 10]), &right);
        drop(right);
        let part = whole.slice(..1);
        drop(whole);
        assert!(budget.take(ONE, 800 << 10).is_none());
        drop(part);
        assert!(budget.take(ONE, 800 << 10).is_some());
    }

    #[test]
    fn a_right_grows_as_bytes_come() {
        let budget = ByteBudget::new(1 << 20);
        let mut right = HeldBytes::new(ONE);
        for kilobytes in [10, 100, 400, 700] {
            assert!(budget.extend(&mut right, kilobytes << 10), "{kilobytes}");
        }
        assert!(budget.extend(&mut right, 2 << 20), "it is alone");
        assert!(budget.take(OTHER, 100 << 10).is_none(), "all is used up");
        drop(right);
        assert!(budget.take(ONE, 800 << 10).is_some());
    }

    #[test]
    fn a_right_that_grows_byte_by_byte_takes_what_it_would_at_once() {
        let budget = ByteBudget::new(1 << 20);
        let mut right = HeldBytes::new(ONE);
        for bytes in 1..=500 << 10 {
            assert!(budget.extend(&mut right, bytes), "{bytes}");
        }
        let counted = units_of((500 << 10) - FREE) as usize;
        let permits =
            [&right.own, &right.all].map(|held| held.as_ref().map(|held| held.num_permits()));
        assert_eq!(permits, [Some(counted); 2]);
        assert_eq!(
            budget.all.available_permits(),
            budget.units as usize - counted
        );
    }

    #[test]
    fn a_small_budget_has_its_share_too() {
        // A share of whole hundredths would be nothing.
        assert_eq!(ByteBudget::new(60 * UNIT).share, 49);
    }
}
