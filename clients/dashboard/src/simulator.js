// SPDX-License-Identifier: MIT
// Only with the simulator: turning the ball, and breaking it.
import { errorMessage, kFaults } from "./words.js";

const kTurnEveryMs = 33;
const kStep = Math.PI / 12;

export class Simulator {
  constructor(root, link, ball, showMessage) {
    this.root = root;
    this.link = link;
    this.ball = ball;
    this.showMessage = showMessage;
    const select = root.querySelector("[name=fault]");
    select.replaceChildren(...Object.entries(kFaults).map(([name, words]) => new Option(words, name)));
    select.addEventListener("change", () => this.set({ fault: select.value ? { faults: [select.value] } : {} }));
    const drag = root.querySelector("[name=turn]");
    drag.addEventListener("change", () => ball.setTurning(drag.checked));
    root.querySelector("[data-upright]").addEventListener("click", () => this.turn({ w: 1, x: 0, y: 0, z: 0 }));
    for (const button of root.querySelectorAll("[data-turn]")) {
      const [right, down] = button.dataset.turn.split(",").map(Number);
      button.addEventListener("click", () => ball.turnBy(right * kStep, down * kStep));
    }
    ball.addEventListener("turn", ({ detail: q }) => this.later({ w: q.w, x: q.x, y: q.y, z: q.z }));
  }

  /** Shown when there is a simulator and this connection may. */
  allow(hello) {
    const may = hello.device.simulated && hello.role === "operate";
    this.root.hidden = !may;
    if (may) this.set({}).then((now) => { this.root.querySelector("[name=fault]").value = now?.faults[0] ?? ""; });
  }

  async set(params) {
    try {
      return await this.link.call("sim.set", params);
    } catch (error) {
      this.showMessage(errorMessage(error), true);
      return null;
    }
  }

  turn(quaternion) {
    this.later(quaternion);
  }

  /** At most so often, and the last one surely. */
  later(quaternion) {
    this.next = quaternion;
    this.timer ??= setTimeout(() => {
      this.timer = null;
      this.link.notify("sim.set", { orientation: this.next });
    }, kTurnEveryMs);
  }
}
