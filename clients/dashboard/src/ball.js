// SPDX-License-Identifier: MIT
// The ball in three dimensions. The room is the protocol's world: z up, millimetres; the ball inside turns
// with the orientation. Draws only when something has changed.
import {
  AmbientLight, CanvasTexture, Color, ConeGeometry, CylinderGeometry, DirectionalLight, Group, InstancedMesh,
  Matrix4, Mesh, MeshBasicMaterial, MeshStandardMaterial, PerspectiveCamera, Quaternion, Raycaster, RingGeometry,
  Scene, SphereGeometry, Sprite, SpriteMaterial, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const kRadius = 35;
/** From where it is seen at first, mm. */
const kDistance = 249;
/** Pins move by tenths of a millimetre, which nobody would see. */
export const kExaggeration = 25;
const kPinRadius = 4;
const kPinLength = 10;
const kRest = new Color("#8b99b2");
const kOut = new Color("#ff9a1f");
const kIn = new Color("#3d4a63");
/** Extension that is shown in the full colour, mm. */
const kStrong = 0.3;

/** What the picture must hold whichever way it is turned: the arrows to their tips. */
const kReach = 78;

const kOwnTurnMs = 600;

const z = new Vector3(0, 0, 1);

function label(text) {
  const canvas = document.createElement("canvas");
  canvas.width = 256;
  canvas.height = 64;
  const context = canvas.getContext("2d");
  context.font = "500 34px system-ui, sans-serif";
  context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--soft");
  context.textAlign = "center";
  context.fillText(text, 128, 44);
  const sprite = new Sprite(new SpriteMaterial({ map: new CanvasTexture(canvas), depthWrite: false }));
  sprite.scale.set(28, 7, 1);
  return sprite;
}

function arrow(color, width) {
  const group = new Group();
  const material = new MeshStandardMaterial({ color, emissive: color, emissiveIntensity: 0.5, roughness: 0.5 });
  const shaft = new Mesh(new CylinderGeometry(width, width, 1, 16), material);
  const tip = new Mesh(new ConeGeometry(2.4 * width, 6 * width, 20), material);
  for (const part of [shaft, tip]) part.rotation.x = Math.PI / 2;
  group.add(shaft, tip);
  group.userData = { shaft, tip, tipLength: 6 * width };
  group.visible = false;
  return group;
}

function pointArrow(group, direction, from, length) {
  const { shaft, tip, tipLength } = group.userData;
  group.quaternion.setFromUnitVectors(z, direction);
  shaft.scale.y = length;
  shaft.position.z = from + length / 2;
  tip.position.z = from + length + tipLength / 2;
}

export class Ball extends EventTarget {
  /** Dispatches `pin` (detail: its number) when one is clicked, `turn` (detail: three.Quaternion) when dragged. */
  constructor(canvas) {
    super();
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(36, 1, 10, 1000);
    this.camera.up.copy(z);
    // As the holder sees it: from behind and above, left on the left.
    this.camera.position.set(-208, -26, 134).setLength(kDistance);
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.enablePan = false;
    this.orbit.minDistance = 110;
    this.orbit.maxDistance = 400;
    this.orbit.addEventListener("change", () => this.draw());
    this.body = new Group();
    this.scene.add(this.body);
    this.light();
    this.furnish();
    this.pins = [];
    this.turning = false;
    this.turnedAt = -Infinity;
    this.listen();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.resize();
  }

  light() {
    const key = new DirectionalLight("#ffffff", 2.4);
    key.position.set(-120, 90, 160);
    const rim = new DirectionalLight("#7aa2ff", 1.4);
    rim.position.set(140, -120, -40);
    this.scene.add(new AmbientLight("#8795b5", 1.1), key, rim);
  }

  furnish() {
    const shell = new MeshStandardMaterial({ color: "#222b3c", roughness: 0.75, metalness: 0.1 });
    this.shell = new Mesh(new SphereGeometry(kRadius, 64, 40), shell);
    this.body.add(this.shell);
    // The casing's mark of the front, and the fan below.
    const front = new Mesh(new ConeGeometry(2.6, 7, 3), new MeshStandardMaterial({ color: "#6fb1ff" }));
    front.position.set(kRadius + 14, 0, 0);
    front.rotation.z = -Math.PI / 2;
    this.body.add(front);
    const fan = new Mesh(new CylinderGeometry(11, 11, 3, 32), new MeshStandardMaterial({ color: "#10151f" }));
    fan.rotation.x = Math.PI / 2;
    fan.position.z = -kRadius;
    this.body.add(fan);
    const floor = new Mesh(
      new RingGeometry(49.4, 50, 128), new MeshBasicMaterial({ color: "#2b364b", side: 2 }));
    floor.position.z = -46;
    this.scene.add(floor);
    for (const [text, x, y] of [["front", 62, 0], ["left", 0, 64], ["right", 0, -64]]) {
      const sprite = label(text);
      sprite.position.set(x, y, -46);
      this.scene.add(sprite);
    }
    this.arrow = arrow("#ffb454", 1.3);
    this.body.add(this.arrow);
    this.up = arrow("#6fe0b0", 0.7);
    this.scene.add(this.up);
    this.up.visible = false;
  }

  /** `pins`: as device.describe tells them. */
  setPins(pins) {
    if (this.mesh) {
      this.body.remove(this.mesh);
      this.mesh.dispose();
    }
    this.pins = pins.map((pin) => ({
      number: pin.pin,
      direction: new Vector3(...pin.position).normalize(),
      rest: pin.rest_mm,
      extension: 0,
    }));
    const geometry = new CylinderGeometry(kPinRadius, kPinRadius, kPinLength, 24);
    geometry.rotateX(Math.PI / 2);
    this.mesh = new InstancedMesh(
      geometry, new MeshStandardMaterial({ roughness: 0.62, metalness: 0.15 }), this.pins.length);
    this.body.add(this.mesh);
    this.place();
  }

  /** mm, by number. */
  setExtensions(extensions) {
    let changed = false;
    this.pins.forEach((pin) => {
      const next = extensions[pin.number] ?? 0;
      changed ||= Math.abs(next - pin.extension) > 1e-4;
      pin.extension = next;
    });
    if (changed) this.place();
  }

  place() {
    const matrix = new Matrix4();
    const turn = new Quaternion();
    const color = new Color();
    const one = new Vector3(1, 1, 1);
    this.pins.forEach((pin, i) => {
      // The outer end, 2.5 mm above the shell at rest.
      const end = kRadius + 2.5 + kExaggeration * pin.extension;
      const at = pin.direction.clone().multiplyScalar(end - kPinLength / 2);
      matrix.compose(at, turn.setFromUnitVectors(z, pin.direction), one);
      this.mesh.setMatrixAt(i, matrix);
      const share = Math.min(1, Math.abs(pin.extension) / kStrong);
      color.copy(kRest).lerp(pin.extension > 0 ? kOut : kIn, Math.sqrt(share));
      this.mesh.setColorAt(i, color);
    });
    this.mesh.instanceMatrix.needsUpdate = true;
    if (this.mesh.instanceColor) this.mesh.instanceColor.needsUpdate = true;
    this.mesh.computeBoundingSphere();
    this.draw();
  }

  /** `field`: unit vector in the ball, or zero; `strength`: 0 to 1 of the most. */
  setField(field, strength) {
    const direction = new Vector3(...field);
    this.arrow.visible = direction.length() > 0.5;
    if (this.arrow.visible) pointArrow(this.arrow, direction.normalize(), kRadius + 12, 4 + 18 * strength);
    this.draw();
  }

  /** The protocol's quaternion, device to world. */
  setOrientation({ w, x, y, z: k }) {
    // What the daemon says is older than what was just done here.
    if (performance.now() - this.turnedAt < kOwnTurnMs) return;
    this.body.quaternion.set(x, y, k, w);
    this.draw();
  }

  /** The room's up, for the indicator. */
  showUp() {
    this.up.visible = true;
    pointArrow(this.up, z, 50, 23);
    this.draw();
  }

  /** Dragging turns the ball instead of the view. */
  setTurning(on) {
    this.turning = on;
    this.orbit.enableRotate = !on;
    this.canvas.style.cursor = on ? "grab" : "";
  }

  /** In the ball's frame, for tests and for the caption. */
  arrowDirection() {
    return this.arrow.visible ? z.clone().applyQuaternion(this.arrow.quaternion).toArray() : null;
  }
  extension(number) {
    return this.pins.find((pin) => pin.number === number)?.extension ?? null;
  }

  /** By angles about the screen's axes, radians. */
  turnBy(right, down) {
    const view = new Vector3();
    this.camera.getWorldDirection(view);
    const side = new Vector3().crossVectors(view, z).normalize();
    const turn = new Quaternion().setFromAxisAngle(z, right);
    turn.multiply(new Quaternion().setFromAxisAngle(side, down));
    this.body.quaternion.premultiply(turn).normalize();
    this.turnedAt = performance.now();
    this.dispatchEvent(new CustomEvent("turn", { detail: this.body.quaternion }));
    this.draw();
  }

  listen() {
    let last = null;
    let moved = 0;
    this.canvas.addEventListener("pointerdown", (event) => {
      last = [event.clientX, event.clientY];
      moved = 0;
    });
    this.canvas.addEventListener("pointermove", (event) => {
      if (!last) return;
      const [dx, dy] = [event.clientX - last[0], event.clientY - last[1]];
      moved += Math.abs(dx) + Math.abs(dy);
      last = [event.clientX, event.clientY];
      if (this.turning) this.turnBy(dx * 0.01, dy * 0.01);
    });
    addEventListener("pointerup", (event) => {
      if (last && moved < 6 && event.target === this.canvas) this.click(event);
      last = null;
    });
  }

  /** A three.Raycaster from the eye through the pointer. */
  ray(event) {
    const box = this.canvas.getBoundingClientRect();
    const at = new Vector2(
      (2 * (event.clientX - box.left)) / box.width - 1, 1 - (2 * (event.clientY - box.top)) / box.height);
    const ray = new Raycaster();
    ray.setFromCamera(at, this.camera);
    return ray;
  }

  /** What of the ball is under the pointer. */
  hit(event) {
    return this.mesh && this.ray(event).intersectObjects([this.mesh, this.shell])[0];
  }

  click(event) {
    const hit = this.hit(event);
    if (hit?.object === this.mesh) {
      this.dispatchEvent(new CustomEvent("pin", { detail: this.pins[hit.instanceId].number }));
    }
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    // A tall, narrow picture must hold the whole breadth too.
    const half = Math.tan(Math.asin(kReach / kDistance));
    this.camera.fov = (2 * Math.atan(half * Math.max(1, height / width)) * 180) / Math.PI;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  draw() {
    if (this.due) return;
    this.due = requestAnimationFrame(() => {
      this.due = null;
      this.renderer.render(this.scene, this.camera);
    });
  }
}
