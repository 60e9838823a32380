//! The sample patterns, drafted from body measurements: what the example writes and the tests draft again.

mod aama;
mod body;
mod curve;
mod garment;
mod piece;
mod skirt;
mod top;

use body::Body;
use piece::Style;
use seamster::scene::DressForm;

/// A pattern with its garment file, as bytes to write.
pub(crate) struct Sample {
    /// Stem of both file names.
    pub(crate) name: &'static str,
    /// The pattern.
    pub(crate) dxf: String,
    /// The garment, without its pattern.
    pub(crate) garment: String,
}

/// All samples, drafted for the default dress form.
pub(crate) fn samples() -> Vec<Sample> {
    let form = DressForm::default();
    let body = Body::of(&form);
    let sample = |name, style: &Style, garment: garment::Draft| Sample {
        name,
        dxf: aama::write(style),
        garment: garment.json(&form),
    };
    vec![
        sample("skirt", &skirt::draft(&body), skirt::garment()),
        sample("top", &top::draft(&body), top::garment()),
    ]
}
