//! Entities of the `dxf` crate as ours: curves become polylines.

use super::geometry::{BlockInsert, EntityPath, EntityShape};
use super::plane::{is_seen_from_behind, note_projected, xy};
use super::polyline::with_bulges;
use super::spline;
use crate::fault::{Fault, PatternCode};
use crate::pattern::Point2;
use crate::pattern::curve;
use crate::pattern::dxf::findings::{DxfFindings, at_line};
use dxf::entities::{Arc, Circle, Ellipse, EntityType, Insert, Line, LwPolyline, Polyline};
use std::f64::consts::TAU;

/// Converts an entity; `None` for one without extent, which is dropped with a warning. Not many
/// more than `point_limit` points are made.
///
/// # Errors
/// Numbers that make no entity of the drawing plane.
pub(super) fn convert(
    entity: &EntityType,
    line: usize,
    point_limit: usize,
    findings: &mut DxfFindings,
) -> Result<Option<EntityShape>, Fault> {
    let path = match entity {
        EntityType::ModelPoint(p) => {
            return Ok(Some(EntityShape::Point(xy(&p.location), p.location.z)));
        }
        EntityType::Text(t) => {
            return Ok(Some(EntityShape::Text(xy(&t.location), t.value.clone())));
        }
        EntityType::MText(t) => {
            let text = format!("{}{}", t.extended_text.concat(), t.text);
            return Ok(Some(EntityShape::Text(xy(&t.insertion_point), text)));
        }
        EntityType::Insert(i) => return Ok(Some(EntityShape::Insert(insert(i, line)?))),
        EntityType::Line(l) => Some(straight(l, line, findings)),
        EntityType::Polyline(p) => polyline(p, line, point_limit, findings)?,
        EntityType::LwPolyline(p) => lwpolyline(p, line, point_limit, findings)?,
        EntityType::Arc(a) => arc(a, line, findings)?,
        EntityType::Circle(c) => circle(c, line, findings)?,
        EntityType::Ellipse(e) => Some(ellipse(e, line)?),
        EntityType::Spline(s) => Some(spline::path(s, line, point_limit)?),
        _ => None,
    };
    Ok(path.map(EntityShape::Path))
}

fn straight(l: &Line, line: usize, findings: &mut DxfFindings) -> EntityPath {
    note_projected(&[&l.p1, &l.p2], line, findings);
    EntityPath::line(xy(&l.p1), xy(&l.p2))
}

fn polyline(
    p: &Polyline,
    line: usize,
    point_limit: usize,
    findings: &mut DxfFindings,
) -> Result<Option<EntityPath>, Fault> {
    const MESHES: i32 = 16 | 64;
    const FRAME_VERTEX: i32 = 16;
    if p.flags & MESHES != 0 {
        findings.skip("POLYLINE that is a mesh", line);
        return Ok(None);
    }
    let kept: Vec<_> = p
        .vertices()
        .filter(|v| v.flags & FRAME_VERTEX == 0)
        .collect();
    let points: Vec<_> = kept.iter().map(|v| &v.location).collect();
    note_projected(&points, line, findings);
    if kept.is_empty() {
        findings.skip("POLYLINE without vertices", line);
        return Ok(None);
    }
    let vertices: Vec<(Point2, f64)> = kept.iter().map(|v| (xy(&v.location), v.bulge)).collect();
    let path = with_bulges(&vertices, p.is_closed(), point_limit, line)?;
    Ok(Some(path.flipped_if(is_seen_from_behind(&p.normal, line)?)))
}

fn lwpolyline(
    p: &LwPolyline,
    line: usize,
    point_limit: usize,
    findings: &mut DxfFindings,
) -> Result<Option<EntityPath>, Fault> {
    let from_behind = is_seen_from_behind(&p.extrusion_direction, line)?;
    if p.vertices.is_empty() {
        findings.skip("LWPOLYLINE without vertices", line);
        return Ok(None);
    }
    let vertices: Vec<(Point2, f64)> = p.vertices.iter().map(|v| ([v.x, v.y], v.bulge)).collect();
    let path = with_bulges(&vertices, p.is_closed(), point_limit, line)?;
    Ok(Some(path.flipped_if(from_behind)))
}

fn arc(a: &Arc, line: usize, findings: &mut DxfFindings) -> Result<Option<EntityPath>, Fault> {
    let Some(radius) = positive_radius(a.radius, line, findings)? else {
        return Ok(None);
    };
    let start = a.start_angle.to_radians();
    let sweep = curve::sweep(start, a.end_angle.to_radians());
    let points = curve::arc(xy(&a.center), radius, start, sweep);
    let from_behind = is_seen_from_behind(&a.normal, line)?;
    Ok(Some(EntityPath::curve(points).flipped_if(from_behind)))
}

fn circle(
    c: &Circle,
    line: usize,
    findings: &mut DxfFindings,
) -> Result<Option<EntityPath>, Fault> {
    let Some(radius) = positive_radius(c.radius, line, findings)? else {
        return Ok(None);
    };
    let points = curve::arc(xy(&c.center), radius, 0.0, TAU);
    let from_behind = is_seen_from_behind(&c.normal, line)?;
    Ok(Some(EntityPath::curve(points).flipped_if(from_behind)))
}

fn ellipse(e: &Ellipse, line: usize) -> Result<EntityPath, Fault> {
    let flip = if is_seen_from_behind(&e.normal, line)? {
        -1.0
    } else {
        1.0
    };
    let major = [e.major_axis.x, e.major_axis.y];
    let minor = [
        -major[1] * e.minor_axis_ratio * flip,
        major[0] * e.minor_axis_ratio * flip,
    ];
    let start = e.start_parameter;
    let range = [start, curve::sweep(start, e.end_parameter)];
    let points = curve::ellipse(xy(&e.center), major, minor, range);
    Ok(EntityPath::curve(points))
}

/// Returns the radius; `None`, with a warning, where it is 0.
fn positive_radius(
    radius: f64,
    line: usize,
    findings: &mut DxfFindings,
) -> Result<Option<f64>, Fault> {
    if radius < 0.0 {
        let detail = format!("the radius is {radius}");
        return Err(
            Fault::new(PatternCode::NegativeRadius, at_line(line), detail)
                .fix("draw this arc anew"),
        );
    }
    if radius == 0.0 {
        let detail = "an arc of radius 0 is left out";
        findings.warn(PatternCode::ZeroRadius, line, detail);
        return Ok(None);
    }
    Ok(Some(radius))
}

fn insert(i: &Insert, line: usize) -> Result<BlockInsert, Fault> {
    let at_least_one = |n: i16| u32::try_from(n).unwrap_or(1).max(1);
    Ok(BlockInsert {
        name: i.name.clone(),
        at: xy(&i.location),
        scale: [i.x_scale_factor, i.y_scale_factor],
        angle: i.rotation.to_radians(),
        count: [at_least_one(i.column_count), at_least_one(i.row_count)],
        spacing: [i.column_spacing, i.row_spacing],
        flipped: is_seen_from_behind(&i.extrusion_direction, line)?,
    })
}
