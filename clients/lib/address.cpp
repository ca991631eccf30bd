// SPDX-License-Identifier: MIT
#include "clients/lib/address.h"

#include <unistd.h>

#include <charconv>
#include <cstdlib>

namespace hedgehog::client {
namespace {

ClientError bad_address(std::string_view text, std::string_view why) {
  return {Failure::kBadAddress,
          "'" + std::string(text) + "' is no address of a daemon: " + std::string(why) +
              " (for example 127.0.0.1:7586, [::1]:7586 or /run/hedgehog/hedgehogd.sock)",
          {}};
}

ClientError bad_fingerprint() {
  return {Failure::kBadAddress,
          "HEDGEHOG_FINGERPRINT is invalid: it must have 64 hexadecimal digits, as hedgehogctl "
          "token certificate prints it",
          {}};
}

std::optional<std::uint16_t> parse_port(std::string_view text) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (error != std::errc{} || end != text.data() + text.size() || port == 0) return std::nullopt;
  return port;
}

bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

/// "host", "host:port", "[v6]", "[v6]:port" or a bare IPv6 address.
Outcome<Address> parse_tcp(std::string_view text, std::string_view whole) {
  Address address;
  std::string_view rest;
  if (take_prefix(text, "[")) {
    const auto close = text.find(']');
    if (close == std::string_view::npos) return bad_address(whole, "']' is missing");
    address.host = text.substr(0, close);
    rest = text.substr(close + 1);
  } else {
    const auto colon = text.find(':');
    const bool bare_v6 = colon != std::string_view::npos && colon != text.rfind(':');
    address.host = bare_v6 ? text : text.substr(0, colon);
    rest = bare_v6 || colon == std::string_view::npos ? std::string_view() : text.substr(colon);
  }
  if (address.host.empty()) return bad_address(whole, "it names no host");
  if (rest.empty()) return address;
  const auto port = take_prefix(rest, ":") ? parse_port(rest) : std::nullopt;
  if (!port) return bad_address(whole, "the port is a number from 1 to 65535");
  address.port = *port;
  return address;
}

Address unix_socket(std::string path) { return {.path = std::move(path)}; }

std::string in_folder(const std::string& folder) { return folder + "/" + std::string(kSocketName); }

}  // namespace

Outcome<Address> parse_address(std::string_view text) {
  const std::string_view whole = text;
  if (take_prefix(text, "unix:") || text.starts_with('/')) {
    if (text.empty()) return bad_address(whole, "it names no socket");
    return unix_socket(std::string(text));
  }
  if (take_prefix(text, "mdns://"))
    return Address{.host = std::string(text), .tls = true, .mdns = true};
  const bool tls = take_prefix(text, "tls://");
  if (!tls) take_prefix(text, "tcp:");
  auto address = parse_tcp(text, whole);
  if (address) address->tls = tls;
  return address;
}

std::string to_string(const Address& address) {
  if (!address.path.empty()) return address.path;
  if (address.mdns) return "mdns://" + address.host;
  const bool v6 = address.host.find(':') != std::string::npos;
  return (address.tls ? "tls://" : "") + (v6 ? "[" + address.host + "]" : address.host) + ":" +
         std::to_string(address.port);
}

std::optional<ClientError> missing_fingerprint(const Address& address) {
  if (!address.mdns || address.fingerprint) return std::nullopt;
  return ClientError{Failure::kBadAddress,
                     "mdns:// needs a fingerprint (HEDGEHOG_FINGERPRINT), as hedgehogctl token "
                     "certificate prints it: any machine can announce a ball",
                     {}};
}

std::optional<std::string> process_environment(const std::string& name) {
  const char* value = std::getenv(name.c_str());
  return value == nullptr ? std::nullopt : std::optional<std::string>(value);
}

Outcome<std::vector<Address>> daemon_addresses(const std::optional<std::string>& given,
                                               const Environment& environment) {
  const auto variable = [&](const char* name) {
    auto value = environment(name);
    return value && !value->empty() ? value : std::nullopt;
  };
  const auto token = variable("HEDGEHOG_TOKEN");
  if (const auto one = given ? given : variable("HEDGEHOG_ADDRESS")) {
    auto address = parse_address(*one);
    if (!address) return address.error();
    address->token = token;
    if (const auto fingerprint = variable("HEDGEHOG_FINGERPRINT"); fingerprint && address->tls) {
      address->fingerprint = base::parse_sha256(*fingerprint);
      if (!address->fingerprint) return bad_fingerprint();
    }
    if (auto missing = missing_fingerprint(*address)) return *std::move(missing);
    return std::vector<Address>{*std::move(address)};
  }
  std::vector<Address> all;
  const auto add = [&](Address address) {
    address.token = token;
    for (const Address& known : all)
      if (known == address) return;
    all.push_back(std::move(address));
  };
  if (const auto runtime = variable("RUNTIME_DIRECTORY"))
    add(unix_socket(in_folder(runtime->substr(0, runtime->find(':')))));
  add(unix_socket(in_folder("/run/hedgehog")));
  if (const auto runtime = variable("XDG_RUNTIME_DIR")) {
    add(unix_socket(in_folder(*runtime + "/hedgehog")));
  } else if (!variable("RUNTIME_DIRECTORY")) {
    // The default of a daemon that was started by hand without XDG_RUNTIME_DIR.
    add(unix_socket(in_folder("/tmp/hedgehog-" + std::to_string(getuid()))));
  }
  add({.host = "127.0.0.1"});
  return all;
}

}  // namespace hedgehog::client
