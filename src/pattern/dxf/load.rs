//! The `dxf` crate at work: one block's entities at a time, each counted when it comes back.

use super::clean::{Cleaned, Expected};
use super::curve;
use super::entity::{Entity, Insert, Path, Shape};
use super::spline;
use super::{Findings, at_line};
use crate::fault::Fault;
use crate::pattern::Point2;
use dxf::entities::EntityType;
use dxf::{Drawing, Point, Vector};

/// Reads entities. Their points are taken from `points_left`; where those do not suffice, the rest is not made.
///
/// A difference between what the file holds and what the crate gives back is a fault at the first entity concerned.
pub(super) fn load(
    cleaned: &Cleaned,
    points_left: &mut usize,
    findings: &mut Findings,
) -> Vec<Entity> {
    if cleaned.expected.is_empty() {
        return Vec::new();
    }
    let loaded = Drawing::load_with_encoding(&mut cleaned.text.as_bytes(), encoding_rs::UTF_8);
    let drawing = match loaded {
        Ok(drawing) => drawing,
        Err(error) => {
            findings.faults.push(Fault::new(
                "pattern/unreadable",
                at_line(cleaned.expected[0].line),
                format!("the entities from here on cannot be read: {error}"),
            ));
            return Vec::new();
        }
    };
    let mut found = drawing.entities();
    let mut entities = Vec::with_capacity(cleaned.expected.len());
    for expected in &cleaned.expected {
        let entity = found.next();
        let Some(entity) = entity.filter(|e| came_back(expected, &e.specific)) else {
            findings.faults.push(lost(expected));
            return entities;
        };
        match shape(&entity.specific, expected.line, *points_left, findings) {
            Ok(Some(shape)) => {
                let count = if let Shape::Path(path) = &shape {
                    path.points.len()
                } else {
                    1
                };
                let Some(left) = points_left.checked_sub(count) else {
                    findings.faults.push(too_many_points(expected.line));
                    return Vec::new();
                };
                *points_left = left;
                entities.push(Entity {
                    layer: entity.common.layer.clone(),
                    line: expected.line,
                    shape,
                });
            }
            Ok(None) => {}
            Err(fault) => findings.faults.push(fault),
        }
    }
    entities
}

fn came_back(expected: &Expected, found: &EntityType) -> bool {
    match found {
        EntityType::Line(_) => expected.kind == "LINE",
        EntityType::ModelPoint(_) => expected.kind == "POINT",
        EntityType::Text(_) => expected.kind == "TEXT",
        EntityType::MText(_) => expected.kind == "MTEXT",
        EntityType::Polyline(p) => {
            expected.kind == "POLYLINE" && p.vertices().count() == expected.vertices
        }
        EntityType::LwPolyline(p) => {
            expected.kind == "LWPOLYLINE" && p.vertices.len() == expected.vertices
        }
        EntityType::Arc(_) => expected.kind == "ARC",
        EntityType::Circle(_) => expected.kind == "CIRCLE",
        EntityType::Ellipse(_) => expected.kind == "ELLIPSE",
        EntityType::Spline(_) => expected.kind == "SPLINE",
        EntityType::Insert(_) => expected.kind == "INSERT",
        _ => false,
    }
}

fn too_many_points(line: usize) -> Fault {
    Fault::new(
        "pattern/too_large",
        at_line(line),
        "up to here the drawing has more points, with those that its curves are drawn with, than are read",
    )
    .fix("export fewer pieces or sizes, or fewer curves")
}

fn lost(expected: &Expected) -> Fault {
    Fault::new(
        "pattern/lost_entity",
        at_line(expected.line),
        format!(
            "the {} that begins here could not be read whole",
            expected.kind
        ),
    )
    .fix("export the file again, or report this file")
}

/// An entity of the crate as ours; `None` for one without extent that is dropped with a warning. Not many more than
/// `most` points are made.
fn shape(
    entity: &EntityType,
    line: usize,
    most: usize,
    findings: &mut Findings,
) -> Result<Option<Shape>, Fault> {
    Ok(Some(match entity {
        EntityType::Line(l) => {
            flat(&[&l.p1, &l.p2], line, findings);
            Shape::Path(Path {
                points: vec![xy(&l.p1), xy(&l.p2)],
                closed: false,
                straight: true,
                made: Vec::new(),
            })
        }
        EntityType::ModelPoint(p) => Shape::Point(xy(&p.location), p.location.z),
        EntityType::Text(t) => Shape::Text(xy(&t.location), t.value.clone()),
        EntityType::MText(t) => Shape::Text(
            xy(&t.insertion_point),
            format!("{}{}", t.extended_text.concat(), t.text),
        ),
        EntityType::Polyline(p) => return polyline(p, line, most, findings),
        EntityType::LwPolyline(p) => {
            let flipped = flipped(&p.extrusion_direction, line)?;
            if p.vertices.is_empty() {
                findings.left_out("LWPOLYLINE without vertices", line);
                return Ok(None);
            }
            let vertices: Vec<(Point2, f64)> =
                p.vertices.iter().map(|v| ([v.x, v.y], v.bulge)).collect();
            Shape::Path(bulged(&vertices, p.is_closed(), most, line)?.mirrored(flipped))
        }
        EntityType::Arc(a) => {
            let Some(radius) = radius(a.radius, line, findings)? else {
                return Ok(None);
            };
            let start = a.start_angle.to_radians();
            let points = curve::arc(
                xy(&a.center),
                radius,
                start,
                curve::sweep(start, a.end_angle.to_radians()),
            );
            Shape::Path(smooth(points).mirrored(flipped(&a.normal, line)?))
        }
        EntityType::Circle(c) => {
            let Some(radius) = radius(c.radius, line, findings)? else {
                return Ok(None);
            };
            let points = curve::arc(xy(&c.center), radius, 0.0, std::f64::consts::TAU);
            Shape::Path(smooth(points).mirrored(flipped(&c.normal, line)?))
        }
        EntityType::Ellipse(e) => {
            let flip = if flipped(&e.normal, line)? { -1.0 } else { 1.0 };
            let major = [e.major_axis.x, e.major_axis.y];
            let minor = [
                -major[1] * e.minor_axis_ratio * flip,
                major[0] * e.minor_axis_ratio * flip,
            ];
            let range = [
                e.start_parameter,
                curve::sweep(e.start_parameter, e.end_parameter),
            ];
            Shape::Path(smooth(curve::ellipse(xy(&e.center), major, minor, range)))
        }
        EntityType::Spline(s) => Shape::Path(spline::path(s, line, most)?),
        EntityType::Insert(i) => Shape::Insert(insert(i, line)?),
        _ => return Ok(None),
    }))
}

pub(super) fn xy(p: &Point) -> Point2 {
    [p.x, p.y]
}

/// Notes points that do not lie in the drawing plane; they are seen from above.
fn flat(points: &[&Point], line: usize, findings: &mut Findings) {
    if points.iter().any(|p| p.z != 0.0) {
        findings.projected(line);
    }
}

/// Whether an entity is seen from behind.
fn flipped(normal: &Vector, line: usize) -> Result<bool, Fault> {
    if normal.x.abs() > 1e-6 || normal.y.abs() > 1e-6 || normal.z == 0.0 {
        return Err(Fault::new(
            "pattern/not_flat",
            at_line(line),
            "an entity does not lie in the drawing plane",
        )
        .fix("flatten the drawing in the CAD program"));
    }
    Ok(normal.z < 0.0)
}

/// The radius, `None` (with a warning) where it is 0.
fn radius(radius: f64, line: usize, findings: &mut Findings) -> Result<Option<f64>, Fault> {
    if radius < 0.0 {
        return Err(Fault::new(
            "pattern/negative_radius",
            at_line(line),
            format!("the radius is {radius}"),
        )
        .fix("draw this arc anew"));
    }
    if radius == 0.0 {
        findings.warn(
            "pattern/zero_radius",
            line,
            "an arc of radius 0 is left out",
        );
        return Ok(None);
    }
    Ok(Some(radius))
}

/// A curve as a path: all its points were made.
pub(super) fn smooth(points: Vec<Point2>) -> Path {
    Path {
        made: vec![true; points.len()],
        points,
        closed: false,
        straight: false,
    }
}

fn polyline(
    p: &dxf::entities::Polyline,
    line: usize,
    most: usize,
    findings: &mut Findings,
) -> Result<Option<Shape>, Fault> {
    const MESHES: i32 = 16 | 64;
    const FRAME_VERTEX: i32 = 16;
    if p.flags & MESHES != 0 {
        findings.left_out("POLYLINE that is a mesh", line);
        return Ok(None);
    }
    let kept: Vec<_> = p
        .vertices()
        .filter(|v| v.flags & FRAME_VERTEX == 0)
        .collect();
    flat(
        &kept.iter().map(|v| &v.location).collect::<Vec<_>>(),
        line,
        findings,
    );
    if kept.is_empty() {
        findings.left_out("POLYLINE without vertices", line);
        return Ok(None);
    }
    let vertices: Vec<(Point2, f64)> = kept.iter().map(|v| (xy(&v.location), v.bulge)).collect();
    let path = bulged(&vertices, p.is_closed(), most, line)?;
    Ok(Some(Shape::Path(path.mirrored(flipped(&p.normal, line)?))))
}

/// The polyline through vertices with bulges.
fn bulged(
    vertices: &[(Point2, f64)],
    closed: bool,
    most: usize,
    line: usize,
) -> Result<Path, Fault> {
    /// A bulge of 1000 is an arc that lacks 0.2 degrees of a full circle.
    const LARGEST: f64 = 1000.0;
    if let Some((_, bulge)) = vertices.iter().find(|(_, bulge)| bulge.abs() > LARGEST) {
        return Err(Fault::new(
            "pattern/bulge",
            at_line(line),
            format!("a vertex has the bulge {bulge}"),
        )
        .fix("draw this arc anew"));
    }
    let mut points = Vec::with_capacity(vertices.len());
    let mut made = Vec::new();
    for (i, (a, bulge)) in vertices.iter().enumerate() {
        if points.len() > most {
            return Err(too_many_points(line));
        }
        made.resize(points.len(), true);
        made.push(false);
        match vertices
            .get(i + 1)
            .or_else(|| vertices.first().filter(|_| closed))
        {
            Some((b, _)) => points.extend(curve::bulge(*a, *b, *bulge)),
            None => points.push(*a),
        }
    }
    made.resize(points.len(), true);
    Ok(Path {
        points,
        closed,
        straight: false,
        made,
    })
}

impl Path {
    /// The path with x negated, where `flipped`.
    fn mirrored(mut self, flipped: bool) -> Self {
        if flipped {
            for point in &mut self.points {
                point[0] = -point[0];
            }
        }
        self
    }
}

fn insert(i: &dxf::entities::Insert, line: usize) -> Result<Insert, Fault> {
    let count = |n: i16| u32::try_from(n).unwrap_or(1).max(1);
    Ok(Insert {
        name: i.name.clone(),
        at: xy(&i.location),
        scale: [i.x_scale_factor, i.y_scale_factor],
        angle: i.rotation.to_radians(),
        count: [count(i.column_count), count(i.row_count)],
        spacing: [i.column_spacing, i.row_spacing],
        flipped: flipped(&i.extrusion_direction, line)?,
    })
}
