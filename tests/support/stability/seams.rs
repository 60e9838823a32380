//! Seams softer and stiffer than any thread, closed for good or by the paper's stiff spring, and one with 300 % of ease.

use super::cloth::{poplin, sewn};
use super::scenes::panels::{pattern, rectangle, run, seam};
use super::sheet::Sheet;
use super::{Case, Made};
use nalgebra::Vector3;
use seamster::config::Limits;
use seamster::mesh::triangulate;
use seamster::progress::CancelToken;
use seamster::scene::{Cut, Scene};
use seamster::solver::{Method, SeamClose};
use std::collections::BTreeMap;

pub(super) fn cases() -> Vec<Case> {
    let mut cases = vec![];
    for close in [SeamClose::Weld, SeamClose::Spring] {
        let word = if close == SeamClose::Weld {
            "weld"
        } else {
            "spring"
        };
        for stiffness in [1e2, 1e3, 1e4, 1e5, 1e6, 1e8, 1e10] {
            cases.push(
                Case::new(format!("seam: {stiffness:.0e} N/m, {word}"), move || {
                    Made::drape(sewn(poplin(), 500), Method::Newton).asking(|ask| {
                        ask.seam_close = close;
                        ask.seam_stiffness_n_m = Some(stiffness);
                    })
                })
                .small_if(matches!(stiffness, 1e2 | 1e10)),
            );
        }
        cases.push(Case::new(
            format!("seam: the stiffness of its own, {word}"),
            move || {
                Made::drape(sewn(poplin(), 500), Method::Newton)
                    .asking(|ask| ask.seam_close = close)
            },
        ));
        cases.push(Case::new(
            format!("seam: 300 % of ease, {word}"),
            move || Made::drape(eased(), Method::Newton).asking(|ask| ask.seam_close = close),
        ));
    }
    cases
}

/// A frill: a strip of 0.8 m gathered onto one of 0.2 m, which is held by its upper corners.
fn eased() -> Scene {
    let [band, frill] = [[0.2, 0.1], [0.8, 0.1]];
    let panels = vec![
        rectangle("band", band[0], band[1]),
        rectangle("frill", frill[0], frill[1]),
    ];
    let pattern = pattern(panels);
    let mut pair = seam("gathers", run("band", 3, 0), run("frill", 1, 2));
    pair.gather = true;
    let limits = Limits::default();
    let edge = 0.02;
    let (_, seams) = seamster::seam::check(&pattern, &[pair], &BTreeMap::new(), edge, &limits);
    let seams = seams.expect("a gathered seam may be eased");
    let mesh = triangulate(&pattern, &seams, edge, &limits, &CancelToken::new())
        .expect("rectangles can be meshed");
    let sheet = Sheet {
        size: band,
        cells: [1, 1],
        grid: super::sheet::Grid::Rising,
        fabric: poplin(),
        warp_angle: 0.0,
    };
    let second = mesh.panels[1].vertices.clone();
    let pins = [1, 2].map(|corner| mesh.panels[0].corners[corner]);
    let mut scene = Scene {
        pins: pins.to_vec(),
        ..sheet.scene_of(mesh, |[u, v]| Vector3::new(u, v, 0.0))
    };
    let cut = Cut {
        fabric: 0,
        warp_angle: 0.0,
        face_down: false,
    };
    scene.cut = vec![cut; 2];
    // the frill hangs below, its middle under the band's
    for p in &mut scene.start[second] {
        *p += Vector3::new((band[0] - frill[0]) / 2.0, -frill[1] - 0.02, 0.01);
    }
    scene
}
