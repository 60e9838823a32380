//! The saved garment file (P6) and the whole way from it to an outcome.
//!
//! [`read_garment`] → [`resolve`] → [`run`] → [`FitOutcome`].

mod ahead;
mod costs;
mod crossings;
mod garment;
mod garment_bounds;
mod girths;
mod harder;
mod json_schema;
mod layers;
mod library;
mod limbs;
mod maps;
mod measures;
mod over;
mod panel_spec;
mod picture;
mod references;
mod request_schema;
mod resolve;
mod run;
mod scene_json;
mod schema_fault;
mod seam_check;
mod sewing_pattern;
mod shape_faults;
mod sides;
mod start_from;
mod starts;
mod stored_surface;
mod suggest;
mod support;
mod unsupported;
mod validate;
mod verdict;
mod warm_start;
mod zone;

pub(crate) use ahead::size_warnings;
pub use garment::{
    AvatarRef, DressFormSpec, Elastic, Garment, InnerGarment, InnerPanel, MapKind, OverRef,
    OwnBodySpec, PanelSpec, PatternRef, Pin, SCHEMA, SeamsKeyword, SeamsSpec, SelfContact,
    StartPanel, StartRef, StartShape, WindSpec,
};
pub(crate) use garment_bounds::garment_bounds;
pub use json_schema::garment_schema_json;
pub use library::{AssetLibrary, FinishedFit, NoFinishedFit, ShippedAssets};
pub use maps::{ShapeMap, shape_maps};
pub use measures::{GarmentMeasures, GirthMeasures, PanelMeasures, SeamMeasures, measures};
pub use picture::picture;
pub use request_schema::{ReadError, read_garment};
pub(crate) use request_schema::{RequestSchema, garment_schema};
pub use resolve::{ResolvedGarment, resolve};
pub use run::{FitOutcome, run, scene};
pub use scene_json::scene_json;
pub(crate) use seam_check::check_seams;
