// SPDX-License-Identifier: MIT
// The wiring diagram of a board on an A4 page. Placed by hand below; what is written at each pin, nets, ends of the wire
// and the small parts on it, comes from the netlist.
import { colour, Sheet } from "./sheet.mjs";

const kRails = new Set(["GND", "VM", "12V", "12V_IN", "VM_SW", "FAN_F", "FAN_12V", "VBUS", "3V3", "AVDD"]);
const kSmall = new Set(["resistor", "capacitor", "trimmer"]);
const kRow = 14;
/** Numbers of the module's pins. */
const kPicoLeft = ["GP0", "GP1", "GND", "GP2", "GP3", "GP4", "GP5", "", "GP6", "GP7", "GP8", "GP9", "", "GP10", "GP11", "GP12", "GP13", "", "GP14", "GP15"];
const kPicoRight = ["VBUS", "VSYS", "", "3V3_EN", "3V3", "ADC_VREF", "GP28", "AGND", "GP27", "GP26", "RUN", "GP22", "", "GP21", "GP20", "GP19", "GP18", "", "GP17", "GP16"];

class Diagram {
  constructor(board, types) {
    this.board = board;
    this.types = types;
    this.sheet = new Sheet(1188, 840);
    this.shown = new Set();  // small parts that stand somewhere
  }
  part(ref) {
    return this.board.parts.get(ref);
  }
  /** "PWM_A → U1.GP0 · R7 10k to GND": the net at a pin, as far as it has not been told at this part. */
  label(part, pin) {
    const net = part.pins.get(pin);
    if (!net) return null;
    const ends = [];
    const small = [];
    for (const other of this.board.parts.values()) {
      const on = [...other.pins].filter(([, name]) => name === net);
      if (on.length === 0 || other === part) continue;
      if (kSmall.has(other.kind)) {
        const far = [...other.pins.values()].find((name) => name !== net);
        const here = other.at === undefined ? !kRails.has(net) : other.at === part.ref;
        if (!here || net === "GND" || this.shown.has(other.ref)) continue;
        this.shown.add(other.ref);
        small.push(`${other.ref} ${other.valueText} to ${far}`);
      } else if (!kRails.has(net)) {
        ends.push(...on.map(([name]) => `${other.ref}.${name}`));
      }
    }
    return { net, text: [ends.length ? `→ ${ends.join(" ")}` : "", ...small.map((one) => `· ${one}`)].filter(Boolean).join(" ") };
  }
  flag(part, pin, x, y, side) {
    const label = this.label(part, pin);
    const way = side === "left" ? -1 : 1;
    if (!label) {
      this.sheet.text(x + 6 * way, y + 3, "free", { size: 8, anchor: side === "left" ? "end" : "start", fill: "#888" });
      return;
    }
    this.sheet.line([[x, y], [x + 10 * way, y]], { stroke: colour(label.net) });
    const tail = label.text ? ` ${label.text}` : "";
    const at = { x: x + 13 * way, y: y + 3.2, anchor: side === "left" ? "end" : "start" };
    const escape = (text) => text.replaceAll("&", "&amp;");
    this.sheet.add(`<text x="${at.x}" y="${at.y}" font-size="10" text-anchor="${at.anchor}"><tspan font-weight="bold" fill="${colour(label.net)}">${label.net}</tspan><tspan fill="#333">${escape(tail)}</tspan></text>`);
  }
  /** A box with pins; "" leaves a row out. `at` gives where each pin's wire begins. */
  module(ref, x, y, width, left, right, { numbers = false, wired = [], title = null } = {}) {
    const part = this.part(ref);
    if (!part) return { part: null, at: new Map(), bottom: y };
    const rows = Math.max(left.length, right.length);
    const height = rows * kRow + 8;
    this.sheet.box(x, y, width, height);
    this.sheet.text(x, y - 4, `${ref} ${title ?? part.type}`, { bold: true });
    const at = new Map();
    const side = (pins, edge, way) => pins.forEach((pin, i) => {
      if (pin === "") return;
      const py = y + 4 + kRow * (i + 0.5);
      at.set(pin, [edge, py]);
      const number = numbers ? (way === "left" ? i + 1 : 40 - i) : this.types.get(part.type).pins.get(pin).number ?? null;
      this.sheet.text(edge + (way === "left" ? 4 : -4), py + 3.2, number === null ? pin : way === "left" ? `${number} ${pin}` : `${pin} ${number}`,
        { size: 9, anchor: way === "left" ? "start" : "end" });
      if (!wired.includes(pin)) this.flag(part, pin, edge, py, way);
    });
    side(left, x, "left");
    side(right, x + width, "right");
    return { part, at, bottom: y + height };
  }
  net(text, x, y, anchor = "middle") {
    this.sheet.text(x, y, text, { size: 9, bold: true, anchor, fill: colour(text) });
  }

  power() {
    const { sheet } = this;
    const y = 82;
    const thick = { width: 3, stroke: colour("12V") };
    const j1 = this.module("J1", 24, 60, 50, [], ["", "+", "", "-"], { wired: ["+", "-"], title: "12 V" });
    const minus = j1.at.get("-");
    sheet.line([[74, minus[1]], [96, minus[1]], [96, minus[1] + 10]], { width: 3 });
    sheet.ground(96, minus[1] + 10);
    this.net("GND", 112, minus[1] + 16, "start");
    const wire = (from, to) => sheet.line([[from, y + 3], [to, y + 3]], thick);
    wire(74, 120);
    this.net("12V_IN", 96, y - 5);
    sheet.horizontal(120, y + 3, `F1 ${this.part("F1").value} A`, thick);
    wire(160, 300);
    this.net("12V", 190, y - 5);
    this.module("Q1", 300, 64, 76, ["", "VS", "IN", "IS", "GND"], ["", "OUT"], { wired: ["VS", "OUT"], title: "BTS50010, supply switch" });
    wire(376, 420);
    this.net("VM_SW", 396, y - 5);
    sheet.horizontal(420, y + 3, "RS4 1m", { ...thick, solid: true });
    wire(460, 640);
    this.net("VM", 600, y - 5);
    sheet.text(646, y - 4, "→ M1.VIN  M2.VIN  M3.VIN", { size: 9 });
    sheet.text(646, y + 8, "star from here, short, 2.5 mm²; C1 C2 C3 beside the bridges", { size: 9 });
    sheet.text(646, y + 24, `R32 ${this.part("R32").valueText} from VM to GND`, { size: 9 });
    this.shown.add("R32");
    sheet.dot(600, y + 3);
    sheet.clamp(600, y + 3, "D1");
    const u5 = this.module("U5", 440, 150, 70, ["REF1", "REF2", "VS", "GND"], ["IN+", "IN-", "OUT"], { wired: ["IN+", "IN-"] });
    const sense = (pin, x, net, turn) => {
      const [px, py] = u5.at.get(pin);
      sheet.line([[x, y + 8], [x, y + 22 + turn], [px + 20 + turn, y + 22 + turn], [px + 20 + turn, py], [px, py]]);
      this.net(net, px + 36, py + 3, "start");
    };
    sense("IN+", 426, "IVM_P", 10);
    sense("IN-", 454, "IVM_N", 2);
    // The divider, drawn where it is tapped; what it reaches stands at the converter.
    sheet.dot(190, y + 3);
    sheet.line([[190, y + 3], [190, y + 12]]);
    sheet.text(24, 160, "From 12V, before the switch:", { size: 10 });
    const rows = [["F2", "12V", "FAN_F, of the fan"], ["R3", "12V", "V_SUP"], ["R4", "V_SUP", "GND"], ["C4", "12V", "GND, beside Q1"]];
    rows.forEach(([ref, from, to], i) => sheet.text(24, 174 + 13 * i, `${ref} ${this.part(ref).valueText}  from ${from} to ${to}`, { size: 10 }));
    for (const [ref] of rows) this.shown.add(ref);
  }

  fan() {
    this.module("U8", 820, 150, 60, ["A", "VCC"], ["Y", "GND"]);
    this.module("J6", 1080, 66, 50, ["12V", "GND", "TACH", "PWM"], [], { title: "FAN" });
    this.module("U9", 700, 219, 60, ["IN", "GND"], ["OUT"]);
    this.module("U6", 970, 200, 70, ["IN", "GND"], ["OUT"]);
  }

  channel(letter, x, y, refs) {
    const { sheet } = this;
    const [driver, connector, shunt, amp] = refs;
    const m = this.module(driver, x, y, 74, ["VIN", "PWM", "DIR", "SLP", "FLT", "CS", "VREF", "GND"], ["", "OUTA", "", "", "", "OUTB"],
      { wired: ["OUTA", "OUTB"], title: `G2 18v17, bridge ${letter}` });
    const [ax, ay] = m.at.get("OUTA");
    const [, by] = m.at.get("OUTB");
    const thick = { width: 3, stroke: "#0b4f8a" };
    const jx = ax + 100;
    sheet.box(jx, ay - 14, 32, by - ay + 28);
    sheet.text(jx + 32, ay - 20, `${connector} winding`, { bold: true, size: 9, anchor: "end" });
    sheet.text(jx + 4, ay + 3, "1", { size: 9 });
    sheet.text(jx + 4, by + 3, "2", { size: 9 });
    sheet.add(`<path d="M${jx + 18},${ay} ${[0, 1, 2, 3].map((i) => `A6,6 0 0 1 ${jx + 18},${ay + (i + 1) * (by - ay) / 4}`).join(" ")}" fill="none" stroke="#0b4f8a" stroke-width="1.5"/>`);
    sheet.line([[ax, by], [jx, by]], thick);
    this.net(`RET_${letter}`, ax + 50, by + 12);
    this.net(`DRV_${letter}`, ax + 3, ay - 7, "start");
    if (!this.part(shunt)) {
      sheet.line([[ax, ay], [jx, ay]], thick);
      return;
    }
    sheet.line([[ax, ay], [ax + 26, ay]], thick);
    sheet.horizontal(ax + 26, ay, "", { ...thick, solid: true });
    sheet.text(ax + 46, ay - 17, `${shunt} ${this.part(shunt).valueText}`, { size: 9, anchor: "middle" });
    sheet.line([[ax + 66, ay], [jx, ay]], thick);
    this.net(`COIL_${letter}`, ax + 62, ay - 7, "start");
    const u = this.module(amp, x, y + 158, 74, ["VS", "REF1", "REF2", "GND", "OUT"], ["IN+", "IN-"], { wired: ["IN+", "IN-"] });
    const sense = (pin, sx, down, out) => {
      const [px, py] = u.at.get(pin);
      sheet.line([[sx, ay + 5], [sx, ay + down], [px + out, ay + down], [px + out, py], [px, py]], { stroke: "#555" });
      this.net(u.part.pins.get(pin), px + 34, py + 3, "start");
    };
    sense("IN+", ax + 32, 20, 14);
    sense("IN-", ax + 60, 28, 26);
  }

  control() {
    this.module("U1", 276, 530, 112, kPicoLeft, kPicoRight, { numbers: true });
    this.module("U7", 800, 580, 84, ["CH0", "CH1", "CH2", "CH3", "CH4", "CH5", "CH6", "CH7"],
      ["VDD", "VREF", "AGND", "CLK", "DOUT", "DIN", "CS", "DGND"]);
    const pins = [...this.part("J5").pins.keys()];
    this.module("J5", 800, 730, 76, pins, [], { title: `thermistor${pins.length > 2 ? "s" : ""}: ${this.part("J5").note}` });
  }

  draw() {
    const { sheet, board } = this;
    sheet.text(24, 26, board.title, { size: 17, bold: true });
    sheet.text(1164, 26, "Wires of one name are joined. → other ends · small parts on the wire", { size: 10, anchor: "end" });
    this.power();
    this.fan();
    const channels = [["A", 195, ["M1", "J2", "RS1", "U2"]], ["B", 585, ["M2", "J3", "RS2", "U3"]], ["C", 975, ["M3", "J4", "RS3", "U4"]]];
    for (const [letter, x, refs] of channels) this.channel(letter, x, 268, refs);
    this.control();
    sheet.text(24, 834, "All grounds meet at one point, at J1. Thick: up to 16.5 A. Amplifiers are wired to the shunts' own sense terminals, twisted.", { size: 9 });
    return sheet.svg(board.title);
  }
}

export const diagram = (board, types) => new Diagram(board, types).draw();
