// SPDX-License-Identifier: MIT
// The key frames as a table in which each can be changed, for keys as for a mouse.
import { angles, kEases, kMaxMs, vector } from "./keyframes.js";

export class FrameTable {
  /** `change(index, frame)`, `remove(index)`: what a person did. */
  constructor(table, { change, remove }) {
    Object.assign(this, { table, change, remove });
  }

  /** `chosen`: the index of the one that is marked, or -1. */
  show(frames, chosen) {
    this.table.hidden = frames.length === 0;
    const focused = document.activeElement?.getAttribute?.("aria-label");
    this.table.tBodies[0].replaceChildren(...frames.map((frame, index) => this.row(frame, index)));
    this.table.tBodies[0].rows[chosen]?.setAttribute("aria-current", "true");
    if (focused) this.table.querySelector(`[aria-label="${focused}"]`)?.focus();
  }

  row(frame, index) {
    const { azimuth, elevation } = angles(frame.direction);
    const field = (what, value, min, max, step) => Object.assign(document.createElement("input"), {
      type: "number", value, min, max, step, ariaLabel: `${what} of key frame ${index + 1}` });
    const time = field("time", frame.t, 0, kMaxMs, 10);
    const turn = field("azimuth", azimuth, -180, 180, 5);
    const height = field("elevation", elevation, -90, 90, 5);
    const level = field("level", frame.level, 0, 1, 0.05);
    const ease = Object.assign(document.createElement("select"), { ariaLabel: `way after key frame ${index + 1}` });
    ease.append(...kEases.map((name) => new Option(name, name, false, name === frame.ease)));
    const away = Object.assign(document.createElement("button"), {
      type: "button", textContent: "×", ariaLabel: `remove key frame ${index + 1}` });
    away.addEventListener("click", () => this.remove(index));
    for (const input of [time, turn, height, level, ease]) {
      input.addEventListener("change", () => {
        const turned = Number(turn.value) !== azimuth || Number(height.value) !== elevation;
        this.change(index, { t: Number(time.value), level: Number(level.value), ease: ease.value,
          direction: turned ? vector(Number(turn.value), Number(height.value)) : frame.direction });
      });
    }
    const row = document.createElement("tr");
    for (const cell of [time, turn, height, level, ease, away]) row.insertCell().append(cell);
    return row;
  }
}
