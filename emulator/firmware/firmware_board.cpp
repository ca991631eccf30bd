// SPDX-License-Identifier: MIT
#include "emulator/firmware/firmware_board.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace hedgehog::emulator {
namespace {

constexpr std::uint8_t kBulk = 1;
/// As many as the host's controller has of one endpoint without an acknowledgement of the board.
constexpr std::size_t kMaxQueued = 4;

constexpr std::size_t kDeviceBytes = 18;
constexpr std::size_t kInterfaceBytes = 9;

}  // namespace

FirmwareBoard::FirmwareBoard(std::unique_ptr<BytePort> port, const std::string& trace)
    : file_(trace.empty() ? nullptr : std::fopen(trace.c_str(), "ae")),
      link_(std::make_unique<BoardLink>(std::move(port))) {
  if (!trace.empty() && !file_) throw std::system_error(errno, std::generic_category(), trace);
  link_->plug();
  read_descriptors();
  link_->unplug();
}

Bytes FirmwareBoard::descriptor(std::uint8_t type, std::uint8_t index) {
  constexpr std::uint16_t kMaxBytes = 255;
  auto found =
      link_->control({kToHost, kGetDescriptor, static_cast<std::uint16_t>(type << 8 | index),
                      type == kStringDescriptor ? kUsEnglish : std::uint16_t{0}, kMaxBytes},
                     {});
  if (!found) throw std::runtime_error("the firmware has no descriptor " + std::to_string(type));
  return std::move(*found);
}

std::string FirmwareBoard::string_descriptor(std::uint8_t index) {
  const Bytes bytes = descriptor(kStringDescriptor, index);
  std::string text;
  // UTF-16 of ASCII, after length and type.
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) text += static_cast<char>(bytes[i]);
  return text;
}

void FirmwareBoard::read_descriptors() {
  const Bytes bytes = descriptor(kDeviceDescriptor, 0);
  if (bytes.size() != kDeviceBytes) throw std::runtime_error("the firmware's device descriptor");
  exported_.vendor = device::little_u16(&bytes[8]);
  exported_.product = device::little_u16(&bytes[10]);
  exported_.release = device::little_u16(&bytes[12]);
  product_name_ = string_descriptor(bytes[15]);
  serial_ = string_descriptor(bytes[16]);
  const Bytes all = descriptor(kConfigurationDescriptor, 0);
  for (std::size_t at = 0; at + 1 < all.size() && all[at] > 0; at += all[at])
    if (all[at + 1] == kInterfaceDescriptor && at + kInterfaceBytes <= all.size())
      exported_.interfaces.push_back({all[at + 5], all[at + 6], all[at + 7]});
}

void FirmwareBoard::clear() {
  in_halted_ = out_halted_ = false;
  out_.clear();
  queued_ = 0;
  in_.clear();
  pending_reads_ = 0;
}

void FirmwareBoard::plugged() {
  clear();
  link_->plug();
  started_ = true;
}

void FirmwareBoard::unplugged() {
  clear();
  link_->unplug();
}

void FirmwareBoard::step() {
  if (!started_) return;
  const bool reading = !silent() && pending_reads_ > in_.size();
  std::vector<Bytes> out;
  while (!out_.empty() && out.size() < BoardLink::kMaxPackets) {
    out.push_back(std::move(out_.front()));
    out_.pop_front();
  }
  const auto begin = std::chrono::steady_clock::now();
  auto made = link_->run(out, reading ? pending_reads_ - in_.size() : 0);
  const auto taken = std::chrono::steady_clock::now() - begin;
  ++exchanges_;
  exchange_sum_ += taken;
  max_exchange_ = std::max(max_exchange_, taken);
  in_halted_ = made.in_halted;
  out_halted_ = made.out_halted;
  queued_ = made.queued;
  for (Bytes& packet : made.in) in_.push_back(std::move(packet));
  if (!file_ || made.events.empty()) return;
  (void)std::fwrite(made.events.data(), 1, made.events.size(), file_.get());
  (void)std::fflush(file_.get());
}

std::string FirmwareBoard::status() const {
  using Microseconds = std::chrono::duration<double, std::micro>;
  const double count = exchanges_ > 0 ? static_cast<double>(exchanges_) : 1.0;
  std::string text = link_->status();
  if (!text.ends_with('}')) throw std::runtime_error("the emulated board's status is no object");
  text.pop_back();
  return text + fmt::format(R"(,"exchange_us":{:.1f},"max_exchange_us":{:.1f}}})",
                            Microseconds(exchange_sum_).count() / count,
                            Microseconds(max_exchange_).count());
}

std::optional<Bytes> FirmwareBoard::control(const SetupPacket& setup, std::span<const Byte> data) {
  auto response = link_->control(setup, data);
  if (!response) return std::nullopt;
  const auto address = static_cast<std::uint8_t>(setup.index);
  if (setup.type == kOfEndpoint && setup.request == kClearFeature)
    (((address & kIn) != 0) ? in_halted_ : out_halted_) = false;
  if (setup.type == kOfDevice && setup.request == kSetConfiguration)
    in_halted_ = out_halted_ = false;
  return response;
}

bool FirmwareBoard::accepts(std::uint8_t endpoint) const {
  return endpoint == kBulk && out_.size() + queued_ < kMaxQueued;
}

void FirmwareBoard::out(std::uint8_t /*endpoint*/, std::span<const Byte> data) {
  do {
    const auto packet = data.first(std::min(data.size(), BoardLink::kMaxPacket));
    out_.emplace_back(packet.begin(), packet.end());
    data = data.subspan(packet.size());
  } while (!data.empty());
}

std::optional<Bytes> FirmwareBoard::take(std::uint8_t endpoint) {
  if (endpoint != kBulk || in_.empty()) return std::nullopt;
  Bytes packet = std::move(in_.front());
  in_.pop_front();
  return packet;
}

void FirmwareBoard::set_pending_reads(std::uint8_t endpoint, std::size_t count) {
  if (endpoint == kBulk) pending_reads_ = count;
}

void FirmwareBoard::halt(std::uint8_t address, int times) {
  if (times != 1) throw std::runtime_error("the firmware's halt is cleared once");
  if (!link_->control({kOfEndpoint, kSetFeature, 0, address, 0}, {}))
    throw std::runtime_error("the firmware has not halted the endpoint");
  (((address & kIn) != 0) ? in_halted_ : out_halted_) = true;
}

bool FirmwareBoard::halted(std::uint8_t address) const {
  if ((address & ~kIn) != kBulk) return false;
  return (address & kIn) != 0 ? in_halted_ : out_halted_;
}

}  // namespace hedgehog::emulator
