// SPDX-License-Identifier: MIT
// Sound as it is heard, from a microphone or a file, as effects: what begins in it pushes, its low tones vibrate.
// The rules are those of clients/sound, but for onsets in windows of 20 ms.

const kCrossoverHz = 150;
const kTickMs = 20;
/** High tones are kept for a timer whose calls are 0.15 s apart, on a busy page, and their last window. */
const kKeptS = 0.17;
/** The window of the low tones, samples. */
const kLowWindow = 2048;
const kLeaseMs = 250;
const kPulseMs = 25;
/** Windows between two pushes: 60 ms. */
const kApart = 3;
/** Amplitudes below it are silence. */
const kSilence = 0.01;
/** Power of an onset over that of the last windows: 6 dB. */
const kRise = 4;
const kBefore = 3;

/** Left 90, right -90. */
export const azimuth = (left, right) => Math.round(90 - (2 * Math.atan2(right, left) * 180) / Math.PI);

export class Listener {
  /** `strength()`: {current_a, felt_a}. `onPushes(pushes)`: after each push; `ended()`: the file is over. */
  constructor(link, { strength, onPushes, ended }) {
    Object.assign(this, { link, strength, onPushes, ended });
    this.context = null;
  }

  async startMicrophone() {
    const stream = await navigator.mediaDevices.getUserMedia(
      { audio: { echoCancellation: false, noiseSuppression: false, autoGainControl: false } });
    await this.stop();
    this.stream = stream;
    this.begin();
    this.analyse(this.context.createMediaStreamSource(stream));
  }

  async startFile(file) {
    await this.stop();
    this.begin();
    const context = this.context;
    const buffer = await context.decodeAudioData(await file.arrayBuffer());
    // Stopped, or another one started meanwhile.
    if (this.context !== context) return;
    const source = context.createBufferSource();
    source.buffer = buffer;
    source.onended = () => {
      if (this.context !== context) return;
      this.poll();
      this.stop().then(this.ended);
    };
    this.analyse(source);
    source.connect(context.destination);
    source.start();
  }

  begin() {
    this.context = new AudioContext();
    this.pushes = 0;
    this.before = [];
    /** Frames of the context whose high tones have been looked at. */
    this.seen = 0;
    this.sincePush = kApart;
    this.vibrating = false;
  }

  /** Four analysers: low and high, left and right. */
  analyse(source) {
    const { context } = this;
    const sides = context.createChannelSplitter(2);
    // One channel on both sides.
    const stereo = new GainNode(context, { channelCount: 2, channelCountMode: "explicit", channelInterpretation: "speakers" });
    source.connect(stereo).connect(sides);
    // A power of two, as analysers require.
    const kept = Math.min(32_768, 2 ** Math.ceil(Math.log2(kKeptS * context.sampleRate)));
    this.analysers = {};
    for (const type of ["lowpass", "highpass"]) {
      this.analysers[type] = [0, 1].map((side) => {
        const first = new BiquadFilterNode(context, { type, frequency: kCrossoverHz, Q: -5.33 });
        const second = new BiquadFilterNode(context, { type, frequency: kCrossoverHz, Q: 2.32 });
        const analyser = new AnalyserNode(context, { fftSize: type === "lowpass" ? kLowWindow : kept });
        sides.connect(first, side).connect(second).connect(analyser);
        return { analyser, samples: new Float32Array(analyser.fftSize) };
      });
    }
    this.timer = setInterval(() => this.poll(), kTickMs);
  }

  samples(type) {
    return this.analysers[type].map(({ analyser, samples }) => {
      analyser.getFloatTimeDomainData(samples);
      return samples;
    });
  }

  power(samples) {
    let [sum, peak, periods] = [0, 0, 0];
    for (let i = 0; i < samples.length; ++i) {
      sum += samples[i] * samples[i];
      peak = Math.max(peak, Math.abs(samples[i]));
      if (i > 0 && samples[i - 1] < 0 && samples[i] >= 0) periods += 1;
    }
    const seconds = samples.length / this.context.sampleRate;
    return { mean: sum / samples.length, peak: Math.min(1, peak), frequency: periods / seconds };
  }

  /** Amplitude 0..1 as what can be felt of the strength. */
  level(amplitude) {
    const { current_a, felt_a } = this.strength();
    const felt = current_a > felt_a ? felt_a / current_a : 0;
    return Number((felt + (1 - felt) * Math.min(1, amplitude)).toFixed(3));
  }

  poll() {
    if (this.context?.state !== "running") return;
    const { sampleRate, currentTime } = this.context;
    const now = Math.round(currentTime * sampleRate);
    const size = Math.round((sampleRate * kTickMs) / 1000);
    const kept = this.samples("highpass");
    const first = now - kept[0].length;
    this.seen = Math.max(this.seen, first);
    let onset = null;
    for (; this.seen + size <= now; this.seen += size) {
      const from = this.seen - first;
      const high = kept.map((samples) => this.power(samples.subarray(from, from + size)));
      if (this.isOnset(high)) onset = high;
    }
    // Of several that are late only the last: together they would be one push that is too strong.
    if (onset) this.push(onset);
    this.vibrate(this.samples("lowpass").map((samples) => this.power(samples)));
  }

  /** The high tones of the next window rise over those before. */
  isOnset([left, right]) {
    const mean = Math.max(left.mean, right.mean);
    const rises = Math.max(left.peak, right.peak) > 2 * kSilence && mean > 1e-6 && mean > kRise * Math.max(0, ...this.before);
    this.before = [...this.before, mean].slice(-kBefore);
    this.sincePush += 1;
    if (!rises || this.sincePush < kApart) return false;
    this.sincePush = 0;
    return true;
  }

  push([left, right]) {
    this.pushes += 1;
    this.link.notify("effect.pulse", { direction: { azimuth_deg: azimuth(left.peak, right.peak) }, duration_ms: kPulseMs,
      current_a: this.strength().current_a, gain: this.level(Math.max(left.peak, right.peak)) });
    this.onPushes(this.pushes);
  }

  vibrate([left, right]) {
    const [l, r] = [left, right].map(({ mean }) => Math.sqrt(2 * mean));
    const louder = l >= r ? left : right;
    if (Math.max(l, r) < kSilence) {
      if (this.vibrating) this.link.notify("effect.stop", { slot: "sound" });
      this.vibrating = false;
      return;
    }
    this.vibrating = true;
    this.link.notify("effect.vibrate", { slot: "sound", direction: { azimuth_deg: azimuth(l, r) }, waveform: "sine",
      frequency_hz: Math.min(kCrossoverHz, Math.max(20, Math.round(louder.frequency))),
      current_a: this.strength().current_a, gain: this.level(Math.max(l, r)), lease_ms: kLeaseMs });
  }

  async stop() {
    clearInterval(this.timer);
    const { context, stream } = this;
    this.context = this.stream = null;
    for (const track of stream?.getTracks() ?? []) track.stop();
    if (this.vibrating) this.link.notify("effect.stop", { slot: "sound" });
    this.vibrating = false;
    if (context && context.state !== "closed") await context.close();
  }
}
