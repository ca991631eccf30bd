// SPDX-License-Identifier: MIT
// The camera behind the car: it follows where the car heads, not how it rolls, and takes its time.
import { Vector3 } from "three";

const kBehind = 7.6;
const kAbove = 3.1;
const kAhead = 5;
/** Shares of the way that are left after a second. */
const kPlaceLag = 0.004;
const kLookLag = 0.0006;
const kJump = 25;

export class Chase {
  constructor(camera) {
    this.camera = camera;
    this.target = new Vector3();
    this.heading = new Vector3(1, 0, 0);
    this.fresh = true;
  }

  follow(car, speed, seconds) {
    const front = new Vector3(1, 0, 0).applyQuaternion(car.quaternion).setZ(0);
    if (front.length() > 0.35) this.heading.lerp(front.normalize(), 1 - 0.003 ** seconds).normalize();
    const back = kBehind + Math.min(3, 0.06 * Math.abs(speed));
    const place = car.position.clone().addScaledVector(this.heading, -back);
    place.z = Math.max(car.position.z, 0.3) + kAbove;
    const target = car.position.clone().addScaledVector(this.heading, kAhead);
    target.z = car.position.z + 0.4;
    if (this.fresh || this.camera.position.distanceTo(place) > kJump) {
      this.heading.copy(front.lengthSq() > 0.1 ? front : this.heading).normalize();
      this.camera.position.copy(car.position).addScaledVector(this.heading, -back).setZ(place.z);
      this.target.copy(target);
      this.fresh = false;
    }
    this.camera.position.lerp(place, 1 - kPlaceLag ** seconds);
    this.target.lerp(target, 1 - kLookLag ** seconds);
    this.camera.lookAt(this.target);
  }
}
