//! Settings that the garment file can state and this version cannot follow: refused, never ignored.

use super::garment::{Garment, MapKind, PanelSpec, SelfContact};
use crate::fault::{Fault, GarmentCode, pointer_token};
use crate::solver::{Analysis, SolverOptions};

/// A setting: whether it is at fault, its field, what it asks for, and what to give instead.
type StatedSetting = (bool, &'static str, &'static str, &'static str);

/// Returns a fault for every setting that this version cannot follow.
pub(super) fn faults(garment: &Garment) -> Vec<Fault> {
    let settings = garment_settings(garment).into_iter();
    let settings = settings.chain(options_settings(&garment.simulate));
    let mut faults: Vec<Fault> = settings.filter_map(|s| fault("", s)).collect();
    for (id, panel) in &garment.panels {
        let under = format!("/panels/{}", escape(id));
        let settings = panel_settings(panel).into_iter();
        faults.extend(settings.filter_map(|s| fault(&under, s)));
    }
    faults
}

fn fault(under: &str, (is_wrong, field, what, fix): StatedSetting) -> Option<Fault> {
    is_wrong.then(|| {
        let detail = format!("{what} is not available in this version");
        Fault::new(
            GarmentCode::NotAvailable,
            format!("{under}/{field}"),
            detail,
        )
        .fix(fix)
    })
}

fn garment_settings(garment: &Garment) -> [StatedSetting; 4] {
    let is_of_body = |map: &MapKind| *map != MapKind::Strain;
    [
        (
            garment.over.is_some()
                && (garment.self_contact == SelfContact::Off
                    || garment.simulate.method.is_time_stepping()),
            "over",
            "wearing it over another garment without contact of cloth with cloth",
            "leave out self_contact, and give the method \"newton\"",
        ),
        (
            garment.self_contact == SelfContact::On && garment.simulate.method.is_time_stepping(),
            "self_contact",
            "contact of cloth with cloth by a method that steps in time",
            "give \"auto\" or \"off\", or the method \"newton\"",
        ),
        (
            garment.start_from.is_some() && garment.simulate.method.is_time_stepping(),
            "start_from",
            "starting from another fit with a method that steps in time",
            "leave it out, or give the method \"newton\"",
        ),
        (
            garment.over.is_some() && garment.maps.iter().any(is_of_body),
            "maps",
            "pressure or gap of a garment that is worn over another, whose cloth is not the body,",
            "ask for \"strain\" alone",
        ),
    ]
}

fn options_settings(options: &SolverOptions) -> [StatedSetting; 3] {
    [
        (
            options.analysis == Analysis::Transient,
            "simulate/want",
            "motion",
            "give \"drape\"",
        ),
        (
            options.duration_s.is_some(),
            "simulate/duration_s",
            "a duration, which belongs to motion,",
            "leave it out",
        ),
        (
            options.frame_rate_hz.is_some(),
            "simulate/frame_rate_hz",
            "a frame rate, which belongs to motion,",
            "leave it out",
        ),
    ]
}

fn panel_settings(panel: &PanelSpec) -> [StatedSetting; 2] {
    [
        (
            panel.texture.is_some(),
            "texture",
            "a texture",
            "leave it out",
        ),
        (
            !panel.elastic.is_empty(),
            "elastic",
            "elastic",
            "leave it out",
        ),
    ]
}

/// Returns `id` as one step of a JSON Pointer (RFC 6901).
pub(super) fn escape(id: &str) -> String {
    pointer_token(id)
}
