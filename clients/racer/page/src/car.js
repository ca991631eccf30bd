// SPDX-License-Identifier: MIT
// The car: a low buggy of a few boxes, with wheels that steer and turn as the game says.
import {
  BoxGeometry, BufferGeometry, CylinderGeometry, Float32BufferAttribute, Group, Mesh, MeshStandardMaterial,
} from "three";

import { place } from "./frames.js";

const kPaint = "#ff9d3c";
const kDark = "#1b2333";

/** A box whose upper face is smaller and moved: [front, back, side] of the lower and the upper face. */
function wedge(low, high, bottom, top) {
  const corner = ([front, back, side], z) => [[front, side, z], [front, -side, z], [back, -side, z], [back, side, z]];
  const points = [...corner(low, bottom), ...corner(high, top)];
  const faces = [[0, 1, 2, 3], [7, 6, 5, 4], [4, 5, 1, 0], [5, 6, 2, 1], [6, 7, 3, 2], [7, 4, 0, 3]];
  const flat = faces.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]).flatMap((i) => points[i]);
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(flat, 3));
  geometry.computeVertexNormals();
  return geometry;
}

function wheelOf(radius, width) {
  const wheel = new Group();
  const tyre = new Mesh(new CylinderGeometry(radius, radius, width, 18),
    new MeshStandardMaterial({ color: "#12161f", roughness: 0.95, flatShading: true }));
  const rim = new Mesh(new CylinderGeometry(0.58 * radius, 0.58 * radius, width + 0.02, 5),
    new MeshStandardMaterial({ color: "#c3cddd", roughness: 0.4, metalness: 0.3, flatShading: true }));
  tyre.castShadow = true;
  wheel.add(tyre, rim);
  return wheel;
}

export class Car {
  constructor({ half: [x, y, z], lift, wheel_radius: radius, wheel_width: width }) {
    this.body = new Group();
    this.lights = new MeshStandardMaterial({ color: "#5a1820", emissive: "#ff3344", emissiveIntensity: 0.25 });
    const paint = new MeshStandardMaterial({ color: kPaint, roughness: 0.45, metalness: 0.1, flatShading: true });
    const dark = new MeshStandardMaterial({ color: kDark, roughness: 0.6, flatShading: true });
    const glass = new MeshStandardMaterial({ color: "#7fa6d8", roughness: 0.15, metalness: 0.4, flatShading: true });
    const low = lift - z;
    const part = (geometry, material, at = [0, 0, 0]) => {
      const mesh = new Mesh(geometry, material);
      mesh.position.set(...at);
      mesh.castShadow = true;
      this.body.add(mesh);
    };
    part(wedge([x, -x, 0.62 * y], [x, -x, 0.62 * y], low, low + 0.14), dark);
    part(wedge([x, -x, 0.66 * y], [0.45 * x, -0.96 * x, 0.6 * y], low + 0.14, lift + 0.4 * z), paint);
    part(wedge([0.4 * x, -0.85 * x, 0.58 * y], [0.02 * x, -0.62 * x, 0.42 * y], lift + 0.4 * z, lift + 1.7 * z), glass);
    part(wedge([0.03 * x, -0.63 * x, 0.44 * y], [0, -0.6 * x, 0.4 * y], lift + 1.7 * z, lift + 1.85 * z), paint);
    part(new BoxGeometry(0.34, 1.9 * y, 0.07), dark, [-0.93 * x, 0, lift + 1.55 * z]);
    for (const side of [1, -1]) {
      part(new BoxGeometry(0.1, 0.08, 0.55), dark, [-0.9 * x, side * 0.5 * y, lift + 0.8 * z]);
      part(new BoxGeometry(0.9, 0.26, 0.07), paint, [1.14, side * 0.95 * y, 0.22]);
      part(new BoxGeometry(0.9, 0.26, 0.07), paint, [-1.14, side * 0.95 * y, 0.22]);
      part(new BoxGeometry(0.06, 0.34, 0.12), this.lights, [-x - 0.01, side * 0.42 * y, lift]);
      part(new BoxGeometry(0.06, 0.26, 0.1), new MeshStandardMaterial({ color: "#fff2d6", emissive: "#ffe2a8", emissiveIntensity: 1.2 }),
        [x - 0.02, side * 0.45 * y, lift - 0.45 * z]);
    }
    this.wheels = [0, 1, 2, 3].map(() => wheelOf(radius, width));
  }

  addTo(scene) {
    scene.add(this.body, ...this.wheels);
  }

  show({ from, to, share }) {
    place(this.body, from.car, to.car, share);
    this.wheels.forEach((wheel, i) => place(wheel, from.wheels[i], to.wheels[i], share));
    this.lights.emissiveIntensity = to.brake > 0.05 ? 2.2 : 0.25;
  }
}
