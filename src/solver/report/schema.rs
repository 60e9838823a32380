//! The report of a drape, as JSON has it. Errors are RMS over the vertices.

use crate::fault::Warning;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Quality of a drape: convergence, errors, what ran and what it took.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(rename = "Report")]
#[schema(as = Report)]
pub struct DrapeReport {
    /// True if a shape at rest was reached, to the tolerance asked for.
    pub converged: bool,
    /// Reason for stopping, in words.
    pub why: String,
    /// `r = sqrt(sum |f_i|² / n) / (M 9.80665 / n)`.
    pub residual: f64,
    /// Residual below which r is rounding.
    pub residual_floor: f64,
    /// Estimate of the distance to the exact solution on this mesh \[m\].
    pub error_estimate_m: Option<f64>,
    /// True if the conditions under which the estimate holds were met.
    pub error_estimate_valid: bool,
    /// Basis of the estimate, and how far it is to be trusted.
    #[serde(default)]
    pub error_estimate_because: String,
    /// Estimate of the distance to the solution on an ever finer mesh \[m\], apart from the
    /// solver's error: how far the shape moved when it went from the mesh of a third of the
    /// vertices to this one.
    pub mesh_error_m: Option<f64>,
    /// Change of one option that would halve the error, and its cost.
    #[serde(default)]
    pub to_halve_the_error: Option<Advice>,
    /// Energy by term.
    pub energy_j: Energy,
    /// Largest distance between the two points of any stitch \[m\].
    pub seam_gap_max_m: f64,
    /// Largest principal stretch less 1.
    pub strain_max: f64,
    /// Deepest that a vertex or the middle of a triangle lies inside the body \[m\].
    pub penetration_max_m: f64,
    /// Verdict on the garment, where it was judged: a fit that was not canceled is.
    #[serde(default)]
    pub good: Option<Verdict>,
    /// Pairs of triangles of cloth that meet without being neighbors, or lie on each other.
    pub self_intersections: Option<usize>,
    /// Triangles of cloth without area.
    #[serde(default)]
    pub degenerate_triangles: Option<usize>,
    /// Pairs of a triangle of cloth and one of the body's surface that meet.
    #[serde(default)]
    pub body_intersections: Option<usize>,
    /// Vertices of cloth inside the body.
    #[serde(default)]
    pub vertices_inside_body: Option<usize>,
    /// Places of these, those with most first: of the first 10 000 of each kind, at most 25 places.
    #[serde(default)]
    pub intersections: Vec<Intersection>,
    /// Area of cloth that lies nearer the body than a lower layer on the same ray along the body's
    /// normal \[m²\]; null where panels have no layers or there is no avatar.
    #[serde(default)]
    pub layers_wrong_area_m2: Option<f64>,
    /// Verdict on how the body carries the garment.
    #[serde(rename = "worn")]
    pub support: Support,
    /// The shape that it was begun with; null where it was sewn from flat panels.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub started_from: Option<StartedFrom>,
    /// Maps that were asked for, in short.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub maps: Vec<MapSummary>,
    /// Vertices of the mesh.
    pub vertices: usize,
    /// Triangles of the mesh.
    pub triangles: usize,
    /// Point pairs sewn together.
    pub stitches: usize,
    /// The terms that ran.
    pub terms: Vec<TermTime>,
    /// The terms that this scene did not need.
    #[serde(rename = "left_out")]
    pub skipped_terms: Vec<SkippedTerm>,
    /// Newton iterations on all levels.
    #[serde(default)]
    pub newton_iterations: usize,
    /// Levels planned, and the time expected for them.
    #[serde(default)]
    pub plan: Plan,
    /// The levels that ran, coarsest first.
    #[serde(default)]
    pub levels: Vec<LevelReport>,
    /// CPU time by stage.
    pub cpu_s: CpuSeconds,
    /// Largest resident memory of the process \[bytes\].
    pub memory_peak_bytes: u64,
    /// Convergence history: the error of the shapes on the way to the final one.
    pub error_against_run_time: Vec<ErrorPoint>,
    /// The method that was used.
    pub method: String,
    /// Fallbacks of the solver that were used.
    #[serde(rename = "ladder")]
    pub fallbacks: Vec<String>,
    /// Version of the program.
    pub version: String,
    /// Warnings about the seams that were sewn.
    #[serde(default)]
    pub warnings: Vec<Warning>,
}

/// The shape of an earlier fit that a drape began with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct StartedFrom {
    /// Energy by term of that shape as this garment begins with it, with its own fabrics and body
    /// \[J\]: `energy_j` is what became of it.
    pub energy_j: Energy,
}

/// A map in short: its values on panels and beside zones of the body.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
#[schema(as = Map)]
pub struct MapSummary {
    /// `strain_warp`, `strain_weft`, `strain_share`, `pressure` or `gap`.
    pub name: String,
    /// Unit of its values.
    pub unit: String,
    /// Error of its values by the mesh: RMS difference from those of the mesh of a third of the
    /// vertices. Null where there is none, or it did not come to rest, or on another skin, and
    /// where the garment started from an earlier fit.
    pub error: Option<f64>,
    /// Its values on each panel.
    pub panels: Vec<MapPart>,
    /// Its values beside each zone of the body; none without an avatar.
    pub zones: Vec<MapPart>,
}

/// Values of a map on a part of the cloth, in the unit of the map.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct MapPart {
    /// Id of the panel, or name of the zone.
    pub name: String,
    /// Area of the part on the pattern \[m²\].
    pub area_m2: f64,
    /// Mean by area.
    pub mean: f64,
    /// Largest value.
    pub max: f64,
    /// Place of the largest value \[m\].
    pub max_at_m: [f64; 3],
}

/// Verdict on a garment, at rest or not; whether it is worn is judged only at rest.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[schema(as = Good)]
pub struct Verdict {
    /// True if nothing failed.
    pub ok: bool,
    /// Faults, the gravest first.
    pub failed: Vec<Shortcoming>,
    /// Sentence on each of them, with its place.
    pub because: Vec<String>,
}

/// Fault of a garment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
#[schema(as = Failed)]
pub enum Shortcoming {
    /// Cloth passes through cloth, or has triangles without area.
    Crossings,
    /// Cloth passes through the body.
    Body,
    /// Layers lie in the wrong order.
    Layers,
    /// A seam is open.
    Gap,
    /// Cloth is stretched further than any bears.
    Strain,
    /// The body does not carry it.
    Worn,
}

/// Place where a garment passes through itself or the body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Intersection {
    /// Kinds that meet there.
    pub kind: IntersectionKind,
    /// Panels of the cloth that does: two where cloth meets cloth, the same twice where a panel
    /// meets itself.
    pub panels: Vec<String>,
    /// A point of it \[m\].
    pub at: [f64; 3],
    /// Pairs of triangles, triangles or vertices there.
    pub count: usize,
}

/// Kinds that meet at an [`Intersection`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum IntersectionKind {
    /// Triangles of cloth.
    Cloth,
    /// A triangle of cloth and one of the body.
    Body,
    /// A triangle without area, with itself.
    Degenerate,
    /// A vertex that is inside the body.
    InsideBody,
}

/// Energy by term \[J\].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Energy {
    /// Stretch and shear.
    pub stretch: f64,
    /// Bending.
    pub bend: f64,
    /// Height, against the start.
    pub gravity: f64,
    /// Seam springs.
    pub seam: f64,
    /// Contact with the body.
    pub contact: f64,
}

/// Support of the garment by the body.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(rename = "Worn")]
#[schema(as = Worn)]
pub struct Support {
    /// True if the body carries the garment; null where that is not judged: without an avatar,
    /// with pins that carry the cloth, and for motion.
    pub ok: Option<bool>,
    /// Reason, in words.
    pub because: String,
    /// The openings of the garment: neck, armholes, wrists, waist, hem.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub openings: Vec<SupportOpening>,
    /// Distance by which its middle sank, where nothing else speaks against it \[m\].
    #[serde(skip)]
    pub sank_m: Option<f64>,
}

/// An opening of a garment, and what it goes round.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(rename = "WornOpening")]
#[schema(as = WornOpening)]
pub struct SupportOpening {
    /// Ids of the panels along it.
    pub panels: Vec<String>,
    /// The part of the body that it was placed round, in words.
    pub placed_round: String,
    /// The part of the body that it goes round in the end, in words.
    pub goes_round: String,
    /// Length along it \[m\].
    pub length_m: f64,
    /// Mean height above the floor \[m\].
    pub height_m: f64,
}

/// Levels and time as planned and expected, against what came of them.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Plan {
    /// Vertices of each mesh that was to be solved, coarsest first; one that is solved for softer
    /// cloth first is there again.
    pub levels: Vec<usize>,
    /// CPU time allowed \[s\].
    pub time_limit_s: Option<f64>,
    /// CPU time that sewing and draping were expected to take when the coarsest mesh had been
    /// solved \[s\].
    pub expected_cpu_s: Option<f64>,
    /// Outcome, in words.
    pub outcome: String,
}

/// A change of one field of `simulate`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Advice {
    /// Name of the field.
    pub field: String,
    /// Factor by which its value is to be multiplied.
    pub factor: f64,
    /// CPU time that the whole run is then expected to take \[s\].
    pub cpu_s: f64,
    /// Reason, in words.
    pub because: String,
}

/// One level of the hierarchy of meshes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct LevelReport {
    /// Vertices of its mesh.
    pub vertices: usize,
    /// Newton iterations on it.
    pub newton_iterations: usize,
    /// CPU time on it \[s\].
    pub cpu_s: f64,
    /// Residual r where it was left.
    pub residual: f64,
    /// RMS distance between the shape that the coarser level handed on and where it was left \[m\].
    pub moved_m: Option<f64>,
}

/// A term that ran, and its time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(rename = "Term")]
#[schema(as = Term)]
pub struct TermTime {
    /// `stretch`, `bend`, `gravity`, `seam`, `contact`, ...
    pub name: String,
    /// CPU time in it \[s\].
    pub cpu_s: f64,
}

/// A term that this scene did not need.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename = "LeftOut")]
#[schema(as = LeftOut)]
pub struct SkippedTerm {
    /// Name of the term.
    pub name: String,
    /// Reason.
    pub because: String,
}

/// CPU time by stage \[s\].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct CpuSeconds {
    /// Meshing.
    pub mesh: f64,
    /// Building the scene and the solver's tables.
    pub assemble: f64,
    /// Sewing.
    pub sew: f64,
    /// Draping.
    pub drape: f64,
    /// Writing results.
    pub export: f64,
    /// All of it.
    pub total: f64,
}

/// Distance from the final shape and its estimate at one moment of a fit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct ErrorPoint {
    /// CPU time of the fit \[s\].
    pub cpu_s: f64,
    /// Distance from the final shape \[m\].
    pub rms_error_m: f64,
    /// Estimate known then \[m\].
    pub error_estimate_m: Option<f64>,
    /// Residual r then.
    pub residual: f64,
}
