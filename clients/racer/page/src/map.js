// SPDX-License-Identifier: MIT
// The track from above, with the car on it.

export class TrackMap {
  constructor(canvas, track) {
    this.canvas = canvas;
    this.points = track.centre.map(([x, y]) => [x, y]);
    this.width = track.width;
    this.patches = track.patches;
    const ratio = Math.min(devicePixelRatio, 2);
    this.size = [canvas.clientWidth, canvas.clientHeight];
    canvas.width = this.size[0] * ratio;
    canvas.height = this.size[1] * ratio;
    this.context = canvas.getContext("2d");
    const of = (axis) => (this.points.length ? this.points.map((p) => p[axis]) : [-40, 40]);
    const [low, high] = [[0, 1].map((k) => Math.min(...of(k))), [0, 1].map((k) => Math.max(...of(k)))];
    const scale = Math.min(...[0, 1].map((k) => (this.size[k] - 18) / (high[k] - low[k])));
    this.at = ([x, y]) => [
      this.size[0] / 2 + scale * (x - (low[0] + high[0]) / 2),
      this.size[1] / 2 - scale * (y - (low[1] + high[1]) / 2),
    ];
    this.road = new Path2D();
    this.points.forEach((p, i) => this.road[i ? "lineTo" : "moveTo"](...this.at(p)));
    this.road.closePath();
    this.context.scale(ratio, ratio);
  }

  draw(car) {
    const { context } = this;
    context.clearRect(0, 0, ...this.size);
    context.lineJoin = "round";
    for (const [colour, width] of [["#46557a", 7], ["#131926", 4.5]]) {
      context.strokeStyle = colour;
      context.lineWidth = width;
      context.stroke(this.road);
    }
    const dot = (at, colour, radius) => {
      context.fillStyle = colour;
      context.beginPath();
      context.arc(...this.at(at), radius, 0, 2 * Math.PI);
      context.fill();
    };
    for (const { at } of this.patches) dot(at, "#6fb1ff", 2.5);
    if (this.points.length) dot(this.points[0], "#e6edf8", 2.5);
    dot(car, "#ffb454", 4.5);
  }
}
