// SPDX-License-Identifier: MIT
// The page's connection to the game: JSON texts on /ws. Comes back by itself, and says so.

const kFirstPauseMs = 250;
const kLongestPauseMs = 2000;
const kTimeoutMs = 3000;
const kSilentMs = 2000;
const kWelcomeMs = 3000;

/** Dispatches one event for each message, named by its `type` (detail: the message). */
export class Link extends EventTarget {
  constructor() {
    super();
    this.url = `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/ws`;
    this.pauseMs = kFirstPauseMs;
    this.was = "start";
    this.closeReason = "";
    this.connect();
    setInterval(() => this.listen(), 250);
  }

  connect() {
    const socket = new WebSocket(this.url);
    this.socket = socket;
    const timeoutId = setTimeout(() => socket.close(), kTimeoutMs);
    socket.onmessage = ({ data }) => {
      if (this.socket !== socket) return;
      clearTimeout(timeoutId);
      const message = JSON.parse(data);
      this.receivedAt = performance.now();
      if (message.type === "goodbye") this.closeReason = message.reason;
      if (message.type === "track") this.back();
      this.dispatchEvent(new CustomEvent(message.type, { detail: message }));
    };
    socket.onclose = () => {
      clearTimeout(timeoutId);
      if (this.socket === socket) this.lost();
    };
  }

  back() {
    this.pauseMs = kFirstPauseMs;
    this.closeReason = "";
    this.show("open", this.was === "gone" ? "The game is back." : "");
    if (this.was === "gone") setTimeout(() => document.body.dataset.link === "open" && this.show("open", ""), kWelcomeMs);
    this.was = "open";
  }

  lost() {
    const why = this.closeReason || "closed without a reason";
    this.show("gone", this.was === "start"
      ? "No game answers. This page tries again by itself."
      : `The game is gone (${why}). Start hedgehog-racer again; this page comes back by itself.`);
    if (this.was === "open") this.was = "gone";
    this.dispatchEvent(new CustomEvent("gone"));
    setTimeout(() => this.connect(), this.pauseMs);
    this.pauseMs = Math.min(2 * this.pauseMs, kLongestPauseMs);
  }

  /** A game that is connected and says nothing is not drawn as if it ran. */
  listen() {
    const { link } = document.body.dataset;
    if (!["open", "silent"].includes(link)) return;
    const silent = performance.now() - this.receivedAt > kSilentMs;
    if (silent && link === "open") this.show("silent", "The game is connected but silent. The values shown are out of date.");
    if (!silent && link === "silent") this.show("open", "");
  }

  show(state, text) {
    const banner = document.getElementById("gone");
    document.body.dataset.link = state;
    banner.hidden = text === "";
    banner.dataset.kind = state;
    banner.textContent = text;
  }

  send(message) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
  }
}
