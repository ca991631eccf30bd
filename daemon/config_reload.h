// SPDX-License-Identifier: MIT
// The configuration, read again while the daemon runs, on a thread of its own: its files and the
// names of users and groups may come from a network that does not answer, and the io thread must
// go on to receive stops. The end of the process does not wait for it.
#pragma once

#include <boost/system/result.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "daemon/config/load_config.h"

namespace hedgehog::daemon {

/// io thread.
class ConfigReload {
 public:
  using Loaded = boost::system::result<config::Config, keys::FileErrors>;
  /// Called on the thread of this class with the configuration in use.
  using Load = std::function<Loaded(const config::Config&)>;

  ConfigReload(const config::Paths& paths, const config::Overrides& overrides);
  /// For tests: other sources.
  explicit ConfigReload(Load load) : load_(std::move(load)) {}

  /// The next `step` starts to load; during a load it is repeated afterwards, as the files may have
  /// been read before they were changed.
  void request() noexcept { requested_ = true; }
  /// Starts what is requested. Returns each loaded configuration once; does not block.
  std::optional<Loaded> step(const config::Config& now);

 private:
  struct Answer;

  const Load load_;
  bool requested_ = false;
  std::shared_ptr<Answer> pending_;
};

}  // namespace hedgehog::daemon
