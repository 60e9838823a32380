//! The garment file: all that a fit needs, as JSON (P6).

use crate::pattern::{Pattern, Placement, Point2, SeamPair};
use crate::scene::triples::{positions_schema, triangles_schema};
use crate::scene::{BodySource, DressForm, Fabric, OwnBody};
use crate::seam::FaceRequest;
use crate::solver::SolverOptions;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;
use utoipa::ToSchema;
use uuid::Uuid;

/// Name and version of the garment file format.
pub const SCHEMA: &str = "seamster/garment/1";

fn schema() -> String {
    SCHEMA.to_owned()
}

fn default_fabric() -> String {
    "cotton-poplin".to_owned()
}

/// A garment: the saved file. Only `pattern` and `seams` are required.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Garment {
    /// Always `seamster/garment/1`.
    #[serde(default = "schema")]
    pub schema: String,
    /// The pattern, by id or whole. Absent only where a DXF comes beside the garment.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pattern: Option<PatternRef>,
    /// The seams, or `suggest`.
    pub seams: SeamsSpec,
    /// Settings of single panels, by id.
    #[serde(default)]
    pub panels: BTreeMap<String, PanelSpec>,
    /// Fabric of panels that name none.
    #[serde(default = "default_fabric")]
    pub default_fabric: String,
    /// Fabrics of one's own, by id.
    #[serde(default)]
    pub fabrics: BTreeMap<String, Fabric>,
    /// The body: an id, measurements, a body of one's own, or null for none. The default dress form
    /// if absent.
    #[serde(default = "AvatarRef::default_form")]
    pub avatar: Option<AvatarRef>,
    /// Corners that do not move.
    #[serde(default)]
    pub pins: Vec<Pin>,
    /// Moving air.
    #[serde(default)]
    pub wind: Option<WindSpec>,
    /// Contact of cloth with cloth.
    #[serde(default)]
    pub self_contact: SelfContact,
    /// Coulomb coefficient against the body; the fabrics' own if absent.
    #[serde(default)]
    pub friction: Option<f64>,
    /// The shape to begin from: the id of a fit that has succeeded. The saved file has its shape
    /// instead.
    #[serde(default)]
    pub start_from: Option<StartRef>,
    /// The garment that it is worn over: the id of a fit that has succeeded on the same avatar.
    /// The saved file has its surface instead.
    #[serde(default)]
    pub over: Option<OverRef>,
    /// Options of the simulation.
    #[serde(default)]
    pub simulate: SolverOptions,
    /// Maps wanted on the mesh.
    #[serde(default)]
    pub maps: Vec<MapKind>,
}

/// A pattern by id or whole.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(untagged)]
#[schema(as = PatternAsked)]
pub enum PatternRef {
    /// Id of a stored pattern.
    Id(Uuid),
    /// The pattern itself.
    Whole(Box<Pattern>),
}

/// The seams, or a keyword.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(untagged)]
#[schema(as = SeamsAsked)]
pub enum SeamsSpec {
    /// As the client states them.
    Pairs(Vec<SeamPair>),
    /// Found by the service.
    Keyword(SeamsKeyword),
}

/// The keyword that asks for suggested seams.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
#[schema(as = SuggestWord)]
pub enum SeamsKeyword {
    /// Use the service's own suggestions.
    Suggest,
}

/// Settings of one panel.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(default, deny_unknown_fields)]
#[schema(as = PanelAsked)]
pub struct PanelSpec {
    /// Id of its fabric.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fabric: Option<String>,
    /// Id of its texture.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub texture: Option<String>,
    /// Side that is out.
    pub face: FaceRequest,
    /// Layer, counted from the body outwards: where panels lie on each other, that of the higher
    /// one is further out.
    pub layer: i32,
    /// Direction of the warp, overriding the pattern's \[degrees\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grain_deg: Option<f64>,
    /// Width to cut away inside the outline before sewing, where the outline was given as cut
    /// \[m\].
    pub seam_allowance_m: f64,
    /// Edges that are shortened.
    pub elastic: Vec<Elastic>,
    /// Place where it starts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub placement: Option<Placement>,
}

/// A shortened edge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Elastic {
    /// Corner it begins at.
    pub from: usize,
    /// Corner it ends at.
    pub to: usize,
    /// Rest length over drawn length.
    pub factor: f64,
}

/// The body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(untagged)]
#[schema(as = AvatarAsked)]
#[expect(clippy::large_enum_variant, reason = "a garment has one")]
pub enum AvatarRef {
    /// Id of a stored avatar.
    Id(Uuid),
    /// A dress form made from measurements.
    Form(DressFormSpec),
    /// A body of one's own, whole.
    Own(OwnBodySpec),
}

impl AvatarRef {
    /// Returns the reference to a dress form made from measurements.
    pub fn form(form: DressForm) -> Self {
        Self::Form(DressFormSpec { form })
    }

    /// Returns the reference to a body as it is saved.
    pub fn whole(body: BodySource) -> Self {
        match body {
            BodySource::Form(form) => Self::form(form),
            BodySource::Own(body) => Self::Own(OwnBodySpec {
                body: Box::new(Arc::unwrap_or_clone(body)),
            }),
        }
    }

    #[expect(clippy::unnecessary_wraps, reason = "serde wants the field's own type")]
    fn default_form() -> Option<Self> {
        Some(Self::form(DressForm::default()))
    }
}

/// A dress form made from measurements.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
#[schema(as = FormAsked)]
pub struct DressFormSpec {
    /// The measurements.
    pub form: DressForm,
}

/// A body of one's own, whole.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
#[schema(as = BodyAsked)]
pub struct OwnBodySpec {
    /// Its surface and landmarks, as a saved file has them.
    pub body: Box<OwnBody>,
}

/// A garment that another one is worn over.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(untagged)]
#[schema(as = OverAsked)]
pub enum OverRef {
    /// Id of a fit that has succeeded.
    Id(Uuid),
    /// Its surface, as a saved file has it.
    Whole(Box<InnerGarment>),
}

/// The surface of a garment that another one is worn over, with all that it is worn over itself. It
/// does not move.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct InnerGarment {
    /// The body that it is worn on.
    pub avatar: Option<AvatarRef>,
    /// Its panels.
    pub panels: Vec<InnerPanel>,
}

/// A panel of a garment that another one is worn over.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct InnerPanel {
    /// Its name in reports: that of the panel after `over:`, which stands once for each garment on
    /// it.
    pub panel: String,
    /// Thickness of its fabric \[m\].
    pub thickness_m: f64,
    /// Coulomb coefficient of its fabric.
    pub friction: f64,
    /// Positions \[m\], y up; `#V`.
    #[schema(schema_with = positions_schema)]
    pub positions: Vec<[f64; 3]>,
    /// Corners of its triangles; `#T`.
    #[schema(schema_with = triangles_schema)]
    pub triangles: Vec<[u32; 3]>,
}

/// A shape to begin from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(untagged)]
#[schema(as = StartAsked)]
pub enum StartRef {
    /// Id of a fit that has succeeded.
    Id(Uuid),
    /// The shape in which it ended, as a saved file has it.
    Whole(Box<StartShape>),
}

/// The shape in which a fit ended.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct StartShape {
    /// The body that it is worn on.
    pub avatar: Option<AvatarRef>,
    /// Its panels.
    pub panels: Vec<StartPanel>,
}

/// A panel of a shape to begin from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct StartPanel {
    /// Id of the panel.
    pub panel: String,
    /// Positions \[m\], y up; `#V`.
    #[schema(schema_with = positions_schema)]
    pub positions: Vec<[f64; 3]>,
    /// Pattern coordinates \[m\]; `#V`.
    #[schema(value_type = Vec<[f64; 2]>)]
    pub uv: Vec<Point2>,
    /// Corners of its triangles; `#T`.
    #[schema(schema_with = triangles_schema)]
    pub triangles: Vec<[u32; 3]>,
}

/// A corner that does not move.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Pin {
    /// Id of the panel.
    pub panel: String,
    /// Index of the corner.
    pub corner: usize,
}

/// Moving air.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
#[schema(as = Wind)]
pub struct WindSpec {
    /// Velocity \[m/s\].
    pub velocity_m_s: [f64; 3],
    /// Share by which it swells and falls.
    #[serde(default)]
    pub gust: f64,
}

/// Contact of cloth with cloth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum SelfContact {
    /// Cloth may not pass through cloth, where the method can keep it from that.
    #[default]
    Auto,
    /// It may not; a method that cannot keep it from that is refused.
    On,
    /// It may.
    Off,
}

/// A map on the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum MapKind {
    /// Strain along warp and weft, and as a share of what the fabric gives.
    Strain,
    /// Pressure of the body on the cloth \[kPa\].
    Pressure,
    /// Gap to the body, 0 in contact \[mm\].
    Gap,
}
