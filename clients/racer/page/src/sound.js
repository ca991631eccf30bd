// SPDX-License-Identifier: MIT
// What is heard: engine, sliding wheels and blows, made by WebAudio from what the game tells. Off until somebody wants it;
// before that there is no audio context.

const kVolume = 0.5;
/** How fast a sound follows, s. */
const kFollow = 0.05;
/** The engine's tone at a standstill, and for each m/s, Hz. */
const kIdleHz = 46;
const kHzPerMps = 4.2;
const kImpacts = { hit: { hz: 900, seconds: 0.35 }, landing: { hz: 260, seconds: 0.3 } };

/** A second of noise, the same each time. */
function noise(context) {
  const buffer = context.createBuffer(1, context.sampleRate, context.sampleRate);
  const samples = buffer.getChannelData(0);
  let state = 1;
  for (let i = 0; i < samples.length; ++i) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    samples[i] = state / 2147483648 - 1;
  }
  return buffer;
}

export class Sound {
  /** `button`: shows whether it is on. */
  constructor(button) {
    this.button = button;
    this.context = null;
    this.on = false;
    document.addEventListener("visibilitychange", () => document.hidden && this.rest());
  }

  toggle() {
    this.on = !this.on;
    this.button.setAttribute("aria-pressed", this.on);
    if (this.on && !this.context) this.build();
    if (this.on) this.context.resume();
    else this.context.suspend();
  }

  build() {
    const context = new AudioContext();
    this.context = context;
    this.master = new GainNode(context, { gain: kVolume });
    this.master.connect(context.destination);
    this.noise = noise(context);
    this.engine = new OscillatorNode(context, { type: "sawtooth", frequency: kIdleHz });
    this.muffler = new BiquadFilterNode(context, { type: "lowpass", frequency: 300, Q: 2 });
    this.engineGain = new GainNode(context, { gain: 0 });
    this.engine.connect(this.muffler).connect(this.engineGain).connect(this.master);
    this.engine.start();
    const tyres = new AudioBufferSourceNode(context, { buffer: this.noise, loop: true });
    this.tyreGain = new GainNode(context, { gain: 0 });
    tyres.connect(new BiquadFilterNode(context, { type: "bandpass", frequency: 1400, Q: 3 })).connect(this.tyreGain).connect(this.master);
    tyres.start();
  }

  follow(parameter, value) {
    parameter.setTargetAtTime(value, this.context.currentTime, kFollow);
  }

  /** Nothing moves, or nobody tells. */
  rest() {
    if (!this.context) return;
    this.follow(this.engineGain.gain, 0);
    this.follow(this.tyreGain.gain, 0);
  }

  scene({ speed_mps: speed, throttle, wheels, paused }) {
    if (!this.on) return;
    if (paused) {
      this.rest();
      return;
    }
    this.follow(this.engine.frequency, kIdleHz + kHzPerMps * Math.abs(speed));
    this.follow(this.muffler.frequency, 250 + 900 * throttle + 12 * Math.abs(speed));
    this.follow(this.engineGain.gain, 0.1 + 0.16 * throttle);
    this.follow(this.tyreGain.gain, 0.35 * Math.max(0, ...wheels.map(({ skid, contact }) => (contact ? skid : 0))));
  }

  felt({ kind, strength }) {
    const impact = kImpacts[kind];
    if (!this.on || !impact) return;
    const { context } = this;
    const now = context.currentTime;
    const source = new AudioBufferSourceNode(context, { buffer: this.noise });
    const gain = new GainNode(context, { gain: 0.25 + 0.75 * strength });
    gain.gain.setTargetAtTime(0, now, impact.seconds / 4);
    source.connect(new BiquadFilterNode(context, { type: "lowpass", frequency: impact.hz })).connect(gain).connect(this.master);
    source.start(now);
    source.stop(now + impact.seconds);
  }
}
