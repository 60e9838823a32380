//! A cache of dress forms: one takes most of a second to make, and the same one is dressed again
//! and again.

use super::{Avatar, DressForm};
use crate::fault::Faults;
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};

/// Number of forms kept, of some megabytes each.
const CAPACITY: usize = 4;

/// A cache of the dress forms made lately, newest last.
#[derive(Debug, Default)]
pub struct DressFormCache {
    // A std mutex: held for a lookup or an insertion, not while a form is made.
    made: Mutex<VecDeque<(DressForm, Arc<Avatar>)>>,
}

impl DressFormCache {
    /// Returns the avatar of these measurements. Blocks while it is made.
    ///
    /// # Errors
    /// Measurements outside what a person has, each with its pointer.
    pub fn build(&self, form: &DressForm) -> Result<Arc<Avatar>, Faults> {
        let known = {
            let made = self.made.lock().unwrap_or_else(PoisonError::into_inner);
            let found = made.iter().find(|(known, _)| known == form);
            found.map(|(_, avatar)| Arc::clone(avatar))
        };
        if let Some(avatar) = known {
            return Ok(avatar);
        }
        let avatar = Arc::new(form.build()?);
        let mut made = self.made.lock().unwrap_or_else(PoisonError::into_inner);
        if made.len() == CAPACITY {
            made.pop_front();
        }
        made.push_back((*form, Arc::clone(&avatar)));
        Ok(avatar)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_measurements_are_made_once() {
        let cache = DressFormCache::default();
        let form = DressForm::default();
        let first = cache.build(&form).unwrap();
        assert!(Arc::ptr_eq(&first, &cache.build(&form).unwrap()));
    }
}
