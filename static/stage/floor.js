/**
 * The floor with the soft shadow of what stands over it: its depth is drawn from below and blurred.
 */

import * as THREE from "three";

const RADIUS_M = 1.3;
const PIXELS = 256;
/** Height over the floor above which nothing darkens it [m]. */
const REACH_M = 1.1;
const DARKNESS = 0.9;
/** Widths of the blur, in shares of the floor: the second hides the steps of the first. */
const BLURS = [1 / 130, 1 / 320];

const SCREEN = `varying vec2 at; void main() { at = uv; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`;

const BLUR = `
  uniform sampler2D picture; uniform vec2 step; varying vec2 at;
  void main() {
    float sum = 0.0, weights = 0.0;
    for (int i = -6; i <= 6; i++) {
      float weight = exp(-0.08 * float(i * i));
      sum += weight * texture2D(picture, at + float(i) * step).r;
      weights += weight;
    }
    gl_FragColor = vec4(vec3(sum / weights), 1.0);
  }`;

const FLOOR = `
  uniform sampler2D picture; uniform vec3 color; varying vec2 at;
  void main() {
    float edge = 1.0 - smoothstep(0.55, 1.0, 2.0 * distance(at, vec2(0.5)));
    float shadow = texture2D(picture, vec2(at.x, 1.0 - at.y)).r;
    gl_FragColor = vec4(mix(color, color * 0.12, ${DARKNESS.toFixed(2)} * shadow), max(edge * 0.9, shadow * edge));
    #include <colorspace_fragment>
  }`;

const DEPTH = `
  varying vec4 at;
  void main() { gl_FragColor = vec4(vec3(pow(1.0 - (0.5 * at.z / at.w + 0.5), 1.3)), 1.0); }`;

const depthMaterial = () => new THREE.ShaderMaterial({
  vertexShader: "varying vec4 at; void main() { at = projectionMatrix * modelViewMatrix * vec4(position, 1.0); gl_Position = at; }",
  fragmentShader: DEPTH, side: THREE.DoubleSide,
});

/** What stands over the floor, seen from below with x to the right. */
function cameraBelow() {
  const camera = new THREE.OrthographicCamera(-RADIUS_M, RADIUS_M, RADIUS_M, -RADIUS_M, 0, REACH_M);
  camera.rotation.x = Math.PI / 2;
  return camera;
}

function blurPass() {
  const uniforms = { picture: { value: null }, step: { value: new THREE.Vector2() } };
  const material = new THREE.ShaderMaterial({ uniforms, vertexShader: SCREEN, fragmentShader: BLUR, depthTest: false });
  const scene = new THREE.Scene();
  scene.add(new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material));
  return { scene, uniforms, camera: new THREE.OrthographicCamera(-1, 1, 1, -1, -1, 1) };
}

/**
 * The floor: `mesh`, `moveTo(height)`, `setColor(color)`, and `darken(renderer, scene)` for when its
 * shadow changed.
 */
export function createFloor() {
  const [shadow, blurred] = [0, 0].map(() => new THREE.WebGLRenderTarget(PIXELS, PIXELS));
  const uniforms = { picture: { value: shadow.texture }, color: { value: new THREE.Color() } };
  const material = new THREE.ShaderMaterial({ uniforms, vertexShader: SCREEN, fragmentShader: FLOOR, transparent: true, depthWrite: false });
  const mesh = new THREE.Mesh(new THREE.CircleGeometry(RADIUS_M, 64), material);
  mesh.rotation.x = -Math.PI / 2;
  // Behind all else that is transparent.
  mesh.renderOrder = -1;
  const [below, depth, pass] = [cameraBelow(), depthMaterial(), blurPass()];

  const blur = (renderer, from, to, [x, y]) => {
    pass.uniforms.picture.value = from.texture;
    pass.uniforms.step.value.set(x / 6, y / 6);
    renderer.setRenderTarget(to);
    renderer.render(pass.scene, pass.camera);
  };
  return {
    mesh,
    /** Puts the floor at a height [m]. */
    moveTo(height) {
      mesh.position.y = height;
      below.position.y = height;
    },
    setColor: (color) => uniforms.color.value.set(color),
    darken(renderer, scene) {
      const hidden = scene.children.filter((child) => child.visible && !child.userData.castsOnFloor);
      for (const child of hidden) child.visible = false;
      scene.overrideMaterial = depth;
      renderer.setRenderTarget(shadow);
      renderer.setClearColor(0x000000, 1);
      renderer.clear();
      renderer.render(scene, below);
      scene.overrideMaterial = null;
      for (const child of hidden) child.visible = true;
      for (const width of BLURS) {
        blur(renderer, shadow, blurred, [width * 6, 0]);
        blur(renderer, blurred, shadow, [0, width * 6]);
      }
      renderer.setRenderTarget(null);
      renderer.setClearColor(0x000000, 0);
    },
  };
}
