//! What the name of a panel says of it: pattern makers' words in several languages, and the short codes of pattern CAD.

use super::labels::{FrontBack, Laterality, PanelKind};
use std::collections::BTreeSet;

/// What a name says.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct NameHints {
    pub(super) kind: Option<PanelKind>,
    /// What else it names: the sleeve or the leg of a cuff.
    pub(super) of: Vec<PanelKind>,
    /// The number it ends with, counted from 1; 0 where there is none.
    pub(super) number: u32,
    pub(super) front_back: Option<FrontBack>,
    pub(super) laterality: Option<Laterality>,
}

/// A kind with the parts of words that say it, and the whole words and codes that do.
type Entry = (PanelKind, &'static [&'static str], &'static [&'static str]);

/// In order: the first that fits counts, so that "collar interfacing" is no collar and "arm binding" no sleeve.
const KINDS: [Entry; 16] = [
    (
        PanelKind::Layer,
        &[
            "interfac",
            "facing",
            "interlin",
            "lining",
            "fusible",
            "einlage",
            "futter",
            "doublure",
            "entretela",
            "包条",
        ],
        &["iy", "ix"],
    ),
    (
        PanelKind::Godet,
        &["godet", "gusset", "insert", "zwickel"],
        &["ins"],
    ),
    (
        PanelKind::Pocket,
        &[
            "pocket",
            "flap",
            "tasche",
            "poche",
            "bolsillo",
            "welt",
            "карман",
            "口袋",
        ],
        &["pkt", "pk"],
    ),
    (
        PanelKind::Placket,
        &[
            "placket", "button", "zip", "fly", "loop", "belt", "strap", "tie", "blende", "patte",
        ],
        &[],
    ),
    (
        PanelKind::ArmBand,
        &[
            "armbinding",
            "armholebinding",
            "armholeband",
            "sleeveband",
            "armband",
            "armrib",
        ],
        &["bia"],
    ),
    (
        PanelKind::NeckBand,
        &[
            "neckbinding",
            "neckband",
            "neckrib",
            "neckline",
            "ribcollar",
            "罗纹领",
            "领",
        ],
        &["bin", "nr", "nb", "rib"],
    ),
    (
        PanelKind::Cuff,
        &[
            "cuff",
            "manschette",
            "poignet",
            "puño",
            "polsino",
            "манжет",
            "袖口",
        ],
        &["cu", "cuf"],
    ),
    (
        PanelKind::Waistband,
        &[
            "waistband",
            "bund",
            "ceinture",
            "pretina",
            "cintura",
            "пояс",
            "腰",
        ],
        &["wb", "wa", "waist", "band"],
    ),
    (
        PanelKind::Hood,
        &[
            "hood",
            "kapuze",
            "capuche",
            "capucha",
            "cappuccio",
            "капюшон",
            "帽",
        ],
        &["ho"],
    ),
    (
        PanelKind::CollarStand,
        &["collarstand", "collarbase", "collarband", "steg"],
        &["stand"],
    ),
    (
        PanelKind::Collar,
        &[
            "collar",
            "kragen",
            "cuello",
            "colletto",
            "воротник",
            "turtle",
            "lapel",
        ],
        &["co", "clr", "col"],
    ),
    (
        PanelKind::Yoke,
        &["yoke", "passe", "empiècement", "canesú", "sprone", "кокетк"],
        &["yk", "yl", "yp"],
    ),
    (
        PanelKind::Sleeve,
        &[
            "sleeve",
            "ärmel",
            "aermel",
            "manche",
            "manga",
            "manica",
            "рукав",
            "袖",
        ],
        &["sl", "sls", "slv", "ss", "ls", "sa"],
    ),
    (
        PanelKind::Trouser,
        &["pant", "trouser", "legging", "jeans", "hose", "брюк", "裤"],
        &["leg", "ll", "short", "shorts"],
    ),
    (
        PanelKind::Skirt,
        &["skirt", "jupe", "falda", "gonna", "юбк", "裙"],
        &["rock"],
    ),
    (
        PanelKind::Bodice,
        &["torso", "bodice", "shirt", "corpiño", "лиф"],
        &["body", "tank", "top"],
    ),
];

const FRONT: (&[&str], &[&str]) = (
    &[
        "front",
        "frnt",
        "vorder",
        "devant",
        "delantero",
        "davanti",
        "перед",
        "前",
        "ftorso",
    ],
    &["fr", "frt", "f", "fa", "ft", "vt"],
);
const BACK: (&[&str], &[&str]) = (
    &[
        "back", "rücken", "rueck", "hinter", "dos", "espalda", "trasero", "dietro", "спин", "задн",
        "后", "後", "btorso",
    ],
    &["bk", "bck", "b", "ba", "rear", "ht"],
);
const LEFT: (&[&str], &[&str]) = (
    &["left", "links", "gauche", "izquierd", "sinistr", "左"],
    &["l", "lft", "lh"],
);
const RIGHT: (&[&str], &[&str]) = (
    &["right", "rechts", "droit", "derech", "destr", "右"],
    &["r", "rgt", "rh"],
);

/// What `name` says; `code` is what is left of it without what all names of the pattern begin with, `shared` are the words
/// that all of them have: those are the garment's and say nothing of one panel, but for the kind of body panels.
pub(super) fn hints(name: &str, code: &str, shared: &BTreeSet<String>) -> NameHints {
    let mut words = split(name);
    words.retain(|word| !shared.contains(word));
    let joined: String = words.concat();
    words.extend(split(code));
    let says = |(parts, codes): (&[&str], &[&str])| {
        let part =
            |p: &&str| words.iter().any(|w| w.contains(*p)) || p.len() > 6 && joined.contains(*p);
        parts.iter().any(part) || words.iter().any(|w| codes.contains(&w.as_str()))
    };
    // A code grown together with a name before it: "RACERBK" after "RACE".
    let ends = |codes: &[&str]| {
        split(code)
            .iter()
            .any(|w| w.len() <= 4 && codes.iter().any(|c| w.ends_with(c)))
    };
    let before = letters_before(&words);
    let (front, back) = (
        says(FRONT) || ends(&["fr"]) || before.contains('f'),
        says(BACK) || ends(&["bk"]) || before.contains('b'),
    );
    let (left, right) = (
        says(LEFT) || before.contains('l'),
        says(RIGHT) || before.contains('r'),
    );
    let mut kinds = KINDS
        .iter()
        .filter(|(_, parts, codes)| says((parts, codes)))
        .map(|(kind, ..)| *kind);
    let kind = kinds
        .next()
        .or_else(|| ends(&["co"]).then_some(PanelKind::Collar))
        .or_else(|| body_kind(shared));
    let mut of: Vec<PanelKind> = kinds.collect();
    if of.contains(&PanelKind::Sleeve) {
        of.retain(|kind| *kind != PanelKind::Trouser); // "short sleeve cuff"
    }
    NameHints {
        kind,
        of,
        number: number(name),
        front_back: either(front, back, FrontBack::Front, FrontBack::Back),
        laterality: either(left, right, Laterality::Left, Laterality::Right),
    }
}

/// One or two letters grown together with a kind that they stand before: `lf` in `lfsleeve`, `r` in `rhood`.
fn letters_before(words: &[String]) -> &str {
    let kinds = ["sleeve", "hood", "cuff", "collar", "pocket"];
    words
        .iter()
        .filter_map(|word| kinds.iter().find_map(|kind| word.strip_suffix(kind)))
        .find(|rest| (1..=2).contains(&rest.len()) && rest.chars().all(|c| "lrfb".contains(c)))
        .unwrap_or_default()
}

/// The kind of body panel that words say.
fn body_kind(words: &BTreeSet<String>) -> Option<PanelKind> {
    let says = |parts: &[&str], codes: &[&str]| {
        let part = |p: &&str| words.iter().any(|w| w.contains(*p));
        parts.iter().any(part) || words.iter().any(|w| codes.contains(&w.as_str()))
    };
    let body = [PanelKind::Trouser, PanelKind::Skirt];
    let found = KINDS.iter().filter(|(kind, ..)| body.contains(kind));
    let mut found = found.filter(|(_, parts, codes)| says(parts, codes));
    found.next().map(|(kind, ..)| *kind)
}

fn either<T>(first: bool, second: bool, a: T, b: T) -> Option<T> {
    match (first, second) {
        (true, false) => Some(a),
        (false, true) => Some(b),
        _ => None,
    }
}

/// The number that a name ends with, and 1; 0 where it ends with none.
fn number(name: &str) -> u32 {
    let digits = name.len() - name.trim_end_matches(|c: char| c.is_ascii_digit()).len();
    name[name.len() - digits..]
        .parse::<u32>()
        .map_or(0, |n| n.saturating_add(1))
}

/// Words that all names have, where there are several names.
pub(super) fn shared(names: &[&str]) -> BTreeSet<String> {
    let mut all = names
        .iter()
        .map(|name| split(name).into_iter().collect::<BTreeSet<_>>());
    let first = all.next().filter(|_| names.len() > 1).unwrap_or_default();
    all.fold(first, |shared, words| {
        shared.intersection(&words).cloned().collect()
    })
}

/// Words of a name: parted at what is no letter and where a capital follows a small letter.
fn split(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut small = false;
    for c in name.chars() {
        let ends = !c.is_alphabetic() || small && c.is_uppercase();
        if ends {
            words.push(String::new());
        }
        if c.is_alphabetic() {
            words
                .last_mut()
                .expect("begun with one")
                .extend(c.to_lowercase());
        }
        small = c.is_lowercase();
    }
    words.retain(|word| !word.is_empty());
    words
}

/// What all names begin with, in bytes: the style's code before the piece's.
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

    #[test]
    fn names_of_many_tools_are_understood() {
        let all = |name: &str, code: &str| {
            let s = hints(name, code, &BTreeSet::new());
            (s.kind, s.front_back, s.laterality)
        };
        assert_eq!(
            all("right_sleeve_f", ""),
            (
                Some(PanelKind::Sleeve),
                Some(FrontBack::Front),
                Some(Laterality::Right)
            )
        );
        assert_eq!(
            all("aaron.armBinding", ""),
            (Some(PanelKind::ArmBand), None, None)
        );
        assert_eq!(all("GMH1006FBK", "BK"), (None, Some(FrontBack::Back), None));
        assert_eq!(
            all("COLLARTOPINTERFACE", ""),
            (Some(PanelKind::Layer), None, None)
        );
        assert_eq!(
            all("pant_b_l", ""),
            (
                Some(PanelKind::Trouser),
                Some(FrontBack::Back),
                Some(Laterality::Left)
            )
        );
        assert_eq!(
            all("wb_front", ""),
            (Some(PanelKind::Waistband), Some(FrontBack::Front), None)
        );
        assert_eq!(all("后片", ""), (None, Some(FrontBack::Back), None));
    }

    #[test]
    fn words_that_all_names_share_say_nothing_of_one_panel() {
        let names = ["HOODIE-FRONT_L", "HOODIE-SLEEVE_L"];
        let shared = shared(&names);
        let front = hints(names[0], "", &shared);
        assert_eq!(
            (front.kind, front.front_back, front.laterality),
            (None, Some(FrontBack::Front), None)
        );
        assert_eq!(hints(names[1], "", &shared).kind, Some(PanelKind::Sleeve));
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
