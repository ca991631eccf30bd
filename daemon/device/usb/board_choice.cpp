// SPDX-License-Identifier: MIT
#include "daemon/device/usb/board_choice.h"

#include <algorithm>

#include "daemon/device/board_core/frame.h"

namespace hedgehog::device {
namespace {

std::string no_board(const std::vector<model::UsbId>& ids) {
  std::string text = "no driver board is connected";
  for (std::size_t i = 0; i < ids.size(); ++i)
    text += (i == 0 ? " (" : ", ") + usb_ids(ids[i].vendor, ids[i].product);
  return ids.empty() ? text : text + ")";
}

/// nullptr: it has none.
const UsbInterface* board_interface(const UsbDevice& device) {
  const auto found =
      std::find_if(device.interfaces.begin(), device.interfaces.end(), [](const UsbInterface& one) {
        return one.category == kBoardClass && one.subclass == kBoardSubclass;
      });
  return found != device.interfaces.end() ? &*found : nullptr;
}

}  // namespace

std::string firmware_of(const UsbDevice& device) {
  const std::string& release = device.release;
  if (release.size() != 4) return {};
  const std::size_t from = release[0] == '0' ? 1 : 0;
  return release.substr(from, 2 - from) + "." + release.substr(2);
}

std::optional<int> frame_version(const UsbDevice& device) {
  const UsbInterface* found = board_interface(device);
  return found != nullptr ? std::optional<int>(found->protocol) : std::nullopt;
}

std::string describe_board(const UsbDevice& device) {
  std::string text = describe(device);
  if (!device.serial.empty()) text += ", serial number " + device.serial;
  const std::string firmware = firmware_of(device);
  return firmware.empty() ? text : text + ", firmware " + firmware;
}

std::string foreign_version(int version) {
  return "it speaks version " + std::to_string(version) +
         " of the board protocol, this hedgehogd " + std::to_string(int{board::kProtocolVersion}) +
         "; update one of them";
}

bool is_board(const UsbDevice& device, const BoardIds& wanted) {
  return std::any_of(
      wanted.ids.begin(), wanted.ids.end(),
      [&](const model::UsbId& id) {
        return id.vendor == device.vendor && id.product == device.product;
      });
}

BoardChoice choose_board(const std::vector<UsbDevice>& devices, const BoardIds& wanted) {
  BoardChoice choice;
  std::string others;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    if (!is_board(devices[i], wanted)) continue;
    choice.seen = true;
    if (!wanted.serial.empty() && devices[i].serial != wanted.serial) {
      others += (others.empty() ? "" : " and ") + describe_board(devices[i]);
      continue;
    }
    if (choice.index) {
      choice.failure = "two driver boards are connected, " +
                       describe_board(devices[*choice.index]) + " and " +
                       describe_board(devices[i]) + "; `usb_serial` in the device file says which";
      choice.index.reset();
      return choice;
    }
    choice.index = i;
  }
  if (!choice.index) {
    choice.failure = others.empty() ? no_board(wanted.ids)
                                    : "no driver board with serial number " + wanted.serial +
                                          " is connected, only " + others;
    return choice;
  }
  const UsbDevice& board = devices[*choice.index];
  const UsbInterface* found = board_interface(board);
  if (found == nullptr) {
    choice.failure = describe_board(board) + ": it has no interface of a driver board";
    choice.index.reset();
  } else if (found->protocol != board::kProtocolVersion) {
    choice.failure = describe_board(board) + ": " + foreign_version(found->protocol);
    choice.index.reset();
  } else {
    choice.interface = found->number;
  }
  return choice;
}

}  // namespace hedgehog::device
