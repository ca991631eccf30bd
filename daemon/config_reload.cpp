// SPDX-License-Identifier: MIT
#include "daemon/config_reload.h"

#include <atomic>
#include <system_error>
#include <thread>
#include <utility>

namespace hedgehog::daemon {

struct ConfigReload::Answer {
  std::atomic<bool> there{false};
  std::optional<Loaded> loaded;
};

ConfigReload::ConfigReload(const config::Paths& paths, const config::Overrides& overrides)
    : load_([paths, overrides](const config::Config& now) {
        return config::load_config(paths, overrides, config::read_file, &now);
      }) {}

std::optional<ConfigReload::Loaded> ConfigReload::step(const config::Config& now) {
  std::optional<Loaded> loaded;
  if (pending_ && pending_->there.load(std::memory_order_acquire)) {
    loaded = std::move(pending_->loaded);
    pending_.reset();
  }
  if (requested_ && !pending_ && !loaded) {
    const auto answer = std::make_shared<Answer>();
    try {
      std::thread([answer, now, load = load_] {
        answer->loaded = load(now);
        answer->there.store(true, std::memory_order_release);
      }).detach();
      requested_ = false;
      pending_ = answer;
    } catch (const std::system_error&) {
      // No thread is left: the next step tries again.
    }
  }
  return loaded;
}

}  // namespace hedgehog::daemon
