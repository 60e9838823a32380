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
    /// Length of mesh edges \[m\] with which it has about 10 000 vertices, of those that are also
    /// run within a time limit.
    pub(crate) fine_edge_length: Option<f64>,
}

const fn kind(
    name: &'static str,
    file: Option<&'static str>,
    fine_edge_length: Option<f64>,
) -> Kind {
    Kind {
        name,
        file,
        fine_edge_length,
    }
}

pub(crate) const GARMENTS: [Kind; 13] = [
    kind("skirt", None, Some(0.009)),
    kind("top", None, Some(0.0075)),
    kind("T-shirt", Some("gc_tshirt_specification.json"), Some(0.009)),
    kind(
        "pencil skirt",
        Some("gc_pencil_skirt_specification.json"),
        Some(0.009),
    ),
    kind(
        "circle skirt",
        Some("gc_circle_skirt_specification.json"),
        Some(0.011),
    ),
    kind(
        "shirt",
        Some("gcup_shirt_mean_specification.json"),
        Some(0.009),
    ),
    kind(
        "jumpsuit",
        Some("gcup_js_mean_all_specification.json"),
        None,
    ),
    kind(
        "T 2",
        Some("fs_teagan__layers_line_spline.dxf"),
        Some(0.009),
    ),
    kind(
        "tank",
        Some("fs_aaron__layers_line_spline.dxf"),
        Some(0.0095),
    ),
    kind(
        "skirt on a band",
        Some("fs_sandy__layers_line_spline.dxf"),
        None,
    ),
    kind("raglan", Some("gerber_GLX4802S19_AAMA.DXF"), None),
    kind("T 3", Some("gerber_GMH1406F15-4.DXF"), Some(0.0105)),
    kind("tank 2", Some("gerber_WM_SLIM_TANK.DXF"), Some(0.0075)),
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
