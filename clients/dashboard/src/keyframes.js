// SPDX-License-Identifier: MIT
// Key frames of a pattern as they are edited: directions over time. No page, no daemon.

/** As long as one effect may last. */
export const kMaxMs = 10_000;
export const kMaxKeyframes = 256;
export const kEases = ["linear", "step", "smooth"];
/** Members of a pattern that are parameters of `effect.play`, too. */
const kWave = ["waveform", "frequency_hz", "on_fraction"];
const kFrame = ["t_ms", "direction", "level", "ease"];
/** What `pattern.get` returns besides the pattern. */
const kResults = ["duration_ms", "shipped"];

const unit = (v) => {
  const length = Math.hypot(...v);
  return length > 1e-9 ? v.map((c) => c / length) : [1, 0, 0];
};
const dot = (a, b) => a.reduce((sum, c, i) => sum + c * b[i], 0);
const rounded = (value, digits) => Number(value.toFixed(digits));

/** Along the great circle. */
export function between(a, b, share) {
  const angle = Math.acos(Math.min(1, Math.max(-1, dot(a, b))));
  if (angle < 1e-6) return b;
  // Opposite ones go over the top, as the daemon plays them.
  if (Math.PI - angle < 1e-6) {
    const over = Math.abs(a[2]) > 0.99 ? [1, 0, 0] : [0, 0, 1];
    return share < 0.5 ? between(a, over, 2 * share) : between(over, b, 2 * share - 1);
  }
  return a.map((c, i) => (Math.sin((1 - share) * angle) * c + Math.sin(share * angle) * b[i]) / Math.sin(angle));
}

export function angles([x, y, z]) {
  const degrees = (radians) => Math.round((radians * 180) / Math.PI);
  return { azimuth: degrees(Math.atan2(y, x)), elevation: degrees(Math.asin(Math.min(1, Math.max(-1, z)))) };
}

export function vector(azimuth, elevation) {
  const [a, e] = [azimuth, elevation].map((degrees) => (degrees * Math.PI) / 180);
  return [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
}

const kWords = { front: [1, 0, 0], back: [-1, 0, 0], left: [0, 1, 0], right: [0, -1, 0], up: [0, 0, 1], down: [0, 0, -1] };

function vectorOf(direction, pins) {
  if (typeof direction === "string" && direction in kWords) return kWords[direction];
  if (Array.isArray(direction) && direction.length === 3 && direction.every(Number.isFinite)) return unit(direction);
  const pin = pins.find(({ number }) => number === direction?.pin);
  if (pin) return pin.direction;
  if (Number.isFinite(direction?.azimuth_deg ?? direction?.elevation_deg)) {
    return vector(direction.azimuth_deg ?? 0, direction.elevation_deg ?? 0);
  }
  throw new Error("one of its directions is none");
}

export class Keyframes {
  constructor() {
    /** In order of time: {t, direction, level, ease}; t in ms, direction a unit vector of the ball. A new list for each change. */
    this.frames = [];
    /** Of the file, except `keyframes`: its name, description and wave, and members that this page does not know. */
    this.members = {};
    /** How many key frames `read` has moved by 1 ms. */
    this.moved = 0;
  }

  /** One at `frame.t`, in place of that which is there; its index. */
  put(frame) {
    const t = Math.min(kMaxMs, Math.max(0, Math.round(frame.t)));
    const level = rounded(Math.min(1, Math.max(0, frame.level)), 3);
    const next = { t, direction: unit(frame.direction), level, ease: kEases.includes(frame.ease) ? frame.ease : "linear" };
    const others = this.frames.filter((other) => other.t !== t);
    if (others.length >= kMaxKeyframes) throw new Error(`${kMaxKeyframes} key frames are the most`);
    this.frames = [...others, next].sort((a, b) => a.t - b.t);
    return this.frames.indexOf(next);
  }

  remove(index) {
    this.frames = this.frames.filter((_, i) => i !== index);
  }

  length() {
    return this.frames.at(-1)?.t ?? 0;
  }

  /** What plays at `t`: {direction, level}; null where it rests. */
  at(t) {
    const next = this.frames.findIndex((frame) => frame.t > t);
    if (next === 0 || this.frames.length === 0) return null;
    if (next < 0) return t === this.length() ? this.frames.at(-1) : null;
    const [a, b] = [this.frames[next - 1], this.frames[next]];
    const u = (t - a.t) / (b.t - a.t);
    const share = { linear: u, step: 0, smooth: u * u * (3 - 2 * u) }[a.ease];
    return { direction: between(a.direction, b.direction, share), level: a.level + share * (b.level - a.level) };
  }

  /** As `effect.play` and `pattern.put` take them. */
  wire() {
    return this.frames.map(({ t, direction, level, ease }) => ({
      t_ms: t, direction: direction.map((c) => rounded(c, 4)), level, ...(ease === "linear" ? {} : { ease }),
    }));
  }

  /** The waveform of the file, as parameters of `effect.play`; empty: none. */
  wave() {
    return Object.fromEntries(kWave.filter((key) => key in this.members).map((key) => [key, this.members[key]]));
  }

  /** As `pattern.put` takes it, and as a file. */
  pattern(name) {
    return { ...this.members, name, keyframes: this.wire() };
  }

  /** Whether the daemon would take it. */
  playable() {
    return this.length() >= 1;
  }

  /** From a pattern's file; `pins`: {number, direction} of the ball. Throws a sentence for a person. */
  static read(text, pins = []) {
    let pattern;
    try {
      pattern = JSON.parse(text);
    } catch {
      throw new Error("this file is no JSON");
    }
    if (!Array.isArray(pattern?.keyframes) || pattern.keyframes.length === 0) throw new Error("this file has no keyframes");
    if (pattern.keyframes.length > kMaxKeyframes) throw new Error(`${kMaxKeyframes} key frames are the most`);
    const read = new Keyframes();
    read.members = Object.fromEntries(Object.entries(pattern).filter(([key]) => key !== "keyframes" && !kResults.includes(key)));
    let direction = [1, 0, 0];
    let before = 0;
    for (const frame of pattern.keyframes) {
      if (!Number.isFinite(frame?.t_ms) || frame.t_ms < before) throw new Error("its times are not in order");
      if (frame.t_ms > kMaxMs) throw new Error(`it is longer than the ${kMaxMs / 1000} s of this page`);
      if (!(frame.level >= 0 && frame.level <= 1)) throw new Error("one of its levels is not 0 to 1");
      if (!kEases.includes(frame.ease ?? "linear")) throw new Error("one of its ways is not linear, step or smooth");
      const unknown = Object.keys(frame).find((key) => !kFrame.includes(key));
      if (unknown !== undefined) throw new Error(`this page does not know ${unknown} of a key frame`);
      if (frame.direction !== undefined) direction = vectorOf(frame.direction, pins);
      before = frame.t_ms;
      // Of two at one time the first is the end of a way: both are kept, 1 ms apart.
      const time = Math.round(frame.t_ms);
      const t = Math.max(time, (read.frames.at(-1)?.t ?? -1) + 1);
      if (t > time + 1) throw new Error(`this page keeps one key frame a millisecond, and the file has more at ${time} ms`);
      if (t > kMaxMs) throw new Error(`two of its key frames are at ${kMaxMs} ms, the end of this page`);
      read.moved += t - time;
      read.put({ t, direction, level: frame.level, ease: frame.ease ?? "linear" });
    }
    return read;
  }

  /**
   * A drag as few key frames: Ramer-Douglas-Peucker with time, off by at most `tolerance` degrees. `points`: {t,
   * direction} in order.
   */
  static drawn(points, level, tolerance = 3) {
    const error = (a, b, p) => {
      const plays = between(a.direction, b.direction, (p.t - a.t) / (b.t - a.t));
      return (Math.acos(Math.min(1, Math.max(-1, dot(plays, p.direction)))) * 180) / Math.PI;
    };
    const kept = new Set([0, points.length - 1]);
    const parts = [[0, points.length - 1]];
    while (parts.length > 0 && kept.size < kMaxKeyframes) {
      const [first, last] = parts.pop();
      let worst = -1;
      let most = tolerance;
      for (let i = first + 1; i < last; ++i) {
        const off = error(points[first], points[last], points[i]);
        if (off > most) [most, worst] = [off, i];
      }
      if (worst < 0) continue;
      kept.add(worst);
      parts.push([first, worst], [worst, last]);
    }
    const drawn = new Keyframes();
    for (const i of [...kept].sort((a, b) => a - b)) drawn.put({ ...points[i], level, ease: "linear" });
    return drawn;
  }
}
