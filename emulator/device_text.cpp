// SPDX-License-Identifier: MIT
#include "emulator/device_text.h"

#include <cmath>

#include "emulator/board_gadget.h"
#include "emulator/firmware/firmware_board.h"
#include "emulator/firmware/uart.h"
#include "emulator/imu_gadgets.h"
#include "emulator/temper_gadget.h"
#include "emulator/words.h"

namespace hedgehog::emulator {
namespace {

constexpr const char* kFirmwareBoard = "firmware-board";

struct GadgetSpec {
  std::string serial;
  BoardSettings board;
  bool started = false;
  /// Has a key that determines what another process emulates.
  bool simulated_only = false;
};

/// Returns an empty string, or the error.
std::string take(const std::string& part, GadgetSpec& spec, MadeDevice& made) {
  const std::size_t equals = part.find('=');
  const std::string key = part.substr(0, equals);
  const std::string value = equals == std::string::npos ? "" : part.substr(equals + 1);
  if (part == "unplugged") {
    made.plugged = false;
  } else if (key == "name") {
    made.name = value;
  } else if (key == "serial") {
    spec.serial = value;
    spec.simulated_only = true;
  } else if (key == "trace") {
    spec.board.trace = value;
  } else if (key == "start" || key == "ambient") {
    const auto celsius = number<double>(value);
    if (!celsius || !(std::abs(*celsius) <= 150.0)) return part + ": not a temperature";
    (key == "start" ? spec.board.board.start_c : spec.board.board.ambient_c) = *celsius;
    spec.started = spec.started || key == "start";
    spec.simulated_only = true;
  } else {
    return "unknown: " + part;
  }
  return {};
}

std::unique_ptr<EmulatedDevice> make(const std::string& kind, GadgetSpec spec) {
  const auto serial = [&spec](const char* otherwise) {
    return spec.serial.empty() ? std::string(otherwise) : spec.serial;
  };
  if (kind == "board") {
    spec.board.serial = serial("B1");
    if (!spec.started) spec.board.board.start_c = spec.board.board.ambient_c;
    return std::make_unique<BoardGadget>(spec.board);
  }
  if (kind == kFirmwareBoard)
    return std::make_unique<FirmwareBoard>(std::make_unique<Uart>(), spec.board.trace);
  if (kind == "stranger") return std::make_unique<OtherDeviceGadget>(serial("X1"));
  if (kind == "mti") return std::make_unique<MtiGadget>(serial("0368248C"));
  if (kind == "hid-sensor") return std::make_unique<HidSensorGadget>(serial("H1"));
  if (kind == "dualsense") return std::make_unique<PadGadget>(serial("P1"));
  if (kind == "temper") return std::make_unique<TemperGadget>(serial("T1"));
  return nullptr;
}

}  // namespace

MadeDevice make_device(const std::string& text) {
  MadeDevice made;
  const auto parts = split(text, ',');
  if (parts.empty()) {
    made.failure = "no kind of device";
    return made;
  }
  made.name = parts[0];
  GadgetSpec spec;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    made.failure = take(parts[i], spec, made);
    if (!made.failure.empty()) return made;
  }
  if (parts[0] == kFirmwareBoard && spec.simulated_only) {
    made.failure = "the firmware has its own serial number and temperatures";
    return made;
  }
  made.device = make(parts[0], std::move(spec));
  if (!made.device) made.failure = "no such kind of device; there are: " + device_kinds();
  return made;
}

std::string device_kinds() {
  return "board, mti, hid-sensor, dualsense, temper, stranger, firmware-board";
}

}  // namespace hedgehog::emulator
