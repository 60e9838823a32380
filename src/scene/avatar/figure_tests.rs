//! Bodies with arms and legs: measured by slices of their own, looked over for holes and crossings.

use super::*;
use std::f64::consts::TAU;

const LIMBS: Option<Limbs> = Some(Limbs {
    arms: true,
    legs: true,
});
/// Allowed for girths and for lengths \[m\].
const GIRTH: f64 = 0.003;
const LENGTH: f64 = 0.005;

fn with_limbs() -> DressForm {
    DressForm {
        limbs: LIMBS,
        ..DressForm::default()
    }
}

/// Numbers from 0 to 1 (MMIX's linear congruential generator, D. E. Knuth).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn within(&mut self, [least, most]: [f64; 2]) -> f64 {
        least + (most - least) * self.next()
    }

    /// A form that can be built, women's and men's in turn.
    fn form(&mut self) -> DressForm {
        loop {
            let height = self.within([1.45, 2.05]);
            let bust = self.within([0.46, 0.66]) * height;
            let hip = self.within([0.88, 1.15]) * bust;
            let waist = self.within([0.70, 0.95]) * bust.min(hip);
            let mut form = DressForm::new(height, bust, waist, hip);
            form.limbs = LIMBS;
            form.sex = if self.next() < 0.5 {
                Sex::Women
            } else {
                Sex::Men
            };
            let mut vary =
                |field: &str, by: f64| Some(form.value(field) * self.within([1.0 - by, 1.0 + by]));
            let neck = vary("neck_m", 0.05);
            let waist_height = vary("waist_height_m", 0.015);
            let inside_leg = vary("inside_leg_m", 0.02);
            let limbs = ["thigh_m", "knee_m", "calf_m", "ankle_m"].map(|field| vary(field, 0.06));
            let arm = ["arm_length_m", "upper_arm_m", "elbow_m", "wrist_m"].map(|f| vary(f, 0.06));
            form.neck_m = neck;
            form.waist_height_m = waist_height;
            form.inside_leg_m = inside_leg;
            [form.thigh_m, form.knee_m, form.calf_m, form.ankle_m] = limbs;
            [
                form.arm_length_m,
                form.upper_arm_m,
                form.elbow_m,
                form.wrist_m,
            ] = arm;
            if form.check().is_empty() {
                return form;
            }
        }
    }
}

/// Points of a surface in the plane through `point` normal to `normal`, no further than `within`
/// from the point.
fn cut(
    surface: &TriangleMesh,
    (point, normal): (Vector3<f64>, Vector3<f64>),
    within: f64,
) -> Vec<Vector3<f64>> {
    let mut found = Vec::new();
    for t in 0..surface.triangles.len() {
        let corners = surface.corners(t);
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            let (da, db) = ((a - point).dot(&normal), (b - point).dot(&normal));
            if (da < 0.0) != (db < 0.0) {
                let p = a + (b - a) * (da / (da - db));
                if (p - point).norm() < within {
                    found.push(p);
                }
            }
        }
    }
    found
}

/// Perimeter of the hull of points in a plane: the mean width times pi (A.-L. Cauchy), from
/// supports in `DIRECTIONS`; each edge of the hull is seen within a share of pi² / (6
/// DIRECTIONS²) of its length.
fn hull_length(points: &[Vector3<f64>], normal: Vector3<f64>) -> f64 {
    const DIRECTIONS: usize = 720;
    let one = normal.cross(&Vector3::new(0.31, 0.22, 0.92)).normalize();
    let two = normal.cross(&one).normalize();
    let supports = (0..DIRECTIONS).map(|i| {
        let (sin, cos) = (TAU * i as f64 / DIRECTIONS as f64).sin_cos();
        let direction = one * cos + two * sin;
        let reach = points.iter().map(|p| p.dot(&direction));
        reach.fold(f64::NEG_INFINITY, f64::max)
    });
    supports.sum::<f64>() * TAU / DIRECTIONS as f64
}

fn tape(avatar: &Avatar, at: Vector3<f64>, normal: Vector3<f64>, within: f64) -> f64 {
    hull_length(&cut(&avatar.surface, (at, normal), within), normal)
}

fn close(found: f64, asked: f64, tolerance: f64, what: &str) {
    let off = (found - asked).abs();
    assert!(off <= tolerance, "{what}: {found} for {asked}");
}

/// Points of the torso at a height: those from the middle on to the first gap in x, which the arms
/// are beyond. No edge of a torso is as wide.
fn torso(avatar: &Avatar, y: f64) -> Vec<Vector3<f64>> {
    let mut points = cut(&avatar.surface, (Vector3::y() * y, Vector3::y()), 2.0);
    points.sort_by(|p, q| p.x.abs().total_cmp(&q.x.abs()));
    let gap = points
        .windows(2)
        .position(|p| p[1].x.abs() - p[0].x.abs() > 0.017);
    points.truncate(gap.map_or(points.len(), |last| last + 1));
    points
}

fn check_measures(form: &DressForm, avatar: &Avatar) {
    let at = |name: &str| avatar.landmarks[name];
    let axis = avatar.limb(Limb::LegLeft).expect("a leg");
    let value = |field: &str| form.value(field);
    let heights = [("bust_m", 0.726), ("hip_m", 0.508), ("neck_m", 0.868)];
    let heights = heights.map(|(field, share)| (field, share * form.height_m));
    let waist = ("waist_m", at("waist_front").y);
    for (field, y) in heights.into_iter().chain([waist]) {
        let girth = hull_length(&torso(avatar, y), Vector3::y());
        close(girth, value(field), GIRTH, field);
        close(avatar.girth_at(y).expect("a torso"), girth, 1e-4, field);
    }
    close(
        at("waist_front").y,
        value("waist_height_m"),
        LENGTH,
        "waist height",
    );
    close(at("crotch").y, value("inside_leg_m"), LENGTH, "inside leg");
    close(
        2.0 * at("shoulder_tip_l").x,
        value("shoulder_m"),
        LENGTH,
        "shoulder",
    );
    let arm =
        (at("elbow_l") - at("shoulder_tip_l")).norm() + (at("wrist_l") - at("elbow_l")).norm();
    close(arm, value("arm_length_m"), LENGTH, "arm length");
    let girth = |at: Vector3<f64>, normal: Vector3<f64>| {
        tape(avatar, at, normal, 0.75 * value("thigh_m") / TAU * 2.0)
    };
    let (thigh, shank) = (
        axis.points[1] - axis.points[0],
        axis.points[2] - axis.points[1],
    );
    let [thigh, shank] = [thigh, shank].map(|d| d.normalize());
    let down = at("crotch").y - 0.030 * form.height_m / 1.68;
    let on_thigh = at("knee_l") + thigh * ((down - at("knee_l").y) / thigh.y);
    let thigh_points: Vec<_> = cut(&avatar.surface, (on_thigh, thigh), 0.3)
        .into_iter()
        .filter(|p| p.x > 0.0 && p.x < 2.2 * on_thigh.x)
        .collect();
    close(
        hull_length(&thigh_points, thigh),
        value("thigh_m"),
        GIRTH,
        "thigh",
    );
    close(girth(at("knee_l"), shank), value("knee_m"), GIRTH, "knee");
    close(
        girth(at("ankle_l"), shank),
        value("ankle_m"),
        GIRTH,
        "ankle",
    );
    let calf = (0..40).map(|i| {
        let share = f64::from(i) / 40.0;
        girth(at("knee_l").lerp(&at("ankle_l"), 0.12 + 0.5 * share), shank)
    });
    close(calf.fold(0.0, f64::max), value("calf_m"), GIRTH, "calf");
    let along = (at("wrist_l") - at("elbow_l")).normalize();
    let middle = at("shoulder_joint_l").lerp(&at("elbow_l"), 0.5);
    let arm = |at: Vector3<f64>| tape(avatar, at, along, 0.8 * value("upper_arm_m") / TAU * 2.0);
    close(arm(middle), value("upper_arm_m"), GIRTH, "upper arm");
    close(arm(at("elbow_l")), value("elbow_m"), GIRTH, "elbow");
    close(arm(at("wrist_l")), value("wrist_m"), GIRTH, "wrist");
}

fn check_surface(avatar: &Avatar) {
    let surface = &avatar.surface;
    assert_eq!(surface.vertices.len(), surface.triangles.len() / 2 + 2);
    assert!((15_000..=50_000).contains(&surface.triangles.len()));
}

fn check_gaps(avatar: &Avatar, form: &DressForm) {
    let at = |name: &str| avatar.landmarks[name];
    let under = at("armpit_l").y - 0.060;
    let points = cut(&avatar.surface, (Vector3::y() * under, Vector3::y()), 2.0);
    let mut widths: Vec<f64> = points.iter().map(|p| p.x).filter(|x| *x > 0.0).collect();
    widths.sort_by(f64::total_cmp);
    let side = avatar.section_bounds(under).expect("a torso")[0][1];
    let arm = widths.iter().find(|x| **x > side + 1e-9);
    assert!(
        arm.is_none_or(|arm| arm - side >= 0.020),
        "{arm:?} {side} {form:?}"
    );
    let under = at("crotch").y - 0.060;
    let points = cut(&avatar.surface, (Vector3::y() * under, Vector3::y()), 2.0);
    let inner = points
        .iter()
        .map(|p| p.x.abs())
        .fold(f64::INFINITY, f64::min);
    assert!(inner >= 0.010, "{inner} {form:?}");
}

#[test]
fn random_bodies_have_their_measures_and_no_flaw() {
    let mut random = Random(14);
    for number in 0..5 {
        let mut form = random.form();
        let avatar = form
            .build()
            .unwrap_or_else(|faults| panic!("{faults:?} of {form:?}"));
        check_measures(&form, &avatar);
        check_surface(&avatar);
        check_gaps(&avatar, &form);
        form.pose = [Pose::T, Pose::I][number % 2];
        let posed = form.build().expect("as before");
        check_surface(&posed);
        check_gaps(&posed, &form);
    }
}

#[test]
fn a_body_stands_on_the_floor_with_its_ankles_apart() {
    let form = with_limbs();
    let avatar = form.build().expect("size M");
    let heights = avatar.surface.vertices.iter().map(|v| v.y);
    assert!(heights.fold(f64::INFINITY, f64::min).abs() < 1e-9);
    let ankle = avatar.landmarks["ankle_l"].y;
    let level = cut(&avatar.surface, (Vector3::y() * ankle, Vector3::y()), 1.0);
    let inner = level
        .iter()
        .map(|p| p.x.abs())
        .fold(f64::INFINITY, f64::min);
    close(2.0 * inner, 0.25, LENGTH, "between the ankles");
}

#[test]
fn both_sides_are_mirror_images() {
    let form = with_limbs();
    let avatar = form.build().expect("size M");
    let key = |v: &Vector3<f64>| [v.y, v.z, v.x.abs()].map(f64::to_bits);
    let side = |sign: f64| {
        let mut points: Vec<_> = avatar
            .surface
            .vertices
            .iter()
            .filter(|v| v.x * sign > 0.0)
            .map(key)
            .collect();
        points.sort_unstable();
        points
    };
    assert!(!side(1.0).is_empty());
    assert_eq!(side(1.0), side(-1.0));
    let [left, right] = [Limb::ArmLeft, Limb::ArmRight].map(|arm| avatar.limb(arm).expect("arm"));
    assert_eq!(&left.mirrored(), right);
}

#[test]
fn arms_are_at_the_angle_of_the_pose() {
    for (pose, angle) in [(Pose::A, 40.0_f64), (Pose::T, 90.0), (Pose::I, 12.0)] {
        let form = DressForm {
            limbs: LIMBS,
            pose,
            ..DressForm::default()
        };
        let avatar = form.build().expect("size M");
        let at = |name: &str| avatar.landmarks[name];
        let arm = at("wrist_l") - at("shoulder_joint_l");
        close(arm.angle(&-Vector3::y()).to_degrees(), angle, 1e-9, "angle");
        for name in [
            "shoulder_joint_l",
            "elbow_l",
            "wrist_l",
            "hip_joint_l",
            "knee_l",
            "ankle_l",
        ] {
            assert!(
                avatar.exact_distance(&at(name)) < -0.01,
                "{name} is outside"
            );
        }
    }
}

#[test]
fn no_limbs_are_the_torso_alone() {
    let alone = DressForm::default().build().expect("size M");
    let none = DressForm {
        limbs: Some(Limbs::default()),
        ..DressForm::default()
    };
    assert_eq!(alone.surface, none.build().expect("size M").surface);
    assert!(alone.limb(Limb::ArmLeft).is_none());
}

#[test]
fn men_have_no_bust() {
    let depth = |sex: Sex| {
        let form = DressForm {
            sex,
            ..DressForm::default()
        };
        let avatar = form.build().expect("size M");
        let at = |name: &str| avatar.landmarks[name];
        at("bust_point_l").z - at("bust_front").z
    };
    assert!(depth(Sex::Women) > 0.004, "{}", depth(Sex::Women));
    assert!(depth(Sex::Men) < 0.0, "{}", depth(Sex::Men));
}

#[test]
fn the_tape_round_the_torso_is_not_round_the_arms() {
    let form = with_limbs();
    let avatar = form.build().expect("size M");
    let hip = avatar.landmarks["hip_front"].y;
    assert!(avatar.landmarks["wrist_l"].y < 1.0);
    close(
        avatar.girth_at(hip).expect("a torso"),
        form.hip_m,
        1e-3,
        "hip",
    );
    let elbow = avatar.limb(Limb::ArmRight).expect("an arm");
    let along = (elbow.points[1] - elbow.points[0]).norm();
    let girth = avatar.limb_girth(Limb::ArmRight, along).expect("an arm");
    close(girth, form.value("elbow_m"), 1e-3, "elbow");
    let [[left, right], _] = avatar.section_bounds(0.5).expect("legs");
    assert!(left < -0.1 && right > 0.1);
}

#[test]
fn measures_of_missing_limbs_and_impossible_ones_are_refused() {
    let refusal = |form: DressForm| {
        let Err(Faults(faults)) = form.build() else {
            panic!("not refused: {form:?}");
        };
        let fix = faults[0].fix.clone().expect("a way out");
        (faults[0].pointer.clone(), fix)
    };
    let mut form = DressForm {
        thigh_m: Some(0.55),
        limbs: Some(Limbs::default()),
        ..DressForm::default()
    };
    assert_eq!(refusal(form).0, "/thigh_m");
    form.limbs = LIMBS;
    assert!(form.build().is_ok());
    form.thigh_m = Some(0.75);
    let (pointer, fix) = refusal(form);
    assert_eq!(pointer, "/thigh_m");
    assert!(fix.contains("to 0.627 m"), "{fix}");
    form.thigh_m = None;
    form.arm_length_m = Some(0.75);
    assert_eq!(refusal(form).0, "/arm_length_m");
}
