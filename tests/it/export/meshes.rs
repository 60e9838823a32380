//! Exported meshes, read back by readers that are not ours.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use nalgebra::Vector3;
use seamster::export::{
    DrapedPanel, GarmentMesh, VertexMaps, avatar_glb, garment_with_avatar_glb, glb, obj, ply,
};
use seamster::scene::TriangleMesh;
use std::path::Path;
use std::process::Command;

/// A half pipe of radius 0.15 m about the y axis: the front one bulges to +z, the back one to -z.
fn half_pipe(panel: &str, fabric: &str, facing: f64) -> DrapedPanel {
    const ROWS: u32 = 7;
    const COLUMNS: u32 = 13;
    let mut mesh = DrapedPanel {
        panel: panel.to_owned(),
        fabric: fabric.to_owned(),
        ..DrapedPanel::default()
    };
    for row in 0..=ROWS {
        for column in 0..=COLUMNS {
            let u = 0.15 * std::f64::consts::PI * f64::from(column) / f64::from(COLUMNS);
            let v = 0.3 * f64::from(row) / f64::from(ROWS);
            let (sin, cos) = (u / 0.15).sin_cos();
            let position = [-0.15 * cos * facing, 1.0 + v, 0.15 * sin * facing];
            mesh.positions.push(position);
            mesh.uv.push([u, v]);
        }
    }
    for row in 0..ROWS {
        for column in 0..COLUMNS {
            let a = row * (COLUMNS + 1) + column;
            let above = a + COLUMNS + 1;
            mesh.triangles.push([a, a + 1, above]);
            mesh.triangles.push([a + 1, above + 1, above]);
        }
    }
    mesh
}

fn garment() -> GarmentMesh {
    GarmentMesh {
        panels: vec![
            half_pipe("front", "cotton-poplin", 1.0),
            half_pipe("back", "denim", -1.0),
            half_pipe("sleeve~mirror", "cotton-poplin", 1.0),
        ],
    }
}

fn body() -> TriangleMesh {
    let p = |x, y, z| Vector3::new(x, y, z);
    TriangleMesh {
        vertices: vec![
            p(0.0, 1.0, 0.0),
            p(0.1, 1.0, 0.0),
            p(0.0, 1.1, 0.0),
            p(0.0, 1.0, 0.1),
        ],
        triangles: vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
    }
}

fn single<const N: usize>(v: [f64; N]) -> [f32; N] {
    #[expect(clippy::cast_possible_truncation, reason = "what glTF stores")]
    v.map(|x| x as f32)
}

/// Every normal has unit length and lies on the counter-clockwise side of every triangle round it.
fn assert_normals_point_out(positions: &[[f32; 3]], normals: &[[f32; 3]], triangles: &[[u32; 3]]) {
    assert_eq!(positions.len(), normals.len());
    for normal in normals {
        assert!((Vector3::from(*normal).norm() - 1.0).abs() < 1e-5);
    }
    for triangle in triangles {
        let [a, b, c] = triangle.map(|i| Vector3::from(positions[i as usize]));
        let out = (b - a).cross(&(c - a)).normalize();
        for i in triangle {
            assert!(Vector3::from(normals[*i as usize]).dot(&out) > 0.9);
        }
    }
}

/// The document, checked, and its buffer.
fn read(bytes: &[u8]) -> (gltf::Document, Vec<u8>) {
    let file = gltf::Gltf::from_slice(bytes).unwrap();
    (file.document, file.blob.unwrap_or_default())
}

fn triples(indices: impl Iterator<Item = u32>) -> Vec<[u32; 3]> {
    let flat: Vec<u32> = indices.collect();
    flat.chunks(3).map(|t| [t[0], t[1], t[2]]).collect()
}

#[test]
fn glb_reads_back_the_same_mesh() {
    let garment = garment();
    let (document, blob) = read(&glb(&garment));
    let nodes: Vec<_> = document.default_scene().unwrap().nodes().collect();
    assert_eq!(nodes.len(), garment.panels.len());
    for (node, panel) in nodes.iter().zip(&garment.panels) {
        assert_eq!(node.name(), Some(panel.panel.as_str()));
        let primitives: Vec<_> = node.mesh().unwrap().primitives().collect();
        let [primitive] = &primitives[..] else {
            panic!("one primitive a panel");
        };
        let reader = primitive.reader(|buffer| (buffer.index() == 0).then_some(&blob[..]));
        let positions: Vec<[f32; 3]> = reader.read_positions().unwrap().collect();
        let expected: Vec<_> = panel.positions.iter().map(|p| single(*p)).collect();
        assert_eq!(positions, expected);
        let uv: Vec<[f32; 2]> = reader.read_tex_coords(0).unwrap().into_f32().collect();
        let expected: Vec<_> = panel.uv.iter().map(|p| single(*p)).collect();
        assert_eq!(uv, expected);
        let triangles = triples(reader.read_indices().unwrap().into_u32());
        assert_eq!(triangles, panel.triangles);
        let normals: Vec<[f32; 3]> = reader.read_normals().unwrap().collect();
        assert_normals_point_out(&positions, &normals, &triangles);
        assert_eq!(primitive.material().name(), Some(panel.fabric.as_str()));
        assert!(primitive.material().double_sided());
    }
    assert_eq!(document.materials().count(), 2, "one a fabric");
}

#[test]
fn glb_bounds_enclose_the_positions() {
    let garment = garment();
    let (document, _) = read(&glb(&garment));
    for (mesh, panel) in document.meshes().zip(&garment.panels) {
        let bounds = mesh.primitives().next().unwrap().bounding_box();
        for k in 0..3 {
            let along = || panel.positions.iter().map(|p| single(*p)[k]);
            assert_eq!(bounds.min[k], along().fold(f32::INFINITY, f32::min));
            assert_eq!(bounds.max[k], along().fold(f32::NEG_INFINITY, f32::max));
        }
    }
}

#[test]
fn avatar_stands_beside_the_panels() {
    let (document, _) = read(&garment_with_avatar_glb(&garment(), &body()));
    let names: Vec<_> = document
        .nodes()
        .map(|n| n.name().unwrap().to_owned())
        .collect();
    assert_eq!(names, ["front", "back", "sleeve~mirror", "avatar"]);
    let (document, blob) = read(&avatar_glb(&body()));
    let primitive = document
        .meshes()
        .next()
        .unwrap()
        .primitives()
        .next()
        .unwrap();
    let reader = primitive.reader(|buffer| (buffer.index() == 0).then_some(&blob[..]));
    assert_eq!(reader.read_positions().unwrap().count(), 4);
    assert_eq!(reader.read_indices().unwrap().into_u32().count(), 12);
}

#[test]
fn garments_without_cloth_are_valid_files() {
    let bare = GarmentMesh {
        panels: vec![DrapedPanel {
            panel: "front".to_owned(),
            ..DrapedPanel::default()
        }],
    };
    for garment in [GarmentMesh::default(), bare] {
        let (document, _) = read(&glb(&garment));
        assert_eq!(document.nodes().count(), garment.panels.len());
        assert_eq!(document.meshes().count(), 0);
    }
}

/// Two panels, each with maps whose values tell the vertex.
fn mapped() -> GarmentMesh {
    let panels = [
        half_pipe("front", "denim", 1.0),
        half_pipe("back", "jersey", -1.0),
    ];
    let panels = panels.map(|panel| {
        let values = |from: f64| {
            (0..panel.positions.len())
                .map(|v| from + v as f64)
                .collect()
        };
        let maps = VertexMaps {
            strain_warp: values(0.0),
            strain_weft: values(1000.0),
            strain_share: values(2000.0),
            pressure_kpa: values(3000.0),
            gap_mm: values(4000.0),
        };
        DrapedPanel { maps, ..panel }
    });
    GarmentMesh {
        panels: panels.to_vec(),
    }
}

#[test]
fn maps_are_attributes_of_glb() {
    let garment = mapped();
    let (document, buffer) = read(&glb(&garment));
    for (mesh, panel) in document.meshes().zip(&garment.panels) {
        let primitive = mesh.primitives().next().unwrap();
        let floats = |name: &str| -> Vec<f32> {
            let semantic = gltf::Semantic::Extras(name.to_owned());
            let accessor = primitive.get(&semantic).unwrap();
            let view = accessor.view().unwrap();
            let bytes = &buffer[view.offset()..view.offset() + view.length()];
            let floats = bytes.chunks_exact(4);
            floats
                .map(|b| f32::from_le_bytes(b.try_into().unwrap()))
                .collect()
        };
        let strains = floats("STRAIN");
        for v in 0..panel.positions.len() {
            let value = v as f32;
            assert_eq!(strains[2 * v..2 * v + 2], [value, 1000.0 + value]);
            assert_eq!(floats("STRAIN_SHARE")[v], 2000.0 + value);
            assert_eq!(floats("PRESSURE")[v], 3000.0 + value);
            assert_eq!(floats("GAP")[v], 4000.0 + value);
        }
    }
}

/// The file is a PLY that the reader of bodies takes as it is, and its vertices hold the maps.
#[test]
fn ply_holds_the_surface_and_the_maps() {
    let garment = mapped();
    let file = ply(&garment);
    let end = b"end_header\n";
    let at = file.windows(end.len()).position(|w| w == end).unwrap() + end.len();
    let header = std::str::from_utf8(&file[..at]).unwrap();
    for line in [
        "comment panel 1 back",
        "element vertex 224",
        "element face 364",
        "property float pressure_kpa",
    ] {
        assert!(header.lines().any(|l| l == line), "{line} in {header}");
    }
    let columns = header
        .lines()
        .filter(|l| l.starts_with("property float "))
        .count();
    assert_eq!(columns, 13);
    let count = garment.panels[0].positions.len();
    let row = |v: usize| -> Vec<f32> {
        let bytes = &file[at + 4 * columns * v..][..4 * columns];
        let floats = bytes.chunks_exact(4);
        floats
            .map(|b| f32::from_le_bytes(b.try_into().unwrap()))
            .collect()
    };
    for (number, panel) in garment.panels.iter().enumerate() {
        for (v, p) in panel.positions.iter().enumerate() {
            let row = row(number * count + v);
            assert!((f64::from(row[1]) - p[1]).abs() < 1e-7);
            assert_eq!(
                row[8..],
                [0.0, 1e3, 2e3, 3e3, 4e3].map(|from| from + v as f32)
            );
        }
    }
    let faces = &file[at + 4 * columns * 2 * count..];
    assert_eq!(faces.len(), 364 * 17);
    // The first triangle of the second panel: its vertices come after those of the first.
    let first: Vec<u32> = faces[182 * 17 + 1..182 * 17 + 17]
        .chunks_exact(4)
        .map(|b| u32::from_le_bytes(b.try_into().unwrap()))
        .collect();
    let [a, b, c] = garment.panels[1].triangles[0].map(|v| v + u32::try_from(count).unwrap());
    assert_eq!(first, [a, b, c, 1]);
}

#[test]
fn khronos_validator_finds_nothing_to_fault() {
    let folder = tempfile::tempdir().unwrap();
    let files = [
        ("garment.glb", glb(&garment())),
        ("dressed.glb", garment_with_avatar_glb(&garment(), &body())),
        ("avatar.glb", avatar_glb(&body())),
        ("nothing.glb", glb(&GarmentMesh::default())),
        ("maps.glb", glb(&mapped())),
    ]
    .map(|(name, bytes)| {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    });
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/browser/validate-gltf.mjs");
    let output = Command::new("node").arg(script).args(files).output();
    let output = output.expect("node runs (and `npm ci` was run in tests/browser)");
    let text = String::from_utf8_lossy(&output.stdout);
    let faults = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{text}{faults}");
    assert_eq!(text.matches(" 0 errors, 0 warnings").count(), 5, "{text}");
}

#[test]
fn obj_reads_back_the_same_mesh() {
    let garment = garment();
    let text = obj(&garment);
    let options = tobj::LoadOptions {
        single_index: true,
        ..tobj::LoadOptions::default()
    };
    let no_materials = |_: &Path| Err(tobj::LoadError::OpenFileFailed);
    let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, no_materials).unwrap();
    assert_eq!(models.len(), garment.panels.len());
    for (model, panel) in models.iter().zip(&garment.panels) {
        assert_eq!(model.name, panel.panel);
        // A reader numbers vertices as faces come, so compare corner by corner.
        assert_eq!(model.mesh.indices.len(), 3 * panel.triangles.len());
        for (read, drawn) in model
            .mesh
            .indices
            .iter()
            .zip(panel.triangles.iter().flatten())
        {
            let (read, drawn) = (*read as usize, *drawn as usize);
            let of = |list: &[f32], n: usize| list[n * read..n * (read + 1)].to_vec();
            // Half a nanometer as printed, then one rounding to single precision of at most 2 m.
            let close = |a: &[f32], b: &[f64]| {
                a.iter()
                    .zip(b)
                    .all(|(a, b)| (f64::from(*a) - b).abs() < 0.5e-9 + 1.2e-7)
            };
            assert!(close(
                &of(&model.mesh.positions, 3),
                &panel.positions[drawn]
            ));
            assert!(close(&of(&model.mesh.texcoords, 2), &panel.uv[drawn]));
        }
        let vectors = |list: &[f32]| {
            list.chunks(3)
                .map(|p| [p[0], p[1], p[2]])
                .collect::<Vec<_>>()
        };
        assert_normals_point_out(
            &vectors(&model.mesh.positions),
            &vectors(&model.mesh.normals),
            &triples(model.mesh.indices.iter().copied()),
        );
    }
}

#[test]
fn json_reads_back_the_same_mesh() {
    let garment = garment();
    let text = serde_json::to_string(&garment).unwrap();
    let read: GarmentMesh = serde_json::from_str(&text).unwrap();
    assert_eq!(read, garment);
}

/// The normals of each panel, as GLB and as OBJ store them.
fn stored_normals(garment: &GarmentMesh) -> [Vec<Vec<[f32; 3]>>; 2] {
    let (document, blob) = read(&glb(garment));
    let in_glb = document.meshes().map(|mesh| {
        let primitive = mesh.primitives().next().unwrap();
        let reader = primitive.reader(|buffer| (buffer.index() == 0).then_some(&blob[..]));
        reader.read_normals().unwrap().collect()
    });
    let text = obj(garment);
    let lines = text.lines().filter_map(|line| line.strip_prefix("vn "));
    let mut lines = lines.map(|line| {
        let numbers: Vec<f32> = line.split(' ').map(|x| x.parse().unwrap()).collect();
        [numbers[0], numbers[1], numbers[2]]
    });
    let in_obj = garment
        .panels
        .iter()
        .map(|panel| lines.by_ref().take(panel.positions.len()).collect());
    [in_glb.collect(), in_obj.collect()]
}

/// A square of side 0.1 m from the y axis out to `far` (x, z), facing the side that +z is turned
/// to.
fn square(panel: &str, far: [f64; 2], triangles: [[u32; 3]; 2]) -> DrapedPanel {
    let [x, z] = far;
    let positions = [[0.0, 0.0, 0.0], [x, 0.0, z], [x, 0.1, z], [0.0, 0.1, 0.0]];
    DrapedPanel {
        panel: panel.to_owned(),
        fabric: "denim".to_owned(),
        positions: positions.to_vec(),
        uv: vec![[0.0, 0.0], [0.1, 0.0], [0.1, 0.1], [0.0, 0.1]],
        triangles: triangles.to_vec(),
        ..DrapedPanel::default()
    }
}

#[test]
fn light_does_not_break_at_a_smooth_seam_and_does_at_a_crease() {
    let left = square("left", [-0.1, 0.0], [[0, 2, 1], [0, 3, 2]]);
    for (far, is_smooth) in [
        ([0.1, 0.0], true),
        ([0.09, 0.04], true),
        ([0.0, 0.1], false),
    ] {
        let right = square("right", far, [[0, 1, 2], [0, 2, 3]]);
        let garment = GarmentMesh {
            panels: vec![left.clone(), right],
        };
        for normals in stored_normals(&garment) {
            for i in [0, 3] {
                assert_eq!(normals[0][i] == normals[1][i], is_smooth, "{far:?}");
            }
            assert_eq!(normals[0][1], [0.0, 0.0, 1.0], "off the seam");
        }
    }
}

#[test]
fn same_mesh_gives_the_same_bytes() {
    assert_eq!(glb(&garment()), glb(&garment()));
    assert_eq!(obj(&garment()), obj(&garment()));
}
