//! Studies: one garment by many methods, settings and meshes, against a reference that the study converges itself; error
//! against run time as a table and a picture, observed orders, stability limits, and a recommendation.
//!
//! [`read_study`] → [`prepare`] → [`run`] → [`Study`] → [`plot_svg`].

mod asked;
mod compare;
mod drapes;
mod minima;
mod motions;
mod order;
mod plot;
mod prepare;
mod recommend;
mod reference;
mod report;
mod rest;
mod run;
mod stable;
mod work;

pub use asked::{StudyAsked, read_study};
pub use plot::plot_svg;
pub use prepare::{PreparedStudy, prepare};
pub use report::{
    NotDone, SCHEMA, Study, StudyMesh, StudyMinimum, StudyOrder, StudyReference, StudyRun,
    StudyStability,
};
pub use rest::Rest;
pub use run::{StudyPlan, StudyScene, run, run_scenes};
