// SPDX-License-Identifier: MIT
// A forecast as sound, for a person without a ball in the hand: a tone as loud as the current, on the side of the push.

/** The tone of a push, which has no frequency of its own. */
const kPushHz = 110;
/** Slower waves are no tone; the forecast's currents have their beats. */
const kLowestToneHz = 30;
/** Of full scale: headphones must not startle. */
const kLoudest = 0.3;
const kToneWaves = ["sine", "square", "triangle", "sawtooth"];

/** The mean of `count` steps around step `i`. */
function meanLevel(steps, i, count) {
  const first = Math.max(0, i - Math.floor(count / 2));
  const around = steps.slice(first, first + count);
  return around.reduce((sum, { level }) => sum + level, 0) / around.length;
}

/**
 * Puts the sound of `steps` into `context` from the time `at` on: {level, side} of each `stepS` seconds, level 0..1 of the
 * strength, side from -1, left, to 1, right. `wave`: parameters of `effect.play`. Returns its oscillator.
 */
export function render(context, { steps, stepS, wave }, at) {
  const isTone = kToneWaves.includes(wave.waveform) && wave.frequency_hz >= kLowestToneHz;
  const tone = new OscillatorNode(context, isTone ? { type: wave.waveform, frequency: wave.frequency_hz } : { type: "triangle", frequency: kPushHz });
  const loudness = new GainNode(context, { gain: 0 });
  const side = new StereoPannerNode(context, { pan: steps[0]?.side ?? 0 });
  tone.connect(loudness).connect(side).connect(context.destination);
  loudness.gain.setValueAtTime(0, at);
  side.pan.setValueAtTime(steps[0]?.side ?? 0, at);
  // A tone is not modulated by its own wave once more.
  const period = isTone ? Math.max(1, Math.round(1 / (wave.frequency_hz * stepS))) : 1;
  steps.forEach((step, i) => {
    const middle = at + (i + 0.5) * stepS;
    loudness.gain.linearRampToValueAtTime(kLoudest * meanLevel(steps, i, period), middle);
    side.pan.linearRampToValueAtTime(step.side, middle);
  });
  const end = at + steps.length * stepS;
  loudness.gain.linearRampToValueAtTime(0, end);
  tone.start(at);
  tone.stop(end);
  return tone;
}

export class Audition {
  constructor() {
    this.context = null;
    this.tone = null;
  }

  /** Browsers allow sound from a press of a button on. */
  async enable(on) {
    this.silence();
    const { context } = this;
    this.context = on ? new AudioContext() : null;
    await context?.close();
  }

  /** Ends the sound before it, of an effect that has been edited since. */
  play(sound) {
    this.silence();
    if (this.context) this.tone = render(this.context, sound, this.context.currentTime);
  }

  silence() {
    this.tone?.stop();
    this.tone = null;
  }
}
