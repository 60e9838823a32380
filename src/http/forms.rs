//! Dress forms that were made lately: one takes seconds, and a page asks for the same one again and again.

use crate::fault::Faults;
use crate::scene::{Avatar, DressForm};
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};

/// Forms kept, of some megabytes each.
const KEPT: usize = 4;

/// Dress forms that were made lately, newest last.
#[derive(Default)]
pub(super) struct Forms {
    // A std mutex: held to look and to put in, not while a form is made.
    made: Mutex<VecDeque<(DressForm, Arc<Avatar>)>>,
}

impl Forms {
    /// The avatar of these measurements. Blocks while it is made.
    ///
    /// # Errors
    /// Measurements outside what a person has, each with its pointer.
    pub(super) fn build(&self, form: &DressForm) -> Result<Arc<Avatar>, Faults> {
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
        if made.len() == KEPT {
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
        let forms = Forms::default();
        let form = DressForm::default();
        let first = forms.build(&form).unwrap();
        assert!(Arc::ptr_eq(&first, &forms.build(&form).unwrap()));
    }
}
