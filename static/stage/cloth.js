/** Cloth and body as they are drawn: materials, shadows, borders of panels. */

import * as THREE from "three";

/** Muted cloth colors, one for each fabric in the garment. */
const CLOTH = [0x8fa9bf, 0xc79a86, 0x9db08e, 0xb9a3c4, 0xc9b37e, 0x86b1ad];
const BODY = 0xc4bcb2;

/**
 * The body is drawn some 3 mm further away, so that its facets do not show through cloth that lies
 * on it. The report has the true depth.
 */
const BODY_BEHIND = { polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 600 };
const CLOTH_BEHIND = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
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

/** An angle that no fold reaches leaves the border of the panel. */
const borderOf = (mesh) => new THREE.LineSegments(
  new THREE.EdgesGeometry(mesh.geometry, 179),
  new THREE.LineBasicMaterial({ color: SEAM_LINE, transparent: true, opacity: 0.45 }),
);

/** Cloth from the loaded file: both faces, colored by fabric, borders of panels drawn. */
export function dress(model) {
  const fabrics = [];
  for (const mesh of meshesIn(model)) {
    const { name, map } = mesh.material;
    if (!fabrics.includes(name)) fabrics.push(name);
    const color = map ? 0xffffff : CLOTH[fabrics.indexOf(name) % CLOTH.length];
    mesh.material = new THREE.MeshStandardMaterial({ name, map, color, roughness: 0.9, side: THREE.DoubleSide, ...CLOTH_BEHIND });
    mesh.userData.cloth = mesh.material;
    prepare(mesh);
    mesh.add(borderOf(mesh));
  }
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
