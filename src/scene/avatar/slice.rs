//! Horizontal slices of a surface: bounds and the girth that a tape would read.

use super::TriangleMesh;

/// Returns the crossings of the surface with height `y`: points (x, z) \[m\], two for each triangle
/// crossed, in no order.
fn points(surface: &TriangleMesh, y: f64) -> Vec<[f64; 2]> {
    let mut points = Vec::new();
    for t in 0..surface.triangles.len() {
        let corners = surface.corners(t);
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            if (a.y >= y) != (b.y >= y) {
                let s = (y - a.y) / (b.y - a.y);
                points.push([a.x + s * (b.x - a.x), a.z + s * (b.z - a.z)]);
            }
        }
    }
    points
}

/// `[[min x, max x], [min z, max z]]` of the slice at height `y`, `None` where it is empty \[m\].
pub(super) fn bounds(surface: &TriangleMesh, y: f64) -> Option<[[f64; 2]; 2]> {
    let points = points(surface, y);
    let first = points.first()?;
    let mut bounds = [[first[0]; 2], [first[1]; 2]];
    for point in &points {
        for (bound, x) in bounds.iter_mut().zip(point) {
            *bound = [bound[0].min(*x), bound[1].max(*x)];
        }
    }
    Some(bounds)
}

/// z of the back and of the front in the middle (x = 0) at height `y`, for a surface with edges
/// along the middle \[m\].
pub(super) fn middle(surface: &TriangleMesh, y: f64) -> Option<[f64; 2]> {
    let points = points(surface, y);
    let middle = || points.iter().filter(|p| p[0] == 0.0).map(|p| p[1]);
    let back = middle().min_by(f64::total_cmp)?;
    Some([back, middle().max_by(f64::total_cmp)?])
}

/// Perimeter of the convex hull of the slice at height `y`, `None` where it is empty \[m\].
pub(super) fn girth(surface: &TriangleMesh, y: f64) -> Option<f64> {
    let hull = hull(points(surface, y));
    let next = hull.iter().cycle().skip(1);
    let girth = hull
        .iter()
        .zip(next)
        .map(|(a, b)| (b[0] - a[0]).hypot(b[1] - a[1]));
    (!hull.is_empty()).then(|| girth.sum())
}

/// Convex hull, counter-clockwise (A. M. Andrew, "Another efficient algorithm for convex hulls in
/// two dimensions", 1979).
fn hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let mut hull = chain(points.iter());
    hull.pop();
    hull.extend(chain(points.iter().rev()));
    hull.pop();
    hull
}

fn chain<'a>(points: impl Iterator<Item = &'a [f64; 2]>) -> Vec<[f64; 2]> {
    let mut chain: Vec<[f64; 2]> = Vec::new();
    for &p in points {
        while let [.., a, b] = chain[..]
            && (b[0] - a[0]) * (p[1] - a[1]) <= (b[1] - a[1]) * (p[0] - a[0])
        {
            chain.pop();
        }
        chain.push(p);
    }
    chain
}
