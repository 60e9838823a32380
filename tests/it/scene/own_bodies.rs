//! Bodies of one's own: the project's dress form, whose measures are known, written as a file in
//! other axes and units, and the two bodies of the shared data with their true landmarks.

use nalgebra::{Matrix3, Rotation3, Vector3};
use seamster::config::Limits;
use seamster::export;
use seamster::scene::{
    Avatar, BodyImport, BodyImportOptions, BodyUnits, DressForm, LANDMARKS, Limbs, Pose,
    TriangleMesh, import_body,
};
use serde_json::Value;
use std::fmt::Write;
use std::path::PathBuf;

fn form(pose: Pose) -> Avatar {
    let form = DressForm {
        pose,
        limbs: Some(Limbs {
            arms: true,
            legs: true,
        }),
        ..DressForm::default()
    };
    form.build().expect("size M")
}

/// The surface as OBJ, each vertex moved.
fn obj(surface: &TriangleMesh, moved: impl Fn(&Vector3<f64>) -> Vector3<f64>) -> String {
    let mut text = String::new();
    for p in surface.vertices.iter().map(moved) {
        writeln!(text, "v {:.9} {:.9} {:.9}", p.x, p.y, p.z).expect("a string takes all");
    }
    for [a, b, c] in &surface.triangles {
        writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1).expect("a string takes all");
    }
    text
}

fn import(bytes: &[u8]) -> BodyImport {
    import_body(bytes, &BodyImportOptions::default(), &Limits::default()).expect("a body")
}

fn codes(bytes: &[u8]) -> Vec<String> {
    let faults = import_body(bytes, &BodyImportOptions::default(), &Limits::default());
    let faults = faults.expect_err("refused").0;
    faults.into_iter().map(|f| f.code.to_string()).collect()
}

#[test]
fn a_body_is_the_same_from_any_axes_and_unit() {
    let form = form(Pose::A);
    let upright = Matrix3::identity();
    let z_up = Matrix3::new(1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0);
    let mirrored = Matrix3::from_diagonal(&Vector3::new(-1.0, 1.0, 1.0));
    let askew = *Rotation3::from_euler_angles(0.7, -1.9, 2.6).matrix();
    for (turn, unit, units) in [
        (upright, 1.0, BodyUnits::Meter),
        (z_up, 0.0254, BodyUnits::Inch),
        (mirrored, 0.001, BodyUnits::Millimeter),
        (askew, 0.01, BodyUnits::Centimeter),
    ] {
        let file = obj(&form.surface, |p| turn * p / unit);
        let found = import(file.as_bytes());
        assert_eq!(found.units, units);
        // upright on its soles within a degree, which is 26 mm at the neck
        for p in found.body.vertices.iter().step_by(97) {
            let off = form.exact_distance(&Vector3::from(*p)).abs();
            assert!(off < 0.026, "{off} at {p:?}, in {units:?}");
        }
        let body = found.body.build().expect("a closed body");
        let girths = body.girths();
        let asked = [("bust_m", 0.92), ("waist_m", 0.74), ("hip_m", 0.98)];
        for (name, girth) in asked {
            let off = girths[name] - girth;
            assert!(off.abs() < 0.005, "{name} {off} in {units:?}");
        }
        for name in [
            "crotch",
            "waist_side_l",
            "hip_side_r",
            "bust_point_l",
            "armpit_r",
        ] {
            let (p, truth) = (body.landmarks[name], form.landmarks[name]);
            assert!(
                (p.y - truth.y).abs() < 0.02,
                "{name} {p} {truth} in {units:?}"
            );
        }
    }
}

#[test]
fn limbs_are_found_in_every_pose() {
    for pose in [Pose::A, Pose::T, Pose::I] {
        let form = form(pose);
        let found = import(obj(&form.surface, |p| *p).as_bytes());
        let body = found.body.build().expect("a closed body");
        for name in LANDMARKS {
            assert!(body.landmarks.contains_key(name), "{name} in {pose:?}");
        }
        for joint in ["wrist_l", "wrist_r", "knee_l"] {
            let off = (body.landmarks[joint] - form.landmarks[joint]).norm();
            assert!(off < 0.05, "{joint} is {off} off in {pose:?}");
        }
        // The form's axis ends at its ankle girth, above the joint: on the same line.
        let off = body.landmarks["ankle_r"] - form.landmarks["ankle_r"];
        let beside = off.x.hypot(off.z);
        assert!(
            beside < 0.05 && off.y.abs() < 0.08,
            "ankle_r is {off} off in {pose:?}"
        );
    }
}

#[test]
fn all_formats_give_the_same_body() {
    let form = form(Pose::A);
    let from_obj = import(obj(&form.surface, |p| *p).as_bytes()).body;
    let glb = import(&export::avatar_glb(&form.surface)).body;
    for encoding in ["ascii", "binary_little_endian", "binary_big_endian"] {
        let found = import(&ply(&form.surface, encoding)).body;
        assert_eq!(found.triangles, from_obj.triangles, "{encoding}");
        assert_eq!(found.vertices, from_obj.vertices, "{encoding}");
    }
    assert_eq!(glb.triangles.len(), from_obj.triangles.len());
    let waist = |body: &seamster::scene::OwnBody| body.landmarks["waist_side_l"];
    // single precision
    for (a, b) in waist(&glb).iter().zip(waist(&from_obj)) {
        assert!((a - b).abs() < 2e-6);
    }
}

fn ply(surface: &TriangleMesh, encoding: &str) -> Vec<u8> {
    let mut file = format!(
        "ply\nformat {encoding} 1.0\ncomment x\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        surface.vertices.len(),
        surface.triangles.len()
    )
    .into_bytes();
    let rounded = |x: f64| (x * 1e9).round() / 1e9;
    for p in &surface.vertices {
        for x in p.iter().map(|x| rounded(*x)) {
            match encoding {
                "ascii" => file.extend(format!("{x:.9} ").bytes()),
                "binary_big_endian" => file.extend(x.to_be_bytes()),
                _ => file.extend(x.to_le_bytes()),
            }
        }
    }
    for triangle in &surface.triangles {
        let corners = triangle.map(|v| i32::try_from(v).expect("some thousands"));
        match encoding {
            "ascii" => {
                file.extend(format!("3 {} {} {}\n", corners[0], corners[1], corners[2]).bytes());
            }
            big => {
                file.push(3);
                for v in corners {
                    file.extend(if big == "binary_big_endian" {
                        v.to_be_bytes()
                    } else {
                        v.to_le_bytes()
                    });
                }
            }
        }
    }
    file
}

/// The form without the triangles whose corners are all within a distance of a point.
fn with_hole(form: &Avatar, at: &Vector3<f64>, radius: f64) -> TriangleMesh {
    let mut surface = form.surface.clone();
    let vertices = surface.vertices.clone();
    let is_near = |v: &usize| (vertices[*v] - at).norm() < radius;
    surface.triangles.retain(|t| !t.iter().all(is_near));
    surface
}

#[test]
fn a_hole_of_a_palm_is_mended_and_told_and_a_larger_one_refused() {
    let form = form(Pose::A);
    let waist = form.landmarks["waist_back"];
    let found = import(obj(&with_hole(&form, &waist, 0.045), |p| *p).as_bytes());
    let told: Vec<_> = found
        .warnings
        .iter()
        .filter(|w| w.code == "avatar/mended")
        .collect();
    assert_eq!(told.len(), 1, "{:?}", found.warnings);
    assert!(told[0].detail.contains("mm wide"), "{}", told[0].detail);
    let body = found.body.build().expect("closed again");
    // the cap is flat on a back of some 15 cm radius of curvature: 0.045² / (2 · 0.15) = 7 mm
    assert!(body.exact_distance(&waist).abs() < 0.008);
    let large = obj(&with_hole(&form, &waist, 0.11), |p| *p);
    assert_eq!(codes(large.as_bytes()), ["avatar/open"]);
}

#[test]
fn split_vertices_and_loose_pieces_are_no_matter() {
    let form = form(Pose::A);
    let mut split = TriangleMesh::default();
    for triangle in &form.surface.triangles {
        let first = split.vertices.len();
        split
            .vertices
            .extend(triangle.map(|v| form.surface.vertices[v]));
        split.triangles.push([first, first + 1, first + 2]);
    }
    let first = split.vertices.len();
    let eye = [0.0, 0.01, 0.02].map(|x| Vector3::new(x, 1.4 + x * x * 10.0, 0.2));
    split.vertices.extend(eye);
    split.triangles.push([first, first + 1, first + 2]);
    let found = import(obj(&split, |p| *p).as_bytes());
    assert_eq!(found.body.vertices.len(), form.surface.vertices.len());
    let told = found.warnings.iter().any(|w| w.code == "avatar/left_out");
    assert!(told, "{:?}", found.warnings);
}

#[test]
fn a_body_of_no_size_of_a_person_is_told_how_to_state_it() {
    let form = form(Pose::A);
    let tiny = obj(&form.surface, |p| p * 0.3);
    let options = BodyImportOptions {
        units: Some(BodyUnits::Meter),
        ..BodyImportOptions::default()
    };
    let faults = import_body(tiny.as_bytes(), &options, &Limits::default());
    let fault = &faults.expect_err("of 45 cm").0[0];
    assert_eq!(fault.code, "avatar/units");
    assert!(
        fault
            .fix
            .as_deref()
            .is_some_and(|fix| fix.contains("units"))
    );
}

#[test]
fn given_landmarks_are_taken_in_the_files_own_coordinates() {
    let form = form(Pose::A);
    let file = obj(&form.surface, |p| p * 100.0);
    let place = form.landmarks["shoulder_tip_l"] * 100.0 + Vector3::new(0.5, 0.0, 0.0);
    let mut options = BodyImportOptions::default();
    options
        .landmarks
        .insert("shoulder_tip_l".to_owned(), place.into());
    let found = import_body(file.as_bytes(), &options, &Limits::default()).expect("a body");
    let tip = Vector3::from(found.body.landmarks["shoulder_tip_l"]);
    assert!((tip - form.landmarks["shoulder_tip_l"] - Vector3::new(0.005, 0.0, 0.0)).norm() < 1e-4);
    options
        .landmarks
        .insert("crotch".to_owned(), [1e4, 0.0, 0.0]);
    let faults = import_body(file.as_bytes(), &options, &Limits::default()).expect_err("far off");
    assert_eq!(faults.0[0].pointer, "/landmarks/crotch");
}

/// Whatever bytes come, the answer is a body or a fault.
#[test]
fn damaged_files_are_refused_or_read_and_never_panic() {
    let cube = TriangleMesh {
        vertices: (0..8)
            .map(|k| Vector3::from_fn(|axis, _| f64::from((k >> axis) & 1)))
            .collect(),
        triangles: vec![
            [0, 2, 1],
            [1, 2, 3],
            [0, 1, 4],
            [1, 5, 4],
            [0, 4, 2],
            [2, 4, 6],
        ],
    };
    let files = [
        obj(&cube, |p| *p).into_bytes(),
        ply(&cube, "ascii"),
        ply(&cube, "binary_big_endian"),
        export::avatar_glb(&cube),
    ];
    let limits = Limits::default();
    let options = BodyImportOptions::default();
    for file in files {
        for end in 0..file.len() {
            let _ = import_body(&file[..end], &options, &limits);
            let mut flipped = file.clone();
            flipped[end] ^= 0x5a;
            let _ = import_body(&flipped, &options, &limits);
        }
    }
}

#[test]
fn files_that_would_take_much_memory_are_refused_before() {
    let limits = Limits::default();
    let header = "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n";
    assert_eq!(codes(header.as_bytes()), ["avatar/file"]);
    let endless = "ply\nformat ascii 1.0\nelement nothing 4000000000\nend_header\n";
    assert_eq!(codes(endless.as_bytes()), ["avatar/file"]);
    let many = "v 0 0 0\n".repeat(limits.body_vertices + 1);
    assert_eq!(codes(many.as_bytes()), ["avatar/too_large"]);
    assert_eq!(codes(b"v 0 nan 0"), ["avatar/file"]);
    assert_eq!(codes(b"f 1 2 3"), ["avatar/file"]);
    assert_eq!(codes(b""), ["avatar/empty"]);
}

fn shared() -> Option<PathBuf> {
    let folder = std::env::var_os("SEAMSTER_TEST_DATA").map(PathBuf::from);
    if folder.is_none() {
        println!("SEAMSTER_TEST_DATA is not set: 1 test left out (own bodies)");
    }
    folder
}

/// The tolerances of the requirement: 15 mm, 30 mm at the tips of the shoulders, 5 mm of girths.
/// The truth was taken on a finer mesh than the files have: the crotch of the woman's is 14 mm
/// higher in the file, and the girth of her thigh with it.
#[test]
fn landmarks_and_girths_of_the_shared_bodies_are_true() {
    let Some(folder) = shared() else { return };
    let truth = std::fs::read(folder.join("body/landmarks.json")).expect("landmarks");
    let truth: Value = serde_json::from_slice(&truth).expect("JSON");
    for sex in ["female", "male"] {
        let file = std::fs::read(folder.join(format!("body/body_{sex}.obj"))).expect("a body");
        let body = import(&file).body.build().expect("closed");
        let number = |value: &Value| value.as_f64().expect("a number");
        for name in LANDMARKS {
            let at = &truth[sex]["landmarks_m"][name];
            let at = Vector3::new(number(&at[0]), number(&at[1]), number(&at[2]));
            let off = (body.landmarks[name] - at).norm();
            let most = if name.starts_with("shoulder") {
                0.03
            } else {
                0.015
            };
            assert!(off <= most, "{sex} {name}: {:.1} mm", off * 1e3);
        }
        let girths = body.girths();
        for (name, key) in [
            ("bust_m", "bust"),
            ("waist_m", "waist"),
            ("hip_m", "hip"),
            ("neck_m", "neck_min"),
            ("elbow_m", "elbow"),
            ("wrist_m", "wrist"),
            ("knee_m", "knee"),
            ("calf_m", "calf"),
            ("ankle_m", "ankle"),
        ] {
            let off = girths[name] - number(&truth[sex]["measurements_m"][key]);
            assert!(off.abs() <= 0.005, "{sex} {name}: {:.1} mm", off * 1e3);
        }
    }
}
