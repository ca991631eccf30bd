// SPDX-License-Identifier: MIT
// The ball seen from above, the way the driver holds it: what was just felt stands where the pins push.

const kFadeMs = 900;
/** A blow is not hidden by what merely lasts, ms. */
const kImpactMs = 600;
const kRadius = 38;
const kSvg = "http://www.w3.org/2000/svg";
const kKinds = { hit: "Hit", landing: "Landing", skid: "Skidding", tumble: "Rolling over" };

/** "front", "left and above": where a direction of the ball's frame points. */
export function whither([x, y, z]) {
  const parts = [
    [Math.abs(x), x > 0 ? "front" : "back"],
    [Math.abs(y), y > 0 ? "left" : "right"],
    [Math.abs(z), z > 0 ? "above" : "below"],
  ];
  return parts.filter(([size]) => size > 0.38).sort((a, b) => b[0] - a[0]).map(([, word]) => word).join(" and ");
}

export class Ring {
  /** `now`: where `felt` says it in words. */
  constructor(svg, words) {
    this.words = words;
    this.marks = [];
    this.group = svg.querySelector("#pins");
    this.tilt = svg.querySelector("#tilt");
    const dot = (x, y, r) => {
      const circle = document.createElementNS(kSvg, "circle");
      for (const [name, value] of Object.entries({ cx: x, cy: y, r })) circle.setAttribute(name, value);
      this.group.append(circle);
      return circle;
    };
    // The pins that a hand sees from above: rings of 15, 12 and 6, and the pole's.
    for (const [count, radius] of [[15, 34], [12, 25], [6, 13], [1, 0]]) {
      for (let i = 0; i < count; ++i) {
        const turn = (2 * Math.PI * i) / count;
        dot(-radius * Math.sin(turn), -radius * Math.cos(turn), 1.4);
      }
    }
    this.mark = dot(0, 0, 0);
    this.mark.id = "push";
  }

  felt({ kind, direction, strength, level_a: level }) {
    const now = performance.now();
    const lasts = kind === "skid" || kind === "tumble";
    if (lasts && this.last && !this.last.lasts && now - this.last.at < kImpactMs) return;
    this.last = { lasts, kind, direction, strength, at: now };
    const amperes = level > 0 ? `, ${level.toFixed(1)} A` : "";
    this.words.textContent = `${kKinds[kind] ?? kind}: ${whither(direction)}, ${Math.round(100 * strength)} %${amperes}`;
  }

  steer(steer, throttle, brake) {
    this.tilt.setAttribute("cx", 30 * steer);
    this.tilt.setAttribute("cy", 30 * (brake - throttle));
  }

  draw() {
    const { mark, last } = this;
    const left = last ? 1 - (performance.now() - last.at) / kFadeMs : 0;
    if (left <= 0) {
      mark.setAttribute("r", 0);
      return;
    }
    const [x, y, z] = last.direction;
    // From above the lower half lies under the ball: down is the middle, drawn hollow.
    mark.setAttribute("cx", -kRadius * y);
    mark.setAttribute("cy", -kRadius * x);
    mark.setAttribute("r", 4 + 9 * last.strength * (0.6 + 0.4 * left));
    mark.setAttribute("opacity", Math.min(1, 2 * left));
    mark.classList.toggle("below", z < -0.5);
  }
}
