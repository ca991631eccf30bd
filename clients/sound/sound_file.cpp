// SPDX-License-Identifier: MIT
#include "clients/sound/sound_file.h"

#include <fcntl.h>
#include <sndfile.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "base/regular_file.h"

namespace hedgehog::sound {

namespace {

double sane(float value) {
  return std::isfinite(value) ? std::clamp(static_cast<double>(value), -1.0, 1.0) : 0.0;
}

StereoSample both_sides(const float* values, int channels) {
  if (channels == 1) return {sane(values[0]), sane(values[0])};
  double shared = 0.0;
  for (int i = 2; i < channels; ++i) shared += 0.5 * sane(values[i]);
  return {std::clamp(sane(values[0]) + shared, -1.0, 1.0),
          std::clamp(sane(values[1]) + shared, -1.0, 1.0)};
}

/// Why a file that libsndfile can read is not supported; empty: it is.
std::string problem_of(const SF_INFO& info) {
  if (info.samplerate < kMinRateHz || info.samplerate > kMaxRateHz)
    return "has " + std::to_string(info.samplerate) + " samples a second; " +
           std::to_string(kMinRateHz) + " to " + std::to_string(kMaxRateHz) + " are read";
  if (info.channels < 1 || info.channels > kMaxChannels)
    return "has " + std::to_string(info.channels) + " channels; at most " +
           std::to_string(kMaxChannels) + " are read";
  if (info.frames <= 0) return "has no sound in it";
  if (static_cast<double>(info.frames) > kMaxFileSeconds * info.samplerate)
    return "lasts longer than a day";
  return {};
}

}  // namespace

struct SoundFile::Open {
  SNDFILE* handle = nullptr;
  SF_INFO info{};

  Open() = default;
  Open(const Open&) = delete;
  Open& operator=(const Open&) = delete;
  ~Open() {
    if (handle != nullptr) sf_close(handle);
  }
};

SoundFile::SoundFile(std::unique_ptr<Open> file) : file_(std::move(file)) {}
SoundFile::SoundFile(SoundFile&&) noexcept = default;
SoundFile& SoundFile::operator=(SoundFile&&) noexcept = default;
SoundFile::~SoundFile() = default;

client::Outcome<SoundFile> SoundFile::open(const std::string& path) {
  using client::ClientError;
  using client::Failure;
  // Opening must not block on a FIFO without writer.
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (fd < 0) return ClientError{Failure::kNoInput, path + ": " + std::strerror(errno), {}};
  if (const std::string why = base::file_problem(fd); !why.empty()) {
    ::close(fd);
    return ClientError{Failure::kNoInput, path + ": " + why, {}};
  }
  auto file = std::make_unique<Open>();
  file->handle = sf_open_fd(fd, SFM_READ, &file->info, SF_TRUE);
  if (file->handle == nullptr)
    return ClientError{Failure::kBadData,
                       path + ": is no sound file that can be read: " + sf_strerror(nullptr),
                       {}};
  if (const std::string problem = problem_of(file->info); !problem.empty())
    return ClientError{Failure::kBadData, path + ": " + problem, {}};
  return SoundFile(std::move(file));
}

double SoundFile::rate_hz() const noexcept { return file_->info.samplerate; }

double SoundFile::seconds() const noexcept {
  return static_cast<double>(file_->info.frames) / rate_hz();
}

std::vector<StereoSample> SoundFile::read(std::size_t count) {
  const auto channels = static_cast<std::size_t>(file_->info.channels);
  std::vector<float> values(count * channels);
  const sf_count_t got =
      sf_readf_float(file_->handle, values.data(), static_cast<sf_count_t>(count));
  std::vector<StereoSample> samples;
  samples.reserve(static_cast<std::size_t>(std::max<sf_count_t>(got, 0)));
  for (std::size_t i = 0; i < static_cast<std::size_t>(std::max<sf_count_t>(got, 0)); ++i)
    samples.push_back(both_sides(&values[i * channels], file_->info.channels));
  return samples;
}

}  // namespace hedgehog::sound
