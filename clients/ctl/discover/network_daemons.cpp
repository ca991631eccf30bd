// SPDX-License-Identifier: MIT
#include "clients/ctl/discover/network_daemons.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "clients/common/program.h"
#include "clients/lib/discovery/ball_search.h"

namespace hedgehog::client {
namespace {

constexpr std::size_t kFields = 10;  // =;interface;IPv4;name;type;domain;host;address;port;TXT

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// "Ball\032seven\.local" in Avahi's encoding: three decimal digits for a byte, else the next
/// character itself.
std::string unescaped_dns(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      plain += text[i];
      continue;
    }
    int byte = 0;
    const auto digits = text.substr(i + 1, 3);
    if (digits.size() == 3 && std::all_of(digits.begin(), digits.end(), is_digit) &&
        std::from_chars(digits.data(), digits.data() + 3, byte).ec == std::errc{} && byte < 256) {
      plain += static_cast<char>(byte);
      i += 3;
    } else {
      plain += text[++i];
    }
  }
  return plain;
}

/// The value of `key` in `"tls=1" "serial=7"`.
std::optional<std::string> txt_value(std::string_view txt, std::string_view key) {
  while (!txt.empty()) {
    const std::size_t begin = txt.find('"');
    if (begin == txt.npos) return std::nullopt;
    std::size_t end = begin + 1;
    while (end < txt.size() && txt[end] != '"') end += txt[end] == '\\' ? 2 : 1;
    const std::string record =
        unescaped_dns(txt.substr(begin + 1, std::min(end, txt.size()) - begin - 1));
    if (record.size() > key.size() && record.starts_with(key) && record[key.size()] == '=')
      return printable(record.substr(key.size() + 1));
    txt.remove_prefix(std::min(end + 1, txt.size()));
  }
  return std::nullopt;
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  while (fields.size() + 1 < kFields && line.find(';') != line.npos) {
    fields.push_back(line.substr(0, line.find(';')));
    line.remove_prefix(line.find(';') + 1);
  }
  fields.push_back(line);
  return fields;
}

std::optional<DiscoveredBall> daemon_of(std::string_view line) {
  const std::vector<std::string_view> fields = fields_of(line);
  if (fields.size() != kFields || fields[0] != "=") return std::nullopt;
  DiscoveredBall daemon;
  const auto [end, error] =
      std::from_chars(fields[8].data(), fields[8].data() + fields[8].size(), daemon.address.port);
  if (error != std::errc{} || daemon.address.port == 0 || fields[7].empty()) return std::nullopt;
  daemon.name = printable(unescaped_dns(fields[3]));
  daemon.host = printable(unescaped_dns(fields[6]));
  daemon.address.host = printable(fields[7]);
  daemon.serial = txt_value(fields[9], "serial");
  daemon.protocol = txt_value(fields[9], "protocol");
  daemon.address.tls = txt_value(fields[9], "tls") == "1";
  return daemon;
}

bool is_link_local(const DiscoveredBall& daemon) {
  return daemon.address.host.starts_with("fe80:");
}

std::string read_file(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

std::vector<DiscoveredBall> parse_avahi_browse(std::string_view output) {
  std::vector<DiscoveredBall> daemons;
  while (!output.empty()) {
    const std::size_t end = std::min(output.find('\n'), output.size());
    if (auto daemon = daemon_of(output.substr(0, end))) {
      const bool known =
          std::any_of(daemons.begin(), daemons.end(), [&](const DiscoveredBall& one) {
            return one.name == daemon->name && one.address == daemon->address;
          });
      if (!known) daemons.push_back(*std::move(daemon));
    }
    output.remove_prefix(std::min(end + 1, output.size()));
  }
  const std::vector<DiscoveredBall> all = daemons;
  std::erase_if(
      daemons,
      [&](const DiscoveredBall& one) {
        return is_link_local(one) && std::any_of(
                                         all.begin(), all.end(),
                                         [&](const DiscoveredBall& other) {
                                           return other.name == one.name && !is_link_local(other);
                                         });
      });
  std::stable_sort(daemons.begin(), daemons.end(),
                   [](const auto& a, const auto& b) { return a.name < b.name; });
  return daemons;
}

NetworkSearch search_network() {
  NetworkSearch search;
  std::error_code failed;
  std::string output = std::filesystem::temp_directory_path(failed).string() + "/hedgehog-XXXXXX";
  const int file = ::mkstemp(output.data());
  if (file < 0) {
    search.failure = "the network was not searched: no temporary file can be made";
    return search;
  }
  ::close(file);
  const ProgramEnd end = run_program({"avahi-browse", "--parsable", "--resolve", "--terminate",
                                      "--no-db-lookup", "_hedgehog._tcp"},
                                     output);
  const std::string printed = read_file(output);
  std::filesystem::remove(output, failed);
  if (end.start_error != 0) {
    auto found = discover();
    if (found)
      search.daemons = *std::move(found);
    else
      search.failure = "the network was not searched: " + found.error().message;
  } else if (!end.succeeded) {
    search.failure =
        "the network was not searched: " + printable(printed.substr(0, printed.find('\n'))) +
        " (systemctl status avahi-daemon)";
  } else {
    search.daemons = parse_avahi_browse(printed);
  }
  return search;
}

}  // namespace hedgehog::client
