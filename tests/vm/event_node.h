// SPDX-License-Identifier: MIT
// The game's side of an input device with force feedback (/dev/input/event*).
#pragma once

#include <linux/input.h>

#include <optional>
#include <string>

namespace hedgehog::vm {

/// /dev/input/event* of the input device with this name; empty: not found.
std::string event_node(const std::string& name);

/// An open handle of an event node, as in a game. One thread.
class EventNode {
 public:
  /// Throws when it cannot be opened.
  explicit EventNode(const std::string& path);
  EventNode(const EventNode&) = delete;
  EventNode& operator=(const EventNode&) = delete;
  ~EventNode() { close(); }

  /// Whether the device reports `code` of `type`; for type 0: whether it has the type `code`.
  bool has(int type, int code) const;
  input_absinfo axis(int code) const;
  /// Uploads `effect` and sets its id; returns the errno, 0 when it was accepted.
  int upload(ff_effect& effect) const;
  /// Returns the errno, 0 when it was erased.
  int erase(int id) const;
  /// Plays it `count` times; 0 stops it.
  void play(int id, int count = 1) const { write(static_cast<std::uint16_t>(id), count); }
  void set_gain(int gain) const { write(FF_GAIN, gain); }
  /// The next event, for up to a minute; nullopt: none arrived, or the device was removed.
  std::optional<input_event> next() const;
  void close();

 private:
  void write(std::uint16_t code, int value) const;

  int fd_ = -1;
};

}  // namespace hedgehog::vm
