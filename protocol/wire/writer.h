// SPDX-License-Identifier: MIT
// Writes the fields of a value as JSON text. Internal to protocol.
#pragma once

#include <string>

#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

class Writer final : public Fields {
 public:
  /// Appends to `out`, which must outlive this.
  explicit Writer(std::string& out) : out_(out) {}

 private:
  bool open(std::string_view name, Presence presence, bool present) override;
  void close() override {}
  bool begin_object() override;
  void end_object() override;
  std::size_t begin_list(std::size_t size, const Spec& spec) override;
  bool begin_item(std::size_t index) override;
  void end_list() override;

  void boolean(bool& v) override;
  void integer(std::int64_t& v, const Spec& spec) override;
  void number(double& v, const Spec& spec) override;
  void text(std::string& v, const Spec& spec) override;
  void enumerator(std::size_t& index, std::span<const std::string_view> names) override;
  void numbers(std::span<double> v, const Spec& spec) override;

  std::string& out_;
};

/// Appends the JSON of one described value.
template <class T>
void append(std::string& out, const T& value) {
  Writer writer(out);
  // Only readers modify the value.
  writer.value(const_cast<T&>(value));
}

}  // namespace hedgehog::protocol
