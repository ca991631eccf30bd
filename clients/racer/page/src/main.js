// SPDX-License-Identifier: MIT
// The page of the game: draws what the game tells, says what the hands do.
import { ACESFilmicToneMapping, PCFShadowMap, PerspectiveCamera, Scene, WebGLRenderer } from "three";

import { Impact } from "./impact.js";
import { Car } from "./car.js";
import { Chase } from "./chase.js";
import { Frames, place } from "./frames.js";
import { Hands } from "./hands.js";
import { clock, showBall, showLap, showScene } from "./hud.js";
import { Link } from "./link.js";
import { TrackMap } from "./map.js";
import { Ring } from "./ring.js";
import { Sound } from "./sound.js";
import { Trail } from "./trail.js";
import { buildWorld } from "./world.js";

/** A machine that draws slower than this gets a coarser picture, ms. */
const kSlowMs = 40;
const kJudgedFrames = 20;

const $ = (id) => document.getElementById(id);
const canvas = $("view");
const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.toneMapping = ACESFilmicToneMapping;
renderer.shadowMap.enabled = true;
renderer.shadowMap.type = PCFShadowMap;
renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
const camera = new PerspectiveCamera(58, 1, 0.5, 1200);
camera.up.set(0, 0, 1);

const link = new Link();
const frames = new Frames();
const ring = new Ring($("ring"), $("felt"));
const sound = new Sound($("sound"));
/** The configuration of the track: {root, world, car, impact, chase, trail, map, text}. */
let stage = null;
let scene = null;

const page = { renderer, camera, frames, ring, link, sound, clock, stage: () => stage, scene: () => scene, frame: 0 };

function mode(name) {
  link.send({ type: "mode", mode: name });
}
const commands = {
  KeyR: () => link.send({ type: "reset" }),
  KeyP: () => link.send({ type: "pause", on: !scene?.paused }),
};
const hands = new Hands({
  say: (message) => link.send(message),
  grab: () => {
    document.body.dataset.driven = "true";
    if (scene && scene.mode !== "keyboard") mode("keyboard");
    if (scene?.paused) link.send({ type: "pause", on: false });
  },
  commands,
});
/** Pressed by mouse or thumb, it leaves the arrows and the space key to driving. */
function passesBy(control, pressed) {
  pressed.addEventListener("pointerup", () => setTimeout(() => control.blur()));
}
for (const [id, command] of [["reset", commands.KeyR], ["pause", commands.KeyP], ["sound", () => sound.toggle()]]) {
  $(id).addEventListener("click", command);
  passesBy($(id), $(id));
}
for (const choice of document.querySelectorAll("[name=mode]")) {
  choice.addEventListener("change", () => mode(choice.value));
  passesBy(choice, choice.parentElement);
}

link.addEventListener("track", ({ detail: track }) => {
  frames.clear();
  const text = JSON.stringify(track);
  if (stage?.text === text) return;
  const root = new Scene();
  const world = buildWorld(root, track);
  const car = new Car(track.car);
  car.addTo(root);
  stage = {
    text, root, world, car, impact: new Impact(car.body, track.car), chase: new Chase(camera), trail: new Trail(root, track.car.wheel_radius),
    map: new TrackMap($("map"), track),
  };
});
link.addEventListener("scene", ({ detail }) => {
  scene = detail;
  frames.add(detail);
  showScene(detail);
  sound.scene(detail);
});
link.addEventListener("ball", ({ detail }) => showBall(detail));
link.addEventListener("lap", ({ detail }) => showLap(detail));
link.addEventListener("felt", ({ detail: felt }) => {
  ring.felt(felt);
  sound.felt(felt);
  stage?.impact.felt(felt);
  if (felt.kind === "hit" && stage) stage.trail.hit(stage.car.body, felt.direction, felt.strength);
});

link.addEventListener("gone", () => sound.rest());

function fit() {
  const { clientWidth: width, clientHeight: height } = canvas;
  renderer.setSize(width, height, false);
  camera.aspect = width / height;
  camera.fov = width < height ? 74 : 58;
  // On a phone the lower part lies under the thumbs.
  if (width < height) camera.setViewOffset(width, height, 0, 0.14 * height, width, height);
  else camera.clearViewOffset();
  camera.updateProjectionMatrix();
}
new ResizeObserver(fit).observe(canvas);

let slow = 0;
let coarse = 0;
function spare(ms) {
  slow += ms > kSlowMs && ms < 1000 ? 1 : -1;
  slow = Math.max(0, slow);
  if (slow < kJudgedFrames || coarse > 1) return;
  slow = 0;
  ++coarse;
  renderer.setPixelRatio(coarse === 1 ? 1 : 0.6);
  if (coarse === 2 && stage) stage.world.sun.castShadow = false;
  fit();
}

let drawnAt = performance.now();
function draw() {
  requestAnimationFrame(draw);
  const now = performance.now();
  const seconds = Math.min(0.1, (now - drawnAt) / 1000);
  spare(now - drawnAt);
  drawnAt = now;
  hands.step(seconds);
  ring.draw();
  const between = frames.now();
  if (!stage || !between) return;
  const { car, impact, chase, trail, world, map, root } = stage;
  car.show(between);
  impact.show();
  const { from, to, share } = between;
  world.obstacles.forEach((mesh, i) => to.obstacles[i] && place(mesh, from.obstacles[i] ?? to.obstacles[i], to.obstacles[i], share));
  world.follow(car.body.position);
  chase.follow(car.body, to.speed_mps, seconds);
  if (!to.paused) trail.show(to.wheels, car.wheels, seconds);
  ring.steer(to.steer, to.throttle, to.brake);
  map.draw(car.body.position.toArray());
  renderer.render(root, camera);
  ++page.frame;
}
draw();

// For tests: what is drawn, as numbers.
window.racer = page;
