// SPDX-License-Identifier: MIT
// A TEMPer stick without a probe: an inactive keyboard interface, and the thermometer interface.
#pragma once

#include "emulator/gadget.h"

namespace hedgehog::emulator {

class TemperGadget : public Gadget {
 public:
  explicit TemperGadget(const std::string& serial);
  void step() override {}
  /// `temperature C`.
  std::optional<std::string> command(std::span<const std::string> words) override;
  /// {"temperature_c", "asked"}
  std::string status() const override;

 protected:
  std::optional<Bytes> handle_control(const SetupPacket& setup,
                                      std::span<const Byte> data) override;
  void handle_out(std::uint8_t endpoint, std::span<const Byte> data) override;

 private:
  double celsius_ = 25.0;
  std::uint64_t asked_ = 0;
};

}  // namespace hedgehog::emulator
