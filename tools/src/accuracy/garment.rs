//! The garments: two that ship, and others from the folder of real patterns, sewn by their own
//! seams or by suggested ones.

use seamster::config::Limits;
use seamster::fit::{self, ResolvedGarment, ShippedAssets};
use seamster::pattern::{self, ImportOptions, Pattern};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// A garment.
pub(crate) struct Kind {
    pub(crate) name: &'static str,
    /// In the folder, or `None` for a sample of the same name.
    file: Option<&'static str>,
    /// True if it is run with a fine mesh and a time limit, too.
    pub(crate) fine: bool,
}

const fn kind(name: &'static str, file: Option<&'static str>, fine: bool) -> Kind {
    Kind { name, file, fine }
}

pub(crate) const GARMENTS: [Kind; 13] = [
    kind("skirt", None, true),
    kind("top", None, true),
    kind("T-shirt", Some("gc_tshirt_specification.json"), true),
    kind(
        "pencil skirt",
        Some("gc_pencil_skirt_specification.json"),
        true,
    ),
    kind(
        "circle skirt",
        Some("gc_circle_skirt_specification.json"),
        false,
    ),
    kind("shirt", Some("gcup_shirt_mean_specification.json"), false),
    kind(
        "jumpsuit",
        Some("gcup_js_mean_all_specification.json"),
        false,
    ),
    kind("T 2", Some("fs_teagan__layers_line_spline.dxf"), true),
    kind("tank", Some("fs_aaron__layers_line_spline.dxf"), false),
    kind(
        "skirt on a band",
        Some("fs_sandy__layers_line_spline.dxf"),
        false,
    ),
    kind("raglan", Some("gerber_GLX4802S19_AAMA.DXF"), false),
    kind("T 3", Some("gerber_GMH1406F15-4.DXF"), false),
    kind("tank 2", Some("gerber_WM_SLIM_TANK.DXF"), false),
];

impl Kind {
    /// Ready for a fit with mesh edges of `edge_length` \[m\].
    pub(crate) fn prepared(&self, folder: &Path, edge_length: f64) -> ResolvedGarment {
        let limits = Limits::default();
        let samples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../static/samples");
        let file = match self.file {
            Some(file) => folder.join("dxf").join(file),
            None => samples.join(self.name).with_extension("dxf"),
        };
        let bytes = fs::read(file).expect("the folder has it");
        let pattern =
            pattern::import(&bytes, &ImportOptions::default(), &limits).expect("a sound file");
        let mut garment = match self.file {
            Some(_) => found(&pattern),
            None => {
                let file = samples.join(format!("{}.garment.json", self.name));
                let text = fs::read_to_string(file).expect("samples have garments");
                serde_json::from_str(&text).expect("a garment is JSON")
            }
        };
        garment["simulate"]["edge_length_m"] = json!(edge_length);
        garment["pattern"] = json!(pattern);
        let garment = serde_json::from_value(garment).expect("a garment");
        fit::resolve(garment, &ShippedAssets, &limits).expect("its seams can be sewn")
    }
}

/// A garment by the seams that the file states, else by suggested ones, on the mean female of
/// `GarmentCode`.
fn found(pattern: &Pattern) -> Value {
    let seams = if pattern.seams.is_empty() {
        json!("suggest")
    } else {
        json!(pattern.seams)
    };
    let form = json!({"height_m": 1.662, "bust_m": 0.974, "waist_m": 0.803, "hip_m": 1.041});
    json!({"seams": seams, "avatar": {"form": form}, "simulate": {}})
}
