//! No two files use each other, neither directly nor around: each file can be read after those that
//! it uses.

use super::name_graph::NameGraph;
use super::sources::sources;

#[test]
fn no_file_is_used_by_what_it_uses() {
    let sources = sources();
    let files = sources.iter();
    let graph = NameGraph::new(files.map(|(path, text)| (path.as_str(), text.as_str())));
    let circles = graph.circles();
    let found: Vec<String> = circles
        .iter()
        .map(|circle| described(&graph, circle))
        .collect();
    assert!(
        found.is_empty(),
        "{} circles:\n{}",
        found.len(),
        found.join("\n")
    );
}

/// Returns a circle as text: each file with the names that it uses of the next.
fn described(graph: &NameGraph, circle: &[String]) -> String {
    let mut text = circle[0].clone();
    for (i, from) in circle.iter().enumerate() {
        let to = &circle[(i + 1) % circle.len()];
        text += &format!("\n    uses {} of {to}", graph.names(from, to));
    }
    text
}

/// Returns the circles of a crate of these files, each as the files of the circle joined by blanks.
fn circles(files: &[(&str, &str)]) -> Vec<String> {
    let circles = NameGraph::new(files.iter().copied()).circles();
    circles.iter().map(|circle| circle.join(" ")).collect()
}

#[test]
fn two_files_that_use_each_other_are_a_circle() {
    let root = ("m/mod.rs", "mod a;\nmod b;");
    let lib = ("lib.rs", "mod m;");
    let a = ("m/a.rs", "use super::b::g;\npub(super) fn f() { g() }");
    for b in [
        "use super::a::f;\npub(super) fn g() { f() }",
        "pub(super) fn g() { super::a::f() }",
        "use crate::m::a;\npub(super) fn g() { a::f() }",
        "use super::a::*;\npub(super) fn g() { f() }",
        "use super::a::f as other;\npub(super) fn g() { other() }",
        "use super::{a::{self}};\npub(super) fn g() { let _ = vec![a::f()]; }",
        "pub(super) fn g() { fn inner() { use super::a::f; f(); } }",
    ] {
        assert_eq!(
            circles(&[lib, root, a, ("m/b.rs", b)]),
            ["m/a.rs m/b.rs"],
            "{b}"
        );
    }
    let b = "pub(super) fn g() { let f = 1; let _ = f; }";
    assert!(circles(&[lib, root, a, ("m/b.rs", b)]).is_empty());
}

#[test]
fn circle_leads_through_a_third_file() {
    let found = circles(&[
        ("lib.rs", "mod a; mod b; mod c;"),
        ("a.rs", "pub struct A(pub crate::b::B);"),
        ("b.rs", "pub struct B(pub crate::c::C);"),
        ("c.rs", "pub struct C; pub fn c(_: &crate::a::A) {}"),
    ]);
    assert_eq!(found, ["a.rs b.rs c.rs"]);
}

#[test]
fn re_export_is_followed_and_is_no_edge_itself() {
    let files = |root, a| [("lib.rs", "mod m;"), ("m/mod.rs", root), ("m/a.rs", a)];
    let declares = "mod a; pub use a::A;";
    assert!(
        circles(&files(
            declares,
            "pub struct A; pub fn f() -> super::A { A }"
        ))
        .is_empty()
    );
    let defines = "mod a; pub use a::A; pub struct Shared;";
    assert!(circles(&files(defines, "pub struct A(super::Shared);")).is_empty());
    let both = "mod a; pub use a::A; pub struct Shared; pub fn f() -> A { A(Shared) }";
    let found = circles(&files(both, "pub struct A(pub super::Shared);"));
    assert_eq!(found, ["m/a.rs m/mod.rs"]);
}

#[test]
fn tests_may_use_what_uses_their_file() {
    let found = circles(&[
        ("lib.rs", "mod a; mod b; #[cfg(test)] mod t;"),
        (
            "a.rs",
            "pub fn a() {} #[cfg(test)] mod tests { #[test] fn f() { crate::b::b() } }",
        ),
        ("b.rs", "pub fn b() { crate::a::a() }"),
        ("t.rs", "use crate::a::a; fn t() { a() }"),
    ]);
    assert!(found.is_empty(), "{found:?}");
}
