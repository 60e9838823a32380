//! The rules in whole numbers, without an orientation: triangles are disjoint if a plane parts
//! them, and there are only so many directions that such a plane may need to have.

pub(crate) type Whole = [i128; 3];

/// Returns true if two triangles, which may be segments or points, have a common point.
///
/// They have none if the polytope of their differences `a - b` lacks the origin. Then some normal
/// of its facets parts them: a cross product of two edges; in a plane, of such a normal and an
/// edge; on a line, the edge, or what stands on it toward the origin; of a point, the point itself.
pub(crate) fn meet(a: &[Whole; 3], b: &[Whole; 3]) -> bool {
    let edges: Vec<Whole> = [a, b]
        .iter()
        .flat_map(|t| (0..3).map(|i| subtract(t[(i + 1) % 3], t[i])))
        .collect();
    let offset = subtract(a[0], b[0]);
    let normals: Vec<Whole> = (0..6)
        .flat_map(|i| (0..i).map(move |j| (i, j)))
        .map(|(i, j)| cross(edges[i], edges[j]))
        .collect();
    let in_plane = normals
        .iter()
        .flat_map(|n| edges.iter().map(|e| cross(*n, *e)));
    let on_line = edges.iter().map(|e| cross(*e, cross(offset, *e)));
    let directions = normals.iter().copied().chain(in_plane).chain(on_line);
    let mut directions = directions.chain(edges.iter().copied()).chain([offset]);
    !directions.any(|direction| is_parted(a, b, direction))
}

fn is_parted(a: &[Whole; 3], b: &[Whole; 3], direction: Whole) -> bool {
    let range = |t: &[Whole; 3]| {
        let heights = t.map(|p| dot(p, direction));
        let [x, y, z] = heights;
        (x.min(y).min(z), x.max(y).max(z))
    };
    let ((low_a, high_a), (low_b, high_b)) = (range(a), range(b));
    high_a < low_b || high_b < low_a
}

/// Returns true if the triangles count as crossing; `names` are the welded vertices of both.
pub(crate) fn cross_by_rule(corners: [[Whole; 3]; 2], names: [[u32; 3]; 2]) -> bool {
    let [a, b] = corners;
    let is_flat = [0, 1].map(|k| is_degenerate(corners[k], names[k]));
    let shared: Vec<(usize, usize)> = (0..3)
        .flat_map(|i| (0..3).map(move |j| (i, j)))
        .filter(|(i, j)| names[0][*i] == names[1][*j])
        .collect();
    if is_flat[0] || is_flat[1] {
        return is_flat != [true; 2] && shared.is_empty() && meet(&a, &b);
    }
    match shared.as_slice() {
        [] => meet(&a, &b),
        [(i, j)] => {
            let (p, q) = (a[(i + 1) % 3], a[(i + 2) % 3]);
            let (r, s) = (b[(j + 1) % 3], b[(j + 2) % 3]);
            meet(&[p, q, q], &b) || meet(&[r, s, s], &a)
        }
        [(i, j), (k, l)] => {
            let (third_a, third_b) = (a[3 - i - k], b[3 - j - l]);
            let is_folded = |u: Whole, v: Whole| {
                let normal = |p| cross(subtract(v, u), subtract(p, u));
                let (n, m) = (normal(third_a), normal(third_b));
                cross(n, m) == [0; 3] && dot(n, m) > 0
            };
            is_folded(a[*i], a[*k]) || is_folded(b[*j], b[*l])
        }
        _ => true,
    }
}

/// Returns true if a triangle has no area or a vertex twice.
pub(crate) fn is_degenerate([p, q, r]: [Whole; 3], [a, b, c]: [u32; 3]) -> bool {
    a == b || b == c || c == a || cross(subtract(q, p), subtract(r, p)) == [0; 3]
}

fn subtract(a: Whole, b: Whole) -> Whole {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: Whole, b: Whole) -> Whole {
    [0, 1, 2].map(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i] * b[j] - a[j] * b[i]
    })
}

fn dot(a: Whole, b: Whole) -> i128 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[test]
fn known_triangles_meet_or_not() {
    let flat = [[0, 0, 0], [4, 0, 0], [0, 4, 0]];
    let meets = |b: [Whole; 3]| meet(&flat, &b) && meet(&b, &flat);
    let parts = |b: [Whole; 3]| !meet(&flat, &b) && !meet(&b, &flat);
    assert!(meets([[1, 1, -1], [1, 1, 1], [5, 5, 5]]));
    assert!(meets([[2, 2, 0], [4, 4, 0], [5, 4, 0]]));
    assert!(parts([[2, 3, 0], [4, 4, 0], [5, 4, 0]]));
    assert!(meets([[1, 1, 0]; 3]));
    assert!(parts([[3, 3, 0]; 3]));
    assert!(parts([[1, 1, 1]; 3]));
    assert!(meets([[3, 3, 0], [0, 1, 0], [0, 1, 0]]));
    assert!(parts([[3, 2, 0], [2, 3, 0], [2, 3, 0]]));
    assert!(parts([[-1, 0, 1], [1, 0, 1], [0, 5, 1]]));
    let segment = [[0, 0, 0], [2, 2, 2], [4, 4, 4]];
    assert!(meet(&segment, &[[4, 4, 4], [5, 5, 5], [5, 5, 5]]));
    assert!(!meet(&segment, &[[5, 5, 5], [6, 6, 6], [6, 6, 6]]));
    assert!(!meet(&segment, &[[1, 1, 0], [2, 2, 1], [3, 3, 2]]));
}
