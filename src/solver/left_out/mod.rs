//! What a scene lacks costs nothing: no term, no array, no instruction.

mod by_hand;
mod bytes;
#[path = "../../../tests/support/callgrind.rs"]
mod callgrind;
mod instructions;
mod scenes;
mod terms;
