// SPDX-License-Identifier: MIT
// A blow at the car, drawn where it was felt: an arrow that points at the place, larger the harder, fading as the mark on the
// ball does.
import { ConeGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, Vector3 } from "three";

const kFadeMs = 900;
const kKinds = ["hit", "landing"];
/** Between the car's box and the tip, m. */
const kGap = 0.15;

const kAlong = new Vector3(0, 0, 1);

export class Impact {
  /** `body`: the car's group, in whose frame directions are; `size`: as the track tells the car's. */
  constructor(body, { half, lift }) {
    this.half = half;
    this.lift = lift;
    this.until = -Infinity;
    // Seen through the car, too: most is behind it from where the camera is.
    this.material = new MeshBasicMaterial({ color: "#ffb454", transparent: true, depthTest: false, depthWrite: false, toneMapped: false });
    this.mark = new Group();
    const tip = new Mesh(new ConeGeometry(0.24, 0.6, 20).rotateX(-Math.PI / 2).translate(0, 0, 0.3), this.material);
    const shaft = new Mesh(new CylinderGeometry(0.08, 0.08, 1, 12).rotateX(Math.PI / 2).translate(0, 0, 1.1), this.material);
    for (const part of [tip, shaft]) part.renderOrder = 5;
    this.mark.add(tip, shaft);
    this.mark.visible = false;
    body.add(this.mark);
  }

  felt({ kind, direction, strength }) {
    if (!kKinds.includes(kind)) return;
    const out = new Vector3(...direction);
    if (out.lengthSq() < 1e-6) return;
    out.normalize();
    // From the middle of the box to its surface.
    const reach = 1 / Math.max(...out.toArray().map((part, i) => Math.abs(part) / this.half[i]));
    this.mark.position.copy(out).multiplyScalar(reach + kGap);
    this.mark.position.z += this.lift;
    this.mark.quaternion.setFromUnitVectors(kAlong, out);
    this.mark.scale.setScalar(0.7 + 0.9 * strength);
    this.until = performance.now() + kFadeMs;
  }

  /** To be called each frame. */
  show() {
    const left = (this.until - performance.now()) / kFadeMs;
    this.mark.visible = left > 0;
    this.material.opacity = Math.min(1, 2 * Math.max(0, left));
  }
}
