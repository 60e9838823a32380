//! Rules of the source itself: order of its modules, no circles of files, openings and lengths of
//! files.

mod circles;
mod direction;
mod house;
mod name_graph;
mod sources;
