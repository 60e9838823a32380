//! Pictures of garments: what covers which pixel, seen from where.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use nalgebra::Vector3;
use seamster::config::Limits;
use seamster::export::{
    DrapedPanel, GarmentMesh, Picture, PictureSubject, View, picture, picture_sheet,
};
use seamster::fault::RequestCode;
use seamster::scene::TriangleMesh;
use serde_json::json;

const VIEWS: [View; 5] = [
    View::Front,
    View::Back,
    View::Left,
    View::Right,
    View::ThreeQuarter,
];
/// A picture is so much wider than the garment in it.
const MARGIN: f64 = 1.08;

fn panel(positions: Vec<[f64; 3]>, triangles: Vec<[u32; 3]>) -> DrapedPanel {
    DrapedPanel {
        uv: vec![[0.0; 2]; positions.len()],
        positions,
        triangles,
        ..DrapedPanel::default()
    }
}

/// A square of side 2 `half` about `center`, counter-clockwise seen from where `right` x `up`
/// points.
fn square(center: [f64; 3], right: [f64; 3], up: [f64; 3], half: f64) -> DrapedPanel {
    let corner =
        |[a, b]: [f64; 2]| [0, 1, 2].map(|k| center[k] + half * (a * right[k] + b * up[k]));
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    panel(corners.map(corner).to_vec(), vec![[0, 1, 2], [0, 2, 3]])
}

/// A square of side 1 in the plane z, facing the front.
fn facing_front(z: f64) -> DrapedPanel {
    square([0.0, 0.5, z], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], 0.5)
}

/// The four sides of a cube of edge 1, facing out: front, back, left, right.
fn cube() -> Vec<DrapedPanel> {
    let up = [0.0, 1.0, 0.0];
    vec![
        square([0.0, 0.0, 0.5], [1.0, 0.0, 0.0], up, 0.5),
        square([0.0, 0.0, -0.5], [-1.0, 0.0, 0.0], up, 0.5),
        square([0.5, 0.0, 0.0], [0.0, 0.0, -1.0], up, 0.5),
        square([-0.5, 0.0, 0.0], [0.0, 0.0, 1.0], up, 0.5),
    ]
}

fn garment(panels: Vec<DrapedPanel>) -> GarmentMesh {
    GarmentMesh { panels }
}

fn draw(mesh: &GarmentMesh, view: View, width: u32) -> Picture {
    draw_with(mesh, None, &[], view, width)
}

fn draw_with(
    mesh: &GarmentMesh,
    body: Option<&TriangleMesh>,
    marks: &[[f64; 3]],
    view: View,
    width: u32,
) -> Picture {
    let subject = PictureSubject { mesh, body, marks };
    picture(&subject, view, width, &Limits::default()).unwrap()
}

fn pixel(picture: &Picture, x: u32, y: u32) -> [u8; 3] {
    let at = 3 * (y * picture.width() + x) as usize;
    picture.rgb()[at..at + 3].try_into().unwrap()
}

/// The pixel at shares of the width and the height, from the left and from the top.
fn pixel_at(picture: &Picture, [x, y]: [f64; 2]) -> [u8; 3] {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "shares of a small picture"
    )]
    let index = |share: f64, of: u32| (share * f64::from(of)) as u32;
    pixel(
        picture,
        index(x, picture.width()),
        index(y, picture.height()),
    )
}

/// The pixel off the middle, where no line of a square's or a cube's mesh is.
fn middle(picture: &Picture) -> [u8; 3] {
    pixel_at(picture, [0.55, 0.4])
}

fn background() -> [u8; 3] {
    let empty = draw(&GarmentMesh::default(), View::Front, 16);
    pixel(&empty, 0, 0)
}

fn brightness(color: [u8; 3]) -> u32 {
    color.map(u32::from).iter().sum()
}

/// Mean place of the red pixels, as shares of the width and the height; none without red.
fn red(picture: &Picture) -> Option<[f64; 2]> {
    let all = (0..picture.height()).flat_map(|y| (0..picture.width()).map(move |x| [x, y]));
    let red: Vec<_> = all
        .filter(|&[x, y]| {
            let [r, g, b] = pixel(picture, x, y);
            r > 180 && g < 80 && b < 80
        })
        .collect();
    let count = red.len() as f64;
    let sum = red.iter().fold([0.0; 2], |[a, b], &[x, y]| {
        [a + f64::from(x) + 0.5, b + f64::from(y) + 0.5]
    });
    let mean = [
        sum[0] / count / f64::from(picture.width()),
        sum[1] / count / f64::from(picture.height()),
    ];
    (count > 0.0).then_some(mean)
}

#[test]
fn triangle_covers_the_pixels_inside_it_and_no_other() {
    // 100 pixels a meter, 4 pixels of margin, and more than one band of rows.
    let corners = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let mesh = garment(vec![panel(corners, vec![[0, 1, 2]])]);
    let picture = draw(&mesh, View::Front, 108);
    assert_eq!([picture.width(), picture.height()], [108; 2]);
    let cloth = pixel(&picture, 30, 80);
    for (x, y) in (0..108).flat_map(|y| (0..108).map(move |x| (x, y))) {
        let [right, up] = [f64::from(x) - 3.5, 103.5 - f64::from(y)];
        let inside = right.min(up).min((100.0 - right - up) / 2_f64.sqrt());
        let found = pixel(&picture, x, y);
        // Lines along the border are 1.2 pixels wide.
        if inside > 1.5 {
            assert_eq!(found, cloth, "({x}, {y})");
        } else if inside < -1.5 {
            assert_eq!(found, background(), "({x}, {y})");
        }
    }
    assert!(brightness(cloth) + 60 < brightness(background()));
    let border = pixel(&picture, 30, 103);
    assert!(brightness(border) + 100 < brightness(cloth), "{border:?}");
}

#[test]
fn nearer_cloth_hides_farther() {
    let alone = [garment(vec![facing_front(0.0)]), {
        // The first panel has no triangles: colors go by number.
        garment(vec![DrapedPanel::default(), facing_front(0.1)])
    }];
    let both = garment(vec![facing_front(0.0), facing_front(0.1)]);
    let swapped = {
        let mut mesh = both.clone();
        mesh.panels[0].positions = facing_front(0.1).positions;
        mesh.panels[1].positions = facing_front(0.0).positions;
        mesh
    };
    for view in [View::Front, View::Back] {
        let [first, second] = [0, 1].map(|i| middle(&draw(&alone[i], view, 100)));
        assert_ne!(first, second);
        let is_front = view == View::Front;
        let nearer = if is_front { second } else { first };
        assert_eq!(middle(&draw(&both, view, 100)), nearer);
        let nearer = if is_front { first } else { second };
        assert_eq!(middle(&draw(&swapped, view, 100)), nearer);
    }
}

#[test]
fn each_view_looks_at_its_side() {
    let whole = garment(cube());
    let sides = [View::Front, View::Back, View::Left, View::Right];
    let mut colors = vec![];
    for (side, view) in sides.into_iter().enumerate() {
        let mut alone = GarmentMesh::default();
        alone.panels.resize(4, DrapedPanel::default());
        alone.panels[side] = cube().remove(side);
        let expected = middle(&draw(&alone, view, 100));
        assert_eq!(middle(&draw(&whole, view, 100)), expected, "{view:?}");
        colors.push(expected);
    }
    colors.sort_unstable();
    colors.dedup();
    assert_eq!(colors.len(), 4, "sides are told apart");
}

#[test]
fn right_and_up_are_where_a_viewer_sees_them() {
    let mesh = garment(cube());
    // Towards the body's left, its front, and up; shares from the left and from the top.
    let marks = [[0.3, 0.0, 0.0], [0.0, 0.0, 0.3], [0.0, 0.3, 0.0]];
    let (low, mid, high) = (0.5 - 0.3 / MARGIN, 0.5, 0.5 + 0.3 / MARGIN);
    let expected = [
        (View::Front, [high, mid]),
        (View::Back, [low, mid]),
        (View::Left, [mid, low]),
        (View::Right, [mid, high]),
    ];
    for (view, across) in expected {
        let seen = marks.map(|mark| red(&draw_with(&mesh, None, &[mark], view, 216)).unwrap());
        let close = |a: f64, b: f64| (a - b).abs() < 0.01;
        assert!(close(seen[0][0], across[0]), "{view:?}: {seen:?}");
        assert!(close(seen[1][0], across[1]), "{view:?}: {seen:?}");
        assert!(close(seen[2][0], mid) && close(seen[2][1], low), "{view:?}");
    }
    let view = View::ThreeQuarter;
    let seen = marks.map(|mark| red(&draw_with(&mesh, None, &[mark], view, 216)).unwrap());
    assert!(seen[0][0] > 0.6 && seen[1][0] < 0.4, "{seen:?}");
    assert!(seen[0][1] > 0.5 && seen[1][1] > 0.5, "from above: {seen:?}");
    assert!(seen[2][1] < 0.4, "{seen:?}");
}

#[test]
fn inner_side_of_cloth_has_a_darker_tone() {
    let mesh = garment(vec![facing_front(0.0)]);
    let [outer, inner] = [View::Front, View::Back].map(|view| middle(&draw(&mesh, view, 100)));
    assert!(brightness(inner) + 100 < brightness(outer));
}

/// A wall in the plane z, wider than the square.
fn wall(z: f64) -> TriangleMesh {
    let p = |x, y| Vector3::new(x, y, z);
    TriangleMesh {
        vertices: vec![p(-3.0, -3.0), p(3.0, -3.0), p(3.0, 3.0), p(-3.0, 3.0)],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
    }
}

#[test]
fn body_shows_beside_cloth_and_through_it_only_where_it_is_well_before_it() {
    let mesh = garment(vec![facing_front(0.0)]);
    let cloth = middle(&draw(&mesh, View::Front, 100));
    let with_wall = |z| draw_with(&mesh, Some(&wall(z)), &[], View::Front, 100);
    let body = pixel(&with_wall(-0.1), 1, 1);
    assert!(body != background() && body != cloth);
    for z in [-0.1, 0.0, 0.002] {
        let picture = with_wall(z);
        assert_eq!(middle(&picture), cloth, "body at {z}");
        assert_eq!(pixel(&picture, 1, 1), body);
    }
    assert_eq!(middle(&with_wall(0.01)), body);
}

#[test]
fn marks_are_seen_through_cloth_and_body() {
    let mesh = garment(vec![facing_front(0.0)]);
    let body = wall(1.0);
    let mark = [0.2, 0.7, -0.5];
    let picture = draw_with(&mesh, Some(&body), &[mark], View::Front, 216);
    let [x, y] = red(&picture).expect("it is marked");
    assert!((x - (0.5 + 0.2 / MARGIN)).abs() < 0.005, "{x}");
    assert!((y - (0.5 - 0.2 / MARGIN)).abs() < 0.005, "{y}");
    assert_eq!(red(&draw(&mesh, View::Front, 216)), None);
}

#[test]
fn sheet_has_the_views_beside_each_other() {
    let mesh = garment(cube());
    let subject = PictureSubject {
        mesh: &mesh,
        body: None,
        marks: &[[0.3, 0.2, 0.1]],
    };
    let limits = Limits::default();
    let sheet = picture_sheet(&subject, 320, &limits).unwrap();
    assert_eq!([sheet.width(), sheet.height()], [320, 80]);
    let order = [View::Front, View::Right, View::Back, View::Left];
    for (left, view) in (0..320).step_by(80).zip(order) {
        let alone = picture(&subject, view, 80, &limits).unwrap();
        for (x, y) in (0..80).flat_map(|y| (0..80).map(move |x| (x, y))) {
            assert_eq!(pixel(&sheet, left + x, y), pixel(&alone, x, y), "{view:?}");
        }
    }
}

#[test]
fn png_is_read_back_as_the_same_pixels() {
    let mesh = garment(cube());
    let picture = draw(&mesh, View::ThreeQuarter, 150);
    let bytes = picture.png();
    let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes))
        .read_info()
        .unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let frame = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((frame.width, frame.height), (150, picture.height()));
    assert_eq!(frame.color_type, png::ColorType::Rgb);
    assert_eq!(&pixels[..frame.buffer_size()], picture.rgb());
}

#[test]
fn the_same_garment_gives_the_same_bytes() {
    let mesh = garment(cube());
    for view in VIEWS {
        let twice = [(); 2].map(|()| draw_with(&mesh, Some(&wall(0.2)), &[], view, 120).png());
        assert_eq!(twice[0], twice[1]);
    }
}

#[test]
fn width_outside_the_limits_is_refused() {
    let mesh = garment(vec![square(
        [0.0; 3],
        [1.0, 0.0, 0.0],
        [0.0, 0.01, 0.0],
        0.5,
    )]);
    let subject = PictureSubject {
        mesh: &mesh,
        body: None,
        marks: &[],
    };
    let limits = Limits::default();
    for width in [0, 15, 4097, u32::MAX] {
        let fault = picture(&subject, View::Front, width, &limits).unwrap_err();
        assert_eq!(fault.code, RequestCode::OutOfRange);
        assert_eq!(fault.pointer, "/width");
        assert!(fault.detail.contains(&width.to_string()));
        let fix = fault.fix.unwrap();
        assert!(fix.contains("16 to 4096"), "{fix}");
        assert!(picture_sheet(&subject, width, &limits).is_err());
    }
    // What is lower than 50 mm is given the room of 50 mm.
    for (width, height) in [(16, 16), (4096, 205)] {
        let picture = picture(&subject, View::Front, width, &limits).unwrap();
        assert_eq!([picture.width(), picture.height()], [width, height]);
    }
}

#[test]
fn height_is_bounded_and_the_whole_garment_is_in() {
    let tall = square([0.0; 3], [0.1, 0.0, 0.0], [0.0, 1.0, 0.0], 0.9);
    let mesh = garment(vec![tall]);
    let subject = PictureSubject {
        mesh: &mesh,
        body: None,
        marks: &[[0.0, 0.85, 0.0], [0.0, -0.85, 0.0]],
    };
    let limits = Limits {
        picture_px: [16, 90],
        ..Limits::default()
    };
    for (width, height) in [(30, 60), (90, 90)] {
        let picture = picture(&subject, View::Front, width, &limits).unwrap();
        assert_eq!(picture.height(), height);
        let up = 0.85 / 0.9 / MARGIN;
        for y in [0.5 - up / 2.0, 0.5 + up / 2.0] {
            let [r, g, _] = pixel_at(&picture, [0.5, y]);
            assert!(r > 180 && g < 80, "at {y} of {width} x {height}");
        }
    }
}

#[test]
fn what_has_no_place_is_not_drawn() {
    let mesh = garment(vec![facing_front(0.0)]);
    let expected = draw(&mesh, View::Front, 100);
    for stray in [f64::NAN, f64::INFINITY, 1e300, -11.0] {
        let mut wild = mesh.clone();
        wild.panels[0].positions.push([stray, 0.5, 0.0]);
        wild.panels[0].uv.push([0.0; 2]);
        wild.panels[0].triangles.push([0, 3, 4]);
        let picture = draw_with(&wild, None, &[[0.0, stray, 0.0]], View::Front, 100);
        assert_ne!(middle(&picture), background(), "{stray}");
        assert_eq!(picture.height(), expected.height());
        assert_eq!(red(&picture), None);
        wild.panels[0].positions.fill([stray; 3]);
        let nothing = draw(&wild, View::Front, 100);
        assert!(nothing.rgb().chunks(3).all(|color| color == background()));
    }
}

#[test]
fn views_have_their_words() {
    let words = VIEWS.map(|view| json!(view));
    assert_eq!(
        json!(words),
        json!(["front", "back", "left", "right", "three_quarter"])
    );
}
