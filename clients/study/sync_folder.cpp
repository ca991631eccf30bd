// SPDX-License-Identifier: MIT
#include "clients/study/sync_folder.h"

#include <fcntl.h>
#include <unistd.h>

namespace hedgehog::study {

void sync_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) {
    ::fsync(descriptor);
    ::close(descriptor);
  }
}

}  // namespace hedgehog::study
