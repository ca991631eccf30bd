// SPDX-License-Identifier: MIT
#include "emulator/board_gadget.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "daemon/device/board_core/crc32.h"
#include "emulator/words.h"

namespace hedgehog::emulator {
namespace {

constexpr std::uint8_t kEndpoint = 1;

GadgetShape board_shape(const std::string& serial) {
  GadgetShape shape{kBoardVendor, kBoardProduct, "Hedgehog", "Hedgehog driver board", serial, {}};
  shape.interfaces.push_back(
      {kBoardClass, kBoardSubclass, kBoardProtocol, {{0x01, true, 64}, {0x81, true, 64}}, {}});
  return shape;
}

/// Sets the protocol version of a frame and updates its CRC.
void set_version(device::Frame& frame, std::uint8_t version) {
  frame[1] = version;
  const std::uint32_t crc = board::crc32(frame.data(), frame.size() - 4);
  for (std::size_t i = 0; i < 4; ++i) frame[frame.size() - 4 + i] = static_cast<Byte>(crc >> 8 * i);
}

}  // namespace

BoardGadget::BoardGadget(const BoardSettings& settings)
    : Gadget(board_shape(settings.serial)),
      file_(settings.trace.empty() ? nullptr : std::fopen(settings.trace.c_str(), "ae")),
      board_(settings.board),
      trace_(file_.get()) {
  if (!settings.trace.empty() && !file_)
    throw std::system_error(errno, std::generic_category(), settings.trace);
  trace_.note(board_, "start");
}

void BoardGadget::step() {
  auto telemetry = board_.step();
  trace_.after_step(board_);
  peak_a_ = std::max(peak_a_, norm(board_.plant().current_a()));
  if (!telemetry) return;
  if (version_ != board::kProtocolVersion) set_version(*telemetry, version_);
  give(kEndpoint, Bytes(telemetry->begin(), telemetry->end()));
  ++frames_out_;
}

void BoardGadget::handle_out(std::uint8_t /*endpoint*/, std::span<const Byte> data) {
  ++frames_in_;
  // A firmware of another version rejects every frame of this one.
  if (version_ == board::kProtocolVersion) board_.receive(data);
}

std::optional<std::string> BoardGadget::command(std::span<const std::string> words) {
  if (words[0] == "version" && words.size() == 2) {
    const auto version = number<std::uint8_t>(words[1]);
    if (!version) return "error: version 0 to 255";
    version_ = *version;
    return "ok";
  }
  if (words[0] == "faults" && words.size() >= 2) {
    const auto bits = number<std::uint16_t>(words[1]);
    const auto coil = number<std::uint8_t>(words.size() > 2 ? words[2] : "0");
    if (!bits || !coil || *coil >= board::kWindings) return "error: faults BITS [WINDING 0..2]";
    device::SimulatorSettings settings = board_.settings();
    settings.faults = *bits;
    settings.coil = *coil;
    board_.apply(settings);
    return "ok";
  }
  return std::nullopt;
}

std::string BoardGadget::status() const {
  const board::BoardCore& core = board_.core();
  const model::Vec3 current = board_.plant().current_a();
  const std::uint32_t age = core.set_point_age_ms();
  const double peak_a = std::exchange(peak_a_, norm(current));
  return fmt::format(R"({{"board_ms": {}, "mode": "{}", "faults": {}, "set_point_age_ms": {}, )"
                     R"("awake": {}, "current_a": [{:.4f}, {:.4f}, {:.4f}], "peak_a": {:.4f}, )"
                     R"("frames_in": {}, "frames_out": {}, "frames_lost": {}}})",
                     core.now_ms(), device::words(core.mode()), core.faults(),
                     age == UINT32_MAX ? "null" : std::to_string(age), core.outputs().awake,
                     current[0], current[1], current[2], peak_a, frames_in_, frames_out_, lost());
}

OtherDeviceGadget::OtherDeviceGadget(const std::string& serial)
    : Gadget({kBoardVendor,
              kBoardProduct,
              "Somebody",
              "Something else",
              serial,
              {{0xFF, 0, 0, {{0x02, true, 64}, {0x82, true, 64}}, {}}}}) {}

}  // namespace hedgehog::emulator
