// SPDX-License-Identifier: MIT
// A hand on the key frames of the ball: a press chooses one, a drag moves it, and a click beside them puts a new one.

/** What moves less is a click, pixels. */
const kMaxStillPx = 6;

export class PathEditor {
  /**
   * `busy()`: something else has the pointer. `choose(index)`, `move(index, direction)` again and again, then
   * `moved()`, `put(direction)`: what a person did.
   */
  constructor(ball, path, { busy, choose, move, moved, put }) {
    Object.assign(this, { ball, path, busy, choose, move, moved, put });
    /** {from: [x, y], index, moved}: while the pointer is down. */
    this.press = null;
    ball.canvas.addEventListener("pointerdown", (event) => this.down(event));
    ball.canvas.addEventListener("pointermove", (event) => this.over(event));
    addEventListener("pointerup", (event) => this.up(event));
    for (const ending of ["pointercancel", "blur"]) addEventListener(ending, () => this.end());
  }

  down(event) {
    if (this.busy() || this.press || event.button !== 0) return;
    const index = this.path.pick(event);
    this.press = { id: event.pointerId, from: [event.clientX, event.clientY], index, moved: false };
    if (index < 0) return;
    this.ball.orbit.enableRotate = false;
    this.choose(index);
  }

  over(event) {
    const { press } = this;
    if (!press) {
      this.ball.canvas.style.cursor = !this.busy() && this.path.pick(event) >= 0 ? "move" : "";
      return;
    }
    if (event.pointerId !== press.id) return;
    press.moved ||= Math.hypot(event.clientX - press.from[0], event.clientY - press.from[1]) >= kMaxStillPx;
    const direction = press.moved && press.index >= 0 ? this.path.directionAt(event) : null;
    if (direction) this.move(press.index, direction);
  }

  up(event) {
    const { press } = this;
    if (!press || event.pointerId !== press.id) return;
    this.end();
    const direction = press.index < 0 && !press.moved && event.target === this.ball.canvas ? this.path.directionAt(event) : null;
    if (direction) this.put(direction);
  }

  end() {
    const { press } = this;
    this.press = null;
    if (!press || press.index < 0) return;
    this.ball.orbit.enableRotate = true;
    if (press.moved) this.moved();
  }
}
