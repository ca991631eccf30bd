// SPDX-License-Identifier: MIT
// The scenes as they come, made smooth: what is drawn lies a moment back, between two of them.
import { Quaternion, Vector3 } from "three";

/** A little more than two scenes, so that one that comes late is not missed, ms. */
const kBehindMs = 40;
const kMost = 12;
/** A car does not move so far in a frame, m: it was put there. */
const kJump = 3;

const kFrom = new Quaternion();
const kTo = new Quaternion();

/** [w, x, y, z] as the game says it. */
export const turnOf = ([w, x, y, z], into = new Quaternion()) => into.set(x, y, z, w);

export class Frames {
  constructor() {
    this.clear();
  }

  clear() {
    this.scenes = [];
    this.offset = null;
  }

  add(scene) {
    const now = performance.now();
    const last = this.scenes.at(-1);
    if (last && scene.time_s < last.time_s) this.clear();
    const offset = now - 1000 * scene.time_s;
    // The quickest way here is the true one; a pause of the game moves it slowly back.
    this.offset = this.offset === null || Math.abs(offset - this.offset) > 250
      ? offset : Math.min(offset, this.offset + 0.5);
    if (scene.time_s === this.scenes.at(-1)?.time_s) this.scenes.pop();
    this.scenes.push(scene);
    if (this.scenes.length > kMost) this.scenes.shift();
  }

  /** {from, to, share}: what to draw now; null: nothing is known. */
  now() {
    if (this.scenes.length === 0) return null;
    const time = (performance.now() - this.offset - kBehindMs) / 1000;
    let i = this.scenes.length - 1;
    while (i > 0 && this.scenes[i - 1].time_s > time) --i;
    const to = this.scenes[i];
    const from = this.scenes[Math.max(0, i - 1)];
    const gap = to.time_s - from.time_s;
    const jumped = Math.hypot(...to.car.at.map((x, k) => x - from.car.at[k])) > kJump;
    const share = gap > 0 && !jumped ? Math.min(1, Math.max(0, (time - from.time_s) / gap)) : 1;
    return { from, to, share };
  }
}

/** Puts `object` between two poses of the game. */
export function place(object, from, to, share) {
  object.position.set(...from.at).lerp(new Vector3(...to.at), share);
  object.quaternion.slerpQuaternions(turnOf(from.turn, kFrom), turnOf(to.turn, kTo), share);
}
