#!/usr/bin/env python3
"""Counts what the rules on names and layout are measured by.

    tools/house_counts.py [FOLDER]         counts of a checkout, this one by default
    tools/house_counts.py --list KIND      the places: openings, types, wide, closures

Read as text: doc comments that open with a question word, type names that more than one file defines, comment lines
over 100 columns, closures bound by `let`, test binaries. Circles between files are found by the test `structure`.
"""

import re
import sys
from collections import defaultdict
from pathlib import Path

WIDTH = 100
ROOTS = ("src", "cholesky", "crossings", "tests", "tools", "examples", "fuzz", "crates")
QUESTION = re.compile(r"\s*//[/!]\s+(What|Whether|How|Where|Which|Why)\b")
DOC = re.compile(r"\s*//[/!]")
COMMENT = re.compile(r"\s*//")
TYPE = re.compile(r"^\s*(?:pub(?:\([^)]*\))?\s+)?(?:struct|enum|union|trait|type)\s+([A-Z]\w*)")
ASSOCIATED = re.compile(r"^\s+type\s+\w+\s*(=|:|;)")
CLOSURE = re.compile(r"^\s*let\s+(?:mut\s+)?\w+\s*=\s*(?:move\s+)?\|")


def rust_files(root):
    for folder in ROOTS:
        for path in sorted((root / folder).rglob("*.rs")):
            if not {"target", "node_modules"} & set(path.parts):
                yield path


def openings(lines):
    """The first lines of doc comments."""
    before = None
    for number, line in enumerate(lines, 1):
        kind = line.strip()[:3] if DOC.match(line) else None
        if kind and kind != before:
            yield number, line
        before = kind


def count(root):
    found = defaultdict(list)
    types = defaultdict(set)
    docs = comments = 0
    for path in rust_files(root):
        name = path.relative_to(root)
        lines = path.read_text().splitlines()
        in_source = name.parts[0] in ("src", "crates")
        for number, line in openings(lines):
            docs += 1
            if QUESTION.match(line):
                found["openings"].append(f"{name}:{number}: {line.strip()}")
        for number, line in enumerate(lines, 1):
            place = f"{name}:{number}: {line.strip()[:90]}"
            if COMMENT.match(line):
                comments += 1
                if len(line) > WIDTH:
                    found["wide"].append(place)
            if in_source and CLOSURE.match(line):
                found["closures"].append(place)
            match = TYPE.match(line)
            if in_source and match and not ASSOCIATED.match(line):
                types[match.group(1)].add(str(name))
    for name, files in sorted(types.items()):
        if len(files) > 1:
            found["types"].append(f"{name}: {', '.join(sorted(files))}")
    return found, docs, comments


def test_binaries(root):
    """Integration test binaries: a file each, or a folder with a `main.rs`."""
    tests = root / "tests"
    return len(list(tests.glob("*.rs"))) + len(list(tests.glob("*/main.rs")))


def main():
    arguments = sys.argv[1:]
    kind = None
    if arguments[:1] == ["--list"]:
        kind, arguments = arguments[1], arguments[2:]
    root = Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent
    found, docs, comments = count(root)
    if kind:
        print("\n".join(found[kind]))
        return
    share = len(found["openings"]) / docs
    print(f"doc comments that open with What/Whether/How/Where/Which/Why: {len(found['openings'])} of {docs} ({share:.1%})")
    print(f"type names defined in more than one file of src: {len(found['types'])}")
    wide = len(found["wide"])
    print(f"comment lines over {WIDTH} columns: {wide} of {comments} ({wide / comments:.1%})")
    print(f"closures bound by let in src: {len(found['closures'])}")
    print(f"integration test binaries: {test_binaries(root)}")


if __name__ == "__main__":
    main()
