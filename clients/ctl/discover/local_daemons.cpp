// SPDX-License-Identifier: MIT
#include "clients/ctl/discover/local_daemons.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace hedgehog::client {
namespace {

namespace fs = std::filesystem;

bool is_socket_file(const fs::path& path) {
  std::error_code unseen;
  return fs::is_socket(path, unseen);
}

void add_of(const fs::path& runtime, std::vector<LocalDaemon>& daemons) {
  const auto add = [&](std::string instance, const fs::path& folder) {
    const fs::path socket = folder / kSocketName;
    if (is_socket_file(socket)) daemons.push_back({std::move(instance), socket.string()});
  };
  add("hedgehogd", runtime);
  std::error_code unseen;
  std::vector<fs::path> folders;
  for (fs::directory_iterator it(runtime, unseen), end; !unseen && it != end; it.increment(unseen))
    if (std::error_code ignored; it->is_directory(ignored)) folders.push_back(it->path());
  std::sort(folders.begin(), folders.end());
  for (const fs::path& folder : folders) add(folder.filename().string(), folder);
}

}  // namespace

std::vector<LocalDaemon> local_daemons(const Environment& environment) {
  const auto variable = [&](const char* name) {
    auto value = environment(name);
    return value && !value->empty() ? value : std::nullopt;
  };
  std::vector<LocalDaemon> daemons;
  if (const auto runtime = variable("RUNTIME_DIRECTORY")) {
    add_of(runtime->substr(0, runtime->find(':')), daemons);
    return daemons;
  }
  add_of("/run/hedgehog", daemons);
  const auto session = variable("XDG_RUNTIME_DIR");
  add_of(session ? *session + "/hedgehog" : "/tmp/hedgehog-" + std::to_string(getuid()), daemons);
  return daemons;
}

}  // namespace hedgehog::client
