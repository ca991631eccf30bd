// SPDX-License-Identifier: MIT
// Selection of the board among the USB devices of this machine, by the device file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "daemon/device/sensors/discovery.h"
#include "model/device_model.h"

namespace hedgehog::device {

inline constexpr std::uint8_t kBoardClass = 0xFF;  // vendor-specific
inline constexpr std::uint8_t kBoardSubclass = 0x48;

/// The board section of the device file.
struct BoardIds {
  std::vector<model::UsbId> ids;
  std::string serial;  // empty: any, if there is only one
};

std::string firmware_of(const UsbDevice& device);  // "1.02" of bcdDevice 0102; empty: unknown
/// Version of its frames, from its interface descriptor; nullopt: no driver board interface.
std::optional<int> frame_version(const UsbDevice& device);
/// "Hedgehog driver board (1209:0001), serial number 7, firmware 1.02".
std::string describe_board(const UsbDevice& device);
bool is_board(const UsbDevice& device, const BoardIds& wanted);

/// An index into `devices` and the interface's number, or a sentence with the reason for none.
struct BoardChoice {
  std::optional<std::size_t> index;
  int interface = 0;
  bool seen = false;  // a device with the ids is connected
  std::string failure;
};
BoardChoice choose_board(const std::vector<UsbDevice>& devices, const BoardIds& wanted);

std::string foreign_version(int version);  // "it speaks version 2 of the board protocol, ..."

}  // namespace hedgehog::device
