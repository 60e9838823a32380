//! Measurements that a draft needs, the missing ones by proportion.

use seamster::scene::DressForm;

/// Body measurements \[mm\].
///
/// Height and girths are taken as they are. The rest is proportional, as in drafting books (a twentieth of the bust and
/// 20 mm for half the neck, an eighth and 55 mm for half the back), with constants that suit the dress form.
pub(crate) struct Body {
    pub(crate) bust: f64,
    pub(crate) waist: f64,
    pub(crate) hip: f64,
    /// Down the side, from waist to hip line.
    pub(crate) waist_to_hip: f64,
    /// From the seventh neck vertebra down to the waist.
    pub(crate) nape_to_waist: f64,
    /// From the nape down to the level of the armpits.
    pub(crate) armscye_depth: f64,
    /// Half the width of the neck at its base.
    pub(crate) half_neck: f64,
    /// How far the side of the neck lies above the nape.
    pub(crate) neck_rise: f64,
    /// Half the width from shoulder tip to shoulder tip.
    pub(crate) half_shoulders: f64,
    /// Drop of the shoulder for each unit outwards: 20 degrees.
    pub(crate) shoulder_slope: f64,
    /// Half the width of the back between the armholes.
    pub(crate) half_back: f64,
}

impl Body {
    pub(crate) fn of(form: &DressForm) -> Self {
        let mm = |metres: f64| metres * 1000.0;
        let (height, bust) = (mm(form.height_m), mm(form.bust_m));
        Self {
            bust,
            waist: mm(form.waist_m),
            hip: mm(form.hip_m),
            waist_to_hip: 0.119 * height,
            nape_to_waist: 0.226 * height,
            armscye_depth: bust / 10.0 + 95.0,
            half_neck: bust / 20.0 + 20.0,
            neck_rise: 10.0,
            half_shoulders: 0.107 * height,
            shoulder_slope: 20.0_f64.to_radians().tan(),
            half_back: bust / 8.0 + 55.0,
        }
    }
}
