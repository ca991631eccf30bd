// SPDX-License-Identifier: MIT
// The simulator's ball and electronics for an emulated microcontroller: each line on stdin is
// answered by a line on stdout.
//
//   step PWM PWM PWM DIR SLEEP SWITCH FAN   a millisecond with these pins: compare values, bit k
//       of DIR for winding k, 1 for awake and closed. Answer: the converter's values of the three
//       currents, the supply current, the supply, the three thermistors; bits of FLT lines that are
//       low; the tach's period in us; the true currents in mA; the fan's true duty in thousandths
//   faults BITS WINDING   as in daemon/device/simulator/simulator_settings.h
//   error [KIND WINDING VALUE]...
//       errors of daemon/device/simulator/simulator_error.h, replacing the earlier ones
//
//   heat CELSIUS   windings, core and thermistors
//
//   core   a new board core
//
//   frame CURRENT CURRENT CURRENT SHUNT SUPPLY NTC NTC NTC CONVERTED FLT TACH [PACKET]...
//       one millisecond of that core: its inputs and the packets in hexadecimal. Answer: its
//       telemetry
//
//   host MS
//       with --fd: waits up to MS for packets of the host, until a set-point. Answer: "closed", or
//       "open", 1 if there was a set-point, and the packets for the board in hexadecimal. Packets
//       for the simulator are applied here
//
//   answer MS [PACKET]...   sends the packets and the true values of this millisecond, and ends it
//
// Arguments: those of hedgehog-simboard (--fd: the host's socket); none: a ball of typical parts.
//
// Exit: 0 at the end of the input, 64 wrong arguments, 65 an unknown line.
#include <sysexits.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "daemon/device/board_core/board_core.h"
#include "daemon/device/board_core/port.h"
#include "daemon/device/simulator/simulated_board.h"
#include "daemon/device/socket_transport.h"
#include "firmware/pico_wiring.h"
#include "tests/firmware/board_arguments.h"

namespace hedgehog {
namespace {

constexpr board::Wiring kWiring = firmware::pico_wiring();

/// The outputs of the bridges for these pin values.
board::BoardOutputs outputs(std::istream& words) {
  std::array<int, board::kWindings> pwm{};
  unsigned direction = 0;
  int fan = 0;
  board::BoardOutputs outputs;
  for (int& one : pwm) words >> one;
  words >> direction >> outputs.awake >> outputs.supply_switch_closed >> fan;
  for (int k = 0; k < board::kWindings; ++k) {
    const int duty = pwm[static_cast<std::size_t>(k)] * INT16_MAX / kWiring.pwm_top;
    outputs.duty_q15[k] = static_cast<std::int16_t>((direction >> k & 1u) != 0 ? -duty : duty);
  }
  outputs.fan = static_cast<std::uint8_t>((fan * 255 + kWiring.fan_top / 2) / kWiring.fan_top);
  return outputs;
}

void print(const board::RawInputs& raw, const model::Vec3& current_a, int fan_permille) {
  for (const auto one : raw.current_adc) std::printf("%u ", one);
  std::printf("%u %u ", raw.shunt_adc, raw.supply_adc);
  for (const auto one : raw.ntc_adc) std::printf("%u ", one);
  std::printf("%u %u ", raw.faults_low, raw.tach_period_us);
  for (int k = 0; k < model::kCoils; ++k) std::printf("%.0f ", 1000.0 * current_a[k]);
  std::printf("%d\n", fan_permille);
}

board::RawInputs raw_inputs(std::istream& words) {
  board::RawInputs raw;
  unsigned faults = 0;
  for (auto& one : raw.current_adc) words >> one;
  words >> raw.shunt_adc >> raw.supply_adc;
  for (auto& one : raw.ntc_adc) words >> one;
  words >> raw.ntc_converted >> faults >> raw.tach_period_us;
  raw.faults_low = static_cast<std::uint8_t>(faults);
  return raw;
}

std::vector<std::uint8_t> bytes_of(const std::string& hex) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(hex.substr(i, 2), nullptr, 16)));
  return bytes;
}

void print_hex(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) std::printf("%02x", byte);
}

void step_core(board::BoardCore& core, std::istream& words) {
  const board::RawInputs raw = raw_inputs(words);
  for (std::string hex; words >> hex;) {
    const std::vector<std::uint8_t> packet = bytes_of(hex);
    core.receive(packet.data(), packet.size());
  }
  core.step(board::measured(kWiring, raw, core.outputs(), core.last_inputs()));
  std::array<std::uint8_t, board::kFrameSize> frame{};
  core.write_telemetry(frame.data());
  print_hex(frame);
  std::printf("\n");
}

bool set_world(device::SimulatedBoard& world, const std::string& command, std::istream& words) {
  if (command == "faults") {
    device::SimulatorSettings settings = world.settings();
    int winding = 0;
    words >> settings.faults >> winding;
    settings.coil = static_cast<std::uint8_t>(winding);
    world.apply(settings);
  } else if (command == "error") {
    int kind = 0;
    int winding = 0;
    device::SimulatorErrorList errors;
    device::SimulatorError error;
    while (errors.count < errors.kMaxErrors && words >> kind >> winding >> error.value) {
      error.kind = static_cast<device::SimulatorErrorKind>(kind);
      error.coil = static_cast<std::uint8_t>(winding);
      errors.error[errors.count++] = error;
    }
    errors.generation = static_cast<std::uint8_t>(world.settings().errors.generation + 1);
    world.set_errors(errors);
  } else if (command == "heat") {
    double celsius = 25.0;
    words >> celsius;
    world.plant().set_heat({{celsius, celsius, celsius}, celsius});
  } else {
    return false;
  }
  std::printf("ok\n");
  return true;
}

/// The socket of a host in lock-step (daemon/device/simulator/process_lock_step.h).
class Host {
 public:
  Host(int fd, device::SimulatedBoard& world)
      : socket_(device::FileDescriptor(fd)), world_(world) {}

  void receive(std::istream& words) {
    int timeout_ms = 0;
    words >> timeout_ms;
    socket_.wait(timeout_ms);
    std::vector<std::vector<std::uint8_t>> for_board;
    bool set_point = false;
    std::array<std::uint8_t, 2 * board::kFrameSize> packet{};
    while (!set_point) {
      const std::size_t length = socket_.receive(packet);
      if (length == 0) break;
      set_point = take({packet.data(), length}, for_board);
    }
    std::printf(socket_.open() ? "open %d" : "closed", set_point ? 1 : 0);
    for (const auto& one : for_board) {
      std::printf(" ");
      print_hex(one);
    }
    std::printf("\n");
  }

  void respond(std::istream& words) {
    std::uint32_t now_ms = 0;
    words >> now_ms;
    device::Frame frame;
    for (std::string hex; words >> hex;) {
      const std::vector<std::uint8_t> bytes = bytes_of(hex);
      if (bytes.size() != frame.size() || silent()) continue;
      std::copy(bytes.begin(), bytes.end(), frame.begin());
      socket_.send(frame);
    }
    socket_.send(world_.truth(now_ms));
    std::printf("ok\n");
  }

 private:
  bool silent() const { return (world_.settings().faults & device::kSimSilent) != 0; }

  /// True if it is a set-point.
  bool take(std::span<const std::uint8_t> packet,
            std::vector<std::vector<std::uint8_t>>& for_board) {
    board::FrameHeader header;
    const bool valid =
        board::read_header(packet.data(), packet.size(), header) == board::FrameError::kNone;
    if (valid && (header.type == board::FrameType::kSimulator ||
                  header.type == board::FrameType::kSimulatorError))
      world_.receive(packet);
    else if (!silent())
      for_board.emplace_back(packet.begin(), packet.end());
    return valid && header.type == board::FrameType::kSetPoint;
  }

  device::SocketTransport socket_;
  device::SimulatedBoard& world_;
};

}  // namespace
}  // namespace hedgehog

int main(int argument_count, char** arguments) {
  using namespace hedgehog;
  const auto given = device::read_board_arguments({arguments + 1, arguments + argument_count});
  if (!given || given->board.front_end.kind == device::FrontEndKind::kIdeal) {
    std::fprintf(stderr, "plant: arguments as of hedgehog-simboard, with electronics\n");
    return EX_USAGE;
  }
  device::SimulatedBoard world(given->board);
  std::optional<Host> host;
  if (given->fd >= 0) host.emplace(given->fd, world);
  board::BoardCore core{board::reference_limits()};
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string command;
    words >> command;
    if (command == "step") {
      const board::BoardOutputs pins = outputs(words);
      print(world.step_electronics(pins), world.plant().current_a(), pins.fan * 1000 / 255);
    } else if (command == "frame") {
      step_core(core, words);
    } else if (command == "host" && host) {
      host->receive(words);
    } else if (command == "answer" && host) {
      host->respond(words);
    } else if (command == "core") {
      core = board::BoardCore{board::reference_limits()};
      std::printf("ok\n");
    } else if (!set_world(world, command, words)) {
      std::fprintf(stderr, "plant: %s\n", line.c_str());
      return EX_DATAERR;
    }
    std::fflush(stdout);
  }
  return EX_OK;
}
