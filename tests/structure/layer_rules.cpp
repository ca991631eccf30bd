// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "tests/structure/rules.h"

namespace hedgehog::structure {
namespace {

struct Layer {
  std::string_view folder;
  std::vector<std::string_view> may_include;        // besides itself
  std::vector<std::string_view> forbidden_headers;  // prefixes of library headers
};

constexpr std::string_view kAsio = "boost/asio";
constexpr std::string_view kBeast = "boost/beast";
constexpr std::string_view kJson = "nlohmann/";
constexpr std::string_view kSpdlog = "spdlog/";
constexpr std::string_view kCli = "CLI/";
constexpr std::string_view kSystemd = "systemd/";

// The longest matching folder decides, so board_core is stricter than the device layer around it.
const std::vector<Layer>& layers() {
  static const std::vector<Layer> kLayers{
      {"base", {}, {kAsio, kBeast, kJson, kSpdlog, kCli, kSystemd}},
      {"base/keys", {"base"}, {kAsio, kBeast, kSpdlog, kCli, kSystemd}},
      {"cli", {"base"}, {kAsio, kBeast, kJson, kSpdlog, kSystemd}},
      {"model",
       {"base"},
       {kAsio, kBeast, kJson, kSpdlog, kCli, kSystemd, "sys/", "unistd.h", "thread"}},
      {"protocol", {"base", "model"}, {kAsio, kBeast, kSpdlog, kCli, kSystemd}},
      {"access", {"base", "protocol"}, {kAsio, kBeast, kJson, kSpdlog, kCli, kSystemd}},
      {"daemon/device/board_core", {}, {}},
      {"daemon/device",
       {"base", "model", "daemon/device/board_core"},
       {kAsio, kBeast, kJson, kSpdlog, kCli, kSystemd}},
      {"emulator",
       {"base", "cli", "model", "daemon/device"},
       {kAsio, kBeast, kJson, kSpdlog, kCli, kSystemd}},
      {"daemon/control",
       {"base", "model", "daemon/device"},
       {kAsio, kBeast, kJson, kSpdlog, kCli, kSystemd}},
      {"daemon/config",
       {"base", "base/keys", "model", "access", "daemon/device", "daemon/control"},
       {kAsio, kBeast, kJson, kSpdlog, kCli, kSystemd}},
      {"daemon/server/session",
       {"base", "model", "protocol", "access", "daemon/device", "daemon/control", "daemon/config"},
       {kCli, kBeast, kJson, kSpdlog, kSystemd}},
      {"daemon/server/disk",
       {"base", "model", "protocol", "daemon/device", "daemon/control", "daemon/config"},
       {kCli, kBeast, kSystemd}},
      {"daemon/server/device",
       {"base", "model", "protocol", "daemon/device", "daemon/control", "daemon/config",
        "daemon/server/session", "daemon/server/disk"},
       {kCli, kBeast, kSystemd}},
      {"daemon/server/effects",
       {"base", "model", "protocol", "daemon/device", "daemon/control", "daemon/config",
        "daemon/server/session", "daemon/server/disk", "daemon/server/device"},
       {kCli, kAsio, kBeast, kJson, kSpdlog, kSystemd}},
      {"daemon/server/history",
       {"base", "model", "protocol", "daemon/device", "daemon/control", "daemon/config",
        "daemon/server/disk", "daemon/server/effects"},
       {kCli, kAsio, kBeast, kSystemd}},
      {"daemon/server/rpc",
       {"base", "model", "protocol", "access", "daemon/device", "daemon/control", "daemon/config",
        "daemon/server/session", "daemon/server/disk", "daemon/server/device",
        "daemon/server/effects", "daemon/server/history"},
       {kCli, kAsio, kBeast, kSystemd}},
      {"daemon/server/net",
       {"base", "model", "protocol", "access", "daemon/device", "daemon/control", "daemon/config",
        "daemon/server/session", "daemon/server/rpc"},
       {kCli}},
      {"daemon", {"base", "base/keys", "cli", "model", "protocol", "access", "daemon"}, {kCli}},
      {"clients/lib", {"base", "model", "protocol"}, {kSpdlog, kCli, kSystemd}},
      {"clients/common",
       {"base", "base/keys", "cli", "model"},
       {kAsio, kBeast, kJson, kSpdlog, kCli, kSystemd}},
      {"clients/sound",
       {"base", "model", "protocol", "clients/lib"},
       {kAsio, kBeast, kJson, kSpdlog, kCli, kSystemd}},
      {"clients/ctl",
       {"base", "cli", "model", "protocol", "access", "clients/lib", "clients/common",
        "clients/sound"},
       {kCli}},
      {"clients",
       {"base", "base/keys", "cli", "model", "protocol", "clients/lib", "clients/common",
        "clients/sound"},
       {kCli}},
      {"tests/rig",
       {"base", "model", "daemon/device", "daemon/control"},
       {kAsio, kBeast, kJson, kSpdlog, kCli, kSystemd}},
      {"firmware", {"daemon/device/board_core"}, {}},
      {"tests",
       {"base", "base/keys", "cli", "model", "protocol", "access", "daemon", "emulator", "clients",
        "firmware"},
       {}},
  };
  return kLayers;
}

bool is_inside(std::string_view path, std::string_view folder) {
  return path.size() > folder.size() && path.starts_with(folder) && path[folder.size()] == '/';
}

const Layer* layer_of(std::string_view path) {
  const Layer* best = nullptr;
  for (const Layer& layer : layers()) {
    if (!is_inside(path, layer.folder)) continue;
    if (best == nullptr || layer.folder.size() > best->folder.size()) best = &layer;
  }
  return best;
}

bool is_cpp(std::string_view path) { return path.ends_with(".h") || path.ends_with(".cpp"); }

// Compiled by Unreal in a game's source tree, with the module's include folders.
bool is_foreign_build(std::string_view path) {
  return is_inside(path, "clients/unreal") || is_inside(path, "tests/sdk/unreal/game");
}

struct Include {
  std::string header;
  bool quoted = false;
};

std::optional<Include> parse_include(std::string_view line) {
  const auto skip_blanks = [&line] {
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
  };
  skip_blanks();
  if (!line.starts_with('#')) return std::nullopt;
  line.remove_prefix(1);
  skip_blanks();
  if (!line.starts_with("include")) return std::nullopt;
  line.remove_prefix(7);
  skip_blanks();
  if (line.empty() || (line.front() != '"' && line.front() != '<')) return std::nullopt;
  const bool quoted = line.front() == '"';
  line.remove_prefix(1);
  const std::size_t end = line.find(quoted ? '"' : '>');
  if (end == std::string_view::npos) return std::nullopt;
  return Include{std::string(line.substr(0, end)), quoted};
}

std::string at(const SourceFile& file, std::size_t index, const std::string& reason) {
  return file.path + ":" + std::to_string(index + 1) + ": " + reason;
}

// Programs that use the client library may not include each other: "clients/ctl" may include
// "clients/ctl" only.
std::string_view own_folder(std::string_view path, const Layer& layer) {
  if (layer.folder != "clients") return layer.folder;
  const std::size_t second = path.find('/', layer.folder.size() + 1);
  return second == std::string_view::npos ? layer.folder : path.substr(0, second);
}

bool may_include(const SourceFile& file, const Layer& layer, std::string_view header) {
  // A library of its own, which not everybody links.
  const auto inside = [header](std::string_view folder) {
    return is_inside(header, folder) && (folder != "base" || !is_inside(header, "base/keys"));
  };
  return inside(own_folder(file.path, layer)) ||
         std::any_of(layer.may_include.begin(), layer.may_include.end(), inside);
}

std::string library_reason(const SourceFile& file, const Layer& layer, const std::string& header) {
  if (layer.folder == "daemon/device/board_core") {
    const bool allowed = header == "stdint.h" || header == "stddef.h";
    return allowed ? "" : "the board core is freestanding: <stdint.h> and <stddef.h> only";
  }
  if (file.path.ends_with(".h") && header.starts_with(kJson) && !is_inside(file.path, "tests"))
    return "nlohmann/json belongs into .cpp files";
  for (std::string_view prefix : layer.forbidden_headers) {
    const bool exact = !prefix.ends_with('/') && prefix.find('/') == std::string_view::npos;
    if (exact ? header == prefix : header.starts_with(prefix))
      return "<" + header + "> has no business in " + std::string(layer.folder);
  }
  return "";
}

}  // namespace

Violations check_layer_includes(const SourceFile& file) {
  Violations violations;
  const Layer* layer = layer_of(file.path);
  if (!is_cpp(file.path) || layer == nullptr || is_foreign_build(file.path)) return violations;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const std::optional<Include> include = parse_include(file.lines[i]);
    if (!include) continue;
    if (!include->quoted) {
      if (layer_of(include->header) != nullptr)
        violations.push_back(at(file, i, "own headers are included with quotes"));
    } else if (layer_of(include->header) == nullptr) {
      violations.push_back(
          at(file, i, "\"" + include->header + "\" does not start at the repository root"));
    } else if (!may_include(file, *layer, include->header)) {
      violations.push_back(
          at(file, i, std::string(layer->folder) + " may not include \"" + include->header + "\""));
    }
  }
  return violations;
}

Violations check_library_includes(const SourceFile& file) {
  Violations violations;
  const Layer* layer = layer_of(file.path);
  if (!is_cpp(file.path) || layer == nullptr) return violations;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const std::optional<Include> include = parse_include(file.lines[i]);
    if (!include || include->quoted) continue;
    const std::string reason = library_reason(file, *layer, include->header);
    if (!reason.empty()) violations.push_back(at(file, i, reason));
  }
  return violations;
}

}  // namespace hedgehog::structure
