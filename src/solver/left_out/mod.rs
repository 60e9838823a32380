//! Terms that a scene lacks cost nothing: no term, no array, no instruction.

mod by_hand;
mod bytes;
mod instructions;
mod scenes;
mod terms;
