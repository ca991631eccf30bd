// SPDX-License-Identifier: MIT
#include "clients/ctl/import_arguments.h"
#include "cli/program.h"

namespace hedgehog::client {

void add_import_arguments(const cli::CommandSpec& command, ImportOptions& options) {
  command.add_option("file", options.file).required();
  command.add_option("--name", options.name, "vendor/name; default: imported/ and the file's name");
  command.add_flag("--put", options.put, "stores it in the daemon instead of printing it as JSON");
}

}  // namespace hedgehog::client
