//! Vocabulary of the lexicon: the shape of `lexicon.json`, which says itself how it is read.

use super::labels::PanelKind;
use serde::Deserialize;

/// Meaning of a word in the name of a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Meaning {
    /// A kind of panel.
    Kind(PanelKind),
    /// A kind where the name says no other: "short" is an adjective of sleeves.
    KindIfOnly(PanelKind),
    /// A kind where the name says neither another nor front or back: a "button front" is a front.
    KindIfAlone(PanelKind),
    /// Of the front.
    Front,
    /// Of the center front, or a cuff: the other names tell.
    FrontOrCuff,
    /// Of the back.
    Back,
    /// Of the wearer's left.
    Left,
    /// Of the wearer's right.
    Right,
    /// A known word that says nothing by itself.
    Neutral,
}

/// Words that share a meaning.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Entry {
    pub(super) means: Meaning,
    pub(super) words: Vec<String>,
}

/// Vocabulary of one language.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Language {
    /// In English; for readers of the file.
    #[serde(rename = "name")]
    _name: String,
    /// Endings that a stem may take on.
    pub(super) endings: Vec<String>,
    /// Letters between two parts of a compound, besides nothing; absent where words do not
    /// grow together.
    pub(super) compound_links: Option<Vec<String>>,
    pub(super) entries: Vec<Entry>,
}

/// All of the file.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Vocabulary {
    #[serde(rename = "about")]
    _about: Vec<String>,
    pub(super) languages: Vec<Language>,
    pub(super) unspaced: Vec<Entry>,
    pub(super) codes: Vec<Entry>,
    /// What a code may begin with that ends in a place.
    pub(super) code_beginnings: Vec<Entry>,
}

impl Vocabulary {
    /// Reads the file that is part of the program.
    pub(super) fn embedded() -> Self {
        serde_json::from_str(include_str!("lexicon.json"))
            .expect("the embedded lexicon is valid, as its tests show")
    }
}

/// Kinds in the order in which a name that says several is decided: the first counts, so that
/// "collar interfacing" is no collar and "arm binding" no sleeve.
pub(super) const PRECEDENCE: [PanelKind; 18] = [
    PanelKind::Layer,
    PanelKind::Godet,
    PanelKind::Pocket,
    PanelKind::Placket,
    PanelKind::ArmBand,
    PanelKind::NeckBand,
    PanelKind::Cuff,
    PanelKind::Waistband,
    PanelKind::Hood,
    PanelKind::CollarStand,
    PanelKind::Collar,
    PanelKind::Yoke,
    PanelKind::UnderSleeve,
    PanelKind::Sleeve,
    PanelKind::Trouser,
    PanelKind::Skirt,
    PanelKind::Bodice,
    PanelKind::Side,
];
