/** Lines round the garment: where a height cuts it, and its free borders. */

import * as THREE from "three";
import { panelOfMesh } from "./cloth.js";

/** Points in one cell of this size are one: panels meet there [m]. */
const CELL_M = 5e-5;
/** Cells each way, of which three coordinates make one whole number that is exact. */
const CELLS = 2 ** 17;
/** Rings whose middle is further to a side than this are of an arm or a leg [m]. */
const ASIDE_M = 0.03;

const cellOf = (x) => Math.round(x / CELL_M) + CELLS / 2;

/** Triangles of all panels over common vertices: `{points, triangles}`, each corner by number. */
function surfaceOf(meshes) {
  const numbers = new Map();
  const points = [];
  const triangles = [];
  for (const mesh of meshes) {
    const { position } = mesh.geometry.attributes;
    const own = Array.from({ length: position.count }, (_, i) => {
      const at = new THREE.Vector3().fromBufferAttribute(position, i);
      const cell = (cellOf(at.x) * CELLS + cellOf(at.y)) * CELLS + cellOf(at.z);
      if (!numbers.has(cell)) numbers.set(cell, points.push(at) - 1);
      return numbers.get(cell);
    });
    const [panel, index] = [panelOfMesh(mesh), mesh.geometry.index.array];
    for (let i = 0; i < index.length; i += 3) triangles.push({ panel, corners: [own[index[i]], own[index[i + 1]], own[index[i + 2]]] });
  }
  return { points, triangles };
}

const edgesOf = ([a, b, c]) => [[a, b], [b, c], [c, a]];
const keyOf = ([a, b]) => Math.min(a, b) * CELLS + Math.max(a, b);

/** Segments `{ends: [key, key], …}` in lists of those that hang together. */
function partedRings(segments) {
  const parents = new Map();
  const rootOf = (key) => {
    let root = key;
    while (parents.get(root) !== root) root = parents.get(root);
    return root;
  };
  for (const { ends } of segments) {
    for (const end of ends) if (!parents.has(end)) parents.set(end, end);
    parents.set(rootOf(ends[0]), rootOf(ends[1]));
  }
  return [...Map.groupBy(segments, ({ ends }) => rootOf(ends[0])).values()];
}

const middleX = (ring) => ring.reduce((sum, { line: [a, b] }) => sum + a.x + b.x, 0) / (2 * ring.length);
const lengthOf = (ring) => ring.reduce((sum, { line: [a, b] }) => sum + a.distanceTo(b), 0);
const heightOf = (ring) => ring.reduce((sum, { line: [a, b] }) => sum + a.y + b.y, 0) / (2 * ring.length);
const linesOf = (rings) => rings.flat().map(({ line }) => line);

function cut({ points, triangles }, height) {
  const pointOn = ([a, b]) => points[a].clone().lerp(points[b], (height - points[a].y) / (points[b].y - points[a].y));
  const below = points.map(({ y }) => y < height);
  const isCut = ({ corners: [a, b, c] }) => below[a] !== below[b] || below[b] !== below[c];
  return triangles.filter(isCut).map(({ corners }) => edgesOf(corners).filter(([a, b]) => below[a] !== below[b]))
    .map((edges) => ({ ends: edges.map(keyOf), line: edges.map(pointOn) }));
}

/** Lines where a height cuts the cloth round a place of the body, as `left thigh` or `waist`. */
export function girthLines(meshes, { at, height_m: height }) {
  const rings = partedRings(cut(surfaceOf(meshes), height));
  const side = at.startsWith("left") ? 1 : at.startsWith("right") ? -1 : 0;
  const isThere = (ring) => (side === 0 ? Math.abs(middleX(ring)) <= ASIDE_M : side * middleX(ring) > ASIDE_M);
  const there = rings.filter(isThere);
  return linesOf(there.length > 0 ? there : rings);
}

/** Free borders of the sewn garment, each with its panels. */
function borders({ points, triangles }) {
  const found = new Map();
  for (const { panel, corners } of triangles) for (const edge of edgesOf(corners)) {
    const key = keyOf(edge);
    if (!found.delete(key)) found.set(key, { panel, ends: edge, line: edge.map((i) => points[i]) });
  }
  return partedRings([...found.values()]);
}

/** Lines of the opening of a report: the free border of its panels that is most like it. */
export function openingLines(meshes, { panels, height_m: height, length_m: length }) {
  const unlike = (ring) => Math.abs(heightOf(ring) - height) + Math.abs(lengthOf(ring) - length) / 4;
  const own = borders(surfaceOf(meshes)).filter((ring) => ring.some(({ panel }) => panels.includes(panel)));
  return linesOf(own.sort((a, b) => unlike(a) - unlike(b)).slice(0, 1));
}
