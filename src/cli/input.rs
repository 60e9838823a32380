//! Input files: a garment, and the pattern beside it.

use super::faults;
use clap::Args;
use seamster::config::Limits;
use seamster::fault::{Fault, Faults, FileCode, FitCode};
use seamster::fit::{self, AvatarRef, Garment, PatternRef};
use seamster::pattern::{
    self, DrawnDarts, DrawnNotches, GradeTable, ImportOptions, Outlines, Pattern, RotationOrder,
    TextEncoding, Unfold, Units,
};
use seamster::scene::{self, BodyImportOptions, BodySource, BodyUnits};
use serde::de::DeserializeOwned;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A garment, with its pattern or beside it, and how to read that.
#[derive(Args)]
pub(super) struct Input {
    /// The pattern (DXF or a GarmentCode specification), and the garment without its pattern; or a
    /// saved garment alone
    #[arg(required = true, num_args = 1..=2, value_names = ["PATTERN", "GARMENT.json"])]
    inputs: Vec<PathBuf>,
    #[command(flatten)]
    pattern: PatternOptions,
    /// Body to sew on instead of the garment's: an OBJ, a binary glTF 2.0 or a PLY
    #[arg(long, value_name = "BODY.obj")]
    avatar: Option<PathBuf>,
    /// Unit of the body's coordinates, by its height if not given: m, cm, mm, inch, dm or ft
    #[arg(long, requires = "avatar", value_parser = parse_word::<BodyUnits>)]
    avatar_units: Option<BodyUnits>,
}

/// Options for what a pattern file does not say itself.
#[derive(Args)]
pub(super) struct PatternOptions {
    /// Unit of the pattern's coordinates, overriding what it says: mm, cm, m or inch
    #[arg(long, value_parser = parse_word::<Units>)]
    units: Option<Units>,
    /// Encoding of the texts of a DXF, overriding what it says: a label of the Encoding Standard
    /// (windows-1251, gbk) or a code page (cp1251, cp866)
    #[arg(long, value_name = "LABEL", value_parser = parse_word::<TextEncoding>)]
    encoding: Option<TextEncoding>,
    /// Size to read of a graded pattern; its sample size if not given
    #[arg(long)]
    size: Option<String>,
    /// Grade rule table beside the DXF: the size may then be any of its sizes
    #[arg(long, value_name = "TABLE.rul")]
    grading: Option<PathBuf>,
    /// Reading of outlines that lie in others, where layers do not tell: auto (if not given),
    /// allowance, sizes, holes, lines or pieces
    #[arg(long, value_parser = parse_word::<Outlines>)]
    outlines: Option<Outlines>,
    /// Notches drawn into an outline, up to 12 mm deep: marks (if not given) or cloth
    #[arg(long, value_parser = parse_word::<DrawnNotches>)]
    notches: Option<DrawnNotches>,
    /// Darts drawn as lines inside an outline: cut, to be sewn (if not given), or lines
    #[arg(long, value_parser = parse_word::<DrawnDarts>)]
    darts: Option<DrawnDarts>,
    /// Folds about which half pieces are unfolded: all (if not given) or none
    #[arg(long, value_parser = parse_word::<Unfold>)]
    unfold: Option<Unfold>,
    /// Refuse a file with a piece that cannot be read, instead of leaving that piece out
    #[arg(long)]
    strict: bool,
    /// Order of the three angles of a GarmentCode panel in its rotation: xyz (Rx Ry Rz, as it
    /// writes) or zyx
    #[arg(long, value_parser = parse_word::<RotationOrder>)]
    rotation_order: Option<RotationOrder>,
}

impl PatternOptions {
    /// Reads a pattern file.
    ///
    /// # Errors
    /// Everything that keeps it from being read.
    pub(super) fn read(&self, file: &Path, limits: &Limits) -> Result<Pattern, Faults> {
        // The import knows what it is, and bounds each kind.
        let bytes = read_file(file, limits.dxf_bytes.max(limits.json_bytes))?;
        let grading = self.grading.as_ref().map(|table| {
            let bytes = read_file(table, limits.dxf_bytes)?;
            GradeTable::read(&bytes, limits)
        });
        let name = file.file_stem().and_then(|name| name.to_str());
        let options = ImportOptions {
            name: name.map(str::to_owned),
            units: self.units,
            encoding: self.encoding,
            size: self.size.clone(),
            outlines: self.outlines.unwrap_or_default(),
            notches: self.notches.unwrap_or_default(),
            darts: self.darts.unwrap_or_default(),
            unfold: self.unfold.unwrap_or_default(),
            strict: self.strict,
            grading: grading.transpose()?,
            rotation_order: self.rotation_order.unwrap_or_default(),
        };
        pattern::import(&bytes, &options, limits)
    }
}

/// Reads a value by the word that it has in JSON.
pub(super) fn parse_word<T: DeserializeOwned>(text: &str) -> Result<T, String> {
    serde_json::from_value(text.into()).map_err(|error| error.to_string())
}

/// A file with its faults.
pub(super) type FileFaults<'a> = (&'a Path, Faults);

impl Input {
    /// Returns the file of the garment.
    pub(super) fn file(&self) -> &Path {
        self.inputs.last().expect("clap asks for at least one")
    }

    fn pattern_file(&self) -> Option<&Path> {
        match self.inputs.as_slice() {
            [pattern, _] => Some(pattern),
            _ => None,
        }
    }

    /// Reads both files, and prints the warnings of the pattern.
    pub(super) fn garment(&self, limits: &Limits) -> Result<Garment, FileFaults<'_>> {
        let file = self.file();
        let mut garment = read_garment(file, limits).map_err(|faults| (file, faults))?;
        if let Some(pattern_file) = self.pattern_file() {
            if garment.pattern.is_some() {
                let detail = "the pattern is given as a file and in the garment too";
                let fault = Fault::new(FitCode::TwoPatterns, "/pattern", detail);
                return Err((file, fault.fix("leave it out of the garment").into()));
            }
            let pattern = self
                .pattern
                .read(pattern_file, limits)
                .map_err(|faults| (pattern_file, faults))?;
            faults::print_warnings(pattern_file, &pattern.warnings);
            garment.pattern = Some(PatternRef::Whole(Box::new(pattern)));
        }
        if let Some(body_file) = &self.avatar {
            let body = self.read_body(body_file, limits);
            let body = body.map_err(|faults| (&**body_file, faults))?;
            garment.avatar = Some(AvatarRef::whole(body));
        }
        Ok(garment)
    }

    fn read_body(&self, file: &Path, limits: &Limits) -> Result<BodySource, Faults> {
        let bytes = read_file(file, limits.body_bytes)?;
        let options = BodyImportOptions {
            units: self.avatar_units,
            ..BodyImportOptions::default()
        };
        let import = scene::import_body(&bytes, &options, limits)?;
        faults::print_warnings(file, &import.warnings);
        Ok(BodySource::Own(Arc::new(import.body)))
    }
}

fn read_garment(file: &Path, limits: &Limits) -> Result<Garment, Faults> {
    let bytes = read_file(file, limits.json_bytes)?;
    if pattern::is_pattern_file(&bytes) {
        let detail =
            "this is a pattern, and the garment file, which says what is sewn to what, is missing";
        let fix = "give the garment file after the pattern; {\"seams\": \"suggest\"} is the least that it holds";
        return Err(Fault::new(FitCode::NoGarment, "", detail).fix(fix).into());
    }
    fit::read_garment(&bytes, limits).map_err(Faults::from)
}

/// Reads a file of at most `limit` bytes.
fn read_file(file: &Path, limit: usize) -> Result<Vec<u8>, Faults> {
    let fault = |detail: String| Faults::from(Fault::new(FileCode::Unreadable, "", detail));
    let mut bytes = Vec::new();
    File::open(file)
        .and_then(|file| file.take(limit as u64 + 1).read_to_end(&mut bytes))
        .map_err(|error| fault(error.to_string()))?;
    if bytes.len() > limit {
        return Err(fault(format!("it has more than {limit} bytes")));
    }
    Ok(bytes)
}
