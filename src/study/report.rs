//! The result of a study. Errors are RMS over the vertices (of a motion: over its frames too) on
//! the same mesh, unless it says otherwise.

use crate::solver::{Analysis, MembraneModel, Method};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Name and version of the format of a study's result.
pub const SCHEMA: &str = "seamster/study/1";

/// The result of a study. All numbers are finite; apart from CPU times, and from what a time limit
/// left out, the same study gives the same result.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Study {
    /// Always `seamster/study/1`.
    pub schema: String,
    /// Drape or motion: what was wanted of the garment.
    pub want: Analysis,
    /// The membrane, the same for all runs: solver errors are within it.
    pub membrane: MembraneModel,
    /// The shape that the runs begin with, in words.
    pub start: String,
    /// One a mesh, in the order asked for.
    pub meshes: Vec<StudyMesh>,
    /// The work-precision table.
    pub runs: Vec<StudyRun>,
    /// Observed orders of a motion's methods.
    pub orders: Vec<StudyOrder>,
    /// The longest stable step of each method that steps.
    pub stability: Vec<StudyStability>,
    /// The run to take, in a sentence.
    pub recommendation: String,
    /// Notes on how to read the numbers, in sentences.
    pub notes: Vec<String>,
    /// Parts that were not done, and why.
    pub left_out: Vec<SkippedPart>,
    /// True if all that was asked for was done.
    pub complete: bool,
    /// True if it was stopped by the cancel token.
    pub canceled: bool,
    /// CPU time of the study \[s\].
    pub cpu_s: f64,
    /// Version of the program.
    pub version: String,
}

/// One mesh of a study.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct StudyMesh {
    /// Length of mesh edges asked for \[m\].
    pub edge_length_m: f64,
    /// Vertices.
    pub vertices: usize,
    /// Triangles.
    pub triangles: usize,
    /// The reference that errors on this mesh are measured against.
    pub reference: StudyReference,
    /// The rest shapes that runs on this mesh led to, the reference's first; none for a motion.
    pub minima: Vec<StudyMinimum>,
    /// Distance of the reference from that on the finest mesh at the same points of the pattern
    /// \[m\]: the mesh error, apart from solver errors, less that of the finest mesh. None on the
    /// finest mesh and where there is no reference.
    pub mesh_error_m: Option<f64>,
}

/// The reference that errors on a mesh are measured against.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct StudyReference {
    /// True if two independent methods agree on it.
    pub confirmed: bool,
    /// The methods that were compared; the first one's shape or motion is the reference.
    pub methods: Vec<Method>,
    /// Their energies at rest, in the same order \[J\]; none for a motion.
    pub energies_j: Vec<f64>,
    /// Distance between the two \[m\].
    pub apart_m: Option<f64>,
    /// The reference's own error \[m\]: smaller errors than this say nothing.
    pub uncertainty_m: Option<f64>,
    /// True if the two came to rest in different shapes.
    pub several_rest_shapes: bool,
    /// The way it was found and confirmed, or why not, in words.
    pub because: String,
    /// CPU time of it \[s\].
    pub cpu_s: f64,
}

/// A rest shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct StudyMinimum {
    /// Energy of all terms, height against the start \[J\].
    pub energy_j: f64,
    /// Distance from the reference \[m\].
    pub from_reference_m: f64,
    /// Number of the runs that led to it.
    pub runs: usize,
}

/// One run: a row of the work-precision table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct StudyRun {
    /// The method asked for.
    pub method: Method,
    /// The method that was used: `auto` chooses one.
    pub used: String,
    /// The tolerance asked for, if it is what was varied.
    pub tolerance: Option<f64>,
    /// The fixed step asked for, if it is what was varied \[s\].
    pub step_s: Option<f64>,
    /// Length of mesh edges \[m\].
    pub edge_length_m: f64,
    /// Vertices of the mesh.
    pub vertices: usize,
    /// CPU time of the run, its reference not counted \[s\].
    pub cpu_s: f64,
    /// Solver error: RMS distance to the rest shape that this run's own shape leads to, or from the
    /// reference motion \[m\].
    pub error_m: Option<f64>,
    /// True if the error is well above that of its reference. Where it is not, it is an upper
    /// bound.
    pub error_certain: bool,
    /// The solver's own estimate of it \[m\].
    pub estimate_m: Option<f64>,
    /// True if the solver calls its estimate valid.
    pub estimate_valid: bool,
    /// Energy of the shape it stopped at: all terms, and for a motion at its last frame with that
    /// of motion \[J\].
    pub energy_j: f64,
    /// Residual r of a drape.
    pub residual: Option<f64>,
    /// Index of the rest shape that it leads to among the mesh's `minima`.
    pub minimum: Option<usize>,
    /// Energy of that rest shape \[J\].
    pub minimum_energy_j: Option<f64>,
    /// True if that is the reference's.
    pub same_as_reference: Option<bool>,
    /// Steps of time or Newton iterations.
    pub steps: u64,
    /// True if it reached what was asked: rest within the tolerance, or the end of the motion.
    pub converged: bool,
    /// The reason why it ended, in words.
    pub why: String,
}

/// Observed order of a method: the slope of log error over log step, by least squares.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct StudyOrder {
    /// The method.
    pub method: Method,
    /// Length of mesh edges \[m\].
    pub edge_length_m: f64,
    /// The order found; none with fewer than two errors that are certain.
    pub observed: Option<f64>,
    /// The same between the two shortest steps: where it is nearer to theory, the longer ones are
    /// too long for the stiffest part of the motion.
    pub finest: Option<f64>,
    /// The order of theory, where forces are smooth.
    pub theory: f64,
    /// Steps that it was found by \[s\].
    pub steps_s: Vec<f64>,
}

/// The longest stable step of a method, from a tiny disturbance of the rest shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct StudyStability {
    /// The method.
    pub method: Method,
    /// Length of mesh edges \[m\].
    pub edge_length_m: f64,
    /// The longest step, found by bisection, with which the disturbance did not grow \[s\]. None if
    /// no such step was found to be unstable.
    pub found_s: Option<f64>,
    /// The limit from the highest frequency at that shape \[s\]. None for methods that theory calls
    /// stable with any step.
    pub theory_s: Option<f64>,
    /// Longest step that was tried \[s\].
    pub tried_s: f64,
    /// The way it was found, in words.
    pub because: String,
}

/// A part of a study that was not done.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[schema(as = NotDone)]
pub struct SkippedPart {
    /// The part.
    pub what: String,
    /// The reason.
    pub because: String,
}
