//! The garments: their files, the bodies that they were drafted for, and their seams.

use super::form::Form;
use seamster::config::Limits;
use seamster::fit::{Garment, PanelSpec, PatternRef};
use seamster::pattern::{self, ImportOptions, MIRROR, Pattern, SeamPair};
use seamster::scene::{DressForm, Sex};
use seamster::seam::suggest;
use seamster_fixtures::drafts;
use seamster_fixtures::truth::suggest_truth::{self, SuggestionTruth};
use seamster_fixtures::unseen::{self, UnseenGarment};
use serde::Deserialize;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// A garment to sew.
pub(super) struct SweepGarment {
    /// Name of its file, without its ending; of drafted ones, their design and their seed.
    pub(super) name: String,
    /// Body of its own size.
    form: DressForm,
    panels: PanelSource,
    seams: SeamSource,
}

/// Source of the panels of a garment.
enum PanelSource {
    /// A file of the folder.
    File(PathBuf),
    /// Drafted here, with its seams.
    Drafted(Box<SuggestionTruth>),
}

/// Source of the seams of a garment.
enum SeamSource {
    /// The pattern's file states them.
    Pattern,
    /// The program that drafted it wrote them beside it.
    Draft,
    /// They were written down by hand, all of them, in this file.
    Written(PathBuf),
    /// They are not known, and suggested.
    Suggested,
}

/// `own_size.json`.
#[derive(Deserialize)]
struct OwnSizes {
    garments: BTreeMap<String, OwnSize>,
}

#[derive(Deserialize)]
struct OwnSize {
    form: DressForm,
    #[serde(default)]
    sex: Sex,
}

/// Returns the garments of a folder of real patterns whose size is known, in the order of their
/// names.
///
/// # Errors
/// Files that cannot be read.
pub(super) fn list(folder: &Path) -> io::Result<Vec<SweepGarment>> {
    let sizes: OwnSizes = serde_json::from_slice(&fs::read(folder.join("own_size.json"))?)?;
    let garment = |(name, size): (String, OwnSize)| {
        let file = find_pattern(folder, &name)?;
        Ok(SweepGarment {
            seams: seam_source(folder, &name, &file)?,
            form: DressForm {
                sex: size.sex,
                ..size.form
            },
            panels: PanelSource::File(file),
            name,
        })
    };
    sizes.garments.into_iter().map(garment).collect()
}

/// Returns so many garments of each design that suggestions were not made with, on forms that their
/// panels are drafted for.
pub(super) fn drafted(each: u64) -> Vec<SweepGarment> {
    let mut all = unseen::developed(each);
    all.extend(unseen::held_out(each));
    let garment = |garment: UnseenGarment| SweepGarment {
        name: format!("{}-{}", garment.design.replace(' ', "-"), garment.seed),
        form: garment.form,
        panels: PanelSource::Drafted(Box::new(garment.truth)),
        seams: SeamSource::Draft,
    };
    all.into_iter().map(garment).collect()
}

fn find_pattern(folder: &Path, name: &str) -> io::Result<PathBuf> {
    let named = |ending| folder.join("dxf").join(format!("{name}.{ending}"));
    let mut files = ["dxf", "DXF", "json"].into_iter().map(named);
    files.find(|file| file.exists()).ok_or_else(|| {
        let missing = format!("{name}: the folder has no pattern of this name");
        io::Error::new(io::ErrorKind::NotFound, missing)
    })
}

fn seam_source(folder: &Path, name: &str, file: &Path) -> io::Result<SeamSource> {
    if file.extension().is_some_and(|ending| ending == "json") {
        return Ok(SeamSource::Pattern);
    }
    if folder.join(format!("dxf/{name}.seams.json")).exists() {
        return Ok(SeamSource::Draft);
    }
    let truths = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/truth");
    let truth = truths.join(format!("{name}.json"));
    if truth.exists() {
        let stated: Value = serde_json::from_slice(&fs::read(&truth)?)?;
        if stated["complete"] != json!(false) {
            return Ok(SeamSource::Written(truth));
        }
    }
    Ok(SeamSource::Suggested)
}

impl SweepGarment {
    /// Returns true if all its seams are known.
    pub(super) fn has_true_seams(&self) -> bool {
        !matches!(self.seams, SeamSource::Suggested)
    }

    /// Takes its seams as not known, if its file does not state them.
    pub(super) fn forget_seams(&mut self) {
        if !matches!(self.seams, SeamSource::Pattern) {
            self.seams = SeamSource::Suggested;
        }
    }

    /// Returns the garment as it is to be sewn on a form.
    ///
    /// # Errors
    /// A file of a body or a pattern that cannot be read.
    pub(super) fn garment(&self, folder: &Path, form: &Form) -> Result<Garment, Box<dyn Error>> {
        let avatar = form.avatar(self.form)?;
        let (pattern, seams) = match (&self.panels, &self.seams) {
            (PanelSource::File(file), SeamSource::Suggested) => (Self::import(file)?, None),
            (PanelSource::File(file), SeamSource::Pattern) => {
                let pattern = Self::import(file)?;
                let seams = pattern.seams.clone();
                (pattern, Some(seams))
            }
            (PanelSource::File(_), SeamSource::Draft) => {
                let draft = drafts::garment(&folder.join("dxf"), &self.name);
                (draft.pattern, Some(draft.pairs))
            }
            (PanelSource::File(_), SeamSource::Written(file)) => {
                let truth = suggest_truth::written(file, folder);
                (
                    truth.pattern,
                    Some(as_worn(truth.seams, truth.alternatives)),
                )
            }
            (PanelSource::Drafted(truth), SeamSource::Suggested) => (truth.pattern.clone(), None),
            (PanelSource::Drafted(truth), _) => {
                let strict = |seam: &SeamPair| SeamPair {
                    allow_twist: false,
                    ..seam.clone()
                };
                let seams = truth.seams.iter().map(strict).collect();
                (truth.pattern.clone(), Some(seams))
            }
        };
        let garment = match seams {
            None => with_seams(pattern, &json!("suggest")),
            Some(seams) => with_true_seams(pattern, &seams),
        };
        Ok(Garment {
            avatar: Some(avatar),
            ..garment
        })
    }

    fn import(file: &Path) -> Result<Pattern, Box<dyn Error>> {
        let bytes = fs::read(file)?;
        let import = pattern::import(&bytes, &ImportOptions::default(), &Limits::default());
        Ok(import?)
    }
}

/// Adds to the seams those that close a band which is buttoned: a join that no other seam is
/// another way of.
fn as_worn(mut seams: Vec<SeamPair>, others: Vec<SeamPair>) -> Vec<SeamPair> {
    let is_new = |other: &SeamPair| seams.iter().all(|seam| seam.id != other.id);
    let others = others.into_iter().filter(is_new);
    let joins: Vec<_> = others.filter(|seam| seam.id.ends_with("-join")).collect();
    seams.extend(joins);
    seams
}

fn with_seams(pattern: Pattern, seams: &Value) -> Garment {
    Garment {
        pattern: Some(PatternRef::Whole(Box::new(pattern))),
        ..serde_json::from_value(json!({ "seams": seams }))
            .expect("a garment needs its seams alone")
    }
}

/// Returns a garment of the panels that its seams join, started where the service would start them.
fn with_true_seams(mut pattern: Pattern, seams: &[SeamPair]) -> Garment {
    let sides = seams.iter().flat_map(|pair| [&pair.a, &pair.b]);
    let runs = sides.flat_map(|side| side.runs());
    let sewn: BTreeSet<&str> = runs.map(|run| run.panel.as_str()).collect();
    let is_sewn = |id: &str| sewn.iter().any(|name| name.trim_end_matches(MIRROR) == id);
    pattern
        .panels
        .retain(|panel| is_sewn(&panel.id) || sewn.contains(&*panel.id));
    pattern
        .placements
        .retain(|id, _| is_sewn(id) || sewn.contains(&**id));
    let suggested = suggest::suggest(&pattern, &Limits::default()).panels;
    let placed = suggested.into_iter().filter(|(id, _)| {
        let source = id.trim_end_matches(MIRROR);
        !pattern.placements.contains_key(source) && sewn.contains(&**id)
    });
    let spec = |(id, panel): (String, suggest::SuggestedPanel)| {
        let spec = PanelSpec {
            placement: Some(panel.placement),
            ..PanelSpec::default()
        };
        (id, spec)
    };
    let panels = placed.map(spec).collect();
    Garment {
        panels,
        ..with_seams(pattern, &json!(seams))
    }
}
