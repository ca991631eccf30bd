// SPDX-License-Identifier: MIT
// Reads the fields of a value from a JSON tree. Internal to protocol.
#pragma once

#include <string>
#include <vector>

#include "protocol/wire/fields.h"
#include "protocol/wire/json.h"

namespace hedgehog::protocol {

/// Strict (the daemon): all fields must be valid and known. Lenient (clients): unknown fields are
/// ignored, missing or null ones keep their defaults; a wrong type is still an error.
class Reader final : public Fields {
 public:
  enum class Strictness : std::uint8_t { kStrict, kLenient };

  /// `what`: name of the root in messages: "effect.pulse", "the result". `root` must outlive this.
  Reader(const Json& root, Strictness strictness, std::string_view what);

  /// The first error.
  const std::optional<RpcError>& error() const noexcept { return error_; }

  bool checks() const noexcept override { return strict_; }
  bool reads() const noexcept override { return true; }
  Kind kind() const noexcept override;
  bool has(std::string_view name) const noexcept override;
  void fail(RpcError&& error) override;
  std::string path() const override;

 private:
  bool open(std::string_view name, Presence presence, bool present) override;
  void close() override;
  bool begin_object() override;
  void end_object() override;
  std::size_t begin_list(std::size_t size, const Spec& spec) override;
  bool begin_item(std::size_t index) override;
  void end_list() override {}

  void boolean(bool& v) override;
  void integer(std::int64_t& v, const Spec& spec) override;
  void number(double& v, const Spec& spec) override;
  void text(std::string& v, const Spec& spec) override;
  void enumerator(std::size_t& index, std::span<const std::string_view> names) override;
  void numbers(std::span<double> v, const Spec& spec) override;

  struct Place {
    const Json* json;
    std::string name;
    /// The members described so far.
    std::vector<std::string_view> known{};
  };

  const Json& here() const noexcept { return *places_.back().json; }
  void wrong_type(std::string_view wanted);
  std::string path_of(std::string_view member) const;
  std::optional<double> number_in_range(const Json& json, const Spec& spec);

  bool strict_;
  std::string_view what_;
  std::vector<Place> places_{};
  std::optional<RpcError> error_{};
};

}  // namespace hedgehog::protocol
