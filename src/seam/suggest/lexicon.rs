//! The lexicon: meanings of the words of a name, of compounds and phrases too.
//!
//! Words are matched whole. A word that is not known is taken apart into words that are known, in
//! one language at a time and only if nothing is left over: `Vorderteil`, `FRONTPANEL`, but not
//! `butterfly`. Scripts without spaces between words are searched for the longest words.

use super::grown_codes;
use super::vocabulary::{Entry, Language, Meaning, Vocabulary};
use super::words::{folded, is_unspaced};
use std::collections::{BTreeMap, BTreeSet};

/// Shortest part of a compound, in letters.
const MIN_PART: usize = 3;

/// Shortest stem that may take on an ending other than `s`, in letters.
const MIN_INFLECTED: usize = 4;

/// Words by stem, with what each means.
type Stems = BTreeMap<String, Vec<Meaning>>;

/// The vocabulary, ready to look words up in.
#[derive(Clone, Debug)]
pub(super) struct Lexicon {
    languages: Vec<(Language, Stems)>,
    /// Stems in order and what they mean together, the longest first.
    phrases: Vec<(Vec<String>, Meaning)>,
    /// The longest first.
    unspaced: Vec<(String, Meaning)>,
    codes: Stems,
    code_beginnings: Vec<Entry>,
}

impl Lexicon {
    /// Reads the vocabulary.
    pub(super) fn new() -> Self {
        let vocabulary = Vocabulary::embedded();
        let mut phrases: Vec<(Vec<String>, Meaning)> = vec![];
        let languages = vocabulary.languages.into_iter().map(|mut language| {
            for ending in &mut language.endings {
                *ending = folded(ending);
            }
            let stems = stems(&language.entries, &mut phrases);
            (language, stems)
        });
        let languages = languages.collect();
        phrases.sort_by_key(|(stems, _)| std::cmp::Reverse(stems.len()));
        let codes = stems(&vocabulary.codes, &mut phrases);
        let entries = vocabulary.unspaced.iter();
        let mut unspaced: Vec<(String, Meaning)> = entries
            .flat_map(|entry| entry.words.iter().map(|word| (folded(word), entry.means)))
            .collect();
        unspaced.sort_by_key(|(word, _)| std::cmp::Reverse(word.chars().count()));
        Self {
            languages,
            phrases,
            unspaced,
            codes,
            code_beginnings: vocabulary.code_beginnings,
        }
    }

    /// Returns the meanings of the words of a name, given in their order without case and accents.
    pub(super) fn meanings(&self, words: &[String]) -> BTreeSet<Meaning> {
        let mut found = BTreeSet::new();
        let mut roots: Vec<Root> = vec![];
        for word in words {
            if word.starts_with(is_unspaced) {
                self.search_unspaced(word, &mut found);
            }
            roots.extend(self.roots_of(word));
        }
        let mut at = 0;
        while at < roots.len() {
            let mut phrases = self.phrases.iter();
            if let Some((phrase, meaning)) =
                phrases.find(|(phrase, _)| begins(&roots[at..], phrase))
            {
                found.insert(*meaning);
                at += phrase.len();
            } else {
                let known: Vec<Meaning> = self.meanings_of_root(&roots[at]).collect();
                if known.is_empty() && !self.is_known(&roots[at]) {
                    found.extend(grown_codes::parts(&self.code_beginnings, &roots[at].stem));
                }
                found.extend(known);
                at += 1;
            }
        }
        found
    }

    fn meanings_of_root(&self, root: &Root) -> impl Iterator<Item = Meaning> {
        let tables = self.languages.iter().enumerate();
        let tables =
            tables.filter(|(language, _)| root.language.is_none_or(|own| own == *language));
        let codes = root.language.is_none().then_some(&self.codes);
        let all = tables.map(|(_, (_, stems))| stems).chain(codes);
        all.filter_map(|stems| stems.get(&root.stem))
            .flatten()
            .copied()
    }

    /// Returns true if a word is in some table, though it may mean nothing by itself.
    fn is_known(&self, root: &Root) -> bool {
        let mut tables = self.languages.iter().map(|(_, stems)| stems);
        self.codes.contains_key(&root.stem) || tables.any(|stems| stems.contains_key(&root.stem))
    }

    /// Returns the roots of a word; itself where it is not known.
    fn roots_of(&self, word: &str) -> Vec<Root> {
        let root = |stem: &str, language| Root {
            stem: stem.to_owned(),
            language,
        };
        if self.codes.contains_key(word) {
            return vec![root(word, None)];
        }
        let languages = self.languages.iter();
        let whole = languages.filter_map(|(language, stems)| stem_of(word, language, stems));
        if let Some(stem) = whole.max_by_key(|stem| stem.len()) {
            return vec![root(stem, None)];
        }
        for (index, (language, stems)) in self.languages.iter().enumerate() {
            let Some(links) = &language.compound_links else {
                continue;
            };
            let compound = Compound {
                language,
                links,
                stems,
            };
            if let Some(parts) = compound.parts(word, &mut BTreeSet::new()) {
                return parts
                    .into_iter()
                    .map(|part| root(part, Some(index)))
                    .collect();
            }
        }
        vec![root(word, None)]
    }

    /// Adds the meanings of the longest words that stand in `text`, from its beginning on.
    fn search_unspaced(&self, text: &str, found: &mut BTreeSet<Meaning>) {
        let mut rest = text;
        while let Some(first) = rest.chars().next() {
            let mut words = self.unspaced.iter();
            let known = words.find(|(word, _)| rest.starts_with(word.as_str()));
            found.extend(known.map(|(_, meaning)| *meaning));
            rest = &rest[known.map_or(first.len_utf8(), |(word, _)| word.len())..];
        }
    }
}

/// A word, or a part of a compound, as the tables have it.
struct Root {
    stem: String,
    /// Index of the language of the compound; a word by itself may be of any.
    language: Option<usize>,
}

fn begins(roots: &[Root], phrase: &[String]) -> bool {
    roots.len() >= phrase.len()
        && roots
            .iter()
            .zip(phrase)
            .all(|(root, stem)| root.stem == *stem)
}

/// Returns the stems of entries; adds their phrases, each of whose words is known by that.
fn stems(entries: &[Entry], phrases: &mut Vec<(Vec<String>, Meaning)>) -> Stems {
    let mut stems = Stems::new();
    for entry in entries {
        for words in &entry.words {
            let parts: Vec<String> = words.split(' ').map(folded).collect();
            if let [stem] = parts.as_slice() {
                stems.entry(stem.clone()).or_default().push(entry.means);
            } else {
                for part in &parts {
                    stems.entry(part.clone()).or_default();
                }
                phrases.push((parts, entry.means));
            }
        }
    }
    stems
}

/// Returns the longest stem of a language of which `word` is an inflected form.
fn stem_of<'a>(word: &'a str, language: &Language, stems: &Stems) -> Option<&'a str> {
    let cuts = word.char_indices().map(|(at, _)| at).skip(1);
    let mut ends: Vec<usize> = cuts.chain([word.len()]).collect();
    ends.reverse();
    let fits = |end: &usize| {
        let (stem, ending) = word.split_at(*end);
        stems.contains_key(stem) && is_ending(stem, ending, language)
    };
    ends.into_iter().find(fits).map(|end| &word[..end])
}

fn is_ending(stem: &str, ending: &str, language: &Language) -> bool {
    let least = if ending == "s" {
        MIN_PART
    } else {
        MIN_INFLECTED
    };
    ending.is_empty()
        || stem.chars().count() >= least && language.endings.iter().any(|known| known == ending)
}

/// Takes compounds of one language apart.
struct Compound<'a> {
    language: &'a Language,
    /// Letters that may stand between two parts.
    links: &'a [String],
    stems: &'a Stems,
}

impl Compound<'_> {
    /// Returns the stems that make up all of `word`, the longest first part that leads to the end.
    /// `failed` are the lengths of ends of the word that are known to be no compound.
    fn parts<'w>(&self, word: &'w str, failed: &mut BTreeSet<usize>) -> Option<Vec<&'w str>> {
        if failed.contains(&word.len()) {
            return None;
        }
        let cuts = word.char_indices().map(|(at, _)| at);
        let mut ends: Vec<usize> = cuts.chain([word.len()]).skip(MIN_PART).collect();
        ends.reverse();
        for end in ends {
            let (stem, rest) = word.split_at(end);
            if !self.stems.contains_key(stem) {
                continue;
            }
            if is_ending(stem, rest, self.language) {
                return Some(vec![stem]);
            }
            for link in self.links.iter().map(String::as_str).chain([""]) {
                let after = rest.strip_prefix(link).filter(|after| !after.is_empty());
                if let Some(mut parts) = after.and_then(|after| self.parts(after, failed)) {
                    parts.insert(0, stem);
                    return Some(parts);
                }
            }
        }
        failed.insert(word.len());
        None
    }
}
