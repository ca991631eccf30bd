// SPDX-License-Identifier: MIT
// The owner's comfort setting: what everything that is played is multiplied by. Only who operates the ball may change it.
import { errorMessage } from "./words.js";

export class Gain {
  /** `input`: a range from 0 to 1, with its output. */
  constructor(input, link, showMessage) {
    this.input = input;
    this.link = link;
    this.showMessage = showMessage;
    input.addEventListener("input", () => this.show());
    input.addEventListener("change", () => this.set());
    // Somebody else may have changed it meanwhile; no notification tells.
    document.addEventListener("visibilitychange", () => document.hidden || this.refresh());
  }

  describe(hello, { gain }) {
    this.input.disabled = hello.role !== "operate";
    this.put(gain);
  }

  put(gain) {
    this.input.value = gain;
    this.show();
  }

  show() {
    this.input.parentElement.querySelector("output").value = `${Math.round(100 * this.input.value)} %`;
  }

  async refresh() {
    const device = await this.link.call("device.describe").catch(() => null);
    if (device) this.put(device.gain);
  }

  async set() {
    try {
      const { gain } = await this.link.call("output.set_gain", { gain: Number(this.input.value) });
      this.put(gain);
      this.showMessage(`everything plays with ${Math.round(100 * gain)} % of its strength`);
    } catch (error) {
      this.showMessage(errorMessage(error), true);
      this.refresh();
    }
  }
}
