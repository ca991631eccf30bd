// SPDX-License-Identifier: MIT
// A command line with everything that the generators must support.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace hedgehog::cli {

struct SampleApp {
  SampleApp() {
    app.require_subcommand(1);
    app.fallthrough();
    app.add_option("--address", text, "where it's listening: host:port")->envname("SAMPLE_ADDRESS");
    app.add_flag("--json", flag, "for programs");
    app.footer("Exit: 0 done, 64 usage.");
    CLI::App* push = app.add_subcommand("push", "one push");
    push->add_option("--side,side", text, "which \"side\" it's on")->required();
    push->add_option("--shape", text, ".how it rises")->type_name("sine|square");
    push->add_option("--speed", number, "back\\slash")->type_name("1..10");
    CLI::App* preview = app.add_subcommand("preview", "what a verb would do");
    preview->require_subcommand(1);
    CLI::App* other = preview->add_subcommand("push", "one push");
    other->add_option("--side,side", text, "which \"side\" it's on")->required();
    other->add_option("--shape", text, ".how it rises")->type_name("sine|square");
    other->add_option("--speed", number, "back\\slash")->type_name("1..10");
    CLI::App* lists = app.add_subcommand("lists", "all of them, or one");
    lists->require_subcommand(0, 1);
    lists->add_subcommand("remove", "removes one");
    app.add_subcommand("secret", "not shown")->group("");
    push->add_flag("--hidden", flag, "not shown")->group("");
  }

  std::string text;
  int number = 0;
  bool flag = false;
  CLI::App app{"sample: pushes. And more.", "sample"};
};

}  // namespace hedgehog::cli
