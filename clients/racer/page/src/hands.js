// SPDX-License-Identifier: MIT
// Keys and thumbs: what is held, as steer, throttle and brake. A key is all or nothing, a wheel is not, so
// that steering follows in a fraction of a second.

const kKeys = {
  ArrowLeft: "left", KeyA: "left", ArrowRight: "right", KeyD: "right",
  ArrowUp: "throttle", KeyW: "throttle", ArrowDown: "brake", KeyS: "brake", Space: "brake",
};
/** Of the full lock, a second. */
const kTurn = 4;
const kBack = 7;
/** The game lets go of a page that says nothing. */
const kRepeatMs = 100;

export class Hands {
  /** `say`: sends; `grab`: called when somebody begins to drive by hand. */
  constructor({ say, grab, commands }) {
    this.held = new Map();
    this.steer = 0;
    this.said = "";
    this.saidAt = 0;
    this.say = say;
    this.grab = grab;
    addEventListener("keydown", (event) => this.key(event, commands));
    // While a Meta key is down, some systems tell of no other key that is let go.
    addEventListener("keyup", ({ code }) => (code.startsWith("Meta") ? this.letGo() : this.release(code)));
    addEventListener("blur", () => this.letGo());
    document.addEventListener("visibilitychange", () => this.letGo());
    for (const button of document.querySelectorAll("[data-hold]")) this.thumb(button);
  }

  key(event, commands) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const hold = kKeys[event.code];
    const control = event.target.closest?.("button, input, a");
    // Space presses a button, arrows choose among radio buttons: as everywhere.
    if (control && (event.code === "Space" || (control.type === "radio" && event.code.startsWith("Arrow")))) return;
    if (hold) {
      event.preventDefault();
      this.hold(event.code, hold);
    } else if (!event.repeat) {
      commands[event.code]?.();
    }
  }

  thumb(button) {
    const { hold } = button.dataset;
    const name = `thumb ${hold}`;
    const down = (event) => {
      event.preventDefault();
      button.setPointerCapture?.(event.pointerId);
      button.classList.add("held");
      this.hold(name, hold);
    };
    const up = () => {
      button.classList.remove("held");
      this.release(name);
    };
    button.addEventListener("pointerdown", down);
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) button.addEventListener(end, up);
    button.addEventListener("contextmenu", (event) => event.preventDefault());
  }

  hold(name, what) {
    if (!this.held.has(name)) this.grab();
    this.held.set(name, what);
  }

  letGo() {
    this.held.clear();
    for (const button of document.querySelectorAll(".held")) button.classList.remove("held");
  }

  release(name) {
    this.held.delete(name);
  }

  /** To be called each frame. */
  step(seconds) {
    const held = new Set(this.held.values());
    const aim = (held.has("right") ? 1 : 0) - (held.has("left") ? 1 : 0);
    const way = aim - this.steer;
    const most = seconds * (aim === 0 || aim * this.steer < 0 ? kBack : kTurn);
    this.steer += Math.sign(way) * Math.min(Math.abs(way), most);
    const keys = {
      type: "keys", steer: Math.round(100 * this.steer) / 100,
      throttle: held.has("throttle") ? 1 : 0, brake: held.has("brake") ? 1 : 0,
    };
    const text = JSON.stringify(keys);
    const now = performance.now();
    const neutral = !keys.steer && !keys.throttle && !keys.brake;
    if (text === this.said && (neutral || now - this.saidAt < kRepeatMs)) return;
    this.said = text;
    this.saidAt = now;
    this.say(keys);
  }
}
