// SPDX-License-Identifier: MIT
// A forecast as sound, for a person without a ball in the hand: a tone as loud as the current, on the side of the push.

/** The tone of a push, which has no frequency of its own. */
const kPushHz = 110;
/** Slower waves are no tone: they are heard as the forecast's currents rise and fall, as far as its steps show it. */
const kMinToneHz = 30;
/** Of a wave without `frequency_hz`: the protocol's. */
const kWaveHz = 60;
/** Of full scale: headphones must not startle. */
const kMaxGain = 0.3;
const kFadeS = 0.02;
const kPeriods = 4;
const kToneWaves = ["sine", "square", "triangle", "sawtooth"];

/** The mean of `count` steps around step `i`. */
function meanLevel(steps, i, count) {
  const first = Math.max(0, i - Math.floor(count / 2));
  const around = steps.slice(first, first + count);
  return around.reduce((sum, { level }) => sum + level, 0) / around.length;
}

/**
 * Puts the sound of `steps` into `context` from the time `at` on: {level, side} of each `stepS` seconds, level 0..1 of the
 * strength, side from -1, left, to 1, right. `wave`: parameters of `effect.play`. Returns its oscillator and its gain.
 */
export function render(context, { steps, stepS, wave }, at) {
  const hz = wave.frequency_hz ?? kWaveHz;
  const isTone = kToneWaves.includes(wave.waveform) && hz >= kMinToneHz;
  const tone = new OscillatorNode(context, isTone ? { type: wave.waveform, frequency: hz } : { type: "triangle", frequency: kPushHz });
  const loudness = new GainNode(context, { gain: 0 });
  const side = new StereoPannerNode(context, { pan: steps[0]?.side ?? 0 });
  tone.connect(loudness).connect(side).connect(context.destination);
  loudness.gain.setValueAtTime(0, at);
  side.pan.setValueAtTime(steps[0]?.side ?? 0, at);
  // The currents have the wave, too, sampled by steps: over some periods a tone is not modulated by it.
  const count = isTone ? Math.ceil(kPeriods / (hz * stepS)) : 1;
  steps.forEach((step, i) => {
    const middle = at + (i + 0.5) * stepS;
    loudness.gain.linearRampToValueAtTime(kMaxGain * meanLevel(steps, i, count), middle);
    side.pan.linearRampToValueAtTime(step.side, middle);
  });
  const end = at + steps.length * stepS;
  loudness.gain.linearRampToValueAtTime(0, end);
  tone.start(at);
  tone.stop(end);
  return { tone, gain: loudness.gain };
}

export class Audition {
  constructor() {
    this.context = null;
    /** What `render` returned last; null: it was silenced. */
    this.sounding = null;
    /** The effect of that sound, as text; empty: none. */
    this.effect = "";
  }

  /** To be called from a click: browsers allow no sound before. */
  async enable(on) {
    this.silence();
    const { context } = this;
    this.context = on ? new AudioContext() : null;
    await context?.close();
  }

  /** Silence, unless the sound is that of `effect`. */
  endOthers(effect) {
    if (effect !== this.effect) this.silence();
  }

  /** Replaces the sound that plays; that of the same `effect` is not repeated. */
  play(effect, sound) {
    if (!this.context || effect === this.effect) return;
    this.silence();
    this.effect = effect;
    this.sounding = render(this.context, sound, this.context.currentTime);
  }

  silence() {
    this.effect = "";
    if (!this.sounding) return;
    const { tone, gain } = this.sounding;
    this.sounding = null;
    const now = this.context.currentTime;
    // From its present value: a jump would click.
    const { value } = gain;
    gain.cancelScheduledValues(now);
    gain.setValueAtTime(value, now);
    gain.linearRampToValueAtTime(0, now + kFadeS);
    tone.stop(now + kFadeS);
  }
}
