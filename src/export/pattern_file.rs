//! A pattern as a file of another program's format.

/// A pattern file, and what of the pattern its format has no place for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PatternFile {
    /// The file.
    pub text: String,
    /// All that the pattern holds and the file does not, a sentence each; empty where all is
    /// written.
    pub left_out: Vec<String>,
}
