// SPDX-License-Identifier: MIT
#include "access/token.h"

#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <openssl/rand.h>

#include <algorithm>
#include <stdexcept>

namespace hedgehog::access {
namespace {

constexpr std::size_t kMaxName = 32;

std::string base64url(const std::array<unsigned char, 32>& bytes) {
  std::array<unsigned char, 45> text{};  // four characters for three bytes, and a NUL
  const int size = EVP_EncodeBlock(text.data(), bytes.data(), static_cast<int>(bytes.size()));
  std::string out(text.begin(), text.begin() + size);
  std::replace(out.begin(), out.end(), '+', '-');
  std::replace(out.begin(), out.end(), '/', '_');
  out.erase(out.find_last_not_of('=') + 1);
  return out;
}

}  // namespace

std::string new_token() {
  std::array<unsigned char, 32> bytes{};
  if (RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) != 1)
    throw std::runtime_error("the system has no random numbers");
  std::string token = "hht_" + base64url(bytes);
  OPENSSL_cleanse(bytes.data(), bytes.size());
  return token;
}

Digest digest_of(std::string_view text) {
  Digest digest{};
  unsigned int size = 0;
  if (EVP_Digest(text.data(), text.size(), digest.bytes.data(), &size, EVP_sha256(), nullptr) !=
          1 ||
      size != digest.bytes.size())
    throw std::runtime_error("OpenSSL has no SHA-256");
  return digest;
}

bool operator==(const Digest& a, const Digest& b) noexcept {
  return CRYPTO_memcmp(a.bytes.data(), b.bytes.data(), a.bytes.size()) == 0;
}

bool is_token_name(std::string_view text) noexcept {
  return !text.empty() && text.size() <= kMaxName &&
         std::all_of(
             text.begin(), text.end(),
             [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '-' || c == '_' || c == '.';
             });
}

}  // namespace hedgehog::access
