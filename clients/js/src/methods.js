// SPDX-License-Identifier: MIT
// Written by generate.mjs from protocol/schema/openrpc.json.

/** The daemon's methods; parameters by name, as protocol/README.md has them. */
export class Methods {
  /** Who is connected, since when, and what they play. */
  connectionList(params) {
    return this.call("connection.list", params);
  }
  /** Lets the coils be driven again, when the cause of the stop is gone. */
  arm(params) {
    return this.call("device.arm", params);
  }
  /** Only this connection plays until it releases, ends, or is silent. */
  claim(params) {
    return this.call("device.claim", params);
  }
  /** The ball: pins, coils, limits, calibration, identity. */
  describe(params) {
    return this.call("device.describe", params);
  }
  /** Coils off at the next tick, latched until armed. */
  emergencyStop(params) {
    return this.call("device.emergency_stop", params);
  }
  /** The board goes into its boot loader and waits for new firmware; not while it is armed. */
  enterBootLoader(params) {
    return this.call("device.enter_boot_loader", params);
  }
  /** USB and HID devices: which are used, and why the others are not. */
  list(params) {
    return this.call("device.list", params);
  }
  /** Gives a claim back. */
  release(params) {
    return this.call("device.release", params);
  }
  /** Everything that can be known of the ball now. */
  status(params) {
    return this.call("device.status", params);
  }
  /** The field walks round an axis, from pin to pin. */
  circle(axis, params) {
    return this.call("effect.circle", { axis, ...params });
  }
  /** A push that lasts as long as it is renewed. */
  hold(direction, params) {
    return this.call("effect.hold", { direction, ...params });
  }
  /** How long effects took from their request to the board. */
  latency(params) {
    return this.call("effect.latency", params);
  }
  /** Plays key frames, of a named pattern or its own. */
  play(pattern, params) {
    return this.call("effect.play", { pattern, ...params });
  }
  /** What an effect would do, without doing it. */
  preview(params) {
    return this.call("effect.preview", params);
  }
  /** One push towards a direction. */
  pulse(direction, params) {
    return this.call("effect.pulse", { direction, ...params });
  }
  /** Ends one of the connection's own effects. */
  stop(params) {
    return this.call("effect.stop", params);
  }
  /** Ends all effects of the connection, or of everybody. */
  stopAll(params) {
    return this.call("effect.stop_all", params);
  }
  /** Changes a playing effect and renews its lease. */
  update(params) {
    return this.call("effect.update", params);
  }
  /** A push with a waveform. */
  vibrate(direction, params) {
    return this.call("effect.vibrate", { direction, ...params });
  }
  /** What has happened, also before the last start. */
  eventsHistory(params) {
    return this.call("events.history", params);
  }
  /** The front of the ball points at this azimuth now. */
  orientationRecenter(params) {
    return this.call("orientation.recenter", params);
  }
  /** Feeds the orientation from outside. */
  orientationSet(params) {
    return this.call("orientation.set", params);
  }
  /** The owner's comfort setting for everything, stored. */
  outputSetGain(params) {
    return this.call("output.set_gain", params);
  }
  /** One named pattern with its key frames. */
  patternGet(params) {
    return this.call("pattern.get", params);
  }
  /** The named patterns there are. */
  patternList(params) {
    return this.call("pattern.list", params);
  }
  /** Keeps a pattern under vendor/name. */
  patternPut(params) {
    return this.call("pattern.put", params);
  }
  /** Forgets a pattern that was put. */
  patternRemove(params) {
    return this.call("pattern.remove", params);
  }
  /** The device time. */
  ping(params) {
    return this.call("ping", params);
  }
  /** Changes the simulated world. */
  simSet(params) {
    return this.call("sim.set", params);
  }
  /** The simulated ball as it really is. */
  simTruth(params) {
    return this.call("sim.truth", params);
  }
  /** Temperatures and currents of the last minutes. */
  telemetryHistory(params) {
    return this.call("telemetry.history", params);
  }
  /** How long a current or an effect can flow. */
  thermalForecast(params) {
    return this.call("thermal.forecast", params);
  }
}
