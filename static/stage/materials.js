/**
 * Materials of cloth by kind: how rough, how much of a sheen, which weave near by; the inside is
 * lighter than the outside.
 */

import * as THREE from "three";

const BEHIND = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };

/** Roughness and sheen by kind; `weave` as a pattern of threads, `thread` their distance [m]. */
const KINDS = {
  woven: { roughness: 0.88, sheen: 0.15, weave: "plain", thread: 0.0012 },
  knit: { roughness: 1, sheen: 0.5, weave: "columns", thread: 0.0022 },
  fleece: { roughness: 1, sheen: 1, weave: "none", thread: 1 },
  denim: { roughness: 0.95, sheen: 0.1, weave: "diagonal", thread: 0.0026 },
  satin: { roughness: 0.36, sheen: 0.6, weave: "none", thread: 1 },
  sheer: { roughness: 0.7, sheen: 0.3, weave: "plain", thread: 0.001, opacity: 0.66 },
  leather: { roughness: 0.48, sheen: 0, weave: "none", thread: 1 },
};

/** Depth of the threads as shade, from -1 to 1 over a cell of the weave. */
const WEAVES = {
  none: "0.0",
  plain: "sin(cell.x) * sin(cell.y)",
  columns: "sin(cell.x + 0.9 * abs(sin(0.5 * cell.y)))",
  diagonal: "sin(cell.x + cell.y)",
};
const WEAVE_DEPTH = { plain: 0.1, columns: 0.16, diagonal: 0.24, none: 0 };
const INSIDE_LIGHTER = 0.42;

/** Threads fade where they are finer than the pixels; the inside is mixed with white. */
const surface = ({ weave, thread }) => `
  #include <color_fragment>
  vec2 cell = vUv * ${(2 * Math.PI / thread).toFixed(1)};
  float fine = clamp(1.6 - length(fwidth(cell)), 0.0, 1.0);
  diffuseColor.rgb *= 1.0 + ${WEAVE_DEPTH[weave].toFixed(2)} * fine * (${WEAVES[weave]});
  if (!gl_FrontFacing) diffuseColor.rgb = mix(diffuseColor.rgb, vec3(0.9), ${INSIDE_LIGHTER});`;

/** The material of a look; a print of the file goes before its color. */
export function clothMaterial({ kind, color }, map) {
  const { roughness, sheen, opacity = 1, ...threads } = KINDS[kind];
  const material = new THREE.MeshPhysicalMaterial({
    map, color: map ? 0xffffff : color, roughness, sheen, sheenRoughness: 0.55, side: THREE.DoubleSide,
    sheenColor: new THREE.Color(color).lerp(new THREE.Color(0xffffff), 0.5), opacity, transparent: opacity < 1, ...BEHIND,
  });
  material.defines.USE_UV = "";
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace("#include <color_fragment>", surface(threads));
  };
  material.customProgramCacheKey = () => kind;
  return material;
}
