//! Terms that a scene lacks have no arrays: a system takes the memory of its terms.

use crate::scene::Scene;
use crate::solver::left_out::by_hand::{self, no_clock};
use crate::solver::left_out::scenes::{Has, scene};
use crate::solver::model::build::build;
use crate::solver::model::build_options::BuildOptions;
use crate::solver::model::seams::Seams;
use crate::solver::{FrictionAnchors, SolverOptions};
use allocation_counter::{AllocationInfo, measure};

/// Cells along a sheet.
const CELLS: usize = 8;

/// Returns the bytes that `make` allocates in all, and those that remain while its result lives.
fn allocated<T>(make: impl FnOnce() -> T) -> AllocationInfo {
    let mut made = None;
    measure(|| made = Some(make()))
}

fn assembled(scene: &Scene) -> AllocationInfo {
    let anchors = FrictionAnchors::default();
    let build_options = BuildOptions {
        seams: Seams::Stiff { stiffness: 1e4 },
        hold: None,
        gravity: true,
        friction: Some(&anchors),
        explicit: false,
        least_thickness: scene.self_contact.then_some(1e-4),
        finest: false,
    };
    allocated(|| build(scene, &SolverOptions::default(), &build_options, &no_clock))
}

#[test]
fn a_system_allocates_what_its_terms_do() {
    for gravity in [false, true] {
        let has = Has {
            gravity,
            ..Has::default()
        };
        let scene = scene(has, CELLS);
        let by_hand = allocated(|| by_hand::system(&scene, gravity));
        let assembled = assembled(&scene);
        // The particle of each vertex, which a program by hand does not need.
        let dof_map = scene.start.len() * size_of::<usize>();
        let current = by_hand.bytes_current + dof_map as i64;
        assert_eq!(assembled.bytes_current, current, "{has:?}");
        // Means over particles take a count of vertices that is gone when they are taken.
        let counts = if gravity {
            scene.mass.len() * size_of::<f64>()
        } else {
            0
        };
        let in_all = by_hand.bytes_total + (counts + dof_map) as u64;
        assert_eq!(assembled.bytes_total, in_all, "{has:?}");
        let arrays = by_hand::bytes_of_arrays(&scene, gravity) as i64;
        assert!(by_hand.bytes_current >= arrays, "{arrays}: {by_hand:?}");
    }
}

/// So that the count above can fail: each thing more takes more.
#[test]
fn each_thing_that_a_scene_has_takes_memory() {
    let least = assembled(&scene(Has::default(), CELLS)).bytes_current;
    let body = Has {
        body: true,
        ..Has::default()
    };
    let contact = assembled(&scene(body, CELLS)).bytes_current;
    let more = [
        Has {
            gravity: true,
            ..Has::default()
        },
        Has {
            wind: true,
            ..Has::default()
        },
        Has {
            bending: true,
            ..Has::default()
        },
        Has {
            seams: true,
            ..Has::default()
        },
        Has {
            self_contact: true,
            ..Has::default()
        },
        body,
    ];
    for has in more {
        let bytes = assembled(&scene(has, CELLS)).bytes_current;
        assert!(bytes > least, "{has:?}: {bytes}, {least}");
    }
    let friction = Has {
        friction: true,
        ..body
    };
    assert!(assembled(&scene(friction, CELLS)).bytes_current > contact);
    let of_no_body = Has {
        body: false,
        ..friction
    };
    assert_eq!(assembled(&scene(of_no_body, CELLS)).bytes_current, least);
}
