// SPDX-License-Identifier: MIT
// What stands around: sky, hills and trees, and the track as the game describes it.
import {
  BackSide, BoxGeometry, BufferGeometry, Color, ConeGeometry, CylinderGeometry, DirectionalLight, Float32BufferAttribute,
  Fog, Group, HemisphereLight, IcosahedronGeometry, InstancedMesh, Matrix4, Mesh, MeshStandardMaterial,
  Object3D, PlaneGeometry, ShaderMaterial, SphereGeometry, Vector3,
} from "three";

import { turnOf } from "./frames.js";

const kHorizon = new Color("#e0a27a");
const kZenith = new Color("#27406e");
const kFog = new Color("#a98f92");
const kSun = new Vector3(-60, 45, 60);

/** The same numbers each time: the trees stay where they are. */
function dice(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

function sky() {
  const material = new ShaderMaterial({
    side: BackSide, depthWrite: false, fog: false,
    uniforms: { low: { value: kHorizon }, high: { value: kZenith } },
    vertexShader: "varying vec3 way; void main() { way = position; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
    fragmentShader: `uniform vec3 low; uniform vec3 high; varying vec3 way;
      void main() { float h = clamp(normalize(way).z * 2.2 + 0.02, 0.0, 1.0);
        gl_FragColor = vec4(mix(low, high, pow(h, 0.6)), 1.0);
        #include <colorspace_fragment>
      }`,
  });
  return new Mesh(new SphereGeometry(900, 24, 12), material);
}

function flat(colour, more = {}) {
  return new MeshStandardMaterial({ color: colour, roughness: 0.95, flatShading: true, ...more });
}

/** A ring of low hills far away. */
function hills(middle, random) {
  const points = [];
  const count = 70;
  const heights = Array.from({ length: count }, (_, i) => 14 + 22 * random() + 16 * Math.sin(i / 5) ** 2);
  const at = (i, reach, height) => {
    const turn = (2 * Math.PI * i) / count;
    return [middle.x + reach * Math.cos(turn), middle.y + reach * Math.sin(turn), height];
  };
  for (let i = 0; i < count; ++i) {
    const [a, b] = [heights[i], heights[(i + 1) % count]];
    points.push(...at(i, 250, -1), ...at(i, 330, a), ...at(i + 1, 250, -1));
    points.push(...at(i + 1, 250, -1), ...at(i, 330, a), ...at(i + 1, 330, b));
  }
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3));
  geometry.computeVertexNormals();
  return new Mesh(geometry, flat("#4f5d74", { side: 2 }));
}

function trees(track, middle, reach, random) {
  const places = [];
  for (let tries = 0; places.length < 220 && tries < 4000; ++tries) {
    const spot = [middle.x + (2 * random() - 1) * reach, middle.y + (2 * random() - 1) * reach];
    const gap = Math.min(...track.centre.map(([x, y]) => Math.hypot(x - spot[0], y - spot[1])), Infinity);
    if (gap > 0.5 * track.width + 5) places.push([...spot, 0.7 + 0.9 * random()]);
  }
  const crown = new InstancedMesh(new ConeGeometry(1.5, 4.4, 6).rotateX(Math.PI / 2), flat("#ffffff"), places.length);
  const trunk = new InstancedMesh(new CylinderGeometry(0.2, 0.26, 1.2, 5).rotateX(Math.PI / 2), flat("#5a4538"), places.length);
  const matrix = new Matrix4();
  const greens = ["#40694f", "#4c7a56", "#37604f", "#5d8357"].map((c) => new Color(c));
  places.forEach(([x, y, size], i) => {
    matrix.makeScale(size, size, size).setPosition(x, y, 3.2 * size);
    crown.setMatrixAt(i, matrix);
    crown.setColorAt(i, greens[Math.floor(random() * greens.length)]);
    trunk.setMatrixAt(i, matrix.makeScale(size, size, size).setPosition(x, y, 0.6 * size));
  });
  return [crown, trunk];
}

/** A strip along the closed `line`: from `left` to `right` of it (metres, left is positive). */
function strip(line, left, right, z, keep = () => true) {
  const points = [];
  const n = line.length;
  const at = (i, out) => {
    const [a, b] = [line[(i + n - 1) % n], line[(i + 1) % n]];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
    const [x, y, h] = line[i % n];
    return [x - (out * (b[1] - a[1])) / length, y + (out * (b[0] - a[0])) / length, h + z];
  };
  for (let i = 0; i < n; ++i) {
    if (!keep(i)) continue;
    points.push(...at(i, left), ...at(i, right), ...at(i + 1, left));
    points.push(...at(i + 1, left), ...at(i, right), ...at(i + 1, right));
  }
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3));
  geometry.computeVertexNormals();
  return geometry;
}

function lay(geometry, colour, more) {
  const mesh = new Mesh(geometry, new MeshStandardMaterial({ color: colour, roughness: 0.9, side: 2, ...more }));
  mesh.receiveShadow = true;
  return mesh;
}

function road({ centre, width }) {
  if (centre.length < 3) return [];
  const half = 0.5 * width;
  const line = { emissive: "#dfe6f2", emissiveIntensity: 0.12 };
  const kerb = (side) => [0, 1].map((odd) => lay(
    strip(centre, side * half, side * (half - 0.55), 0.024, (i) => i % 2 === odd), odd ? "#e8edf5" : "#c9573f"));
  return [
    lay(strip(centre, half, -half, 0.012), "#4a5266"),
    lay(strip(centre, 0.08, -0.08, 0.022, (i) => i % 4 < 2), "#dfe6f2", line),
    ...kerb(1), ...kerb(-1), ...chequers(centre, half),
  ];
}

function chequers(centre, half) {
  const [a, b] = centre;
  const group = new Group();
  group.position.set(a[0], a[1], a[2] + 0.03);
  group.rotation.z = Math.atan2(b[1] - a[1], b[0] - a[0]);
  const size = 0.7;
  const count = Math.floor((2 * half) / size);
  for (let row = 0; row < 3; ++row) {
    for (let i = 0; i < count; ++i) {
      const tile = lay(new PlaneGeometry(size, size), (row + i) % 2 ? "#f2f5fa" : "#11151e");
      tile.position.set(row * size, (i - 0.5 * (count - 1)) * size, 0);
      group.add(tile);
    }
  }
  return [group];
}

function walls(list) {
  if (list.length === 0) return [];
  const solid = new InstancedMesh(new BoxGeometry(2, 2, 2), flat("#ffffff"), list.length);
  const rail = new InstancedMesh(new BoxGeometry(2, 2, 2), flat("#ffffff"), list.length);
  const thing = new Object3D();
  const colours = ["#7d8ba6", "#8d9ab3"].map((c) => new Color(c));
  const stripes = ["#d9dfe9", "#cf6a4c"].map((c) => new Color(c));
  list.forEach(({ at, turn, half }, i) => {
    turnOf(turn, thing.quaternion);
    thing.position.set(...at);
    thing.scale.set(...half);
    thing.updateMatrix();
    solid.setMatrixAt(i, thing.matrix);
    solid.setColorAt(i, colours[i % 2]);
    thing.position.z += half[2];
    thing.scale.set(half[0], half[1] * 1.15, 0.09);
    thing.updateMatrix();
    rail.setMatrixAt(i, thing.matrix);
    rail.setColorAt(i, stripes[Math.floor(i / 2) % 2]);
  });
  solid.castShadow = true;
  return [solid, rail];
}

function ramp({ at, turn, length, width, height }) {
  const y = 0.5 * width;
  const [a, b, c, d] = [[0, y, 0], [0, -y, 0], [length, -y, height], [length, y, height]];
  const [e, f] = [[length, -y, 0], [length, y, 0]];
  const faces = [[a, b, c], [a, c, d], [d, c, e], [d, e, f], [b, e, c], [a, d, f]];
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(faces.flat(2), 3));
  geometry.computeVertexNormals();
  const group = new Group();
  const wood = new Mesh(geometry, flat("#a9834f", { side: 2 }));
  wood.castShadow = true;
  wood.receiveShadow = true;
  group.add(wood);
  const slope = Math.atan2(height, length);
  // Chevrons that point up the ramp.
  for (let i = 1; i < 4; ++i) {
    for (const side of [1, -1]) {
      const bar = lay(new PlaneGeometry(0.35, 0.42 * width), "#ffd28a", { emissive: "#ffb454", emissiveIntensity: 0.25 });
      bar.position.set((length * i) / 4, side * 0.2 * width, (height * i) / 4 + 0.03);
      bar.rotation.set(0, -slope, side * 0.5, "YZX");
      group.add(bar);
    }
  }
  group.position.set(...at);
  turnOf(turn, group.quaternion);
  return group;
}

function patch({ at, turn, half }) {
  const mesh = new Mesh(new PlaneGeometry(2 * half[0], 2 * half[1], 6, 4), new MeshStandardMaterial({
    color: "#a9d4ff", roughness: 0.08, metalness: 0.25, transparent: true, opacity: 0.55, depthWrite: false,
    emissive: "#3f6fa8", emissiveIntensity: 0.25,
  }));
  mesh.position.set(at[0], at[1], 0.035);
  turnOf(turn, mesh.quaternion);
  mesh.receiveShadow = true;
  return mesh;
}

const kShapes = {
  box: ([x, y, z]) => [new BoxGeometry(2 * x, 2 * y, 2 * z), flat("#c08a52")],
  drum: ([x, , z]) => [new CylinderGeometry(x, x, 2 * z, 14).rotateX(Math.PI / 2), flat("#d8694a")],
  ball: ([x]) => [new IcosahedronGeometry(x, 2), flat("#e8c15a")],
};

function obstacle({ shape, half, at, turn }) {
  const mesh = new Mesh(...(kShapes[shape] ?? kShapes.box)(half));
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  mesh.position.set(...at);
  turnOf(turn, mesh.quaternion);
  return mesh;
}

/** Builds everything into `scene`; `obstacles` are the meshes that move, `follow(position)` each frame. */
export function buildWorld(scene, track) {
  const points = track.centre.length ? track.centre : [[-60, -60, 0], [60, 60, 0]];
  const middle = new Vector3();
  for (const p of points) middle.add(new Vector3(...p).divideScalar(points.length));
  const reach = Math.max(...points.map(([x, y]) => Math.hypot(x - middle.x, y - middle.y))) + 40;
  const random = dice(7);
  const dome = sky();
  scene.fog = new Fog(kFog, 70, 420);
  const sun = new DirectionalLight("#ffe0b8", 2.6);
  sun.castShadow = true;
  sun.shadow.mapSize.set(1024, 1024);
  Object.assign(sun.shadow.camera, { left: -32, right: 32, top: 32, bottom: -32, near: 10, far: 190 });
  sun.shadow.normalBias = 0.05;
  const above = new HemisphereLight("#b9cdf2", "#77806a", 1.6);
  above.position.set(0, 0, 1);
  const ground = lay(new PlaneGeometry(1400, 1400), "#557a5c");
  ground.position.set(middle.x, middle.y, -0.01);
  // So large that its depth is coarse: drawn first, and everything over it.
  ground.material.depthWrite = false;
  ground.renderOrder = -1;
  dome.renderOrder = -2;
  const obstacles = track.obstacles.map(obstacle);
  scene.add(dome, above, sun, sun.target, ground, hills(middle, random),
    ...trees(track, middle, reach, random), ...road(track), ...walls(track.walls), ...track.ramps.map(ramp),
    ...track.patches.map(patch), ...obstacles);
  const follow = (at) => {
    dome.position.copy(at);
    // In whole steps, so that shadows do not shimmer.
    sun.target.position.set(Math.round(at.x / 4) * 4, Math.round(at.y / 4) * 4, 0);
    sun.position.copy(sun.target.position).add(kSun);
  };
  return { obstacles, follow, sun };
}
