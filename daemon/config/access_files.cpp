// SPDX-License-Identifier: MIT
#include "daemon/config/access_files.h"

#include <filesystem>
#include <optional>
#include <utility>

#include "access/certificate.h"

namespace hedgehog::config {

using namespace keys;

namespace {

struct TlsAddress {
  std::string key;
  std::string text;
};

/// The first address with TLS.
std::optional<TlsAddress> tls_address(const Config& config) {
  for (const ListenAddress& address : config.listen.tcp)
    if (address.tls) return TlsAddress{"listen.tcp", to_string(address)};
  if (config.http.listen && config.http.listen->tls)
    return TlsAddress{"http.listen", to_string(*config.http.listen)};
  return std::nullopt;
}

void resolve_path(std::string& file, const Config& config, std::string_view name) {
  if (file.empty()) file = std::filesystem::path(config.state_directory) / name;
}

}  // namespace

void resolve_access(Config& config, const Origins& origins, const std::string& config_file,
                    const std::function<base::FileText(const std::string&)>& reader,
                    FileErrors& errors) {
  AccessSettings& access = config.access;
  resolve_path(access.tokens_file, config, access::kTokenFile);
  resolve_path(access.certificate_file, config, access::kCertificateFile);
  resolve_path(access.key_file, config, access::kKeyFile);
  const auto tls = tls_address(config);
  const auto refuse = [&](const std::string& missing, const char* command) {
    errors.push_back(error_at(origins, tls->key,
                              tls->text +
                                  ": refused, because other machines could reach it and there is "
                                  "no " +
                                  missing + "; make it: hedgehogctl token " + command +
                                  " --state " + config.state_directory,
                              config_file));
  };

  const base::FileText tokens = reader(access.tokens_file);
  if (tokens.good()) {
    auto parsed = access::parse_tokens(tokens.text);
    if (parsed)
      access.tokens = *std::move(parsed);
    else
      errors.push_back({access.tokens_file, parsed.error().line, "", parsed.error().reason});
  } else if (!tokens.missing) {
    errors.push_back({access.tokens_file, 0, "", tokens.problem});
  } else if (tls) {
    refuse(access.tokens_file, "add NAME --role play");
  }
  if (!tls) return;

  const base::FileText certificate = reader(access.certificate_file);
  const base::FileText key = reader(access.key_file);
  if (certificate.missing || key.missing) {
    refuse(certificate.missing ? access.certificate_file : access.key_file, "certificate");
    return;
  }
  for (const auto& [file, name] :
       {std::pair{&certificate, &access.certificate_file}, std::pair{&key, &access.key_file}})
    if (!file->good()) errors.push_back({*name, 0, "", file->problem});
  if (!certificate.good() || !key.good()) return;
  if (std::string why = access::pair_problem(certificate.text, key.text); !why.empty()) {
    errors.push_back({access.certificate_file, 0, "", why + " (" + access.key_file + ")"});
    return;
  }
  access.certificate_pem = certificate.text;
  access.key_pem = key.text;
}

}  // namespace hedgehog::config
