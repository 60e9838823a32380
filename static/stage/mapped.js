/**
 * Cloth in the colors of a map: each pixel takes the color of its value, so that they are those of
 * the legend; a little shade leaves the form to be seen.
 */

import * as THREE from "three";
import { colorsOf, OVER } from "./palette.js";

const COLORS = 256;
/** Share of values at either end that a range leaves out: single vertices differ from the rest. */
const LEFT_OUT = 0.005;

const VERTEX = `
  attribute float value; varying float at; varying vec3 normal_; varying vec3 toEye;
  void main() {
    at = value;
    normal_ = normalize(normalMatrix * normal);
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    toEye = normalize(-seen.xyz);
    gl_Position = projectionMatrix * seen;
  }`;

const FRAGMENT = `
  uniform sampler2D colors; uniform vec2 range; uniform vec3 over; uniform float hasOver;
  varying float at; varying vec3 normal_; varying vec3 toEye;
  void main() {
    float share = (at - range.x) / (range.y - range.x);
    vec3 color = texture2D(colors, vec2(clamp(share, 0.002, 0.998), 0.5)).rgb;
    if (hasOver > 0.5 && share > 1.0) color = over;
    float facing = abs(dot(normalize(normal_), normalize(toEye)));
    gl_FragColor = vec4(color * mix(0.72, 1.0, smoothstep(0.0, 0.8, facing)), 1.0);
    #include <colorspace_fragment>
  }`;

function textureOf(scale) {
  const texture = new THREE.DataTexture(colorsOf(scale, COLORS), COLORS, 1);
  texture.colorSpace = THREE.SRGBColorSpace;
  texture.minFilter = texture.magFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/** The material of a map with `scale`, `range` and `hasOver`. */
export function mapMaterial({ scale, range, hasOver }) {
  const uniforms = {
    colors: { value: textureOf(scale) }, range: { value: new THREE.Vector2(...range) },
    over: { value: new THREE.Color(OVER) }, hasOver: { value: hasOver ? 1 : 0 },
  };
  const material = new THREE.ShaderMaterial({
    uniforms, vertexShader: VERTEX, fragmentShader: FRAGMENT, side: THREE.DoubleSide,
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
  });
  material.addEventListener("dispose", () => uniforms.colors.value.dispose());
  return material;
}

/** Values of a map at the vertices of a mesh; null where the file has none. */
function valuesOf(mesh, { attribute, item }) {
  const found = mesh.geometry.attributes[attribute];
  return found ? Float32Array.from({ length: found.count }, (_, i) => found.getComponent(i, item)) : null;
}

/** Gives each mesh the values of a map; false where one has none. */
export function setValues(meshes, map) {
  const all = meshes.map((mesh) => valuesOf(mesh, map));
  if (all.some((values) => values === null)) return false;
  for (const [i, mesh] of meshes.entries()) mesh.geometry.setAttribute("value", new THREE.BufferAttribute(all[i], 1));
  return true;
}

/** The ends between which nearly all values lie. */
export function extentOf(meshes) {
  const values = meshes.flatMap((mesh) => [...mesh.geometry.attributes.value.array]).sort((a, b) => a - b);
  const at = (share) => values[Math.round(share * (values.length - 1))] ?? 0;
  return [at(LEFT_OUT), at(1 - LEFT_OUT)];
}

/** The value at a hit of a ray. */
export function valueAt({ object, face, barycoord }) {
  const { value } = object.geometry.attributes;
  if (!value || !barycoord) return null;
  return value.getX(face.a) * barycoord.x + value.getX(face.b) * barycoord.y + value.getX(face.c) * barycoord.z;
}
