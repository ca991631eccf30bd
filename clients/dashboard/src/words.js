// SPDX-License-Identifier: MIT
// What the protocol's names mean, in words for a person who holds the ball.

export const kStates = {
  armed: "Armed",
  disarmed: "Disarmed",
  tripped: "Tripped",
  absent: "No ball",
};

const kReasons = {
  never_armed: "It has not been armed since the start.",
  unclean_stop: "The daemon was not stopped in an orderly way last time.",
  hot_plug: "The ball was plugged in while the daemon ran.",
  emergency_stop: "Somebody pressed stop.",
  no_board: "No board answers.",
  boot_loader: "The board is in its boot loader.",
  too_hot: "It is too hot for a push that can be felt.",
  overheated: "A winding reached its highest temperature.",
  sensor_open: "The coil thermometer's wire is open.",
  sensor_short: "The coil thermometer's wire is shorted.",
  sensor_stale: "The coil thermometer gives no new readings.",
  sensor_frozen: "The coil thermometer does not change although its winding gets warmer.",
  sensor_jump: "The coil thermometer jumped faster than any heat could.",
  sensor_implausible: "The coil thermometer reads an impossible value.",
  sensor_disagrees: "Thermometer and winding resistance disagree.",
  unexpected_current: "Current flowed without a command, or more than is measured.",
  current_mismatch: "The measured current is not what the coil should take.",
  bridge_fault: "A bridge of the board reports a fault.",
  fan_stopped: "The fan is driven but does not turn.",
  telemetry_lost: "The board stopped answering.",
  thermometer_lost: "The second thermometer is silent.",
  thermometer_disagrees: "The two thermometers disagree.",
  shell_hot: "The ball's skin is too warm to hold.",
  state_lost: "Its saved state is damaged or of another ball; whether it had tripped is unknown.",
  measurements_disagree: "Measurements contradict each other.",
  internal: "The control loop computed a non-finite number.",
  board_dead_man: "The board received no set-point for 100 ms; its dead-man timer switched the coils off.",
  board_over_current: "The board measured too much current.",
  board_over_heat: "The board's own heat limit was reached.",
  board_heat_budget: "The board's own heat budget was used up.",
  board_stuck_bridge: "Current flowed after switching off; the board opened its supply switch.",
  board_supply: "The supply voltage is out of range.",
};

/** "sensor_open" as a person reads it; of any value. */
const words = (name) => String(name ?? "").replaceAll("_", " ");

/** "winding y: resistance, heat balance"; of a trip that names no contradiction nothing. */
export function contradiction(found) {
  if (!found) return "";
  return `winding ${"xyz"[found.coil] ?? found.coil}: ${found.between.map(words).join(", ")}`;
}

export function reason(name) {
  if (!name) return "";
  return kReasons[name] ?? `${words(name)}.`;
}

/** An event as a person would tell it, however little of it is there; of several of its kind how many. */
export function eventText(event) {
  return single(event) + (event.count > 1 ? `, ${counted(event.count, "time")}` : "");
}

function single(event) {
  switch (event.type) {
    case "state_changed": {
      const measured = [contradiction(event.disagreement), event.temperature_c === undefined ? "" : degrees(event.temperature_c),
        event.current_a === undefined ? "" : amperes(event.current_a), event.client ?? ""].filter(Boolean);
      const why = reason(event.reason).replace(/\.$/, "");
      return [kStates[event.state] ?? event.state, why, measured.join(", ")].filter(Boolean).join(" · ");
    }
    case "effect_ended": {
      const what = event.method ? String(event.method).replace("effect.", "") : `effect ${event.effect}`;
      const whose = event.client ? ` of ${event.client}` : "";
      const played = event.onset_ns ? `, ${Math.round((event.offset_ns - event.onset_ns) / 1e6)} ms` : "";
      return `${what}${whose}: ${words(event.reason ?? "ended")}${played}`;
    }
    case "derating_started":
    case "derating_ended":
      return `${event.type === "derating_started" ? "Derated" : "Full strength again"}: ${amperes(event.limit_a)} allowed`;
    case "overrun":
      return `${Number.isFinite(event.skipped) ? counted(event.skipped, "tick") : "Some ticks"} of the loop skipped`;
    default: {
      const what = words(event.type);
      const detail = words(event.device ?? event.reason) || contradiction(event.disagreement);
      return what.charAt(0).toUpperCase() + what.slice(1) + (detail ? `: ${detail}` : "");
    }
  }
}

export const kFaults = {
  "": "none",
  sensor_open: "thermometer: wire open",
  sensor_short: "thermometer: wire shorted",
  sensor_frozen: "thermometer: frozen",
  sensor_jump: "thermometer: jumps",
  sensor_stale: "thermometer: no new readings",
  sensor_offset: "thermometer: slipped off",
  stuck_bridge: "bridge: stuck on",
  bridge_fault: "bridge: reports a fault",
  open_winding: "coil: unplugged",
  current_sense: "current measurement: wrong",
  fan_stopped: "fan: stopped",
  supply_low: "supply: too low",
  silent: "board: silent",
};

const number = (value) => (Number.isFinite(value) ? value.toFixed(1) : "–");
export const amperes = (a) => `${number(a)} A`;
export const degrees = (c) => (c === null || c === undefined ? "–" : `${number(c)} °C`);
/** "1 tick", "2,500 ticks". */
export const counted = (count, noun) => `${count.toLocaleString("en")} ${noun}${count === 1 ? "" : "s"}`;
/** A pattern's wave: "square, 25 Hz, on for 50 %"; empty: none. */
export const waveWords = ({ waveform, frequency_hz: hertz, on_fraction: on }) => [
  waveform, hertz === undefined ? null : `${hertz} Hz`, on === undefined ? null : `on for ${Math.round(100 * on)} %`,
].filter(Boolean).join(", ");
/** A time that the ball can go on; null: for ever. `known`: how warm it is, without which nobody can tell. */
export const lasting = (s, known, digits = 0) => {
  if (!known || s === undefined) return "not known";
  if (s === null) return "for ever";
  return s < 100 ? `${s.toFixed(digits)} s` : `${(s / 60).toFixed(0)} min`;
};

/** Whether `temperature` of a status tells how warm the ball is: an estimate without a thermometer is a guess. */
export const isHeatKnown = ({ model, sensor }) => Number.isFinite(model) && Number.isFinite(sensor);

const kLimits = {
  thermal: "heat", mix: "what else plays", priority: "what is more important", configuration: "the owner's settings",
};
/** ", limited by heat": why less is played than was asked; "" where it is not. */
export const limitation = (name) => (name ? `, limited by ${kLimits[name] ?? words(name)}` : "");

/** What an error says to a person: its sentence without the protocol's name of it. */
export function errorMessage({ message, data }) {
  const name = data?.name ? `${data.name}: ` : "";
  const sentence = name && message.startsWith(name) ? message.slice(name.length) : message;
  const text = sentence.replace(/^[a-z]+\.[a-z_]+: /, "");
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** "front", "left and up": where a vector of the ball's frame points. */
export function whither([x, y, z]) {
  const parts = [
    [Math.abs(x), x > 0 ? "front" : "back"],
    [Math.abs(y), y > 0 ? "left" : "right"],
    [Math.abs(z), z > 0 ? "up" : "down"],
  ];
  const named = parts.filter(([size]) => size > 0.38).sort((a, b) => b[0] - a[0]);
  return named.map(([, word]) => word).join(" and ") || "nowhere";
}
