//! Bodies with limbs, looked over by the judge of crossings.

use seamster::scene::{DressForm, Limbs, Pose, Sex};
use seamster_crossings::{SearchLimits, Surface, find_crossings};

/// Slim, middle and wide bodies, in all poses.
#[test]
fn no_body_passes_through_itself() {
    let measures = [
        (1.56, 0.80, 0.62, 0.88, Sex::Women, Pose::A),
        (1.68, 0.92, 0.74, 0.98, Sex::Women, Pose::T),
        (1.72, 1.24, 1.12, 1.28, Sex::Women, Pose::A),
        (1.86, 1.04, 0.90, 1.02, Sex::Men, Pose::I),
    ];
    for (height_m, bust_m, waist_m, hip_m, sex, pose) in measures {
        let form = DressForm {
            sex,
            pose,
            limbs: Some(Limbs {
                arms: true,
                legs: true,
            }),
            ..DressForm::new(height_m, bust_m, waist_m, hip_m)
        };
        assert_no_crossings(&form);
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "crossings are found in single precision"
)]
fn assert_no_crossings(form: &DressForm) {
    let avatar = form.build().expect("measures of a person");
    let vertices = avatar.surface.vertices.iter();
    let positions: Vec<[f32; 3]> = vertices
        .map(|v| [v.x as f32, v.y as f32, v.z as f32])
        .collect();
    let triangles = avatar.surface.triangles.iter();
    let triangles: Vec<[u32; 3]> = triangles
        .map(|t| t.map(|v| u32::try_from(v).expect("few")))
        .collect();
    let skin = Surface::new(&positions, &triangles, &[]).expect("finite");
    let limits = SearchLimits {
        kept: 4,
        pairs: 10_000_000,
    };
    let found = find_crossings(&skin, None, limits).expect("few pairs");
    assert_eq!(found.cloth.count, 0, "{form:?}: {:?}", found.cloth.kept);
    assert_eq!(found.degenerate, [0; 0], "{form:?}");
}
