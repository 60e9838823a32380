//! The codes of all faults and warnings, one table an area.

mod code;
mod page;
mod table;

mod avatar;
mod fabric;
mod file;
mod fit;
mod garment;
mod mesh;
mod pattern;
mod placement;
mod request;
mod scene;
mod seam;
mod study;

pub use code::FaultCode;
pub use page::codes_markdown;

pub use avatar::AvatarCode;
pub use fabric::FabricCode;
pub use file::FileCode;
pub use fit::FitCode;
pub use garment::GarmentCode;
pub use mesh::MeshCode;
pub use pattern::PatternCode;
pub use placement::PlacementCode;
pub use request::RequestCode;
pub use scene::SceneCode;
pub use seam::SeamCode;
pub use study::StudyCode;
