// SPDX-License-Identifier: MIT
// Lines, symbols and boxes of a wiring diagram as SVG, 4 units a millimetre.

const kColours = { GND: "#333", VM: "#b00020", "12V": "#b00020", "12V_IN": "#b00020", VM_SW: "#b00020", FAN_F: "#b00020", FAN_12V: "#b00020",
  VBUS: "#b05a00", "3V3": "#b05a00", AVDD: "#7a3fa0" };
export const colour = (net) => kColours[net] ?? "#0b4f8a";

const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");

export class Sheet {
  constructor(width, height) {
    this.size = { width, height };
    this.shapes = [];
  }
  add(shape) {
    this.shapes.push(shape);
  }
  text(x, y, text, { size = 10, anchor = "start", bold = false, fill = "#111" } = {}) {
    this.add(`<text x="${x}" y="${y}" font-size="${size}" text-anchor="${anchor}" fill="${fill}"${bold ? ' font-weight="bold"' : ""}>${escaped(text)}</text>`);
  }
  line(points, { width = 1, stroke = "#111" } = {}) {
    this.add(`<polyline points="${points.map((p) => p.join(",")).join(" ")}" fill="none" stroke="${stroke}" stroke-width="${width}"/>`);
  }
  box(x, y, width, height, { fill = "#fffdf2" } = {}) {
    this.add(`<rect x="${x}" y="${y}" width="${width}" height="${height}" rx="3" fill="${fill}" stroke="#111" stroke-width="1.2"/>`);
  }
  dot(x, y) {
    this.add(`<circle cx="${x}" cy="${y}" r="2.4" fill="#111"/>`);
  }
  /** A resistor, fuse or shunt from (x, y) on to the right, 40 long. */
  horizontal(x, y, label, { width = 1, stroke = "#111", solid = false } = {}) {
    this.add(`<rect x="${x + 6}" y="${y - 5}" width="28" height="10" fill="${solid ? "#ddd" : "#fff"}" stroke="${stroke}" stroke-width="1.3"/>`);
    this.line([[x, y], [x + 6, y]], { width, stroke });
    this.line([[x + 34, y], [x + 40, y]], { width, stroke });
    this.text(x + 20, y - 9, label, { anchor: "middle", size: 9 });
  }
  ground(x, y) {
    for (const [half, down] of [[7, 0], [4.5, 3], [2, 6]]) this.line([[x - half, y + down], [x + half, y + down]], { width: 1.3 });
  }
  /** A suppressor diode from (x, y) down to ground, 44 long. */
  clamp(x, y, label) {
    this.line([[x, y], [x, y + 16]]);
    this.add(`<path d="M${x - 6},${y + 28} L${x + 6},${y + 28} L${x},${y + 16} Z" fill="#fff" stroke="#111"/>`);
    this.line([[x - 8, y + 19], [x - 6, y + 16], [x + 6, y + 16], [x + 8, y + 13]]);
    this.line([[x, y + 28], [x, y + 44]]);
    this.ground(x, y + 44);
    this.text(x + 10, y + 26, label, { size: 9 });
  }
  svg(title) {
    const { width, height } = this.size;
    return [`<svg xmlns="http://www.w3.org/2000/svg" width="297mm" height="210mm" viewBox="0 0 ${width} ${height}" font-family="DejaVu Sans, Arial, sans-serif">`,
      "<!-- SPDX-License-Identifier: MIT. Drawn by board.mjs write from the netlist. -->",
      `<title>${escaped(title)}</title>`, `<rect width="${width}" height="${height}" fill="#fff"/>`, ...this.shapes, "</svg>", ""].join("\n");
  }
}
