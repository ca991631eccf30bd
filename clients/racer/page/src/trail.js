// SPDX-License-Identifier: MIT
// What the wheels leave behind: marks where they slide, dust, and sparks where the car was hit.
import {
  AdditiveBlending, BufferGeometry, CanvasTexture, DynamicDrawUsage, Float32BufferAttribute, Mesh, MeshBasicMaterial, NormalBlending,
  Points, PointsMaterial, Vector3,
} from "three";

const kMarks = 700;
const kWide = 0.13;
const kSlides = 0.25;
const kGrains = 160;
const kDustS = 0.8;
const kSparkS = 0.45;

class Marks {
  constructor() {
    this.points = new Float32Array(kMarks * 18);
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute("position", new Float32BufferAttribute(this.points, 3).setUsage(DynamicDrawUsage));
    this.points = this.geometry.attributes.position.array;
    this.mesh = new Mesh(this.geometry, new MeshBasicMaterial({ color: "#0b0d12", transparent: true, opacity: 0.5, depthWrite: false }));
    this.mesh.frustumCulled = false;
    this.next = 0;
    this.last = [null, null, null, null];
  }

  add(wheel, at, slides) {
    const last = this.last[wheel];
    if (!slides) {
      this.last[wheel] = null;
      return;
    }
    if (last && last.distanceTo(at) < 0.25) return;
    this.last[wheel] = at.clone();
    if (!last || last.distanceTo(at) > 3) return;
    const side = at.clone().sub(last).setZ(0).normalize();
    const [sx, sy] = [-side.y * kWide, side.x * kWide];
    const corner = (p, sign) => [p.x + sign * sx, p.y + sign * sy, p.z];
    const [a, b, c, d] = [corner(last, 1), corner(last, -1), corner(at, 1), corner(at, -1)];
    this.points.set([...a, ...b, ...c, ...c, ...b, ...d], this.next * 18);
    this.next = (this.next + 1) % kMarks;
    this.geometry.attributes.position.needsUpdate = true;
  }
}

class Grains {
  constructor(material, life, fall) {
    this.life = life;
    this.fall = fall;
    this.ways = Array.from({ length: kGrains }, () => ({ way: new Vector3(), left: 0 }));
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute("position", new Float32BufferAttribute(new Float32Array(kGrains * 3).fill(-99), 3));
    this.mesh = new Points(this.geometry, material);
    this.mesh.frustumCulled = false;
    this.next = 0;
  }

  throw(at, way) {
    this.ways[this.next] = { way, left: this.life };
    this.geometry.attributes.position.setXYZ(this.next, at.x, at.y, at.z);
    this.next = (this.next + 1) % kGrains;
  }

  step(seconds) {
    const { position } = this.geometry.attributes;
    this.ways.forEach((grain, i) => {
      if (grain.left <= 0) return;
      grain.left -= seconds;
      grain.way.z -= this.fall * seconds;
      const z = grain.left > 0 ? Math.max(0.05, position.getZ(i) + grain.way.z * seconds) : -99;
      position.setXYZ(i, position.getX(i) + grain.way.x * seconds, position.getY(i) + grain.way.y * seconds, z);
    });
    position.needsUpdate = true;
  }
}

const spread = (size) => (Math.random() - 0.5) * size;

/** A soft round spot. */
function spot() {
  const canvas = Object.assign(document.createElement("canvas"), { width: 32, height: 32 });
  const context = canvas.getContext("2d");
  const fade = context.createRadialGradient(16, 16, 2, 16, 16, 16);
  fade.addColorStop(0, "#fff");
  fade.addColorStop(1, "#fff0");
  context.fillStyle = fade;
  context.fillRect(0, 0, 32, 32);
  return new CanvasTexture(canvas);
}

export class Trail {
  constructor(scene, wheelRadius) {
    this.radius = wheelRadius;
    this.marks = new Marks();
    const map = spot();
    this.dust = new Grains(new PointsMaterial({ map, color: "#d9c9b4", size: 0.9, transparent: true, opacity: 0.35,
      depthWrite: false, blending: NormalBlending }), kDustS, -0.4);
    this.sparks = new Grains(new PointsMaterial({ map, color: "#ffc36b", size: 0.24, transparent: true, opacity: 0.95,
      depthWrite: false, blending: AdditiveBlending }), kSparkS, 9);
    scene.add(this.marks.mesh, this.dust.mesh, this.sparks.mesh);
  }

  show(wheels, meshes, seconds) {
    wheels.forEach(({ skid, contact }, i) => {
      const at = meshes[i].position.clone();
      at.z = Math.max(0.05, at.z - this.radius + 0.05);
      const slides = contact && skid > kSlides;
      this.marks.add(i, at, slides);
      if (slides && Math.random() < skid) this.dust.throw(at, new Vector3(spread(1.6), spread(1.6), 0.5 + Math.random()));
    });
    this.dust.step(seconds);
    this.sparks.step(seconds);
  }

  /** `direction` in the car's frame. */
  hit(car, direction, strength) {
    const out = new Vector3(...direction).applyQuaternion(car.quaternion);
    const at = car.position.clone().addScaledVector(out, 1.3);
    for (let i = 0; i < 6 + 24 * strength; ++i) {
      this.sparks.throw(at, out.clone().multiplyScalar(-3).add(new Vector3(spread(5), spread(5), 1 + 3 * Math.random())));
    }
  }
}
