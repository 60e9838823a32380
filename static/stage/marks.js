/**
 * Marks on the stage, seen through all that is before them: rings where cloth crosses cloth,
 * squares where it crosses the body.
 */

import * as THREE from "three";

/** Size on the screen [px]. */
const SIZE = 26;
const COLORS = { cloth: 0xd0342c, body: 0xd0342c, lit: 0x1a56db };
const PICTURE = 64;

/** The sign of a mark, white round its line, so that it is seen on any cloth. */
const SIGNS = {
  cloth: (pen) => pen.arc(32, 32, 20, 0, 2 * Math.PI),
  body: (pen) => pen.rect(14, 14, 36, 36),
  lit: (pen) => pen.arc(32, 32, 22, 0, 2 * Math.PI),
};

function signOf(kind) {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = PICTURE;
  const pen = canvas.getContext("2d");
  for (const [width, color] of [[13, "#ffffff"], [7, `#${COLORS[kind].toString(16).padStart(6, "0")}`]]) {
    pen.beginPath();
    SIGNS[kind](pen);
    pen.lineWidth = width;
    pen.strokeStyle = color;
    pen.stroke();
  }
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  return texture;
}

const signs = new Map();

function materialOf(kind, ratio) {
  if (!signs.has(kind)) signs.set(kind, signOf(kind));
  return new THREE.PointsMaterial({ map: signs.get(kind), size: SIZE * ratio, sizeAttenuation: false, transparent: true, depthTest: false, toneMapped: false });
}

/**
 * The marks at places `[x, y, z]` of one kind: `cloth`, `body`, or `lit` for what a person asked to
 * see.
 */
export function marksAt(places, kind, ratio) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(places.flat(), 3));
  const points = new THREE.Points(geometry, materialOf(kind, ratio));
  points.renderOrder = 2;
  return points;
}
