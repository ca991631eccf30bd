// SPDX-License-Identifier: MIT
#include "clients/ctl/token/token_verb.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>

#include "access/certificate.h"
#include "access/token_file.h"
#include "base/regular_file.h"
#include "base/wall_time.h"
#include "clients/common/problem.h"
#include "clients/ctl/token/state_folder.h"

namespace hedgehog::client {
namespace {

using nlohmann::ordered_json;

constexpr const char* kReload =
    "The daemon loads it at its next start, or: sudo systemctl reload hedgehogd\n";
constexpr std::size_t kMaxPemBytes = std::size_t{64} * 1024;

std::string folder_of(const TokenOptions& options) {
  return state_folder(options.state, process_environment, ::geteuid() == 0);
}

std::string in(const std::string& folder, std::string_view file) {
  return folder + "/" + std::string(file);
}

int fail(ExitCode code, const char* name, const std::string& message) {
  print_failure(name, message);
  return code;
}

int file_not_written(const std::string& problem) {
  return fail(kCannotCreate, "failed",
              problem + (::geteuid() == 0 ? ""
                                          : "; the service's files are changed as root: sudo "
                                            "hedgehogctl token ..."));
}

Result<access::Tokens> tokens_in(const std::string& path) {
  auto tokens = access::read_tokens(path);
  if (tokens) return *std::move(tokens);
  const access::FileProblem& problem = tokens.error();
  const std::string line = problem.line > 0 ? ":" + std::to_string(problem.line) : std::string();
  return Problem{kBadData, path + line + ": " + problem.reason};
}

std::string today() { return base::rfc3339(base::unix_ms_now()).substr(0, 10); }

std::string host_name() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0 || name[0] == '\0') return "localhost";
  return name.data();
}

std::string read_pem(const std::string& path) {
  return base::read_regular_file(path, kMaxPemBytes).text;
}

}  // namespace

int run_token_add(const CommonOptions& common, const TokenOptions& options) {
  if (!access::is_token_name(options.name)) {
    return fail(
        kUsage, "usage",
        "a token's name has 1 to 32 letters, digits, '-', '_' or '.', not '" + options.name + "'");
  }
  const std::string folder = folder_of(options);
  const FolderLock lock(folder);
  if (!lock.problem().empty()) return file_not_written(lock.problem());
  const std::string path = in(folder, access::kTokenFile);
  auto tokens = tokens_in(path);
  if (!tokens) return fail(kBadData, "bad_data", tokens.error().message);
  if (access::find_token(*tokens, options.name) != nullptr) {
    return fail(kUsage, "usage",
                "there is a token " + options.name + " already; revoke it, or take another name");
  }
  if (tokens->size() == access::kMaxTokens)
    return fail(kUsage, "usage", "there are " + std::to_string(access::kMaxTokens) + " already");
  const std::string secret = access::new_token();
  const bool first = tokens->empty();
  tokens->push_back({options.name, protocol::role_named(options.role).value(),
                     access::digest_of(secret), today()});
  if (std::string problem = access::write_secret_file(path, access::to_text(*tokens));
      !problem.empty())
    return file_not_written(problem);
  if (common.json) {
    const ordered_json line{{"name", options.name}, {"role", options.role}, {"token", secret}};
    std::printf("%s\n", line.dump().c_str());
    return kDone;
  }
  std::printf("%s\n", secret.c_str());
  std::fflush(stdout);
  std::fprintf(stderr,
               "%s has the role %s (%s). The token is shown once; give it to the client as "
               "HEDGEHOG_TOKEN.\n",
               options.name.c_str(), options.role.c_str(), path.c_str());
  if (first)
    std::fputs("From then on clients of TCP and WebSocket without a token may only observe.\n",
               stderr);
  std::fputs(kReload, stderr);
  return kDone;
}

int run_token_list(const CommonOptions& common, const TokenOptions& options) {
  const std::string path = in(folder_of(options), access::kTokenFile);
  const auto tokens = tokens_in(path);
  if (!tokens) return fail(kBadData, "bad_data", tokens.error().message);
  if (common.json) {
    ordered_json list = ordered_json::array();
    for (const access::Token& token : *tokens)
      list.push_back(
          {{"name", token.name}, {"role", protocol::name(token.role)}, {"made", token.made}});
    std::printf("%s\n", list.dump().c_str());
    return kDone;
  }
  if (tokens->empty()) std::fprintf(stderr, "no tokens in %s\n", path.c_str());
  for (const access::Token& token : *tokens)
    std::printf("%-32s  %-7s  %s\n", token.name.c_str(),
                std::string(protocol::name(token.role)).c_str(), token.made.c_str());
  return kDone;
}

int run_token_revoke(const CommonOptions& common, const TokenOptions& options) {
  const std::string folder = folder_of(options);
  const std::string path = in(folder, access::kTokenFile);
  const FolderLock lock(folder);
  if (!lock.problem().empty()) return file_not_written(lock.problem());
  auto tokens = tokens_in(path);
  if (!tokens) return fail(kBadData, "bad_data", tokens.error().message);
  if (std::erase_if(*tokens, [&](const access::Token& one) { return one.name == options.name; }) ==
      0)
    return fail(kNoInput, "no_input", "there is no token " + options.name + " in " + path);
  if (std::string problem = access::write_secret_file(path, access::to_text(*tokens));
      !problem.empty())
    return file_not_written(problem);
  if (common.json) {
    std::printf("%s\n", ordered_json{{"revoked", options.name}}.dump().c_str());
    return kDone;
  }
  std::fprintf(stderr, "%s is revoked; its connections end when the daemon reloads the tokens.\n",
               options.name.c_str());
  if (tokens->empty())
    std::fputs(
        "There is no token any more: from then on clients of TCP and WebSocket on loopback may "
        "play, those with TLS nothing.\n",
        stderr);
  std::fputs(kReload, stderr);
  return kDone;
}

int run_token_certificate(const CommonOptions& common, const TokenOptions& options) {
  const std::string folder = folder_of(options);
  const std::string certificate_file = in(folder, access::kCertificateFile);
  const std::string key_file = in(folder, access::kKeyFile);
  const FolderLock lock(folder);
  if (!lock.problem().empty()) return file_not_written(lock.problem());
  std::string pem = read_pem(certificate_file);
  const bool make = options.replace || pem.empty();
  if (make) {
    access::Certificate made;
    try {
      made =
          access::new_certificate(options.host.empty() ? host_name() : options.host, options.days);
    } catch (const std::exception& error) {
      return fail(kInternal, "failed", error.what());
    }
    for (const auto& [file, text] :
         {std::pair{&key_file, &made.key_pem}, std::pair{&certificate_file, &made.certificate_pem}})
      if (std::string problem = access::write_secret_file(*file, *text); !problem.empty())
        return file_not_written(problem);
    pem = made.certificate_pem;
  }
  const auto digest = access::fingerprint_of(pem);
  if (!digest) return fail(kBadData, "bad_data", certificate_file + ": " + digest.error());
  const std::string fingerprint = base::to_hex(*digest);
  if (common.json) {
    const ordered_json line{{"certificate", certificate_file},
                            {"key", key_file},
                            {"made", make},
                            {"fingerprint", fingerprint}};
    std::printf("%s\n", line.dump().c_str());
    return kDone;
  }
  std::printf("%s\n", fingerprint.c_str());
  std::fflush(stdout);
  std::fprintf(stderr,
               "The SHA-256 fingerprint of %s; give it to clients as HEDGEHOG_FINGERPRINT.\n",
               certificate_file.c_str());
  if (make) std::fputs(kReload, stderr);
  return kDone;
}

}  // namespace hedgehog::client
