//! Start position of each panel (P7): its key point is put at a key point of the body, in front,
//! behind or round it, and what is rolled about the body is turned to the panels that it is sewn
//! to.

mod anchored;
mod by_seams;
#[cfg(test)]
mod by_seams_tests;
mod cone;
mod half_legs;
mod layered;
mod leg_cuffs;
mod leg_line;
mod lifted;
mod limb_pose;
mod name_hint;
mod on_leg;
mod on_limb;
mod panel_placement;
mod placed;
mod spot;
mod taper;
#[cfg(test)]
mod test_body;

pub use anchored::AnchoredPlacement;
pub use by_seams::place_panels;
pub use panel_placement::{PanelPlacement, SeamPoint};
pub use placed::Placed;
