// SPDX-License-Identifier: MIT
// A real hedgehogd with its own folders, for the browser.
import { execFileSync, spawn } from "node:child_process";
import { mkdtempSync, mkdirSync, rmSync, writeFileSync } from "node:fs";
import net from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";

const kProgram = process.env.HEDGEHOGD;
const kTools = process.env.HEDGEHOGCTL;

export class Daemon {
  /**
   * Listens on free ports; `home`: folders of an earlier daemon. In lock-step, so that a busy machine skips no tick.
   * `before(daemon)` is called once its folders exist.
   */
  static async start({ config = {}, more = [], home = null, speed = 1, before = () => {} } = {}) {
    const daemon = new Daemon();
    daemon.home = home ?? mkdtempSync(join(tmpdir(), "hedgehog-web-"));
    mkdirSync(join(daemon.home, "config/hedgehog"), { recursive: true });
    writeFileSync(join(daemon.home, "config/hedgehog/hedgehogd.json"), JSON.stringify(config));
    before(daemon);
    daemon.process = spawn(kProgram, ["--simulate", "--speed", String(speed), "--listen", "127.0.0.1:0", "--log-level", "error", ...more], {
      env: daemon.environment(),
      stdio: ["ignore", "pipe", "inherit"],
    });
    let out = "";
    await new Promise((resolve, reject) => {
      daemon.process.stdout.on("data", (text) => {
        out += text;
        if (out.includes("listening on /")) resolve();
      });
      daemon.process.on("exit", () => reject(new Error(`hedgehogd does not start: ${out}`)));
    });
    daemon.port = Number(/https?:\/\/127\.0\.0\.1:(\d+)/.exec(out)[1]);
    daemon.tcp = Number(/listening on 127\.0\.0\.1:(\d+)/.exec(out)[1]);
    daemon.url = `${/https?/.exec(out)[0]}://127.0.0.1:${daemon.port}`;
    return daemon;
  }

  environment() {
    return { PATH: process.env.PATH, HOME: this.home, XDG_CONFIG_HOME: `${this.home}/config`,
      XDG_STATE_HOME: `${this.home}/state`, XDG_RUNTIME_DIR: `${this.home}/run` };
  }

  /** The output of `hedgehogctl token` with `words`: a token, or a fingerprint. */
  token(...words) {
    return execFileSync(kTools, ["token", ...words, "--state", `${this.home}/state/hedgehog`], { env: this.environment(), encoding: "utf8" }).trim();
  }

  /** One request on a new TCP connection; returns its result, or its error. */
  call(method, params = {}) {
    return new Promise((resolve, reject) => {
      const socket = net.connect(this.tcp, "127.0.0.1");
      let text = "";
      socket.on("connect", () => socket.write(`${JSON.stringify({ jsonrpc: "2.0", id: 1, method, params })}\n`));
      socket.on("error", reject);
      socket.on("close", () => reject(new Error(`${method}: no answer`)));
      socket.on("data", (bytes) => {
        text += bytes;
        if (!text.includes("\n")) return;
        const response = JSON.parse(text);
        socket.end();
        resolve(response.result ?? response.error);
      });
    });
  }

  /** The number of effects with this outcome of the protocol, such as "expired". */
  async ended(outcome) {
    const page = await (await fetch(`${this.url}/metrics`)).text();
    const counts = [...page.matchAll(/effects_total\{[^}]*outcome="(\w+)"[^}]*\} (\d+)/g)];
    return counts.filter(([, name]) => name === outcome).reduce((sum, [, , count]) => sum + Number(count), 0);
  }

  /** Also removes the folders of a daemon that ended by itself. `keep`: keeps them for the next daemon. */
  async end(signal = "SIGTERM", { keep = false } = {}) {
    if (this.process.exitCode === null && this.process.signalCode === null) {
      const ended = new Promise((resolve) => this.process.once("exit", resolve));
      this.process.kill("SIGCONT"); // a test that fails may leave it stopped
      this.process.kill(signal);
      await ended;
    }
    if (!keep) rmSync(this.home, { recursive: true, force: true });
  }
}
