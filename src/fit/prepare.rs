//! Checks a garment whole and finds everything it refers to.

use super::Library;
use super::availability::{self, escape};
use super::garment::{AvatarAsked, Garment, PatternAsked, SCHEMA, SeamsAsked, Wind};
use super::{seams, sewn, suggested};
use crate::config::Limits;
use crate::fault::{Fault, Faults, Warning};
use crate::pattern::{self, Pattern};
use crate::scene::{self, Fabric, ToPlace};
use crate::seam::suggest::SuggestedSeam;
use crate::seam::{self, SeamSet};
use crate::solver::SolverOptions;
use std::collections::BTreeSet;
use std::sync::Arc;

/// A garment that was checked whole: everything it refers to was found, its seams can be sewn. Built only by [`prepare`].
#[derive(Clone, Debug)]
pub struct Prepared {
    pub(super) garment: Garment,
    pub(super) pattern: Arc<Pattern>,
    pub(super) seams: SeamSet,
    suggested: Vec<SuggestedSeam>,
    warnings: Vec<Warning>,
}

impl Prepared {
    /// The garment, complete in itself: pattern, avatar and fabrics that it referred to are inside.
    pub fn garment(&self) -> &Garment {
        &self.garment
    }

    /// The seams with their reasons, where the garment left them to the service; else none.
    pub fn suggested(&self) -> &[SuggestedSeam] {
        &self.suggested
    }

    /// What a user should know about its seams.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}

/// Checks a garment and finds everything it refers to.
///
/// # Errors
/// All its faults at once, with JSON Pointers into the garment.
pub fn prepare(
    mut garment: Garment,
    library: &dyn Library,
    limits: &Limits,
) -> Result<Prepared, Faults> {
    let mut faults = availability::check(&garment);
    if garment.schema != SCHEMA {
        faults.push(
            Fault::new(
                "garment/schema",
                "/schema",
                format!("{} is not a format this service reads", garment.schema),
            )
            .fix(format!("give \"{SCHEMA}\"")),
        );
    }
    faults.extend(simulate_faults(&garment.simulate, limits));
    faults.extend(friction_fault(garment.friction));
    faults.extend(wind_faults(garment.wind, limits));
    inline_fabrics(&mut garment, library, &mut faults);
    inline_avatar(&mut garment, library, &mut faults);
    let pattern = match find_pattern(garment.pattern.take(), library, limits) {
        Ok(pattern) => pattern,
        Err(found) => {
            faults.extend(found.0);
            return Err(Faults(faults));
        }
    };
    let mut pattern = Arc::unwrap_or_clone(pattern);
    let suggested = match suggested::fill(&mut garment, &mut pattern, limits) {
        Ok(suggested) => suggested,
        Err(fault) => {
            faults.push(fault);
            return Err(Faults(faults));
        }
    };
    let whole = sewn::with_copies(&garment, &pattern);
    faults.extend(panel_faults(&garment, &whole));
    // The saved file keeps the outlines as they were given: they are cut anew each time.
    let pattern = sewn::without_allowances(&garment, whole.clone()).unwrap_or_else(|found| {
        faults.extend(found.0);
        whole.clone()
    });
    let pattern = Arc::new(pattern);
    sewn::spell_out_copies(&mut garment, &whole);
    let seams = check_seams(&garment, &pattern, limits)
        .map_err(|found| faults.extend(found.0))
        .ok();
    match seams {
        Some((seams, found)) if faults.is_empty() => {
            let mut warnings = suggested::warnings(&pattern);
            warnings.extend(found);
            faults.extend(placement_faults(&garment, &pattern, &seams));
            garment.pattern = Some(PatternAsked::Whole(Box::new(whole)));
            Faults(faults).or(Prepared {
                garment,
                pattern,
                seams,
                suggested,
                warnings,
            })
        }
        _ => Err(Faults(faults)),
    }
}

fn find_pattern(
    asked: Option<PatternAsked>,
    library: &dyn Library,
    limits: &Limits,
) -> Result<Arc<Pattern>, Faults> {
    match asked {
        None => Err(Fault::new(
            "garment/pattern_missing",
            "/pattern",
            "no pattern was given",
        )
        .fix("give the id of a stored pattern, a whole pattern, or the DXF beside the garment")
        .into()),
        Some(PatternAsked::Id(id)) => library.pattern(id).ok_or_else(|| {
            Fault::new(
                "garment/pattern_unknown",
                "/pattern",
                format!("no pattern has the id {id}"),
            )
            .fix("upload it first: POST /v1/patterns")
            .into()
        }),
        Some(PatternAsked::Whole(pattern)) => pattern::checked(*pattern, limits)
            .map(Arc::new)
            .map_err(|faults| faults.under("/pattern")),
    }
}

fn check_seams(
    garment: &Garment,
    pattern: &Pattern,
    limits: &Limits,
) -> Result<(SeamSet, Vec<Warning>), Faults> {
    let SeamsAsked::Pairs(pairs) = &garment.seams else {
        return Err(Faults(Vec::new()));
    };
    let edge_length = garment
        .simulate
        .edge_length_m
        .clamp(limits.edge_length_m[0], limits.edge_length_m[1]);
    let (check, seams) = seams::check_seams(garment, pattern, pairs, (edge_length, limits));
    let found = check.seams.into_iter().flat_map(|seam| seam.warnings);
    Ok((seams?, check.warnings.into_iter().chain(found).collect()))
}

/// Puts the fabrics that are used into the garment, so that it is complete in itself; those that are not used stay.
fn inline_fabrics(garment: &mut Garment, library: &dyn Library, faults: &mut Vec<Fault>) {
    for (id, fabric) in &garment.fabrics {
        faults.extend(fabric.check(&format!("/fabrics/{}", escape(id))));
    }
    let mut used = vec![("/default_fabric".to_owned(), garment.default_fabric.clone())];
    let special = |(id, panel): (&String, &super::PanelAsked)| {
        Some((
            format!("/panels/{}/fabric", escape(id)),
            panel.fabric.clone()?,
        ))
    };
    used.extend(garment.panels.iter().filter_map(special));
    for (pointer, id) in used {
        if garment.fabrics.contains_key(&id) {
            continue;
        }
        match library.fabric(&id) {
            Some(fabric) => {
                garment.fabrics.insert(id, fabric);
            }
            None => {
                let detail = format!("no fabric has the id {id}");
                faults.push(
                    Fault::new("garment/fabric_unknown", pointer, detail)
                        .fix("see GET /v1/fabrics, or add it under fabrics"),
                );
            }
        }
    }
}

fn inline_avatar(garment: &mut Garment, library: &dyn Library, faults: &mut Vec<Fault>) {
    match &mut garment.avatar {
        Some(AvatarAsked::Id(id)) => match library.form(*id) {
            Some(form) => garment.avatar = Some(AvatarAsked::form(form)),
            None => faults.push(
                Fault::new(
                    "garment/avatar_unknown",
                    "/avatar",
                    format!("no avatar has the id {id}"),
                )
                .fix("make it first: POST /v1/avatars"),
            ),
        },
        Some(AvatarAsked::Form(asked)) => {
            faults.extend(Faults(asked.form.check()).under("/avatar/form").0);
        }
        None => {}
    }
}

fn panel_faults(garment: &Garment, pattern: &Pattern) -> Vec<Fault> {
    let known: BTreeSet<&str> = pattern
        .panels
        .iter()
        .map(|panel| panel.id.as_str())
        .collect();
    let names = known.iter().copied().collect::<Vec<_>>().join(", ");
    let unknown = |pointer: String, id: &str| {
        Fault::new(
            "garment/panel_unknown",
            pointer,
            format!("the pattern has no panel {id}"),
        )
        .fix(format!("its panels are {names}"))
    };
    let mut faults = Vec::new();
    for (id, asked) in &garment.panels {
        let pointer = format!("/panels/{}", escape(id));
        if !known.contains(id.as_str()) {
            faults.push(unknown(pointer.clone(), id));
        }
        let numbers = asked
            .placement
            .iter()
            .flat_map(|p| p.offset_m.iter().chain(&p.rotate_deg).chain(&p.up_deg))
            .chain(asked.grain_deg.iter());
        if numbers.clone().any(|n| !n.is_finite() || n.abs() > 1e4) {
            faults.push(
                Fault::new(
                    "garment/number",
                    pointer,
                    "an offset, a rotation or a grain angle is not a plausible number",
                )
                .fix("metres and degrees"),
            );
        }
    }
    for (i, pin) in garment.pins.iter().enumerate() {
        match pattern.panel_index(&pin.panel) {
            None => faults.push(unknown(format!("/pins/{i}/panel"), &pin.panel)),
            Some(index) if pin.corner >= pattern.panels[index].corners.len() => {
                let count = pattern.panels[index].corners.len();
                let detail = format!("panel {} has no corner {}", pin.panel, pin.corner);
                faults.push(
                    Fault::new(
                        "garment/corner_unknown",
                        format!("/pins/{i}/corner"),
                        detail,
                    )
                    .fix(format!("its corners are 0 to {}", count - 1)),
                );
            }
            Some(_) => {}
        }
    }
    faults
}

/// Panels of which nothing says where they go. Needs no body: the key point alone is looked for.
fn placement_faults(garment: &Garment, pattern: &Pattern, seams: &SeamSet) -> Vec<Fault> {
    let place = |(panel, face): (&pattern::Panel, &seam::Face)| {
        let asked = placement(garment, pattern, &panel.id);
        scene::place(
            ToPlace {
                panel,
                face: *face,
                asked,
            },
            None,
        )
        .err()
    };
    pattern
        .panels
        .iter()
        .zip(&seams.faces)
        .filter_map(place)
        .flat_map(|faults| faults.0)
        .collect()
}

/// What was asked for the start of a panel, or what its file says.
pub(super) fn placement<'a>(
    garment: &'a Garment,
    pattern: &'a Pattern,
    id: &str,
) -> Option<&'a pattern::Placement> {
    garment
        .panels
        .get(id)
        .and_then(|panel| panel.placement.as_ref())
        .or_else(|| pattern.placements.get(id))
}

/// The fabric of a panel. Garments that were prepared hold every fabric that they use.
pub(super) fn fabric<'a>(garment: &'a Garment, panel: &str) -> (&'a str, &'a Fabric) {
    let id = garment
        .panels
        .get(panel)
        .and_then(|p| p.fabric.as_ref())
        .unwrap_or(&garment.default_fabric);
    (id, &garment.fabrics[id])
}

fn friction_fault(friction: Option<f64>) -> Option<Fault> {
    let bad = friction.is_some_and(|f| !(0.0..=2.0).contains(&f));
    bad.then(|| {
        Fault::new(
            "garment/number",
            "/friction",
            "a coefficient of friction lies between 0 and 2",
        )
        .fix("cloth on skin: about 0.3")
    })
}

fn wind_faults(wind: Option<Wind>, limits: &Limits) -> Vec<Fault> {
    let Some(wind) = wind else {
        return Vec::new();
    };
    let [x, y, z] = wind.velocity_m_s;
    let speed = x.hypot(y).hypot(z);
    let mut faults = Vec::new();
    let mut bound = |wrong: bool, field: &str, detail: String, fix: String| {
        if wrong {
            let pointer = format!("/wind/{field}");
            faults.push(Fault::new("garment/number", pointer, detail).fix(fix));
        }
    };
    // so written that a NaN is a fault
    bound(
        !(0.0..=limits.wind_m_s).contains(&speed),
        "velocity_m_s",
        format!("a wind of {speed} m/s is not one to wear a garment in"),
        format!("metres per second, {} at most", limits.wind_m_s),
    );
    bound(
        !(0.0..=1.0).contains(&wind.gust),
        "gust",
        format!("gust is {}", wind.gust),
        "give a share of the mean speed, from 0 to 1".to_owned(),
    );
    faults
}

fn simulate_faults(asked: &SolverOptions, limits: &Limits) -> Vec<Fault> {
    let mut faults = Vec::new();
    let mut within = |field: &str, value: Option<f64>, [low, high]: [f64; 2]| {
        if let Some(value) = value.filter(|v| !(low..=high).contains(v)) {
            let detail = format!("{field} is {value}");
            faults.push(
                Fault::new("garment/number", format!("/simulate/{field}"), detail)
                    .fix(format!("give a number from {low} to {high}")),
            );
        }
    };
    within(
        "edge_length_m",
        Some(asked.edge_length_m),
        limits.edge_length_m,
    );
    within("tolerance", Some(asked.tolerance), [1e-12, 1.0]);
    within("seam_eps_m", Some(asked.seam_eps_m), [1e-6, 0.05]);
    within("seam_stiffness_n_m", asked.seam_stiffness_n_m, [1.0, 1e8]);
    within("time_limit_s", asked.time_limit_s, [0.0, limits.fit_cpu_s]);
    within("step_s", asked.step_s, [1e-9, 1.0]);
    if asked.step_s.is_some() && !asked.method.is_time_stepping() {
        faults.push(
            Fault::new(
                "garment/field",
                "/simulate/step_s",
                "a drape by this method takes no steps of time",
            )
            .fix("leave it out, or give a method that steps"),
        );
    }
    faults
}
