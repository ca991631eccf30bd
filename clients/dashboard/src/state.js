// SPDX-License-Identifier: MIT
// The card of what matters first: may the ball play and why not, and how hot the hottest winding is beside the
// temperatures at which it is derated and trips. Each winding is one click away.
import { contradiction, degrees, kStates, reason } from "./words.js";

const $ = (id) => document.getElementById(id);

function put(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

export class StateCard {
  /** `arm`: the button, which keeps its place while it is away. */
  constructor(arm) {
    this.arm = arm;
    this.mayArm = false;
  }

  describe(hello, device) {
    this.mayArm = hello.role === "operate";
    const { derate_from_c: derates, trip_c: trips } = device.limits;
    put($("thresholds"), `Derated from ${degrees(derates)}, trips at ${degrees(trips)}.`);
    const on = "xyz"[device.thermal?.sensor_winding];
    put($("thermistor-name"), on ? `Thermistor on winding ${on}` : "Thermistor");
    put($("thermistor-legend"), on ? `thermistor on ${on}` : "thermistor");
  }

  show(status) {
    const { state } = status;
    document.body.dataset.state = state;
    // Amber: less than what is asked, or nothing, can be felt.
    document.body.dataset.derating = status.derating || (state === "armed" && Boolean(status.reason));
    put($("state"), status.derating ? "Armed, derated" : kStates[state] ?? state);
    put($("why"), status.reason || !status.derating ? reason(status.reason) : "Less current than requested until the ball has cooled.");
    put($("remedy"), status.remedy ? `${status.remedy}.` : "");
    this.arm.classList.toggle("away", !this.mayArm || !["disarmed", "tripped"].includes(state));
    const trip = status.last_trip;
    put($("trip"), trip ? `Last trip: ${[reason(trip.reason), contradiction(trip.disagreement)].filter(Boolean).join(" ")}` : "");
    this.showHeat(status.temperature_c);
  }

  showHeat(temperature) {
    const { model, sensor, upper, skin, coils, sensors } = temperature;
    const known = Number.isFinite(model);
    put($("hottest"), known ? degrees(model) : "not known");
    put($("bound"), known && Number.isFinite(upper) ? `at most ${degrees(upper)}` : "");
    put($("thermistor"), Number.isFinite(sensor) ? degrees(sensor) : "no reading");
    put($("skin"), Number.isFinite(skin) ? `· skin at most ${degrees(skin)}` : "");
    for (const [i, cell] of document.querySelectorAll("[data-winding]").entries()) put(cell, known ? degrees(coils[i]) : "–");
    for (const [i, cell] of document.querySelectorAll("[data-sensor]").entries()) put(cell, sensors ? degrees(sensors[i]) : "–");
  }
}
