//! Graph of the files of a crate: an edge leads from a file to the one that defines a name it uses.
//!
//! Names are resolved as the compiler does it, as far as this project writes them: `use` with
//! `crate`, `self` and `super`, groups, renames and globs, paths in expressions, types and
//! patterns, and paths inside macros. A re-export is followed to the file that defines the name.
//! `mod` lines, re-exports and methods are no edges, and nothing is that is compiled for tests
//! only.

use super::sources::code;
use std::collections::{BTreeMap, BTreeSet};
use syn::visit::{self, Visit};
use syn::{Attribute, Item, ItemUse, UseTree, Visibility};

/// Path of a module from the root of the crate, which is empty.
type ModulePath = Vec<String>;

/// Re-exports that lead to each other are given up after so many steps.
const MAX_DEPTH: usize = 16;

/// Declarations of a module.
#[derive(Default)]
struct Scope {
    file: String,
    modules: BTreeSet<String>,
    items: BTreeSet<String>,
    imports: BTreeMap<String, Vec<String>>,
    globs: Vec<Vec<String>>,
}

/// Edges between files with the names that make them.
#[derive(Default)]
pub(super) struct NameGraph {
    edges: BTreeMap<String, BTreeMap<String, BTreeSet<String>>>,
}

impl NameGraph {
    /// Reads the files of a crate, given as path below `src` and text.
    pub(super) fn new<'a>(files: impl IntoIterator<Item = (&'a str, &'a str)>) -> Self {
        let mut scopes = Scopes::default();
        let mut parsed = vec![];
        for (path, text) in files {
            let file = syn::parse_file(text).unwrap_or_else(|error| panic!("{path}: {error}"));
            let module = module_path(path);
            scopes.declare(path, &module, &file.items);
            parsed.push((path, module, file));
        }
        scopes.drop_test_modules();
        let mut graph = Self::default();
        for (path, module, file) in &parsed {
            if !scopes.modules.contains_key(module) {
                continue;
            }
            let mut uses = UsedNames {
                scopes: &scopes,
                module: module.clone(),
                found: vec![],
            };
            uses.visit_file(file);
            let targets = graph.edges.entry((*path).to_owned()).or_default();
            for (target, name) in uses.found {
                if target != *path {
                    targets.entry(target).or_default().insert(name);
                }
            }
        }
        graph
    }

    /// Returns the files used by `file`.
    pub(super) fn targets(&self, file: &str) -> impl Iterator<Item = &str> {
        let targets = self.edges.get(file).into_iter().flatten();
        targets.map(|(target, _)| target.as_str())
    }

    /// Returns a shortest circle through each group of files that use each other around.
    pub(super) fn circles(&self) -> Vec<Vec<String>> {
        let mut seen = BTreeSet::new();
        let mut circles = vec![];
        for file in self.edges.keys() {
            if seen.contains(file) {
                continue;
            }
            if let Some(circle) = self.shortest_circle(file) {
                let group = self.reachable(file);
                let group = group.filter(|other| self.reachable(other).any(|back| back == file));
                seen.extend(group.map(str::to_owned));
                circles.push(circle);
            }
        }
        circles
    }

    /// Returns the names by which `from` uses `to`.
    pub(super) fn names(&self, from: &str, to: &str) -> String {
        let names = self.edges.get(from).and_then(|targets| targets.get(to));
        let names: Vec<&str> = names.into_iter().flatten().map(String::as_str).collect();
        names.join(", ")
    }

    fn reachable(&self, from: &str) -> impl Iterator<Item = &str> {
        let mut found: BTreeSet<&str> = BTreeSet::new();
        let mut next: Vec<&str> = self.targets(from).collect();
        while let Some(file) = next.pop() {
            if found.insert(file) {
                next.extend(self.targets(file));
            }
        }
        found.into_iter()
    }

    /// Returns the shortest way from `file` back to it, by breadth first.
    fn shortest_circle(&self, file: &str) -> Option<Vec<String>> {
        let mut before: BTreeMap<&str, &str> = BTreeMap::new();
        let mut front = vec![file];
        while !front.is_empty() {
            let mut next = vec![];
            for from in front {
                for to in self.targets(from) {
                    if before.contains_key(to) {
                        continue;
                    }
                    before.insert(to, from);
                    next.push(to);
                }
            }
            if before.contains_key(file) {
                break;
            }
            front = next;
        }
        let mut circle = vec![*before.get(file)?];
        while circle.last() != Some(&file) {
            circle.push(before[circle[circle.len() - 1]]);
        }
        circle.reverse();
        Some(circle.into_iter().map(str::to_owned).collect())
    }
}

/// `a/b.rs` and `a/b/mod.rs` are the module `a::b`; `lib.rs` and `main.rs` are the root.
fn module_path(file: &str) -> ModulePath {
    let path = file.trim_end_matches(".rs");
    let parts = path.split('/').map(str::to_owned);
    let mut parts: ModulePath = parts.collect();
    if parts.last().is_some_and(|last| last == "mod") || ["lib", "main"].contains(&path) {
        parts.pop();
    }
    parts
}

/// Every module of the crate.
#[derive(Default)]
struct Scopes {
    modules: BTreeMap<ModulePath, Scope>,
    /// Modules that are compiled for tests only.
    tests: BTreeSet<ModulePath>,
}

impl Scopes {
    fn declare(&mut self, file: &str, module: &ModulePath, items: &[Item]) {
        let mut scope = self.modules.remove(module).unwrap_or_default();
        scope.file = file.to_owned();
        for item in items {
            if let Item::Mod(inner) = item {
                let name = inner.ident.to_string();
                let path = child(module, &name);
                if is_for_tests(&inner.attrs) {
                    self.tests.insert(path);
                    continue;
                }
                if let Some((_, items)) = &inner.content {
                    self.declare(file, &path, items);
                }
                scope.modules.insert(name);
            } else if let Some(name) = defined_name(item) {
                scope.items.insert(name);
            }
        }
        let mut imports = Imports::default();
        for item in items.iter().filter(|item| !matches!(item, Item::Mod(_))) {
            imports.visit_item(item);
        }
        scope.imports.extend(imports.names);
        scope.globs.extend(imports.globs);
        self.modules.insert(module.clone(), scope);
    }

    fn drop_test_modules(&mut self) {
        let tests = std::mem::take(&mut self.tests);
        self.modules
            .retain(|path, _| !(0..=path.len()).any(|end| tests.contains(&path[..end])));
    }

    /// Returns the file that defines what `path` names in `module`; `None` if it names a module, or
    /// something of another crate.
    fn resolve(&self, module: &[String], path: &[String], depth: usize) -> Option<String> {
        let (first, rest) = path.split_first()?;
        if depth > MAX_DEPTH {
            return None;
        }
        match first.as_str() {
            "crate" => return self.resolve(&[], rest, depth),
            "self" => return self.resolve(module, rest, depth),
            "super" => {
                let (_, parent) = module.split_last()?;
                return self.resolve(parent, rest, depth);
            }
            _ => {}
        }
        let scope = self.modules.get(module)?;
        if scope.modules.contains(first) && !rest.is_empty() {
            return self.resolve(&child(module, first), rest, depth);
        }
        if scope.items.contains(first) {
            return Some(scope.file.clone());
        }
        if let Some(target) = scope.imports.get(first) {
            // `use dxf::Drawing` in a module that has no `dxf` names another crate.
            let path = [target, rest].concat();
            let is_itself = path.first() == Some(first);
            if is_itself && !scope.modules.contains(first) {
                return None;
            }
            return self.resolve(module, &path, depth + 1);
        }
        let globs = scope.globs.iter();
        let mut found = globs.filter_map(|glob| {
            let path = [glob.as_slice(), path].concat();
            self.resolve(module, &path, depth + 1)
        });
        found.next()
    }
}

fn child(module: &[String], name: &str) -> ModulePath {
    [module, &[name.to_owned()]].concat()
}

fn is_for_tests(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let condition = attribute.path().is_ident("cfg");
        condition
            && attribute
                .parse_args::<syn::Path>()
                .is_ok_and(|path| path.is_ident("test"))
    })
}

fn defined_name(item: &Item) -> Option<String> {
    let name = match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::Type(item) => &item.ident,
        Item::Macro(item) => item.ident.as_ref()?,
        _ => return None,
    };
    Some(name.to_string())
}

/// The names that `use` brings into a module, those within functions too.
#[derive(Default)]
struct Imports {
    names: BTreeMap<String, Vec<String>>,
    globs: Vec<Vec<String>>,
}

impl Visit<'_> for Imports {
    fn visit_item_use(&mut self, item: &ItemUse) {
        for (path, name) in leaves(&item.tree) {
            match name {
                Some(name) => drop(self.names.insert(name, path)),
                None => self.globs.push(path),
            }
        }
    }

    fn visit_item(&mut self, item: &Item) {
        if !is_for_tests(attributes(item)) {
            visit::visit_item(self, item);
        }
    }
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

/// Returns the paths of a `use`, each with the name that it has here; a glob has none.
fn leaves(tree: &UseTree) -> Vec<(Vec<String>, Option<String>)> {
    let mut found = vec![];
    add_leaves(tree, &[], &mut found);
    found
}

fn add_leaves(tree: &UseTree, before: &[String], found: &mut Vec<(Vec<String>, Option<String>)>) {
    match tree {
        UseTree::Path(tree) => {
            add_leaves(&tree.tree, &child(before, &tree.ident.to_string()), found);
        }
        UseTree::Name(tree) if tree.ident == "self" => {
            found.push((before.to_vec(), before.last().cloned()));
        }
        UseTree::Name(tree) => {
            let name = tree.ident.to_string();
            found.push((child(before, &name), Some(name)));
        }
        UseTree::Rename(tree) => {
            let path = child(before, &tree.ident.to_string());
            found.push((path, Some(tree.rename.to_string())));
        }
        UseTree::Glob(_) => found.push((before.to_vec(), None)),
        UseTree::Group(tree) => {
            for tree in &tree.items {
                add_leaves(tree, before, found);
            }
        }
    }
}

/// The names that a file uses, with the files that define them.
struct UsedNames<'a> {
    scopes: &'a Scopes,
    module: ModulePath,
    found: Vec<(String, String)>,
}

impl UsedNames<'_> {
    fn add(&mut self, path: &[String]) {
        if let Some(file) = self.scopes.resolve(&self.module, path, 0) {
            let name = path
                .iter()
                .rfind(|part| !["crate", "self", "super"].contains(&part.as_str()));
            self.found.push((file, name.cloned().unwrap_or_default()));
        }
    }

    /// Adds every path in the text of a macro call, whose syntax is not known.
    fn add_text(&mut self, text: &str) {
        let text = code(text).replace("::", "\u{1}");
        let is_path = |c: char| c.is_alphanumeric() || c == '_' || c == '\u{1}';
        for path in text.split(|c| !is_path(c)) {
            let path: Vec<String> = path.split('\u{1}').map(str::to_owned).collect();
            self.add(&path);
        }
    }
}

impl<'ast> Visit<'ast> for UsedNames<'_> {
    fn visit_item(&mut self, item: &'ast Item) {
        if is_for_tests(attributes(item)) {
            return;
        }
        if let Item::Mod(inner) = item {
            self.module.push(inner.ident.to_string());
            visit::visit_item(self, item);
            self.module.pop();
        } else {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        if matches!(item.vis, Visibility::Inherited) {
            for (path, _) in leaves(&item.tree) {
                self.add(&path);
            }
        }
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let names: Vec<String> = path.segments.iter().map(|s| s.ident.to_string()).collect();
        self.add(&names);
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        self.add_text(&call.tokens.to_string());
        visit::visit_macro(self, call);
    }
}
