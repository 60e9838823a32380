//! What the garment file can say and this version cannot do yet: refused, never ignored.

use super::garment::{Garment, SelfContact};
use crate::fault::Fault;
use crate::solver::Analysis;

/// A fault for every wish that cannot be granted.
pub(crate) fn check(garment: &Garment) -> Vec<Fault> {
    let mut faults = Vec::new();
    let mut refuse = |refused: bool, pointer: String, what: &str, fix: &str| {
        if refused {
            faults.push(
                Fault::new(
                    "garment/not_available",
                    pointer,
                    format!("{what} is not available in this version"),
                )
                .fix(fix),
            );
        }
    };
    let asked = &garment.simulate;
    let at = |field: &str| format!("/{field}");
    refuse(
        garment.self_contact == SelfContact::On,
        at("self_contact"),
        "contact of cloth with cloth",
        "give \"auto\" or \"off\"",
    );
    refuse(
        garment.start_from.is_some(),
        at("start_from"),
        "starting from another fit",
        "leave it out or give null",
    );
    refuse(
        !garment.maps.is_empty(),
        at("maps"),
        "a map on the mesh",
        "leave it out",
    );
    refuse(
        asked.analysis == Analysis::Transient,
        at("simulate/want"),
        "motion",
        "give \"drape\"",
    );
    refuse(
        asked.duration_s.is_some(),
        at("simulate/duration_s"),
        "a duration, which belongs to motion,",
        "leave it out",
    );
    refuse(
        asked.frame_rate_hz.is_some(),
        at("simulate/frame_rate_hz"),
        "a frame rate, which belongs to motion,",
        "leave it out",
    );
    for (id, panel) in &garment.panels {
        let at = |field: &str| format!("/panels/{}/{field}", escape(id));
        refuse(
            panel.texture.is_some(),
            at("texture"),
            "a texture",
            "leave it out",
        );
        refuse(
            panel.layer != 0,
            at("layer"),
            "ordering panels by layer",
            "leave it out or give 0",
        );
        refuse(
            !panel.elastic.is_empty(),
            at("elastic"),
            "elastic",
            "leave it out",
        );
    }
    faults
}

/// `id` as one step of a JSON Pointer (RFC 6901).
pub(crate) fn escape(id: &str) -> String {
    id.replace('~', "~0").replace('/', "~1")
}
