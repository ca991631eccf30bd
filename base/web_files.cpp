// SPDX-License-Identifier: MIT
#include "base/web_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>

#include "base/crc32.h"
#include "base/regular_file.h"

namespace hedgehog::base {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kTypes{{
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".json", "application/json"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".txt", "text/plain; charset=utf-8"},
    {".webmanifest", "application/manifest+json"},
}};

std::string_view type_of(const fs::path& file) {
  for (const auto& [ending, type] : kTypes)
    if (file.extension() == ending) return type;
  return {};
}

std::uint32_t check_sum(const std::string& bytes) { return crc32(std::as_bytes(std::span(bytes))); }

/// The last eight bytes of a gzip file are the CRC-32 and the length of its content (RFC 1952).
bool holds(const std::string& gzip, std::uint32_t sum, std::size_t size) {
  constexpr std::size_t kMinBytes = 18;
  if (gzip.size() < kMinBytes) return false;
  const auto word = [&](std::size_t from_end) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto byte = static_cast<unsigned char>(gzip[gzip.size() - from_end + i]);
      value |= std::uint32_t{byte} << (8 * i);
    }
    return value;
  };
  return word(8) == sum && word(4) == size;
}

/// Naming of esbuild: "-" and eight upper-case letters and digits before the extension.
bool has_hash(const std::string& path) {
  constexpr std::size_t kHash = 8;
  const std::string stem = fs::path(path).stem().string();
  if (stem.size() <= kHash || stem[stem.size() - kHash - 1] != '-') return false;
  return std::all_of(stem.end() - kHash, stem.end(), [](char letter) {
    return (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9');
  });
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool accepts_gzip(std::string_view accept_encoding) {
  while (!accept_encoding.empty()) {
    const std::size_t end = std::min(accept_encoding.find(','), accept_encoding.size());
    const std::string_view one = accept_encoding.substr(0, end);
    accept_encoding.remove_prefix(std::min(end + 1, accept_encoding.size()));
    const std::size_t mark = std::min(one.find(';'), one.size());
    const std::string_view weight = trimmed(one.substr(std::min(mark + 1, one.size())));
    // "q=0", "q=0.000": not acceptable.
    const bool refused =
        weight.starts_with("q=0") && weight.find_first_not_of("q=0.") == std::string_view::npos;
    if (trimmed(one.substr(0, mark)) == "gzip") return !refused;
  }
  return false;
}

}  // namespace

WebFileResponse web_file_response(const WebFile& file, std::string_view accept_encoding,
                                  std::string_view if_none_match) {
  WebFileResponse answer;
  const bool packed = file.gzip != nullptr && accepts_gzip(accept_encoding);
  answer.etag = file.etag;
  if (packed) {
    answer.encoding = "gzip";
    answer.etag.insert(answer.etag.size() - 1, "-gzip");
  }
  if (file.gzip != nullptr) answer.vary = "Accept-Encoding";
  answer.cache_control = file.immutable ? "public, max-age=31536000, immutable" : "no-cache";
  const bool same = !file.etag.empty() && if_none_match.find(answer.etag) != std::string_view::npos;
  if (!same) answer.body = packed ? file.gzip : file.bytes;
  return answer;
}

const WebFile* WebFiles::find(const std::string& path) const {
  const auto file = by_path.find(path == "/" ? "/index.html" : path);
  return file == by_path.end() ? nullptr : &file->second;
}

WebFiles read_web_files(const std::string& folder, WebFolder depth, std::size_t max_bytes) {
  WebFiles files;
  std::size_t total = 0;
  std::map<std::string, std::shared_ptr<const std::string>> packed;
  std::map<std::string, std::uint32_t> sums;
  for (fs::recursive_directory_iterator it(folder, files.error), end; !files.error && it != end;
       it.increment(files.error)) {
    if (depth == WebFolder::kAlone) it.disable_recursion_pending();
    const bool is_packed = it->path().extension() == ".gz";
    const std::string_view type = type_of(is_packed ? it->path().stem() : it->path());
    if (type.empty() || it->is_symlink() || !it->is_regular_file()) continue;
    std::error_code ec;
    const std::uintmax_t size = it->file_size(ec);
    if (ec) continue;
    total += size;
    if (total > max_bytes) {
      files.by_path.clear();
      files.too_large = true;
      return files;
    }
    auto bytes =
        std::make_shared<const std::string>(read_regular_file(it->path().string(), max_bytes).text);
    std::string path = "/" + it->path().lexically_relative(folder).generic_string();
    if (is_packed) {
      packed.emplace(path.substr(0, path.size() - 3), std::move(bytes));
    } else {
      const std::uint32_t sum = sums[path] = check_sum(*bytes);
      std::string etag = fmt::format(R"("{:08x}-{:x}")", sum, bytes->size());
      const bool immutable = has_hash(path);
      files.by_path.emplace(std::move(path),
                            WebFile{type, std::move(bytes), nullptr, std::move(etag), immutable});
    }
  }
  for (auto& [path, bytes] : packed) {
    const auto file = files.by_path.find(path);
    if (file != files.by_path.end() && holds(*bytes, sums[path], file->second.bytes->size()))
      file->second.gzip = std::move(bytes);
  }
  return files;
}

}  // namespace hedgehog::base
