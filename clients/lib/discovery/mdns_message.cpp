// SPDX-License-Identifier: MIT
#include "clients/lib/discovery/mdns_message.h"

#include <arpa/inet.h>

#include <algorithm>
#include <array>

namespace hedgehog::client::mdns {
namespace {

constexpr std::uint32_t kClassIn = 1;
/// In a question's class: the response may be unicast. In a record's class: replaces other records.
constexpr std::uint32_t kTopBit = 0x8000;
constexpr std::size_t kMaxName = 255;
/// Limit of pointers in one name: each record may follow the whole chain again.
constexpr int kMaxPointers = 32;
/// RFC 6762, section 17; with the IP and UDP headers.
constexpr std::size_t kMaxMessageBytes = 9000;
constexpr std::size_t kMaxLabel = 63;
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kMaxQueryBytes = 1200;

/// Sequential reader. Once data is missing it is invalid, and all further reads are empty.
class Reader {
 public:
  explicit Reader(std::string_view data) : data_(data) {}

  bool valid() const noexcept { return valid_; }
  void fail() noexcept { valid_ = false; }
  std::size_t at() const noexcept { return at_; }

  std::string_view take(std::size_t size) {
    if (!valid_ || size > data_.size() - at_) {
      fail();
      return {};
    }
    at_ += size;
    return data_.substr(at_ - size, size);
  }

  std::uint32_t number(std::size_t bytes) {
    std::uint32_t value = 0;
    for (const char c : take(bytes)) value = value << 8u | static_cast<unsigned char>(c);
    return value;
  }

  std::string name() {
    std::string name;
    std::optional<std::size_t> end;
    std::size_t begin = at_;
    int pointers = 0;
    while (valid_) {
      const std::uint32_t size = number(1);
      if (size >= 0xc0u) {
        const std::size_t target = (size & 0x3fu) << 8u | number(1);
        if (!end) end = at_;
        // Pointers must go backwards, so that no name loops.
        if (target >= begin || ++pointers > kMaxPointers) fail();
        at_ = begin = std::min(target, begin);
        continue;
      }
      if (size > kMaxLabel || name.size() + 1 + size > kMaxName) fail();
      name += static_cast<char>(size);
      name += take(size);
      if (size == 0) break;
    }
    if (end) at_ = *end;
    return name;
  }

 private:
  std::string_view data_;
  std::size_t at_ = 0;
  bool valid_ = true;
};

std::string ipv4_text(std::string_view bytes) {
  std::array<char, INET_ADDRSTRLEN> text{};
  return ::inet_ntop(AF_INET, bytes.data(), text.data(), text.size()) == nullptr ? "" : text.data();
}

/// Empty: link-local, which requires an interface.
std::string ipv6_text(std::string_view bytes) {
  if (bytes[0] == '\xfe' && (static_cast<unsigned char>(bytes[1]) & 0xc0u) == 0x80u) return {};
  std::array<char, INET6_ADDRSTRLEN> text{};
  return ::inet_ntop(AF_INET6, bytes.data(), text.data(), text.size()) == nullptr ? ""
                                                                                  : text.data();
}

std::map<std::string, std::string> read_entries(Reader& reader, std::size_t end) {
  std::map<std::string, std::string> entries;
  while (reader.valid() && reader.at() < end) {
    const std::string_view entry = reader.take(reader.number(1));
    const std::size_t equals = entry.find('=');
    if (equals != entry.npos)
      entries.emplace(key_of(std::string(entry.substr(0, equals))), entry.substr(equals + 1));
  }
  return entries;
}

/// nullopt: not of interest, or the reader is invalid.
std::optional<Record> read_record(Reader& reader) {
  Record record{reader.name()};
  const std::uint32_t kind = reader.number(2);
  const bool is_in = (reader.number(2) & ~kTopBit) == kClassIn;
  const bool withdrawn = reader.number(4) == 0;
  const std::size_t size = reader.number(2);
  const std::size_t end = reader.at() + size;
  record.kind = static_cast<Kind>(kind);
  bool known = true;
  switch (record.kind) {
    case Kind::kPtr:
      record.target = reader.name();
      break;
    case Kind::kSrv:
      reader.take(4);
      record.port = static_cast<std::uint16_t>(reader.number(2));
      record.target = reader.name();
      break;
    case Kind::kTxt:
      record.entries = read_entries(reader, end);
      break;
    case Kind::kA: {
      const std::string_view bytes = reader.take(4);
      if (reader.valid()) record.address = ipv4_text(bytes);
      break;
    }
    case Kind::kAaaa: {
      const std::string_view bytes = reader.take(16);
      if (reader.valid()) record.address = ipv6_text(bytes);
      known = !record.address.empty();
      break;
    }
    default:
      reader.take(size);
      known = false;
  }
  if (reader.at() != end) reader.fail();
  if (!reader.valid() || !is_in || withdrawn || !known) return std::nullopt;
  return record;
}

void append_number(std::string& out, std::size_t value) {
  out += static_cast<char>(value >> 8u & 0xffu);
  out += static_cast<char>(value & 0xffu);
}

}  // namespace

std::vector<Record> read_response(std::string_view packet, std::uint16_t id) {
  if (packet.size() > kMaxMessageBytes) return {};
  Reader reader(packet);
  const bool ours = reader.number(2) == id;
  // A response to a standard query, without an error.
  const bool is_response = (reader.number(2) & 0xf80fu) == 0x8000u;
  const std::uint32_t questions = reader.number(2);
  std::uint32_t count = 0;
  for (int section = 0; section < 3; ++section) count += reader.number(2);
  if (!ours || !is_response) return {};
  for (std::uint32_t i = 0; i < questions && reader.valid(); ++i) {
    reader.name();
    reader.take(4);
  }
  std::vector<Record> records;
  for (std::uint32_t i = 0; i < count && reader.valid(); ++i)
    if (auto record = read_record(reader)) records.push_back(*std::move(record));
  if (!reader.valid()) return {};
  return records;
}

std::string make_query(std::uint16_t id, const std::vector<Question>& questions) {
  std::string body;
  std::size_t count = 0;
  for (const Question& question : questions) {
    if (kHeaderBytes + body.size() + question.name.size() + 4 > kMaxQueryBytes) continue;
    body += question.name;
    append_number(body, static_cast<std::size_t>(question.kind));
    append_number(body, kClassIn | kTopBit);
    ++count;
  }
  std::string query;
  for (const std::size_t field :
       {std::size_t{id}, std::size_t{0}, count, std::size_t{0}, std::size_t{0}, std::size_t{0}})
    append_number(query, field);
  return query + body;
}

std::string key_of(std::string name) {
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
  return name;
}

std::vector<std::string_view> labels_of(std::string_view name) {
  std::vector<std::string_view> labels;
  while (!name.empty() && name[0] != '\0') {
    const auto size = static_cast<std::size_t>(static_cast<unsigned char>(name[0]));
    labels.push_back(name.substr(1, size));
    name.remove_prefix(std::min(1 + size, name.size()));
  }
  return labels;
}

}  // namespace hedgehog::client::mdns
