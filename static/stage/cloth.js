/** Cloth and body as they are drawn: materials, shadows, borders of panels. */

import * as THREE from "three";
import { clothMaterial } from "./materials.js";

const BODY = 0xc4bcb2;

/**
 * The body is drawn some 3 mm further away, so that its facets do not show through cloth that lies
 * on it. The report has the true depth.
 */
const BODY_BEHIND = { polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 600 };
const SEAM_LINE = 0x2c3338;

export function meshesIn(model) {
  const meshes = [];
  model.traverse((object) => object.isMesh && meshes.push(object));
  return meshes;
}

function prepare(mesh) {
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  if (!mesh.geometry.attributes.normal) mesh.geometry.computeVertexNormals();
}

/** Pairs of vertices of the edges that only one triangle has. */
function freeEdges({ index, attributes: { position } }) {
  const free = new Map();
  const { array } = index;
  for (let i = 0; i < array.length; i++) {
    const [a, b] = [array[i], array[i % 3 === 2 ? i - 2 : i + 1]];
    const key = Math.min(a, b) * position.count + Math.max(a, b);
    if (!free.delete(key)) free.set(key, [a, b]);
  }
  return [...free.values()].flat();
}

/** The border of a panel, as lines over its own vertices. */
function borderOf({ geometry }) {
  const border = new THREE.BufferGeometry();
  border.setAttribute("position", geometry.attributes.position);
  border.setIndex(freeEdges(geometry));
  return new THREE.LineSegments(border, new THREE.LineBasicMaterial({ color: SEAM_LINE, transparent: true, opacity: 0.45 }));
}

/** The id of the panel that a mesh is. */
export const panelOfMesh = (mesh) => mesh.userData.panel ?? mesh.name;

/** Gives the panels the looks that they have now. */
export function restyle(meshes, lookOf) {
  for (const mesh of meshes) {
    const before = mesh.userData.cloth;
    const cloth = clothMaterial(lookOf(panelOfMesh(mesh)), mesh.userData.print);
    if (mesh.material === before) mesh.material = cloth;
    mesh.userData.cloth = cloth;
    before.dispose();
  }
}

/** Cloth from the loaded file: looks by panel, borders of panels drawn. */
export function dress(model, lookOf) {
  const meshes = meshesIn(model);
  for (const mesh of meshes) {
    mesh.userData.print = mesh.material.map;
    mesh.userData.cloth = mesh.material;
    prepare(mesh);
    mesh.add(borderOf(mesh));
  }
  restyle(meshes, lookOf);
}

export function dressBody(model) {
  for (const mesh of meshesIn(model)) {
    mesh.material = new THREE.MeshStandardMaterial({ color: BODY, roughness: 0.82, ...BODY_BEHIND });
    prepare(mesh);
  }
}

/** Frees what the graphics card holds of a group, and empties it. */
export function dispose(group) {
  group.traverse((object) => {
    object.geometry?.dispose();
    object.material?.dispose();
    object.userData.cloth?.dispose();
  });
  group.clear();
}
