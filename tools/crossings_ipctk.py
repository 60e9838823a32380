#!/usr/bin/env python3
"""Compares the crossings of garments by `seamster-crossings` with those by `ipctk`.

    cargo build --release -p seamster-crossings --example judge_glb
    seamster sew PATTERN.dxf GARMENT.json -o NAME.glb --scene NAME.scene.json
    tools/crossings_ipctk.py [--judge PROGRAM] NAME.glb...

Needs `pip install numpy ipctk` (IPC Toolkit: its predicate for an edge and a triangle, its broad phase). The mesh is
welded by the stitches of the scene beside the file, which has the body as well; a GLB file does not tell its stitches.
Where there is no scene, vertices at exactly one place are welded, and the body is the node `avatar`, if there is one.

For each file: pairs of cloth triangles that cross by the judge and by ipctk; the same for cloth against the body;
ipctk's own `has_intersections` of the welded cloth. Each pair that only one of them has is decided a third time, in
fractions, and explained. The exit code is 1 if the judge is wrong by that anywhere.

ipctk looks at edges and triangles without a common vertex, so it does not see triangles folded onto each other about a
common edge, nor one on its copy. Where an edge lies in a triangle's plane, its answer depends on the order of the
edge's ends.
"""

import argparse
import json
import struct
import subprocess
import sys
from collections import defaultdict
from fractions import Fraction
from itertools import combinations
from pathlib import Path

import ipctk
import numpy as np

JUDGE = Path(__file__).parent.parent / "target/release/examples/judge_glb"
TYPES = {5126: "<f4", 5125: "<u4", 5123: "<u2"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}


class Mesh:
    """Vertices [m] and triangles of some panels, and the welded index of each vertex."""

    def __init__(self):
        self.vertices = np.zeros((0, 3))
        self.triangles = np.zeros((0, 3), np.int32)

    def add(self, vertices, triangles):
        self.triangles = np.vstack([self.triangles, triangles + len(self.vertices)]).astype(np.int32)
        self.vertices = np.vstack([self.vertices, vertices])

    def corners(self, triangle):
        return self.vertices[self.triangles[triangle]]


def read_glb(path):
    """Returns the cloth and the avatar."""
    data = path.read_bytes()
    (length,) = struct.unpack_from("<I", data, 12)
    document, buffer = json.loads(data[20 : 20 + length]), data[28 + length :]

    def accessor(index):
        a = document["accessors"][index]
        view = document["bufferViews"][a["bufferView"]]
        start = view.get("byteOffset", 0) + a.get("byteOffset", 0)
        width = WIDTHS[a["type"]]
        return np.frombuffer(buffer, TYPES[a["componentType"]], a["count"] * width, start).reshape(-1, width)

    cloth, avatar = Mesh(), Mesh()
    for node in document.get("nodes", []):
        for part in document["meshes"][node["mesh"]]["primitives"] if "mesh" in node else []:
            mesh = avatar if node.get("name") == "avatar" else cloth
            mesh.add(accessor(part["attributes"]["POSITION"]), accessor(part["indices"]).reshape(-1, 3).astype(int))
    return cloth, avatar


def read_scene(path):
    """Returns a scene's stitches and body."""
    scene, body = json.loads(path.read_text()), Mesh()
    collider = scene["collider"] or {}
    if "triangles" in collider:
        body.add(np.array(collider["vertices"], "<f4"), np.array(collider["triangles"], int))
    return scene["stitches"], body


def weld(vertices, stitches):
    """Returns the lowest vertex that each is stitched to; by equal places without stitches."""
    if stitches is None:
        _, first, place = np.unique(vertices, axis=0, return_index=True, return_inverse=True)
        return first[place.reshape(-1)]
    welded = list(range(len(vertices)))

    def root(v):
        while welded[v] != v:
            v = welded[v]
        return v

    for a, b in stitches:
        a, b = root(a), root(b)
        welded[max(a, b)] = min(a, b)
    return np.array([root(v) for v in range(len(vertices))], int)


def edges_of(triangles):
    """Returns the edges and the triangles at each."""
    at = defaultdict(list)
    for t, (a, b, c) in enumerate(triangles.tolist()):
        for edge in ((a, b), (b, c), (c, a)):
            at[tuple(sorted(edge))].append(t)
    edges = sorted(at)
    return np.array(edges, np.int32).reshape(-1, 2), [at[edge] for edge in edges]


def ipctk_pairs(vertices, triangles, names):
    """Returns the pairs of triangles of which an edge of one meets the other by ipctk, the ends of the edge not being
    among the other's corners; `names` are the welded vertices."""
    edges, at = edges_of(triangles)
    broad = ipctk.LBVH()
    # ipctk's boxes are closed in double precision; the margin is against rounding inside it.
    broad.build(np.asfortranarray(vertices), np.asfortranarray(edges), np.asfortranarray(triangles), 1e-9)
    pairs = set()
    for candidate in broad.detect_edge_face_candidates():
        edge, face = edges[candidate.edge_id], triangles[candidate.face_id]
        if set(names[edge]) & set(names[face]):
            continue
        if ipctk.is_edge_intersecting_triangle(*vertices[edge], *vertices[face]):
            pairs |= {tuple(sorted((t, candidate.face_id))) for t in at[candidate.edge_id]}
    return pairs


def has_intersections(vertices, triangles):
    edges, _ = edges_of(triangles)
    mesh = ipctk.CollisionMesh(np.asfortranarray(vertices), np.asfortranarray(edges), np.asfortranarray(triangles))
    return ipctk.has_intersections(mesh, np.asfortranarray(vertices))


def welded_mesh(mesh, names):
    """Returns the mesh on its welded vertices only, without triangles that have one twice."""
    used, triangles = np.unique(names[mesh.triangles], return_inverse=True)
    triangles = triangles.reshape(-1, 3).astype(np.int32)
    proper = [len(set(t)) == 3 for t in triangles.tolist()]
    return mesh.vertices[used], triangles[proper]


## The same in fractions


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def have_common_point(a, b):
    """Returns if the hulls of two sets of points meet: nothing parts them along any direction that could."""
    edges = [minus(p, q) for points in (a, b) for p, q in combinations(points, 2)]
    offset = minus(a[0], b[0])
    normals = [cross(e, f) for e, f in combinations(edges, 2)]
    directions = normals + [cross(n, e) for n in normals for e in edges]
    directions += [cross(e, cross(offset, e)) for e in edges] + edges + [offset]
    for direction in directions:
        heights_a, heights_b = ([dot(p, direction) for p in points] for points in (a, b))
        if max(heights_a) < min(heights_b) or max(heights_b) < min(heights_a):
            return False
    return True


def decide(a, b, names_a, names_b):
    """Returns if two triangles cross by the rules, and how they lie."""
    a, b = ([[Fraction(float(x)) for x in p] for p in points] for points in (a, b))
    shared = [(i, names_b.index(v)) for i, v in enumerate(names_a) if v in names_b]
    volumes = [dot(minus(p, t[0]), cross(minus(t[1], t[0]), minus(t[2], t[0]))) for s, t in ((a, b), (b, a)) for p in s]
    flat = all(v == 0 for v in volumes)
    place = "in one plane" if flat else "touching" if volumes.count(0) > 2 * len(shared) else "apart from touching"
    if len(shared) == 0:
        return have_common_point(a, b), f"no common vertex, {place}"
    if len(shared) == 1:
        ((i, j),) = shared
        ends_a, ends_b = ([t[(k + 1) % 3], t[(k + 2) % 3]] for t, k in ((a, i), (b, j)))
        return have_common_point(ends_a, b) or have_common_point(ends_b, a), f"one common vertex, {place}"
    if len(shared) == 2:
        (i, j), (k, l) = shared
        folded = False
        for u, v in ((a[i], a[k]), (b[j], b[l])):
            n, m = (cross(minus(v, u), minus(t, u)) for t in (a[3 - i - k], b[3 - j - l]))
            folded |= cross(n, m) == [0, 0, 0] and dot(n, m) > 0
        return folded, f"common edge, {place}"
    return True, "all vertices common"


## Comparison


def judge_pairs(program, path, scene):
    """Returns the judge's pairs, of cloth and with the body, and the other faults."""
    command = [program, path] + ([scene] if scene else [])
    lines = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split("\n")
    found = defaultdict(list)
    for kind, *words in (line.split() for line in lines if line):
        found[kind].append(tuple(int(word) for word in words[:2]) if kind in ("cloth", "body") else int(words[0]))
    return found


def explain(judged, other, place_of):
    """Prints the differences, explained, and returns how often the judge is wrong."""
    wrong, reasons = 0, defaultdict(int)
    for pair in judged ^ other:
        truth, place = decide(*place_of(pair))
        wrong += truth != (pair in judged)
        reasons[("judge only" if pair in judged else "ipctk only", place, "crossing" if truth else "no crossing")] += 1
    for (who, place, truth), count in sorted(reasons.items()):
        print(f"    {count} by {who}: {place}; {truth} in fractions")
    return wrong


def compare(path, program):
    cloth, avatar = read_glb(path)
    scene = path.with_suffix(".scene.json")
    scene = scene if scene.exists() else None
    stitches, avatar = read_scene(scene) if scene else (None, avatar)
    names = weld(cloth.vertices, stitches)
    found = judge_pairs(program, path, scene)
    flat = set(found["degenerate"])

    def cloth_place(pair):
        return [cloth.corners(t) for t in pair] + [names[cloth.triangles[t]].tolist() for t in pair]

    judged, other = set(found["cloth"]), ipctk_pairs(cloth.vertices, cloth.triangles, names)
    meets = has_intersections(*welded_mesh(cloth, names))
    welded_by = "stitches" if scene else "places"
    print(f"{path.name}: {len(cloth.triangles)} triangles, {len(flat)} degenerate, welded by {welded_by}")
    print(f"  cloth: {len(judged)} by the judge, {len(other)} by ipctk, has_intersections {meets}")
    wrong = explain(judged, {p for p in other if not flat & set(p)}, cloth_place)
    if len(avatar.triangles):
        wrong += compare_with_body(cloth, avatar, names, found)
    return wrong


def compare_with_body(cloth, avatar, names, found):
    """Compares the pairs that are not all inside by the judge."""
    first = len(cloth.triangles)
    vertices = np.vstack([cloth.vertices, avatar.vertices])
    triangles = np.vstack([cloth.triangles, avatar.triangles + len(cloth.vertices)]).astype(np.int32)
    own = np.arange(len(vertices))
    inside = set(found["inside"])

    def counts(t, wall):
        return t < first <= wall and not inside.issuperset(cloth.triangles[t].tolist())

    other = {(t, wall - first) for t, wall in ipctk_pairs(vertices, triangles, own) if counts(t, wall)}
    judged = set(found["body"])
    print(f"  body: {len(judged)} by the judge, {len(other)} by ipctk, {len(inside)} vertices inside")
    return explain(judged, other, lambda p: (cloth.corners(p[0]), avatar.corners(p[1]), [0, 1, 2], [3, 4, 5]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("garments", nargs="+", type=Path)
    parser.add_argument("--judge", default=JUDGE, help="the example judge_glb, built")
    arguments = parser.parse_args()
    wrong = sum(compare(path, arguments.judge) for path in arguments.garments)
    print(f"the judge is wrong about {wrong} pairs")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
