// SPDX-License-Identifier: MIT
#include "tests/firmware/vectors.h"

#include "daemon/device/board_core/crc32.h"
#include "daemon/device/board_core/port.h"

namespace hedgehog::firmware {
namespace {

using namespace hedgehog::board;

/// One line of text, built without a library.
class Line {
 public:
  Line& text(const char* words) noexcept {
    for (; *words != 0 && length_ < sizeof(text_) - 1; ++words) text_[length_++] = *words;
    return *this;
  }
  Line& hex(uint32_t value, int digits = 8) noexcept {
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) {
      const char digit[2] = {"0123456789abcdef"[(value >> shift) & 15], 0};
      text(digit);
    }
    return *this;
  }
  const char* end() noexcept {
    text_[length_] = 0;
    return text_;
  }

 private:
  char text_[120];
  unsigned length_ = 0;
};

/// xorshift32 (Marsaglia 2003).
class Noise {
 public:
  explicit Noise(uint32_t seed) noexcept : state_(seed) {}
  uint32_t next() noexcept {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return state_;
  }
  uint32_t below(uint32_t limit) noexcept { return next() % limit; }

 private:
  uint32_t state_;
};

/// Number of telemetry frames included in the hashes so far.
uint32_t frames = 0;

/// A host and an environment for one board.
struct Bench {
  BoardCore core;
  BoardInputs inputs;
  SetPointFrame set_point;
  uint32_t sequence = 0;
  uint8_t arms = 0;
  bool feeding = true;
  uint32_t hash = 0;

  Bench() noexcept {
    inputs.supply_mv = 12000;
    inputs.thermistor[0].cc = 2500;
    inputs.thermistors_converted = true;
    set_point.enable = true;
    set_point.duty_q15[0] = 8000;
    set_point.boost_q15[0] = 1000;
  }
  template <class Frame>
  void send(Frame frame, uint32_t broken_byte = kFrameSize) noexcept {
    uint8_t bytes[kFrameSize];
    frame.sequence = ++sequence;
    write_frame(frame, bytes);
    if (broken_byte < kFrameSize) bytes[broken_byte] = static_cast<uint8_t>(bytes[broken_byte] ^ 4);
    core.receive(bytes, kFrameSize);
  }
  void arm() noexcept {
    send(set_point);
    ArmFrame frame;
    frame.count = ++arms;
    send(frame);
    step();
    send(set_point);
    step();
  }
  void step() noexcept {
    core.step(inputs);
    uint8_t telemetry[kFrameSize];
    core.write_telemetry(telemetry);
    // All telemetry bytes of the board, one millisecond chained to the next: the hash so far
    // replaces the frame's own check sum, with which the sum over all would be a constant.
    for (unsigned i = 0; i < 4; ++i)
      telemetry[kFrameSize - 4 + i] = static_cast<uint8_t>(hash >> (8 * i));
    hash = crc32(telemetry, sizeof(telemetry));
    ++frames;
  }
  void run(int ms) noexcept {
    for (int i = 0; i < ms; ++i) {
      if (feeding) send(set_point);
      step();
    }
  }
};

struct Result {
  Print print;
  bool good = true;
  /// Bits of modes and faults that occurred in the random tests.
  uint32_t modes = 0;
  uint32_t seen = 0;

  void line(const char* name, Bench& bench, bool expected) noexcept {
    Line made;
    made.text(name).text(": mode ").hex(static_cast<uint32_t>(bench.core.mode()), 1);
    made.text(" faults ").hex(bench.core.faults(), 4).text(" duty ");
    for (const int16_t duty : bench.core.outputs().duty_q15)
      made.hex(static_cast<uint16_t>(duty), 4).text(" ");
    made.text("ms ").hex(bench.core.now_ms()).text(" hash ").hex(bench.hash);
    if (!expected) made.text(" UNEXPECTED");
    good = good && expected;
    print(made.end());
  }
};

void faults(Result& result) noexcept {
  struct Case {
    const char* name;
    Fault fault;
    void (*damage)(Bench&);
  };
  const Case cases[] = {
      {"dead man", kDeadMan, [](Bench& b) { b.feeding = false; }},
      {"over current", kOverCurrent,
       [](Bench& b) {
         b.set_point.duty_q15[0] = 20'000;
         b.inputs.current_ma[0] = 17000;
       }},
      {"unexpected current", kUnexpectedCurrent, [](Bench& b) { b.inputs.current_ma[2] = -800; }},
      {"excess in the supply line", kUnexpectedCurrent,
       [](Bench& b) {
         b.inputs.supply_current_measured = true;
         b.inputs.supply_ma = 5000;
       }},
      {"current not measured", kCurrentSense, [](Bench& b) { b.inputs.currents_measured = 6; }},
      {"third sensor hot", kOverHeat,
       [](Bench& b) {
         b.inputs.thermistors = 3;
         b.inputs.thermistor[2].cc = 7600;
       }},
      {"over heat", kOverHeat, [](Bench& b) { b.inputs.thermistor[0].cc = 7600; }},
      {"bridge", kBridge, [](Bench& b) { b.inputs.bridge_faults = 2; }},
      {"sensor open", kSensorOpen, [](Bench& b) { b.inputs.thermistor[0].open = true; }},
      {"sensor short", kSensorShort, [](Bench& b) { b.inputs.thermistor[0].shorted = true; }},
      {"supply low", kSupply, [](Bench& b) { b.inputs.supply_mv = 6000; }},
      {"stuck bridge", kStuckBridge,
       [](Bench& b) {
         b.set_point.enable = false;
         b.inputs.current_ma[2] = -900;
       }},
  };
  for (const Case& c : cases) {
    Bench bench;
    bench.arm();
    bench.run(50);
    result.line(c.name, bench, bench.core.mode() == Mode::kDriving);
    c.damage(bench);
    bench.run(150);
    const BoardOutputs& out = bench.core.outputs();
    const bool safe = !out.awake && out.duty_q15[0] == 0 && out.fan == 255;
    result.line(
        c.name, bench,
        bench.core.mode() == Mode::kLatched && (bench.core.faults() & c.fault) != 0 && safe);
  }
  // The I^2 t sums are 64 bits wide: the compiler's runtime divides them.
  Bench heat;
  heat.arm();
  heat.set_point.duty_q15[1] = 16'000;
  heat.inputs.current_ma[1] = 14500;
  heat.run(90'000);
  result.line("heat budget", heat, (heat.core.faults() & kHeatBudget) != 0);
}

/// Random input for minutes: measurements from the whole range; frames complete, corrupt, late,
/// truncated.
void random_packets(Result& result, uint32_t seed, int ms) noexcept {
  Noise noise(seed);
  Bench bench;
  bench.arm();
  for (int i = 0; i < ms; ++i) {
    if (noise.below(50) == 0)
      bench.inputs.current_ma[noise.below(3)] = static_cast<int16_t>(noise.next());
    else if (noise.below(10) == 0)
      for (int16_t& current : bench.inputs.current_ma) current = 0;
    if (noise.below(100) == 0) {
      bench.inputs.currents_measured =
          static_cast<uint8_t>(noise.below(4) == 0 ? noise.below(8) : 7u);
      bench.inputs.supply_current_measured = noise.below(2) != 0;
      bench.inputs.supply_ma = static_cast<uint16_t>(noise.below(4) == 0 ? noise.next() : 0u);
      bench.inputs.thermistors = static_cast<uint8_t>(1 + noise.below(3));
      for (ThermistorInput& one : bench.inputs.thermistor)
        one.cc = static_cast<int16_t>(noise.below(9000));
      bench.inputs.supply_mv = static_cast<uint16_t>(noise.below(40000));
      bench.inputs.bridge_faults = static_cast<uint8_t>(noise.below(16) == 0 ? noise.next() : 0u);
      bench.inputs.thermistor[0].open = noise.below(20) == 0;
      bench.inputs.thermistor[0].shorted = noise.below(20) == 0;
      bench.set_point.enable = noise.below(4) != 0;
      for (int k = 0; k < kWindings; ++k) {
        bench.set_point.duty_q15[k] = static_cast<int16_t>(noise.next());
        bench.set_point.boost_q15[k] = static_cast<int16_t>(noise.next());
      }
    }
    if (noise.below(400) == 0) bench.feeding = !bench.feeding;
    if (bench.feeding) bench.send(bench.set_point, noise.below(70));
    if (noise.below(200) == 0) bench.arm();
    if (noise.below(5000) == 0) {
      bench.send(LimitsFrame{0, static_cast<int16_t>(noise.below(9000)),
                             static_cast<uint16_t>(noise.next()),
                             static_cast<uint16_t>(noise.below(1100))});
    }
    bench.step();
    result.modes |= 1u << static_cast<unsigned>(bench.core.mode());
    result.seen |= bench.core.faults();
    if (i % (ms / 4) == ms / 4 - 1) result.line("soup", bench, true);
  }
}

void port(Result& result, const char* name, const Wiring& wiring) noexcept {
  uint32_t hash = 0;
  for (uint32_t adc = 0; adc <= wiring.adc_full; ++adc) {
    RawInputs raw;
    raw.ntc_adc[0] = raw.supply_adc = raw.current_adc[0] = raw.shunt_adc =
        static_cast<uint16_t>(adc);
    raw.tach_period_us = adc * adc;
    BoardOutputs outputs;
    outputs.awake = true;
    outputs.duty_q15[0] = static_cast<int16_t>(adc * 16 - 32768);
    const BoardInputs in = measured(wiring, raw, outputs);
    const PinOutputs pins = pins_for(wiring, outputs);
    const uint32_t words[] = {hash,
                              static_cast<uint16_t>(in.thermistor[0].cc),
                              in.currents_measured,
                              in.supply_ma,
                              static_cast<uint16_t>(in.current_ma[0]),
                              in.supply_mv,
                              in.fan_rpm,
                              pins.pwm[0],
                              pins.reverse[0]};
    uint8_t bytes[sizeof(words)];
    for (unsigned i = 0; i < sizeof(bytes); ++i)
      bytes[i] = static_cast<uint8_t>(words[i / 4] >> (8 * (i % 4)));
    hash = crc32(bytes, sizeof(bytes));
  }
  Line line;
  result.print(line.text(name).text(": hash ").hex(hash).end());
}

}  // namespace

bool run_vectors(Print print) noexcept {
  Result result{print};
  const uint8_t digits[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  const uint32_t crc = crc32(digits, sizeof(digits));
  result.good = crc == 0xCBF43926u;
  Line line;
  print(line.text("crc32: ").hex(crc).end());
  faults(result);
  port(result, "port with CS", Wiring{});
  port(result, "port with shunts", reference_wiring());
  for (uint32_t seed = 1; seed <= 8; ++seed) random_packets(result, seed, 120'000);
  // Otherwise the random input did not cover enough.
  const bool covers_all = result.modes == 0xE && result.seen == 0x7FF;
  Line summary;
  print(
      summary.text("met: modes ").hex(result.modes, 1).text(" faults ").hex(result.seen, 4).end());
  Line compared;
  print(compared.text("frames: ").hex(frames).end());
  result.good = result.good && covers_all && frames >= 1u << 20;
  return result.good;
}

}  // namespace hedgehog::firmware
