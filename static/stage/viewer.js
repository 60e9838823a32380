/** Garment and body on the stage: shown, styled, mapped, marked and probed. */

import { GLTFLoader } from "../node_modules/three/examples/jsm/loaders/GLTFLoader.js";
import { dispose, dress, dressBody, meshesIn, panelOfMesh, restyle } from "./cloth.js";
import { litLines } from "./lit.js";
import { extentOf, mapMaterial, setValues, valueAt } from "./mapped.js";
import { marksAt } from "./marks.js";
import { girthLines, openingLines } from "./rings.js";
import { StageScene } from "./scene.js";

/** Cloth this little behind the body is looked at all the same: it lies on it [m]. */
const ON_BODY_M = 0.01;

export class Viewer extends StageScene {
  #isFirst = true;

  /** The model of a file, to be shown as body or garment. */
  async read(bytes) {
    return (await new GLTFLoader().parseAsync(bytes, "")).scene;
  }

  setBodyVisible(visible) {
    this.body.visible = visible;
    this.reshape();
  }

  showBody(model) {
    dispose(this.body);
    if (model) {
      dressBody(model);
      this.body.add(model);
    }
    this.reshape();
  }

  /** Shows a garment. The camera stays where it was when it is sewn again. */
  showGarment(model, lookOf) {
    dispose(this.garment);
    dress(model, lookOf);
    this.garment.add(model);
    if (this.#isFirst) this.look("whole");
    this.#isFirst = false;
    this.reshape();
  }

  clear() {
    dispose(this.garment);
    dispose(this.marks);
    this.#isFirst = true;
    this.reshape();
  }

  /** Gives the cloth the looks that `lookOf(panel)` says. */
  restyle(lookOf) {
    restyle(meshesIn(this.garment), lookOf);
    this.draw();
  }

  /** Colors the cloth by a map, or as it is with null: the range of the colors, or null. */
  showMap(map) {
    const meshes = meshesIn(this.garment);
    const isMapped = map !== null && meshes.length > 0 && setValues(meshes, map);
    const range = isMapped ? map.range(extentOf(meshes)) : null;
    const material = isMapped ? mapMaterial({ ...map, range }) : null;
    for (const old of new Set(meshes.map((mesh) => mesh.material))) if (old.isShaderMaterial) old.dispose();
    for (const mesh of meshes) mesh.material = material ?? mesh.userData.cloth;
    this.draw();
    return range;
  }

  /** The panel at a point of the canvas [px], with its value on the shown map; null if none. */
  probe(x, y) {
    const [hit, before] = [this.garment, this.body].map((group) => this.hitIn(group, x, y));
    if (!hit || (before && before.distance < hit.distance - ON_BODY_M)) return null;
    return { panel: panelOfMesh(hit.object), value: hit.object.material.isShaderMaterial ? valueAt(hit) : null };
  }

  /** Marks places by kind, `{cloth: [[x, y, z]…], body: […]}`, and lights what is asked for. */
  mark(places, { girth, opening } = {}) {
    const { garment, marks } = this;
    dispose(marks);
    for (const [kind, at] of Object.entries(places)) {
      if (at.length > 0) marks.add(marksAt(at, kind, this.renderer.getPixelRatio()));
    }
    if (girth) marks.add(...litLines(girthLines(meshesIn(garment), girth)));
    if (opening) marks.add(...litLines(openingLines(meshesIn(garment), opening)));
    this.draw();
  }
}
