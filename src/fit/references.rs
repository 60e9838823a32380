//! The pattern, avatar and fabrics that a garment refers to by id, found and put into it.

use super::garment::{AvatarRef, Garment, PanelSpec, PatternRef};
use super::library::AssetLibrary;
use super::unsupported::escape;
use crate::config::Limits;
use crate::fault::{Fault, Faults, GarmentCode, RequestCode};
use crate::pattern::{self, Pattern};
use crate::scene::{BodySource, Fabric};
use std::sync::Arc;

/// A fabric with the id that the garment gives it.
#[derive(Clone, Debug)]
pub(super) struct NamedFabric {
    pub(super) id: String,
    pub(super) fabric: Fabric,
}

/// The fabrics that panels are cut from.
pub(super) struct PanelFabrics {
    /// Each fabric once, in the order of the first panel that is cut from it.
    pub(super) fabrics: Vec<NamedFabric>,
    /// The index of each panel's fabric, in the pattern's order.
    pub(super) of_panel: Vec<usize>,
}

/// Finds the pattern, or checks the one that is given whole.
///
/// # Errors
/// If there is none, or all that is wrong with it.
pub(super) fn find_pattern(
    reference: Option<PatternRef>,
    library: &dyn AssetLibrary,
    limits: &Limits,
) -> Result<Pattern, Faults> {
    match reference {
        None => Err(Fault::new(
            GarmentCode::PatternMissing,
            "/pattern",
            "no pattern was given",
        )
        .fix("give the id of a stored pattern, a whole pattern, or the DXF beside the garment")
        .into()),
        Some(PatternRef::Id(id)) => {
            let pattern = library.pattern(id).map(Arc::unwrap_or_clone);
            pattern.ok_or_else(|| {
                let detail = format!("no pattern has the id {id}");
                Fault::new(GarmentCode::PatternUnknown, "/pattern", detail)
                    .fix("upload it first: POST /v1/patterns")
                    .into()
            })
        }
        Some(PatternRef::Whole(pattern)) => {
            pattern::checked(*pattern, limits).map_err(|faults| faults.under("/pattern"))
        }
    }
}

/// Finds what the body is made from and puts it into the garment; none for a garment without a
/// body.
pub(super) fn inline_avatar(
    garment: &mut Garment,
    library: &dyn AssetLibrary,
    faults: &mut Vec<Fault>,
) -> Option<BodySource> {
    let body = match garment.avatar.take()? {
        AvatarRef::Id(id) => {
            garment.avatar = Some(AvatarRef::Id(id));
            let body = library.body(id);
            if body.is_none() {
                let detail = format!("no avatar has the id {id}");
                let fault = Fault::new(GarmentCode::AvatarUnknown, "/avatar", detail);
                faults.push(fault.fix("make it first: POST /v1/avatars"));
            }
            body?
        }
        AvatarRef::Form(spec) => given(BodySource::Form(spec.form), faults),
        AvatarRef::Own(spec) => given(BodySource::Own(Arc::new(*spec.body)), faults),
    };
    garment.avatar = Some(AvatarRef::whole(body.clone()));
    Some(body)
}

/// Returns a body that the garment has whole, checked.
fn given(body: BodySource, faults: &mut Vec<Fault>) -> BodySource {
    faults.extend(Faults(body.check()).under("/avatar").0);
    body
}

/// Puts the fabrics that are used into the garment, so that it is complete in itself; those that
/// are not used stay.
pub(super) fn inline_fabrics(
    garment: &mut Garment,
    library: &dyn AssetLibrary,
    limits: &Limits,
    faults: &mut Vec<Fault>,
) {
    for (id, fabric) in &garment.fabrics {
        faults.extend(fabric.check(&format!("/fabrics/{}", escape(id))));
    }
    for (pointer, id) in fabrics_in_use(garment) {
        if garment.fabrics.contains_key(&id) {
            continue;
        }
        match library.fabric(&id) {
            Some(_) if garment.fabrics.len() >= limits.garment_fabrics => {
                let most = limits.garment_fabrics;
                let detail = format!("the garment has more than {most} fabrics");
                let fault = Fault::new(RequestCode::WrongLength, pointer, detail);
                faults.push(fault.fix("leave out those that no panel is cut from"));
            }
            Some(fabric) => {
                garment.fabrics.insert(id, fabric);
            }
            None => {
                let detail = format!("no fabric has the id {id}");
                let fault = Fault::new(GarmentCode::FabricUnknown, pointer, detail);
                faults.push(fault.fix("see GET /v1/fabrics, or add it under fabrics"));
            }
        }
    }
}

/// Returns the id of every fabric that the garment names, with the place where it does.
fn fabrics_in_use(garment: &Garment) -> Vec<(String, String)> {
    let named = |(id, panel): (&String, &PanelSpec)| {
        let pointer = format!("/panels/{}/fabric", escape(id));
        Some((pointer, panel.fabric.clone()?))
    };
    let default = ("/default_fabric".to_owned(), garment.default_fabric.clone());
    let named = garment.panels.iter().filter_map(named);
    std::iter::once(default).chain(named).collect()
}

/// Finds the fabric of each panel in the garment, which [`inline_fabrics`] completed; none if it
/// has an id that is not known.
pub(super) fn panel_fabrics(garment: &Garment, specs: &[PanelSpec]) -> Option<PanelFabrics> {
    let mut fabrics: Vec<NamedFabric> = Vec::new();
    let mut of_panel = Vec::new();
    for spec in specs {
        let id = spec.fabric.as_ref().unwrap_or(&garment.default_fabric);
        let known = fabrics.iter().position(|named| named.id == *id);
        if known.is_none() {
            let (id, fabric) = garment.fabrics.get_key_value(id)?;
            fabrics.push(NamedFabric {
                id: id.clone(),
                fabric: fabric.clone(),
            });
        }
        of_panel.push(known.unwrap_or(fabrics.len() - 1));
    }
    Some(PanelFabrics { fabrics, of_panel })
}
