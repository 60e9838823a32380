/** A line that is lit on the stage: strong where it is seen, faint where something is before it. */

import * as THREE from "three";

const COLOR = 0x1a56db;
const RADIUS_M = 0.0035;
const FAINT = 0.3;

const Y = new THREE.Vector3(0, 1, 0);

function pieceOf([from, to]) {
  const along = to.clone().sub(from);
  const length = along.length();
  const turn = new THREE.Quaternion().setFromUnitVectors(Y, along.divideScalar(length || 1));
  return new THREE.Matrix4().compose(from.clone().lerp(to, 0.5), turn, new THREE.Vector3(1, length + RADIUS_M, 1));
}

function tube(pieces, faint) {
  const material = new THREE.MeshBasicMaterial({ color: COLOR, toneMapped: false, transparent: faint, opacity: faint ? FAINT : 1, depthTest: !faint });
  const mesh = new THREE.InstancedMesh(new THREE.CylinderGeometry(RADIUS_M, RADIUS_M, 1, 6, 1, true), material, pieces.length);
  for (const [i, piece] of pieces.entries()) mesh.setMatrixAt(i, piece);
  mesh.frustumCulled = false;
  return mesh;
}

/** The objects that light lines `[from, to]`. */
export function litLines(lines) {
  const pieces = lines.map(pieceOf);
  return [tube(pieces, true), tube(pieces, false)];
}
