//! From the bytes of a file to a body that is kept, with what was found, mended and left open.

use super::body::{OwnBody, too_spread};
use super::landmarks::{self, Found, Missing};
use super::mend;
use super::read::{self, BodyFormat};
use super::scale::{BodyUnits, units};
use super::upright::{Axes, axes, extent};
use crate::config::Limits;
use crate::fault::{AvatarCode, Fault, Faults, Warning};
use crate::scene::avatar::TriangleMesh;
use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use utoipa::ToSchema;

/// Distance of a plane of symmetry from x = 0 of the file up to which it is that \[m\].
const CENTERED: f64 = 0.002;
/// Distance of a body from z = 0 of the file up to which it stays where it is \[m\].
const NEAR: f64 = 0.3;
/// Places after the point of stored coordinates \[m\]: a micrometer.
const PLACES: f64 = 1e6;

/// An axis of a file, or its opposite.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub enum FileAxis {
    /// Along x.
    #[serde(rename = "x")]
    X,
    /// Against x.
    #[serde(rename = "-x")]
    MinusX,
    /// Along y.
    #[serde(rename = "y")]
    Y,
    /// Against y.
    #[serde(rename = "-y")]
    MinusY,
    /// Along z.
    #[serde(rename = "z")]
    Z,
    /// Against z.
    #[serde(rename = "-z")]
    MinusZ,
}

impl FileAxis {
    fn direction(self) -> Vector3<f64> {
        match self {
            Self::X => Vector3::x(),
            Self::MinusX => -Vector3::x(),
            Self::Y => Vector3::y(),
            Self::MinusY => -Vector3::y(),
            Self::Z => Vector3::z(),
            Self::MinusZ => -Vector3::z(),
        }
    }
}

/// Facts about the file of a body that are stated, not to be found.
#[derive(Clone, Debug, Default)]
pub struct BodyImportOptions {
    /// Unit of its coordinates.
    pub units: Option<BodyUnits>,
    /// Axis that points up.
    pub up: Option<FileAxis>,
    /// Axis that the body faces.
    pub facing: Option<FileAxis>,
    /// Landmarks in the file's own coordinates.
    pub landmarks: BTreeMap<String, [f64; 3]>,
}

/// A body read from a file.
#[derive(Clone, Debug)]
pub struct BodyImport {
    /// The body.
    pub body: OwnBody,
    /// Format of the file.
    pub format: BodyFormat,
    /// Unit of its coordinates.
    pub units: BodyUnits,
    /// Rows of the map from the file's coordinates to the body's \[m\]: three factors and an
    /// addend each.
    pub from_file: [[f64; 4]; 3],
    /// Remarks: what was found, mended and left out.
    pub warnings: Vec<Warning>,
}

/// Reads a body: makes it one closed surface that stands on the floor and faces +z, and finds its
/// landmarks.
///
/// # Errors
/// `avatar/...`: a file that cannot be read, a surface with large holes or of no person's height,
/// a landmark that cannot be found.
pub fn import_body(
    bytes: &[u8],
    options: &BodyImportOptions,
    limits: &Limits,
) -> Result<BodyImport, Faults> {
    let mut warnings = Vec::new();
    let (format, soup) = read::read(bytes, limits)?;
    let welded = mend::weld(&soup);
    drop(soup);
    let largest = mend::largest_piece(&welded)?;
    let directions = [options.up, options.facing].map(|axis| axis.map(FileAxis::direction));
    check_directions(directions)?;
    let found = axes(&largest, directions[0], directions[1]);
    let unit = units(&largest, &found, options.units)?;
    let place = Placing::new(&largest, &found, unit.meters());
    drop(largest);
    tell_axes(&found, unit, options, &mut warnings);
    let mut whole = mend::main_pieces(&place.moved(welded), &mut warnings)?;
    mend::close(&mut whole, &mut warnings).map_err(Faults)?;
    finish(&mut whole);
    let mut faults = whole.check();
    if faults.is_empty() {
        faults.extend(too_spread(&whole));
    }
    Faults(faults).or(())?;
    let given = given_landmarks(options, &place, &whole)?;
    let (landmarks, missing) = landmarks::find(&whole, &given).map_err(not_found)?;
    warnings.extend(missing.into_iter().map(|Missing(name, why)| {
        let detail = format!("{name} was not found: {why}; cloth is draped on the surface all the same, but the limb has no axis");
        Warning::new(AvatarCode::Landmark, "", detail)
    }));
    Ok(BodyImport {
        body: stored(&whole, &landmarks),
        format,
        units: unit,
        from_file: place.rows(),
        warnings,
    })
}

fn not_found(Missing(name, why): Missing) -> Fault {
    let detail = format!("the landmark {name} cannot be found: {why}");
    Fault::new(AvatarCode::Landmark, format!("/landmarks/{name}"), detail).fix(
        "upload a body with head, arms and legs apart from each other, or give the landmark (name_l and name_r of pairs) in the part `landmarks`",
    )
}

fn check_directions([up, facing]: [Option<Vector3<f64>>; 2]) -> Result<(), Fault> {
    match (up, facing) {
        (Some(up), Some(facing)) if up.dot(&facing) != 0.0 => {
            let fault = Fault::new(AvatarCode::Pose, "", "`up` and `facing` are along one axis");
            Err(fault.fix("state two different axes of the file"))
        }
        _ => Ok(()),
    }
}

/// The map from the file's coordinates to the body's.
struct Placing {
    /// Rotation and scale.
    linear: Matrix3<f64>,
    offset: Vector3<f64>,
}

impl Placing {
    /// The body on the floor, its middle at x = 0.
    fn new(largest: &TriangleMesh, axes: &Axes, scale: f64) -> Self {
        let rows = [axes.left(), axes.up, axes.facing].map(|axis| axis.transpose());
        let linear = Matrix3::from_rows(&rows) * scale;
        let [across, along] = [axes.left(), axes.facing].map(|axis| {
            let [low, high] = extent(largest, &axis);
            0.5 * (low + high) * scale
        });
        let kept = |middle: f64, near: f64| if middle.abs() < near { 0.0 } else { -middle };
        let floor = extent(largest, &axes.up)[0] * scale;
        Self {
            linear,
            offset: Vector3::new(kept(across, CENTERED), -floor, kept(along, NEAR)),
        }
    }

    fn point(&self, p: &Vector3<f64>) -> Vector3<f64> {
        self.linear * p + self.offset
    }

    fn moved(&self, mut surface: TriangleMesh) -> TriangleMesh {
        for p in &mut surface.vertices {
            *p = self.point(p);
        }
        surface
    }

    fn rows(&self) -> [[f64; 4]; 3] {
        [0, 1, 2].map(|k| {
            let row = self.linear.row(k);
            [row[0], row[1], row[2], self.offset[k]]
        })
    }
}

/// Makes a closed surface outward and its coordinates those that are kept.
fn finish(surface: &mut TriangleMesh) {
    if surface.volume() < 0.0 {
        for triangle in &mut surface.triangles {
            triangle.swap(1, 2);
        }
    }
    mend::lift_slivers(surface);
    for p in &mut surface.vertices {
        *p = p.map(rounded);
    }
}

fn rounded(x: f64) -> f64 {
    (x * PLACES).round() / PLACES + 0.0
}

fn stored(surface: &TriangleMesh, landmarks: &Found) -> OwnBody {
    let index = |v: usize| u32::try_from(v).unwrap_or(u32::MAX);
    let triangles = surface.triangles.iter();
    OwnBody {
        vertices: surface.vertices.iter().map(|p| (*p).into()).collect(),
        triangles: triangles.map(|t| t.map(index)).collect(),
        landmarks: landmarks
            .iter()
            .map(|(name, p)| (name.clone(), p.map(rounded).into()))
            .collect(),
    }
}

/// Returns the given landmarks on the body.
fn given_landmarks(
    options: &BodyImportOptions,
    place: &Placing,
    surface: &TriangleMesh,
) -> Result<Found, Faults> {
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| extent(surface, &axis));
    let mut faults = Vec::new();
    let mut given = Found::new();
    for (name, p) in &options.landmarks {
        let p = place.point(&Vector3::from(*p));
        let inside = [x, y, z]
            .iter()
            .zip(p.iter())
            .all(|([low, high], p)| (low - 0.05..=high + 0.05).contains(p));
        if !inside {
            let token = crate::fault::pointer_token(&name.chars().take(60).collect::<String>());
            let detail = format!("{token} is not near the body");
            let fault = Fault::new(AvatarCode::Landmark, format!("/landmarks/{token}"), detail);
            faults.push(fault.fix("give it in the file's own coordinates and unit"));
        }
        given.insert(name.clone(), p);
    }
    Faults(faults).or(given)
}

/// Tells what was found of the axes and the unit, and how to state something else.
fn tell_axes(
    found: &Axes,
    unit: BodyUnits,
    options: &BodyImportOptions,
    warnings: &mut Vec<Warning>,
) {
    let mut say = |code: AvatarCode, detail: String| {
        warnings.push(Warning::new(code, "", detail));
    };
    if options.units.is_none() && unit != BodyUnits::Meter {
        let detail = format!(
            "the coordinates were taken for {}, by the height of the body; state the unit with `units`",
            unit.name()
        );
        say(AvatarCode::Units, detail);
    }
    if options.up.is_none() && !found.up_is_sure {
        let detail = "no legs told which way is up; state the axis with `up`".to_owned();
        say(AvatarCode::Pose, detail);
    }
    if options.facing.is_none() && !found.facing_is_sure {
        let detail = "no feet told which way the body faces; state the axis with `facing`";
        say(AvatarCode::Pose, detail.to_owned());
    }
    let turned = found.up != Vector3::y() || found.facing != Vector3::z();
    if turned && (options.up.is_none() || options.facing.is_none()) {
        let [u, f] = [found.up, found.facing].map(|d| {
            let [x, y, z] = d.map(rounded).into();
            format!("({x:.3}, {y:.3}, {z:.3})")
        });
        let detail = format!(
            "the body was turned: in the file its head is towards {u} and it faces {f}; state other axes with `up` and `facing`"
        );
        say(AvatarCode::Pose, detail);
    }
}
