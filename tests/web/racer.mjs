// SPDX-License-Identifier: MIT
// A real hedgehog-racer with its page, for the browser.
import { spawn } from "node:child_process";

const kProgram = process.env.HEDGEHOG_RACER;

export class Racer {
  /** On a free port. `daemon`: the daemon of the ball; null: no ball. */
  static async start({ daemon = null, more = [] } = {}) {
    const racer = new Racer();
    const ball = daemon ? ["--address", `127.0.0.1:${daemon.tcp}`] : ["--no-ball"];
    racer.process = spawn(kProgram, ["--listen", "127.0.0.1:0", ...ball, ...more], { stdio: ["ignore", "pipe", "inherit"] });
    let out = "";
    await new Promise((resolve, reject) => {
      racer.process.stdout.on("data", (text) => {
        out += text;
        if (out.includes("open this in a browser")) resolve();
      });
      racer.process.on("exit", () => reject(new Error(`hedgehog-racer does not start: ${out}`)));
    });
    racer.port = Number(/http:\/\/127\.0\.0\.1:(\d+)/.exec(out)[1]);
    racer.url = `http://127.0.0.1:${racer.port}`;
    return racer;
  }

  async end(signal = "SIGTERM") {
    if (this.process.exitCode !== null || this.process.signalCode !== null) return;
    const ended = new Promise((resolve) => this.process.once("exit", resolve));
    this.process.kill(signal);
    await ended;
  }
}
