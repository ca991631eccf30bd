// SPDX-License-Identifier: MIT
// Mapping between a value and its JSON object, defined once: the value's `describe(fields)`, or
// for a value of the model `describe(fields, value)`, names each field, and the subclass of
// `Fields` reads, writes or lists it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "model/quaternion.h"
#include "model/vec3.h"
#include "protocol/wire/direction.h"
#include "protocol/wire/error.h"
#include "protocol/wire/names.h"

namespace hedgehog::protocol {

/// Inclusive bounds of a number, or of the characters of a string. `decimals` written for a number,
/// -1: all. `rounded`: fractions are rounded to integers instead of rejected.
struct Spec {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  int decimals = -1;
  bool rounded = false;
  /// Maximum number of items of a list.
  std::size_t items = 64;
};

inline constexpr Spec decimals(int count) { return {.decimals = count}; }

enum class Presence : std::uint8_t { kRequired, kOptional, kNullable };
enum class Kind : std::uint8_t { kNull, kScalar, kString, kList, kObject };

class Fields {
 public:
  virtual ~Fields() = default;

  /// Required in a request; if missing in a result, a client keeps its default.
  template <class T>
  void required(std::string_view name, T& value, const Spec& spec = {}) {
    member(name, Presence::kRequired, true, value, spec);
  }
  /// If missing, it keeps its value; always written, unless `write` is false.
  template <class T>
  void defaulted(std::string_view name, T& value, const Spec& spec = {}, bool write = true) {
    member(name, Presence::kOptional, write, value, spec);
  }
  /// nullopt is omitted.
  template <class T>
  void optional(std::string_view name, std::optional<T>& value, const Spec& spec = {}) {
    maybe(name, Presence::kOptional, value, spec);
  }
  /// nullopt is written as null.
  template <class T>
  void nullable(std::string_view name, std::optional<T>& value, const Spec& spec = {}) {
    maybe(name, Presence::kNullable, value, spec);
  }

  template <class T>
  void value(T& v, const Spec& spec = {});

  /// True if values are external input and must be checked.
  virtual bool checks() const noexcept { return false; }
  virtual bool reads() const noexcept { return false; }
  /// Kind of the current JSON value, and whether the current object has that member (readers only).
  virtual Kind kind() const noexcept { return Kind::kNull; }
  virtual bool has(std::string_view) const noexcept { return false; }
  /// Rejects the input; only the first error counts.
  virtual void fail(RpcError&&) {}
  /// Dotted path of the current value.
  virtual std::string path() const { return {}; }

 protected:
  /// Enters the member; false: missing, or already handled. `present`: for writers, true if there
  /// is a value.
  virtual bool open(std::string_view name, Presence presence, bool present) = 0;
  virtual void close() = 0;
  virtual bool begin_object() = 0;
  virtual void end_object() = 0;
  /// Number of items; `size`: for writers.
  virtual std::size_t begin_list(std::size_t size, const Spec& spec) = 0;
  virtual bool begin_item(std::size_t index) = 0;
  virtual void end_list() = 0;

  virtual void boolean(bool& v) = 0;
  virtual void integer(std::int64_t& v, const Spec& spec) = 0;
  virtual void number(double& v, const Spec& spec) = 0;
  virtual void text(std::string& v, const Spec& spec) = 0;
  /// One of `names`, by index.
  virtual void enumerator(std::size_t& index, std::span<const std::string_view> names) = 0;
  virtual void numbers(std::span<double> v, const Spec& spec) = 0;
  virtual void direction(Direction& v);

 private:
  template <class T>
  void member(std::string_view name, Presence presence, bool present, T& v, const Spec& spec) {
    if (open(name, presence, present)) {
      value(v, spec);
      close();
    }
  }
  template <class T>
  void maybe(std::string_view name, Presence presence, std::optional<T>& v, const Spec& spec) {
    if (open(name, presence, v.has_value())) {
      if (!v) v.emplace();
      value(*v, spec);
      close();
    }
  }
  template <class T>
  void list(std::vector<T>& v, const Spec& spec);
};

namespace detail {
template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
}  // namespace detail

template <class T>
void Fields::list(std::vector<T>& v, const Spec& spec) {
  const std::size_t size = begin_list(v.size(), spec);
  v.resize(size);
  for (std::size_t i = 0; i < size; ++i) {
    if (begin_item(i)) {
      value(v[i], spec);
      close();
    }
  }
  end_list();
}

template <class T>
void Fields::value(T& v, const Spec& spec) {
  if constexpr (std::is_same_v<T, bool>) {
    boolean(v);
  } else if constexpr (std::is_same_v<T, double>) {
    number(v, spec);
  } else if constexpr (std::is_integral_v<T>) {
    auto wide = static_cast<std::int64_t>(v);
    Spec bounds = spec;
    bounds.min = std::max(bounds.min, static_cast<double>(std::numeric_limits<T>::min()));
    if constexpr (sizeof(T) < sizeof(std::int64_t))
      bounds.max = std::min(bounds.max, static_cast<double>(std::numeric_limits<T>::max()));
    integer(wide, bounds);
    v = static_cast<T>(wide);
  } else if constexpr (std::is_same_v<T, std::string>) {
    text(v, spec);
  } else if constexpr (std::is_enum_v<T>) {
    auto index = static_cast<std::size_t>(v);
    enumerator(index, names_of(v));
    v = static_cast<T>(index);
  } else if constexpr (std::is_same_v<T, model::Vec3>) {
    std::array<double, 3> parts{v.x, v.y, v.z};
    numbers(parts, spec);
    v = {parts[0], parts[1], parts[2]};
  } else if constexpr (std::is_same_v<T, std::array<double, 3>>) {
    numbers(v, spec);
  } else if constexpr (std::is_same_v<T, Direction>) {
    direction(v);
  } else if constexpr (detail::IsVector<T>::value) {
    list(v, spec);
  } else {
    if (begin_object()) {
      if constexpr (std::is_same_v<T, model::Quaternion>) {
        required("w", v.w, spec);
        required("x", v.x, spec);
        required("y", v.y, spec);
        required("z", v.z, spec);
      } else if constexpr (requires { v.describe(*this); }) {
        v.describe(*this);
      } else if constexpr (!std::is_empty_v<T>) {
        describe(*this, v);  // a value of the model
      }
      end_object();
    }
  }
}

}  // namespace hedgehog::protocol
