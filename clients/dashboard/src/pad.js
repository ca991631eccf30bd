// SPDX-License-Identifier: MIT
// The pad: six sides, three kinds of effect, and the patterns that the daemon has. Also by arrow keys, and by clicking a pin of the ball.
import { amperes, errorMessage, kStates, limitation } from "./words.js";

const kKeys = {
  ArrowUp: "front", ArrowDown: "back", ArrowLeft: "left", ArrowRight: "right", PageUp: "up", PageDown: "down",
};
/** What a side means to each kind of effect; of a circle it is the axis. */
const kPrompts = {
  pulse: "Push towards", vibrate: "Vibrate towards", pattern: "Play towards", circle: "Turn round this axis",
};

export class Pad {
  /** `showMessage(text, bad)`: one line for the person. */
  constructor(root, link, showMessage) {
    this.root = root;
    this.link = link;
    this.showMessage = showMessage;
    this.form = root.querySelector("form");
    this.form.addEventListener("submit", (event) => event.preventDefault());
    this.form.addEventListener("input", () => this.show());
    for (const button of root.querySelectorAll("[data-direction]")) {
      button.addEventListener("click", () => this.play(button.dataset.direction));
    }
    for (const radio of this.form.elements.kind) {
      // Others may have put and removed patterns meanwhile.
      radio.addEventListener("change", () => radio.value === "pattern" && this.loadPatterns());
    }
    root.querySelector("[data-stop-mine]").addEventListener("click", () => this.stop());
    addEventListener("keydown", (event) => this.key(event));
    link.addEventListener("gone", () => this.set({ connected: false }));
    this.standing = { connected: false, may: true, state: "absent" };
    this.show();
  }

  key(event) {
    const busy = event.target.closest?.("input, select, textarea, [contenteditable]");
    const direction = kKeys[event.key];
    if (!direction || busy || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    if (!event.repeat) this.play(direction);
  }

  /** `hello`: what this connection may do. */
  allow(hello) {
    this.limits = hello.limits;
    this.form.elements.strength.max = hello.limits.current_a;
    this.set({ connected: true, may: hello.role !== "observe", state: hello.state });
    this.loadPatterns();
    this.show();
  }

  /** `some` of {connected, may, state}: nothing can be asked for that would be refused. */
  set(some) {
    const before = this.blocker();
    Object.assign(this.standing, some);
    if (before !== this.blocker()) this.show();
  }

  /** Why nothing can be played now; empty: it can. */
  blocker() {
    const { connected, may, state } = this.standing;
    if (!connected) return "Not connected: nothing plays.";
    if (!may) return "This connection may only observe.";
    if (state === "disarmed") return "Disarmed: arm the ball to play.";
    return state === "armed" ? "" : `${kStates[state] ?? state}: nothing plays.`;
  }

  /** The patterns there are; what was chosen stays so, and a call that fails leaves those that were known. */
  async loadPatterns() {
    const { patterns } = await this.link.call("pattern.list").catch(() => ({}));
    if (!patterns) return;
    const select = this.form.elements.pattern;
    const chosen = select.value;
    this.patterns = patterns;
    select.replaceChildren(...patterns.map(({ name }) =>
      Object.assign(document.createElement("option"), { value: name, textContent: name })));
    if (patterns.some(({ name }) => name === chosen)) select.value = chosen;
    this.show();
  }

  value(name) {
    return Number(this.form.elements[name].value);
  }

  show() {
    const kind = this.form.elements.kind.value;
    const blocker = this.blocker();
    this.root.dataset.kind = kind;
    this.root.querySelector("#ask").textContent = blocker || kPrompts[kind];
    for (const control of this.form.elements) control.disabled = blocker !== "";
    for (const button of this.form.querySelectorAll("[data-direction]")) {
      button.textContent = kind === "circle" ? `axis ${button.dataset.direction}` : button.dataset.direction;
    }
    this.root.querySelector("#pattern-description").textContent =
      this.patterns?.find(({ name }) => name === this.form.elements.pattern.value)?.description ?? "";
    const text = { strength: amperes(this.value("strength")), duration: `${this.value("duration").toFixed(1)} s`,
      speed: `${this.value("speed")} pins/s`, frequency: `${this.value("frequency")} Hz` };
    for (const [name, shown] of Object.entries(text)) {
      this.form.querySelector(`output[for=${name}]`).value = shown;
    }
  }

  request(direction) {
    const common = { current_a: this.value("strength"), duration_ms: Math.round(1000 * this.value("duration")) };
    switch (this.form.elements.kind.value) {
      case "circle":
        return ["effect.circle", { ...common, axis: direction, speed_pins_s: this.value("speed"), slot: "pad" }];
      case "vibrate":
        return ["effect.vibrate", { ...common, direction, frequency_hz: this.value("frequency"), slot: "pad" }];
      case "pattern":
        return ["effect.play",
          { current_a: common.current_a, pattern: this.form.elements.pattern.value, rotate_to: direction, slot: "pad" }];
      default:
        return ["effect.pulse", { ...common, direction }];
    }
  }

  async play(direction) {
    const blocker = this.blocker();
    if (blocker) {
      this.showMessage(blocker, true);
      return;
    }
    const [method, params] = this.request(direction);
    try {
      const admission = await this.link.call(method, params);
      const side = typeof direction === "string" ? direction : `pin ${direction.pin}`;
      const where = method === "effect.circle" ? `axis ${side}` : side;
      const less = limitation(admission.limited_by);
      this.showMessage(`${where}: ${amperes(admission.current_a)}, ${(1000 * admission.force_n).toFixed(0)} mN at pin ${admission.pin}${less}`);
    } catch (error) {
      this.showMessage(errorMessage(error), true);
    }
  }

  async stop() {
    try {
      await this.link.call("effect.stop_all");
      this.showMessage("effects of this page ended");
    } catch (error) {
      this.showMessage(errorMessage(error), true);
    }
  }
}
