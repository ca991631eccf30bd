// SPDX-License-Identifier: MIT
// The certificate by which clients authenticate a daemon on another machine. Any thread.
#pragma once

#include <boost/system/result.hpp>
#include <string>
#include <string_view>

#include "base/digest_text.h"

namespace hedgehog::access {

struct Certificate {
  std::string certificate_pem;
  std::string key_pem;
};

/// Self-signed, for `name` (a host name or a numeric address), with a new P-256 key; valid for
/// `days` from now. Throws std::runtime_error when OpenSSL fails.
Certificate new_certificate(const std::string& name, int days);

/// SHA-256 of the first certificate of a PEM text, as pinned by clients, or the error as a clause.
boost::system::result<base::Sha256, std::string> fingerprint_of(std::string_view certificate_pem);

/// Why TLS cannot use them: no certificate, no key, a weak one, or that of another certificate.
/// Empty: usable.
std::string pair_problem(std::string_view certificate_pem, std::string_view key_pem);

}  // namespace hedgehog::access
