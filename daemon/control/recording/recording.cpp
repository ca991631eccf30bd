// SPDX-License-Identifier: MIT
#include "daemon/control/recording/recording.h"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

#include "base/crc32.h"
#include "base/regular_file.h"
#include "daemon/control/recording/word_delta.h"

namespace hedgehog::control {
namespace {

constexpr std::array<char, 8> kMagic{'H', 'H', 'R', 'E', 'C', '0', '0', '2'};

struct FileHead {
  std::array<char, 8> magic = kMagic;
  std::array<char, 64> build{};
  std::uint64_t controller_bytes = sizeof(Controller);
};

template <class T>
void append(std::vector<std::byte>& bytes, const T& value) {
  const auto* from = reinterpret_cast<const std::byte*>(&value);
  bytes.insert(bytes.end(), from, from + sizeof(T));
}

/// Reads values from the front of a span; not good() after too few bytes.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}
  template <class T>
  void take(T* to, std::size_t count = 1) noexcept {
    const std::size_t size = sizeof(T) * count;
    if (size > bytes_.size()) {
      good_ = false;
      return;
    }
    if (size > 0) std::memcpy(static_cast<void*>(to), bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
  }
  template <class T>
  void take(WordDelta<T>& delta, T& to) noexcept {
    const std::size_t used = delta.decode(bytes_, to);
    good_ = good_ && used > 0;
    bytes_ = bytes_.subspan(used);
  }
  bool good() const noexcept { return good_; }
  bool empty() const noexcept { return bytes_.empty(); }

 private:
  std::span<const std::byte> bytes_;
  bool good_ = true;
};

bool is_whole(std::span<const std::byte> recording) noexcept {
  std::uint32_t sum = 0;
  if (recording.size() < sizeof sum) return false;
  const auto body = recording.first(recording.size() - sizeof sum);
  std::memcpy(&sum, recording.last(sizeof sum).data(), sizeof sum);
  return sum == base::crc32(body);
}

int find_build_id(dl_phdr_info* info, std::size_t, void* out) {
  auto& id = *static_cast<std::string*>(out);
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const auto& header = info->dlpi_phdr[i];
    if (header.p_type != PT_NOTE) continue;
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the loader gives addresses as numbers
    const auto* at = reinterpret_cast<const char*>(info->dlpi_addr + header.p_vaddr);
    const char* end = at + header.p_memsz;
    while (at + sizeof(ElfW(Nhdr)) <= end) {
      ElfW(Nhdr) note;
      std::memcpy(&note, at, sizeof(note));
      const char* owner = at + sizeof(note);
      const char* description = owner + ((note.n_namesz + 3u) & ~3u);
      if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 &&
          std::memcmp(owner, "GNU", 4) == 0) {
        for (std::size_t k = 0; k < note.n_descsz; ++k)
          id += fmt::format("{:02x}", static_cast<unsigned char>(description[k]));
        return 1;
      }
      at = description + ((note.n_descsz + 3u) & ~3u);
    }
  }
  return 1;  // stops after the first object, the program itself
}

bool read_inputs(Reader& reader, WordDelta<TickInputs>& delta, StepInputs& inputs) noexcept {
  TickInputs head;
  reader.take(delta, head);
  if (!reader.good() || head.stop_count > inputs.stops.size() ||
      head.command_count > inputs.commands.size())
    return false;
  static_cast<TickInputs&>(inputs) = head;
  reader.take(inputs.stops.data(), head.stop_count);
  reader.take(inputs.commands.data(), head.command_count);
  return reader.good();
}

}  // namespace

std::string build_id() {
  std::string id;
  dl_iterate_phdr(find_build_id, &id);
  return id.empty() ? "version " HEDGEHOG_VERSION : id;
}

std::vector<std::byte> begin_recording(const Controller& start) {
  FileHead head;
  const std::string build = build_id();
  std::copy_n(build.begin(), std::min(build.size(), head.build.size() - 1), head.build.begin());
  std::vector<std::byte> bytes;
  append(bytes, head);
  append(bytes, start);
  return bytes;
}

void end_recording(std::vector<std::byte>& recording) { append(recording, base::crc32(recording)); }

ReplayResult replay(std::span<const std::byte> recording, const ReplaySink& sink) {
  ReplayResult result;
  result.error = ReplayError::kNotARecording;
  const std::size_t body = recording.size() - std::min(recording.size(), sizeof(std::uint32_t));
  Reader reader(recording.first(body));
  FileHead head;
  reader.take(&head);
  if (!reader.good() || head.magic != kMagic || head.build.back() != '\0') return result;
  result.written_by = head.build.data();
  if (head.controller_bytes != sizeof(Controller) || result.written_by != build_id()) {
    result.error = ReplayError::kOtherBuild;
    return result;
  }
  if (!is_whole(recording)) return result;
  const auto controller = std::make_unique<Controller>(ControlSettings{});
  reader.take(controller.get());
  if (!reader.good()) return result;

  const auto inputs = std::make_unique<StepInputs>();
  const auto events = std::make_unique<EventList>();
  WordDelta<TickInputs> inputs_delta;
  WordDelta<TickOutputs> outputs_delta;
  while (!reader.empty()) {
    TickOutputs recorded;
    if (!read_inputs(reader, inputs_delta, *inputs)) return result;
    reader.take(outputs_delta, recorded);
    if (!reader.good()) return result;
    const device::BoardCommand board = controller->step(*inputs, *events);
    const TickOutputs replayed = outputs_of(*controller, board, *events);
    const bool same = same_bits(recorded, replayed);
    ++result.ticks;
    if (!same) ++result.different;
    if (sink) sink({*inputs, recorded, replayed, *events, *controller, same});
  }
  result.error = ReplayError::kNone;
  return result;
}

ReplayResult replay_recording(const std::string& path, const ReplaySink& sink) {
  // Exceeds the recorder's capacity by far.
  constexpr std::size_t kMaxBytes = std::size_t{64} << 20;
  const base::FileText file = base::read_regular_file(path, kMaxBytes);
  if (!file.good()) {
    ReplayResult result;
    result.error = ReplayError::kUnreadable;
    return result;
  }
  return replay(std::as_bytes(std::span<const char>(file.text)), sink);
}

}  // namespace hedgehog::control
