// SPDX-License-Identifier: MIT
#include "daemon/config/keys/config_keys.h"

#include <algorithm>

#include "daemon/config/keys/sensor_keys.h"
#include "daemon/config/keys/unix_role_keys.h"

namespace hedgehog::config {

using namespace keys;

namespace {

using D = Draft;

Reason read_addresses(Draft& draft, const Value& value) {
  if (value.kind != Value::Kind::kArray)
    return must_be(R"(a list of addresses, such as ["127.0.0.1:7586", "[::1]:7586"])", value);
  std::vector<ListenAddress> addresses;
  for (const Value& element : value.elements) {
    if (element.kind != Value::Kind::kText)
      return must_be(R"(a list of texts such as "127.0.0.1:7586")", element);
    const auto address = parse_listen_address(element.text);
    if (!address) return describe(element) + ": " + address.error().reason;
    for (const ListenAddress& other : addresses) {
      if (!conflict(other, *address)) continue;
      if (other.host == address->host) return describe(element) + " is given twice";
      return describe(element) + " and " + to_string(other) +
             " overlap: name single addresses, or take another port";
    }
    addresses.push_back(*address);
  }
  draft.config.listen.tcp = std::move(addresses);
  return {};
}

Value write_addresses(const Draft& draft) {
  std::vector<Value> texts;
  for (const ListenAddress& address : draft.config.listen.tcp)
    texts.push_back(Value::of(to_string(address)));
  return Value::array(std::move(texts));
}

Reason read_http_listen(Draft& draft, const Value& value) {
  if (value.kind == Value::Kind::kNull) {
    draft.config.http.listen = std::nullopt;
    return {};
  }
  if (value.kind != Value::Kind::kText)
    return must_be(R"(an address such as "127.0.0.1:7587", or null)", value);
  const auto address = parse_listen_address(value.text);
  if (!address) return describe(value) + ": " + address.error().reason;
  draft.config.http.listen = *address;
  return {};
}

Value write_http_listen(const Draft& draft) {
  const auto& address = draft.config.http.listen;
  return address ? Value::of(to_string(*address)) : Value{};
}

Reason read_origins(Draft& draft, const Value& value) {
  const std::string shape = R"(a list of origins such as "https://example.org")";
  if (value.kind != Value::Kind::kArray) return must_be(shape, value);
  std::vector<std::string> origins;
  for (const Value& element : value.elements) {
    const std::string& text = element.text;
    const std::size_t scheme = text.starts_with("https://")  ? 8
                               : text.starts_with("http://") ? 7
                                                             : 0;
    const bool bare = scheme > 0 && text.size() > scheme &&
                      text.find_first_of("/ *\"\\", scheme) == std::string::npos;
    if (element.kind != Value::Kind::kText || !bare)
      return must_be(shape + ", without a path or \"*\"", element);
    origins.push_back(text);
  }
  draft.config.http.allow_origins = std::move(origins);
  return {};
}

Value write_origins(const Draft& draft) {
  std::vector<Value> texts;
  for (const std::string& o : draft.config.http.allow_origins) texts.push_back(Value::of(o));
  return Value::array(std::move(texts));
}

/// A file or folder; `null` is "". Control characters are rejected: they would break logs and
/// sockets.
template <class Get>
Key<D> path_key(std::string path, bool absolute, bool nullable, Get get) {
  return {std::move(path),
          [=](D& d, const Value& v) -> Reason {
            if (nullable && v.kind == Value::Kind::kNull) {
              get(d).clear();
              return {};
            }
            const bool clean = std::all_of(
                v.text.begin(), v.text.end(),
                [](char c) { return static_cast<unsigned char>(c) >= 0x20 && c != 0x7f; });
            const bool good = v.kind == Value::Kind::kText && !v.text.empty() && clean &&
                              v.text.size() <= 1024 && (!absolute || v.text.front() == '/');
            if (!good)
              return must_be(std::string(absolute ? "an absolute path" : "a path") +
                                 (nullable ? " or null" : ""),
                             v);
            get(d) = v.text;
            return {};
          },
          [=](const D& d) {
            return nullable && get(d).empty() ? Value{} : Value::of(std::string(get(d)));
          }};
}

void add_listeners(std::vector<Key<D>>& keys) {
  keys.push_back({"listen.tcp", read_addresses, write_addresses});
  keys.push_back(path_key(
      "listen.unix", false, true, [](auto& d) -> auto& { return d.config.listen.unix_socket; }));
  keys.push_back({"http.listen", read_http_listen, write_http_listen});
  keys.push_back({"http.allow_origins", read_origins, write_origins});
  keys.push_back(path_key(
      "http.pages", true, true, [](auto& d) -> auto& { return d.config.http.pages; }));
  keys.push_back(path_key(
      "access.tokens", true, true, [](auto& d) -> auto& { return d.config.access.tokens_file; }));
  keys.push_back(path_key(
      "access.certificate", true, true,
      [](auto& d) -> auto& { return d.config.access.certificate_file; }));
  keys.push_back(path_key(
      "access.key", true, true, [](auto& d) -> auto& { return d.config.access.key_file; }));
  add_unix_role_keys(keys);
  keys.push_back(integer_key<D>(
      "connections.max", 1, 1024, [](auto& d) -> auto& { return d.config.connections.max; }));
  keys.push_back(integer_key<D>(
      "connections.queue_bytes", 262144, 67108864,
      [](auto& d) -> auto& { return d.config.connections.queue_bytes; }));
  keys.push_back(integer_key<D>(
      "connections.write_timeout_s", 1, 600,
      [](auto& d) -> auto& { return d.config.connections.write_timeout_s; }));
  keys.push_back(integer_key<D>(
      "connections.io_uring_after", 0, 1024,
      [](auto& d) -> auto& { return d.config.connections.io_uring_after; }));
  keys.push_back(integer_key<D>(
      "telemetry.max_rate_hz", 1, 200,
      [](auto& d) -> auto& { return d.config.telemetry_max_rate_hz; }));
}

Reason read_thermistors(Draft& draft, const Value& value) {
  if (value.kind == Value::Kind::kNull) {
    draft.config.simulator.thermistors = std::nullopt;
    return {};
  }
  if (value.kind != Value::Kind::kNumber || (value.number != 1.0 && value.number != 3.0))
    return must_be("1, 3 or null", value);
  draft.config.simulator.thermistors = static_cast<int>(value.number);
  return {};
}

Value write_thermistors(const Draft& draft) {
  const auto& thermistors = draft.config.simulator.thermistors;
  return thermistors ? Value::of(static_cast<double>(*thermistors)) : Value{};
}

void add_simulator(std::vector<Key<D>>& keys) {
  keys.push_back(number_key<D>(
      "simulator.ambient_c", -20, 60,
      [](auto& d) -> auto& { return d.config.simulator.ambient_c; }));
  keys.push_back(optional_number_key<D>(
      "simulator.start_temperature_c", -20, 100,
      [](auto& d) -> auto& { return d.config.simulator.start_temperature_c; }));
  keys.push_back(boolean_key<D>(
      "simulator.process", [](auto& d) -> auto& { return d.config.simulator.process; }));
  keys.push_back(path_key(
      "simulator.device", false, true,
      [](auto& d) -> auto& { return d.config.simulator.device_file; }));
  constexpr Choices<device::FrontEndKind, 3> kFrontEnds{
      {{"in_line", device::FrontEndKind::kInLine},
       {"driver_cs", device::FrontEndKind::kDriverCs},
       {"ideal", device::FrontEndKind::kIdeal}}};
  keys.push_back(choice_key<D>(
      "simulator.front_end", kFrontEnds,
      [](auto& d) -> auto& { return d.config.simulator.front_end; }));
  keys.push_back({"simulator.thermistors", read_thermistors, write_thermistors});
  keys.push_back(integer_key<D>(
      "simulator.seed", 0, 4294967295.0, [](auto& d) -> auto& { return d.config.simulator.seed; }));
}

std::vector<Key<D>> make_config_keys() {
  constexpr Choices<Backend, 2> kBackends{
      {{"simulator", Backend::kSimulator}, {"usb", Backend::kUsb}}};
  constexpr Choices<ArmAtStart, 2> kArmAtStart{
      {{"after_clean_stop", ArmAtStart::kAfterCleanStop}, {"never", ArmAtStart::kNever}}};
  constexpr Choices<LogLevel, 4> kLogLevels{{{"debug", LogLevel::kDebug},
                                             {"info", LogLevel::kInfo},
                                             {"warning", LogLevel::kWarning},
                                             {"error", LogLevel::kError}}};
  std::vector<Key<D>> keys;
  keys.push_back(choice_key<D>(
      "backend", kBackends, [](auto& d) -> auto& { return d.config.backend; }));
  keys.push_back(path_key(
      "device", false, false, [](auto& d) -> auto& { return d.config.device_file; }));
  keys.push_back(choice_key<D>(
      "arm_at_start", kArmAtStart, [](auto& d) -> auto& { return d.config.arm_at_start; }));
  for (std::size_t i = 0; i < kLimitFields.size(); ++i) {
    const LimitField& field = kLimitFields[i];
    keys.push_back(optional_number_key<D>(
        "limits." + std::string(field.name), field.min,
        field.max, [i](auto& d) -> auto& { return d.limits[i]; }));
  }
  keys.push_back(number_key<D>(
      "output.gain", 0, 1, [](auto& d) -> auto& { return d.config.gain; }));
  add_sensor_keys(keys);
  add_listeners(keys);
  keys.push_back(choice_key<D>(
      "log.level", kLogLevels, [](auto& d) -> auto& { return d.config.log_level; }));
  keys.push_back(path_key(
      "state_directory", true, true, [](auto& d) -> auto& { return d.config.state_directory; }));
  keys.push_back(path_key(
      "runtime_directory", true, true,
      [](auto& d) -> auto& { return d.config.runtime_directory; }));
  add_simulator(keys);
  return keys;
}

}  // namespace

const std::vector<Key<Draft>>& config_keys() {
  static const std::vector<Key<Draft>> keys = make_config_keys();
  return keys;
}

}  // namespace hedgehog::config
