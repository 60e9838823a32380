//! Hints in the name of a panel: its name split into words, and what the lexicon says of them.

use super::grown_codes;
use super::labels::{FrontBack, Laterality, PanelKind};
use super::lexicon::Lexicon;
use super::vocabulary::{Meaning, PRECEDENCE};
use super::words::split;
use std::collections::BTreeSet;

/// Hints that a name gives.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct NameHints {
    pub(super) kind: Option<PanelKind>,
    /// Other kinds that it names: the sleeve or the leg of a cuff.
    pub(super) of: Vec<PanelKind>,
    /// The number it ends with, counted from 1; 0 where there is none.
    pub(super) number: u32,
    pub(super) front_back: Option<FrontBack>,
    pub(super) laterality: Option<Laterality>,
    /// True if what it says of the front may as well say that it is a cuff.
    pub(super) front_or_cuff: bool,
}

/// Decides what `CF` means in the names of one pattern: the center front where no other panel is
/// called front, else a cuff.
pub(super) fn tell_cuffs_from_fronts(hints: &mut [NameHints]) {
    let is_front = |h: &NameHints| h.kind.is_none() && h.front_back == Some(FrontBack::Front);
    if hints.iter().any(|h| is_front(h) && !h.front_or_cuff) {
        for own in hints.iter_mut().filter(|h| is_front(h) && h.front_or_cuff) {
            own.kind = Some(PanelKind::Cuff);
            own.front_back = None;
        }
    }
}

/// Returns names with `LF` spelled out as left where others of them have `RT`: else it is a left
/// front.
pub(super) fn spelled_out(names: &[&str]) -> Vec<String> {
    let has_right = |name: &&str| split(name).iter().any(|word| word == "rt");
    let is_pair = names.iter().any(has_right);
    let spelled = |name: &&str| -> String {
        let parts = name.split_inclusive(|c: char| !c.is_alphanumeric());
        parts
            .map(|part| if is_pair { left(part) } else { part.to_owned() })
            .collect()
    };
    names.iter().map(spelled).collect()
}

/// Returns `LF` as left, with what ends the word.
fn left(part: &str) -> String {
    let word = part.trim_end_matches(|c: char| !c.is_alphanumeric());
    if word.eq_ignore_ascii_case("lf") {
        format!("left{}", &part[word.len()..])
    } else {
        part.to_owned()
    }
}

/// Returns the hints of `name`.
///
/// `code` is what is left of the name without what all names of the pattern begin with. `shared`
/// are the words that all of them have: those are the garment's and say nothing of one panel, but
/// for the kind of body panels.
pub(super) fn hints(
    lexicon: &Lexicon,
    name: &str,
    code: &str,
    shared: &BTreeSet<String>,
) -> NameHints {
    let mut words = split(name);
    words.retain(|word| !shared.contains(word));
    let codes = split(code);
    let mut meanings = lexicon.meanings(&words);
    meanings.extend(lexicon.meanings(&codes));
    meanings.extend(codes.iter().flat_map(|word| grown_codes::ending(word)));
    meanings.extend(words.iter().chain(&codes).flat_map(|w| side_prefix(w)));
    let has = |meaning| meanings.contains(&meaning);
    let mut kinds = kinds(&meanings);
    let kind = if kinds.is_empty() {
        body_kind(&lexicon.meanings(&shared.iter().cloned().collect::<Vec<_>>()))
    } else {
        Some(kinds.remove(0))
    };
    NameHints {
        kind,
        of: kinds,
        number: number(name),
        front_back: either(
            has(Meaning::Front) || has(Meaning::FrontOrCuff),
            has(Meaning::Back),
            FrontBack::Front,
            FrontBack::Back,
        ),
        laterality: either(
            has(Meaning::Left),
            has(Meaning::Right),
            Laterality::Left,
            Laterality::Right,
        ),
        front_or_cuff: has(Meaning::FrontOrCuff) && !has(Meaning::Front),
    }
}

/// Returns the kinds among `meanings`, the one that counts first.
fn kinds(meanings: &BTreeSet<Meaning>) -> Vec<PanelKind> {
    let named = |of: fn(PanelKind) -> Meaning| -> Vec<PanelKind> {
        let all = PRECEDENCE.iter().copied();
        all.filter(|kind| meanings.contains(&of(*kind))).collect()
    };
    let found = named(Meaning::Kind);
    if !found.is_empty() {
        return found;
    }
    let only = named(Meaning::KindIfOnly);
    let places = [Meaning::Front, Meaning::FrontOrCuff, Meaning::Back];
    let alone = places.iter().all(|place| !meanings.contains(place));
    if only.is_empty() && alone {
        return named(Meaning::KindIfAlone);
    }
    only
}

/// Returns the kind of body panel among the meanings of words that all names share.
fn body_kind(meanings: &BTreeSet<Meaning>) -> Option<PanelKind> {
    let found = kinds(meanings).into_iter();
    let mut body = found.filter(|kind| matches!(kind, PanelKind::Trouser | PanelKind::Skirt));
    body.next()
}

/// Meanings of one or two letters grown together with a kind that they stand before: `lf` in
/// `lfsleeve`, `r` in `rhood`.
fn side_prefix(word: &str) -> Vec<Meaning> {
    let kinds = [
        ("sleeve", PanelKind::Sleeve),
        ("hood", PanelKind::Hood),
        ("cuff", PanelKind::Cuff),
        ("collar", PanelKind::Collar),
        ("pocket", PanelKind::Pocket),
    ];
    let mut found = kinds
        .iter()
        .filter_map(|(end, kind)| Some((word.strip_suffix(end)?, *kind)));
    let sides = |letters: &&(&str, PanelKind)| {
        (1..=2).contains(&letters.0.len()) && letters.0.chars().all(|c| "lrfb".contains(c))
    };
    let Some((letters, kind)) = found.find(|found| sides(&found)) else {
        return vec![];
    };
    let side = |letter| match letter {
        'l' => Meaning::Left,
        'r' => Meaning::Right,
        'f' => Meaning::Front,
        _ => Meaning::Back,
    };
    letters
        .chars()
        .map(side)
        .chain([Meaning::Kind(kind)])
        .collect()
}

fn either<T>(first: bool, second: bool, a: T, b: T) -> Option<T> {
    match (first, second) {
        (true, false) => Some(a),
        (false, true) => Some(b),
        _ => None,
    }
}

/// Returns the number that a name ends with, and 1; 0 where it ends with none.
fn number(name: &str) -> u32 {
    let digits = name.len() - name.trim_end_matches(|c: char| c.is_ascii_digit()).len();
    name[name.len() - digits..]
        .parse::<u32>()
        .map_or(0, |n| n.saturating_add(1))
}

/// Returns true if the names are the first letters of the alphabet: they count the panels, so that
/// `B` is no back.
pub(super) fn are_letters_of_a_series(names: &[&str]) -> bool {
    let mut letters: Vec<String> = names.iter().map(|name| name.to_lowercase()).collect();
    letters.sort();
    let series = ('a'..='z').map(String::from);
    letters.len() > 1
        && letters.iter().zip(series).all(|(own, of)| *own == of)
        && letters.len() <= 26
}

/// Returns the words that all names have, where there are several names.
pub(super) fn shared(names: &[&str]) -> BTreeSet<String> {
    let mut all = names
        .iter()
        .map(|name| split(name).into_iter().collect::<BTreeSet<_>>());
    let first = all.next().filter(|_| names.len() > 1).unwrap_or_default();
    all.fold(first, |shared, words| {
        shared.intersection(&words).cloned().collect()
    })
}

/// Returns what all names begin with, in bytes: the style's code before the panel's own.
pub(super) fn common_start(names: &[&str]) -> usize {
    let Some((first, rest)) = names.split_first().filter(|(_, rest)| !rest.is_empty()) else {
        return 0;
    };
    let mut length = first.len();
    for name in rest {
        let same = first
            .char_indices()
            .zip(name.chars())
            .take_while(|((_, a), b)| a == b);
        length = length.min(same.last().map_or(0, |((at, c), _)| at + c.len_utf8()));
    }
    length
}

#[cfg(test)]
mod tests {
    use super::*;
    use FrontBack::{Back, Front};
    use Laterality::{Left, Right};
    use PanelKind::{
        ArmBand, Bodice, Collar, CollarStand, Cuff, Hood, Layer, NeckBand, Placket, Pocket, Skirt,
        Sleeve, Trouser, Waistband, Yoke,
    };

    type Row = (
        &'static str,
        Option<PanelKind>,
        Option<FrontBack>,
        Option<Laterality>,
    );

    fn assert_hints(rows: &[Row], code_of: fn(&str) -> &str) {
        let lexicon = Lexicon::new();
        for (name, kind, front_back, laterality) in rows {
            let found = hints(&lexicon, name, code_of(name), &BTreeSet::new());
            assert_eq!(
                (found.kind, found.front_back, found.laterality),
                (*kind, *front_back, *laterality),
                "{name}"
            );
        }
    }

    #[test]
    fn words_that_only_begin_alike_mean_nothing() {
        let rows: &[Row] = &[
            ("strapless_front", None, Some(Front), None),
            ("button_front_left", None, Some(Front), Some(Left)),
            ("zip_front", None, Some(Front), None),
            ("skirt_tier_2", Some(Skirt), None, None),
            ("butterfly_sleeve", Some(Sleeve), None, None),
            ("pattern_front", None, Some(Front), None),
            ("Pattern2D_768516", None, None, None),
            ("bundle_front", None, Some(Front), None),
            ("sleeveless_back", None, Some(Back), None),
            ("background", None, None, None),
            ("frontier", None, None, None),
            ("cufflink", None, None, None),
            ("Rocker_Back", None, Some(Back), None),
            ("leftover", None, None, None),
            ("hooded_front", None, Some(Front), None),
            ("waistcoat_front", None, Some(Front), None),
            ("flyer", None, None, None),
            ("Bundfalte", None, None, None),
        ];
        assert_hints(rows, |_| "");
    }

    #[test]
    fn names_of_many_tools_are_understood() {
        let rows: &[Row] = &[
            ("right_sleeve_f", Some(Sleeve), Some(Front), Some(Right)),
            ("lfsleeve", Some(Sleeve), Some(Front), Some(Left)),
            ("left_btorso", Some(Bodice), Some(Back), Some(Left)),
            ("pant_b_l", Some(Trouser), Some(Back), Some(Left)),
            ("wb_front", Some(Waistband), Some(Front), None),
            ("aaron.armBinding", Some(ArmBand), None, None),
            ("aaron.neckBinding", Some(NeckBand), None, None),
            ("sandy.waistband", Some(Waistband), None, None),
            ("COLLARTOPINTERFACE", Some(Layer), None, None),
            ("COLLARBASE", Some(CollarStand), None, None),
            ("CollarTop", Some(Collar), None, None),
            ("FRONTPANEL", None, Some(Front), None),
            ("PocketFlapRound", Some(Pocket), None, None),
            ("PLACKETUNDER", Some(Placket), None, None),
            ("SHORTSLEEVE", Some(Sleeve), None, None),
            ("short", Some(Trouser), None, None),
            ("FT SLV", Some(Sleeve), Some(Front), None),
            ("LFSleeve", Some(Sleeve), Some(Front), Some(Left)),
        ];
        assert_hints(rows, |_| "");
        let codes: &[Row] = &[
            ("GMH1006FBK", None, Some(Back), None),
            ("GMH1006FSL", Some(Sleeve), None, None),
            ("GMH1006FNR", Some(NeckBand), None, None),
            ("GMH1006FVCO", Some(Collar), None, None),
        ];
        assert_hints(codes, |name| &name["GMH1006F".len()..]);
    }

    #[test]
    fn names_of_many_languages_are_understood() {
        let rows: &[Row] = &[
            ("Vorderhose_links", Some(Trouser), Some(Front), Some(Left)),
            ("Rückenteil", None, Some(Back), None),
            ("Ru\u{308}ckenteil", None, Some(Back), None),
            ("Ärmelbündchen", Some(Cuff), None, None),
            ("Halsbündchen", Some(NeckBand), None, None),
            ("Taschenbeutel", Some(Pocket), None, None),
            ("Kragensteg", Some(CollarStand), None, None),
            ("mouwboord", Some(Cuff), None, None),
            ("voorpand links", None, Some(Front), Some(Left)),
            ("broekband", Some(Waistband), None, None),
            ("devant droite", None, Some(Front), Some(Right)),
            ("pied_de_col", Some(CollarStand), None, None),
            ("Espalda izquierda", None, Some(Back), Some(Left)),
            ("puños", Some(Cuff), None, None),
            ("manica_dx", Some(Sleeve), None, Some(Right)),
            ("передняя кокетка", Some(Yoke), Some(Front), None),
            ("капюшон", Some(Hood), None, None),
            ("后片", None, Some(Back), None),
            ("后包条", Some(Layer), Some(Back), None),
            ("罗纹领", Some(NeckBand), None, None),
            ("袖口", Some(Cuff), None, None),
            ("右後ろ身頃", Some(Bodice), Some(Back), Some(Right)),
            ("소매", Some(Sleeve), None, None),
        ];
        assert_hints(rows, |_| "");
    }

    #[test]
    fn words_that_all_names_share_say_nothing_of_one_panel() {
        let names = ["HOODIE-FRONT_L", "HOODIE-SLEEVE_L"];
        let shared = shared(&names);
        let of = |name| hints(&Lexicon::new(), name, "", &shared);
        let front = of(names[0]);
        assert_eq!(
            (front.kind, front.front_back, front.laterality),
            (None, Some(Front), None)
        );
        assert_eq!(of(names[1]).kind, Some(Sleeve));
    }

    #[test]
    fn code_of_cuff_and_center_front_is_decided_by_the_other_names() {
        let hints_of = |names: &[&str]| -> Vec<NameHints> {
            let lexicon = Lexicon::new();
            let none = BTreeSet::new();
            let all = names.iter().map(|name| hints(&lexicon, name, "", &none));
            let mut all: Vec<NameHints> = all.collect();
            tell_cuffs_from_fronts(&mut all);
            all
        };
        let shirt = hints_of(&["FR", "BK", "CF"]);
        assert_eq!((shirt[2].kind, shirt[2].front_back), (Some(Cuff), None));
        let princess = hints_of(&["CF", "SF", "CB"]);
        assert_eq!(
            (princess[0].kind, princess[0].front_back),
            (None, Some(Front))
        );
    }

    #[test]
    fn letters_in_a_row_count_panels() {
        assert!(are_letters_of_a_series(&["A", "B", "C"]));
        assert!(are_letters_of_a_series(&["b", "a"]));
        assert!(!are_letters_of_a_series(&["F", "B", "S"]));
        assert!(!are_letters_of_a_series(&["A", "A", "B"]));
        assert!(!are_letters_of_a_series(&["A"]));
    }

    #[test]
    fn style_codes_are_what_names_have_in_common() {
        assert_eq!(
            common_start(&["GMH1006FBK", "GMH1006FFR"]),
            "GMH1006F".len()
        );
        assert_eq!(common_start(&["front"]), 0);
    }
}
