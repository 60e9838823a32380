//! The body of the tests of placement: the default form with arms and legs.

use crate::scene::{Avatar, DressForm, Limbs};

pub(super) fn body() -> Avatar {
    let form = DressForm {
        limbs: Some(Limbs {
            arms: true,
            legs: true,
        }),
        ..DressForm::default()
    };
    form.build().expect("a body")
}
