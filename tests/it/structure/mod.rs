//! Rules of the source itself: order of its modules, openings and lengths of its files.

mod direction;
mod house;
