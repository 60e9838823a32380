//! Studies: one garment by many methods, settings and meshes, against a reference that the study
//! converges itself; error against run time as a table and a picture, observed orders, stability
//! limits, and a recommendation.
//!
//! [`read_study`] → [`resolve`] → [`run`] → [`Study`] → [`plot_svg`].

mod drape_runs;
mod finding;
mod mesh_error;
mod motion_reference;
mod motion_runs;
mod order;
mod part;
mod plan;
mod plot;
mod recommendation;
mod report;
mod request;
mod resolve;
mod rest_shape;
mod rest_shapes;
mod run;
mod schedule;
mod stability;
mod validate;
mod wording;

pub use plan::{StudyPlan, StudyScene};
pub use plot::plot_svg;
pub use report::{
    SCHEMA, SkippedPart, Study, StudyMesh, StudyMinimum, StudyOrder, StudyReference, StudyRun,
    StudyStability,
};
pub use request::{StudyRequest, read_study};
pub(crate) use request::{study_bounds, study_schema};
pub use resolve::{ResolvedStudy, resolve};
pub use rest_shape::RestShape;
pub use run::{run, run_scenes};
