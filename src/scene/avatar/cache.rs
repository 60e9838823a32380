//! A cache of bodies: one takes most of a second to make, and the same one is dressed again and
//! again.

use super::{Avatar, BodySource};
use crate::fault::Faults;
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};

/// Number of bodies kept, of some megabytes each.
const CAPACITY: usize = 4;

/// A cache of the bodies made lately, by what they are made from, newest last.
#[derive(Debug, Default)]
pub struct AvatarCache {
    // A std mutex: held for a lookup or an insertion, not while a body is made.
    made: Mutex<VecDeque<(BodySource, Arc<Avatar>)>>,
}

impl AvatarCache {
    /// Returns the avatar of a body. Blocks while it is made.
    ///
    /// # Errors
    /// All that is wrong with its measurements, or with its surface and landmarks.
    pub fn build(&self, source: &BodySource) -> Result<Arc<Avatar>, Faults> {
        let known = {
            let made = self.made.lock().unwrap_or_else(PoisonError::into_inner);
            let found = made.iter().find(|(known, _)| known == source);
            found.map(|(_, avatar)| Arc::clone(avatar))
        };
        if let Some(avatar) = known {
            return Ok(avatar);
        }
        let avatar = Arc::new(source.build()?);
        let mut made = self.made.lock().unwrap_or_else(PoisonError::into_inner);
        if made.len() == CAPACITY {
            made.pop_front();
        }
        made.push_back((source.clone(), Arc::clone(&avatar)));
        Ok(avatar)
    }
}

#[cfg(test)]
mod tests {
    use super::super::DressForm;
    use super::*;

    #[test]
    fn the_same_measurements_are_made_once() {
        let cache = AvatarCache::default();
        let form = BodySource::Form(DressForm::default());
        let first = cache.build(&form).unwrap();
        assert!(Arc::ptr_eq(&first, &cache.build(&form).unwrap()));
    }
}
