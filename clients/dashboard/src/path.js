// SPDX-License-Identifier: MIT
// Key frames on the ball in three dimensions: a mark for each, larger with its level, and between them the path as dots
// at equal times, so that they are far apart where it is fast. Colours go from the beginning to the end.
import { Color, InstancedMesh, Matrix4, MeshBasicMaterial, Quaternion, SphereGeometry, Vector3 } from "three";

import { kMaxKeyframes } from "./keyframes.js";

/** Of the sphere that they lie on, mm: outside of the pins at rest. */
const kRadius = 41;
/** What hides them, mm. */
const kShell = 35;
const kDots = 400;
/** Between two dots at least, ms. */
const kDotMs = 10;
const kBegin = new Color("#6fb1ff");
const kEnd = new Color("#ffb454");
const kChosen = new Color("#ffffff");
/** How near a pointer takes a mark, pixels. */
const kReach = { mouse: 14, pen: 14, touch: 24 };

function balls(radius, count) {
  const mesh = new InstancedMesh(new SphereGeometry(radius, 20, 14), new MeshBasicMaterial(), count);
  mesh.count = 0;
  mesh.frustumCulled = false;
  return mesh;
}

export class Path {
  /** `ball`: on which it is drawn. */
  constructor(ball) {
    this.ball = ball;
    this.marks = balls(1, kMaxKeyframes);
    this.dots = balls(0.5, kDots);
    ball.body.add(this.marks, this.dots);
    this.frames = [];
  }

  /** `keyframes`: Keyframes; `chosen`: the index of one of them, or -1. */
  show(keyframes, chosen) {
    this.frames = keyframes.frames;
    const length = Math.max(1, keyframes.length());
    const marks = this.frames.map(({ t, direction, level }, index) => ({
      direction, size: (index === chosen ? 3 : 1.4) + level, color: index === chosen ? kChosen : kBegin.clone().lerp(kEnd, t / length) }));
    const dots = [];
    const step = Math.max(kDotMs, length / kDots);
    for (let t = step; t < length && dots.length < kDots; t += step) {
      const at = keyframes.at(t);
      if (at) dots.push({ direction: at.direction, size: 0.4 + at.level, color: kBegin.clone().lerp(kEnd, t / length) });
    }
    this.fill(this.marks, marks);
    this.fill(this.dots, dots);
    this.ball.draw();
  }

  fill(mesh, items) {
    mesh.count = items.length;
    const [matrix, turn, scale] = [new Matrix4(), new Quaternion(), new Vector3()];
    items.forEach(({ direction, size, color }, i) => {
      matrix.compose(new Vector3(...direction).multiplyScalar(kRadius), turn, scale.setScalar(size));
      mesh.setMatrixAt(i, matrix);
      mesh.setColorAt(i, color);
    });
    mesh.instanceMatrix.needsUpdate = true;
    if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
  }

  world(index) {
    return this.ball.body.localToWorld(new Vector3(...this.frames[index].direction).multiplyScalar(kRadius));
  }

  /** Whether the ball is between the mark and the eye. */
  hidden(index) {
    const at = this.world(index);
    const eye = this.ball.camera.position;
    const way = at.clone().sub(eye);
    const length = way.length();
    way.normalize();
    const nearest = -eye.dot(way);
    const beside2 = eye.lengthSq() - nearest * nearest;
    return beside2 < kShell * kShell && nearest - Math.sqrt(kShell * kShell - beside2) < length;
  }

  /** Where a mark is on the screen, in the pointer's coordinates. */
  screen(index) {
    const at = this.world(index).project(this.ball.camera);
    const box = this.ball.canvas.getBoundingClientRect();
    return [box.left + ((1 + at.x) * box.width) / 2, box.top + ((1 - at.y) * box.height) / 2];
  }

  /** The index of the mark under the pointer; -1: none. Of several the nearest. */
  pick(event) {
    let nearest = kReach[event.pointerType] ?? kReach.mouse;
    let picked = -1;
    for (let index = 0; index < this.frames.length; ++index) {
      const [x, y] = this.screen(index);
      const off = Math.hypot(x - event.clientX, y - event.clientY);
      if (off > nearest || this.hidden(index)) continue;
      [nearest, picked] = [off, index];
    }
    return picked;
  }

  /** Where the pointer is on the sphere of the marks: a unit vector of the ball; null beside it. */
  directionAt(event) {
    const { origin, direction } = this.ball.ray(event).ray;
    const nearest = -origin.dot(direction);
    const half2 = kRadius * kRadius - (origin.lengthSq() - nearest * nearest);
    if (half2 < 0) return null;
    const at = origin.clone().addScaledVector(direction, nearest - Math.sqrt(half2));
    return this.ball.body.worldToLocal(at).normalize().toArray();
  }
}
