//! The house's own rules: what every file opens with, how long it may be, what the container shares
//! with the Makefile.

use std::path::{Path, PathBuf};

/// Lines of a source file; above this it holds more than one idea.
const MOST_LINES: usize = 400;
/// Columns of a comment line.
const COMMENT_COLUMNS: usize = 100;

#[test]
fn every_file_says_first_what_it_is() {
    let opens_wrong = |path: &PathBuf| !text(path).starts_with("//!");
    let wrong: Vec<_> = rust_files().into_iter().filter(opens_wrong).collect();
    assert!(wrong.is_empty(), "no //! at the top of {wrong:?}");
}

#[test]
fn no_source_file_is_too_long() {
    let is_source = |path: &PathBuf| path.starts_with(root().join("src"));
    let is_long = |path: &PathBuf| lines_without_tests(&text(path)) > MOST_LINES;
    let files = rust_files().into_iter().filter(is_source);
    let wrong: Vec<_> = files.filter(is_long).collect();
    assert!(wrong.is_empty(), "over {MOST_LINES} lines: {wrong:?}");
}

#[test]
fn the_container_is_built_by_the_makefiles_recipes() {
    let makefile = text(&root().join("Makefile"));
    let dockerfile = text(&root().join("Dockerfile"));
    let recipes = dockerfile
        .lines()
        .filter_map(|line| line.strip_prefix("RUN make "));
    let recipes: Vec<_> = recipes.flat_map(str::split_whitespace).collect();
    assert!(!recipes.is_empty());
    for recipe in recipes {
        let target = format!("\n{recipe}:");
        assert!(makefile.contains(&target), "the Makefile has no {recipe}");
    }
}

#[test]
fn the_container_has_the_pinned_toolchain() {
    let toolchain = text(&root().join("rust-toolchain.toml"));
    let pinned = toolchain.split('"').nth(1).expect("a channel in quotes");
    let image = format!("FROM rust:{}-", pinned.trim_end_matches(".0"));
    assert!(text(&root().join("Dockerfile")).contains(&image), "{image}");
}

#[test]
fn no_comment_is_wider_than_a_page() {
    let is_wide =
        |line: &&str| line.trim_start().starts_with("//") && line.chars().count() > COMMENT_COLUMNS;
    let places = rust_files().into_iter().flat_map(|path| {
        let text = text(&path);
        let wide: Vec<_> = text.lines().filter(is_wide).map(str::to_owned).collect();
        wide.into_iter().map(move |line| (path.clone(), line))
    });
    let wrong: Vec<_> = places.collect();
    assert!(
        wrong.is_empty(),
        "over {COMMENT_COLUMNS} columns: {wrong:#?}"
    );
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn lines_without_tests(text: &str) -> usize {
    let code = text.split("#[cfg(test)]\nmod tests {").next();
    code.map_or(0, |code| code.lines().count())
}

/// Every Rust file of the project's own.
fn rust_files() -> Vec<PathBuf> {
    let mut files = vec![];
    let mut folders: Vec<_> = [
        "src",
        "cholesky/src",
        "crossings",
        "tests",
        "tools",
        "examples",
    ]
    .map(|f| root().join(f))
    .into();
    while let Some(folder) = folders.pop() {
        let Ok(entries) = std::fs::read_dir(folder) else {
            continue;
        };
        for entry in entries {
            let path = entry.expect("a folder that can be listed").path();
            if path.is_dir() && !path.ends_with("node_modules") {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                files.push(path);
            }
        }
    }
    assert!(!files.is_empty());
    files
}
