// SPDX-License-Identifier: MIT
// The completions of a command line in the shells that read them.
#include "cli/completion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/cli/reference_files.h"

namespace hedgehog::cli {
namespace {

using testing::HasSubstr;

/// The text typed after `sample `, and the words that `sample` receives, separated by commas.
using Typed = std::pair<std::string, std::string>;

const std::vector<Typed> kCompleted{
    {"pre\t pu\t left", "preview,push,left"},     {"push --sp\t 3", "push,--speed,3"},
    {"push --ad\t x", "push,--address,x"},        {"push --shape sq\t", "push,--shape,square"},
    {"push --shape=sq\t", "push,--shape=square"},
};

/// The value of an option is not a verb; the word after it may be one.
const std::vector<Typed> kBehindValues{
    {"--address push pre\t", "--address,push,preview"},
    {"--address=push pre\t", "--address=push,preview"},
    {"--address 127.0.0.1:80 pre\t", "--address,127.0.0.1:80,preview"},
    {"--address=localhost:80 push --sh\t x", "--address=localhost:80,push,--shape,x"},
    {"preview --address push --jso\t", "preview,--address,push,--json"},
    {"preview --address push pu\t", "preview,--address,push,push"},
    {"--address pre\t", "--address,pre"},
    {"--address=pre\t", "--address=pre"},
};

class Completion : public Reference {
 protected:
  Completion() { EXPECT_EQ(shell("mkdir '" + path("empty") + "'"), ""); }
};

class BashCompletion : public Completion {
 protected:
  std::string completed_value(const std::string& line) const {
    const std::string input = "source \"" + path("bash-completion/completions/sample") +
                              "\"; sample() { local IFS=,; echo \"$*\"; }\nsample " + line + "\n";
    return shell("cd '" + path("empty") + "' && printf '" + input +
                 "' | INPUTRC=/dev/null bash --norc --noprofile -i 2>/dev/null");
  }
};

TEST_F(BashCompletion, CompletesVerbsOptionsAndValues) {
  for (const auto& [typed, words] : kCompleted)
    EXPECT_EQ(completed_value(typed), words + "\n") << typed;
}

TEST_F(BashCompletion, DoesNotCompleteAValueAsAVerb) {
  for (const auto& [typed, words] : kBehindValues)
    EXPECT_EQ(completed_value(typed), words + "\n") << typed;
}

class ZshCompletion : public Completion {
 protected:
  ZshCompletion() {
    std::ofstream(path("rc")) << "fpath=('" << path("zsh/site-functions") << "' $fpath)\n"
                              << "autoload -U compinit; compinit -u -D\n"
                              << "cd '" << path("empty") << "'\n"
                              << "sample() { print -r -- \"takes:${(j:,:)@}:end\" }\n";
  }
  /// zsh completes only on a terminal.
  std::string completed_value(const std::string& line) const {
    std::ofstream(path("type")) << "zmodload zsh/zpty\nzpty z zsh -f -i\nzpty -w z '. "
                                << path("rc") << "'\nzpty -w z $'sample " << line << "'\n"
                                << "zpty -r z shown '*takes:*:end*'\nzpty -d z\n"
                                << "print -r -- ${${shown##*takes:}%%:end*}\n";
    return shell("timeout 60 zsh -f '" + path("type") + "' </dev/null");
  }
};

TEST_F(ZshCompletion, CompletesVerbsOptionsAndValues) {
  if (!has("zsh")) GTEST_SKIP() << "zsh is not installed";
  EXPECT_EQ(shell("zsh -n '" + path("zsh/site-functions/_sample") + "'"), "");
  for (const auto& [typed, words] : kCompleted)
    EXPECT_EQ(completed_value(typed), words + "\n") << typed;
}

TEST_F(ZshCompletion, DoesNotCompleteAValueAsAVerb) {
  if (!has("zsh")) GTEST_SKIP() << "zsh is not installed";
  for (const auto& [typed, words] : kBehindValues)
    EXPECT_EQ(completed_value(typed), words + "\n") << typed;
}

class FishCompletion : public Completion {
 protected:
  std::string offers(const std::string& line) const {
    return shell("cd '" + path("empty") + "' && HOME='" + folder_.path() +
                 "' fish --no-config -c 'source \"" +
                 path("fish/vendor_completions.d/sample.fish") + "\"; complete -C \"sample " +
                 line + "\"'");
  }
};

TEST_F(FishCompletion, CompletesVerbsOptionsAndValues) {
  if (!has("fish")) GTEST_SKIP() << "fish is not installed";
  EXPECT_THAT(offers("pu"), HasSubstr("push\tone push"));
  EXPECT_THAT(offers("push --s"), HasSubstr("--shape\t.how it rises"));
  EXPECT_THAT(offers("push --shape s"), HasSubstr("square"));
  EXPECT_THAT(offers("push --shape=s"), HasSubstr("square"));
  EXPECT_THAT(offers("preview pu"), HasSubstr("push"));
}

TEST_F(FishCompletion, DoesNotCompleteAValueAsAVerb) {
  if (!has("fish")) GTEST_SKIP() << "fish is not installed";
  EXPECT_EQ(offers("--address push pre"), "preview\twhat a verb would do\n");
  EXPECT_EQ(offers("--address=push pre"), "preview\twhat a verb would do\n");
  EXPECT_EQ(offers("preview --address push pu"), "push\tone push\n");
  EXPECT_EQ(offers("--address pre"), "");
  EXPECT_EQ(offers("--address=pre"), "");
}

}  // namespace
}  // namespace hedgehog::cli
