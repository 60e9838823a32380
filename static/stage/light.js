/**
 * Light of the stage: that of a neutral room as spherical harmonics, which costs no more than a
 * lamp, and two lamps for shadows and gloss.
 */

import * as THREE from "three";

/** Radiance of the walls. */
const WALL = 0.44;
/** Lamps of the room: direction from the middle, and radiance times solid angle. */
const WINDOWS = [
  { from: [0, 1, 0.15], light: 2.6 },
  { from: [-0.9, 0.35, 0.5], light: 1.5 },
  { from: [0.9, 0.2, -0.2], light: 0.9 },
  { from: [0.1, 0.15, -1], light: 0.8 },
  // The floor takes what the ceiling gives.
  { from: [0, -1, 0], light: -0.9 },
];

/** The light of a room that reaches a point from all sides, projected on the basis. */
function room() {
  const probe = new THREE.LightProbe();
  const basis = new Array(9).fill(0);
  const add = (from, light) => {
    THREE.SphericalHarmonics3.getBasisAt(new THREE.Vector3(...from).normalize(), basis);
    probe.sh.coefficients.forEach((coefficient, i) => coefficient.addScalar(light * basis[i]));
  };
  for (const { from, light } of WINDOWS) add(from, light);
  probe.sh.coefficients[0].addScalar(WALL * Math.sqrt(4 * Math.PI));
  return probe;
}

/** The lamp from above, on the left of the viewer, which casts shadows. */
function keyLight() {
  const key = new THREE.DirectionalLight(0xfff8f0, 1.2);
  key.position.set(-1.4, 3.1, 2.3);
  key.castShadow = true;
  key.shadow.mapSize.set(1024, 1024);
  Object.assign(key.shadow.camera, { left: -1.2, right: 1.2, top: 1.4, bottom: -1.4, near: 0.5, far: 7 });
  key.shadow.normalBias = 0.012;
  key.target.position.set(0, 0.9, 0);
  return [key, key.target];
}

/** The lamp behind, which draws the outline of what is dark. */
function rimLight() {
  const rim = new THREE.DirectionalLight(0xe8f0ff, 0.7);
  rim.position.set(2.2, 1.8, -2.4);
  return rim;
}

export const lights = () => [room(), ...keyLight(), rimLight()];
