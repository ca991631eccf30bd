// SPDX-License-Identifier: MIT
// Written by generate.mjs from protocol/schema/openrpc.json.

/** The daemon's methods; parameters by name, as protocol/README.md has them. */
export class Methods {
  /** The connections, with their start times and effects. */
  connectionList(params) {
    return this.call("connection.list", params);
  }
  /** Arms the ball once the cause of the stop no longer exists. */
  arm(params) {
    return this.call("device.arm", params);
  }
  /** Exclusive use of the ball until release, end of the connection, or expiry of the lease. */
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
  /** Restarts the board in its boot loader, for a firmware update; rejected while armed. */
  enterBootLoader(params) {
    return this.call("device.enter_boot_loader", params);
  }
  /** USB and HID devices: which are used, and why the others are not. */
  list(params) {
    return this.call("device.list", params);
  }
  /** Releases the claim. */
  release(params) {
    return this.call("device.release", params);
  }
  /** State of the ball: temperatures, currents, limits, effects. */
  status(params) {
    return this.call("device.status", params);
  }
  /** The field rotates about an axis, from pin to pin. */
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
  /** Computes currents and temperatures of an effect without starting it. */
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
  /** Ends all effects of the connection, or of all connections. */
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
  /** Past events, including those before the last start. */
  eventsHistory(params) {
    return this.call("events.history", params);
  }
  /** Sets the azimuth of the ball's front. */
  orientationRecenter(params) {
    return this.call("orientation.recenter", params);
  }
  /** Sets the orientation measured by an external sensor. */
  orientationSet(params) {
    return this.call("orientation.set", params);
  }
  /** Gain applied to all effects; persistent. */
  outputSetGain(params) {
    return this.call("output.set_gain", params);
  }
  /** One named pattern with its key frames. */
  patternGet(params) {
    return this.call("pattern.get", params);
  }
  /** Lists the named patterns. */
  patternList(params) {
    return this.call("pattern.list", params);
  }
  /** Stores a pattern under vendor/name. */
  patternPut(params) {
    return this.call("pattern.put", params);
  }
  /** Removes a stored pattern. */
  patternRemove(params) {
    return this.call("pattern.remove", params);
  }
  /** The device time. */
  ping(params) {
    return this.call("ping", params);
  }
  /** Sets orientation, ambient temperature and faults of the simulation. */
  simSet(params) {
    return this.call("sim.set", params);
  }
  /** True state of the simulated ball. */
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
