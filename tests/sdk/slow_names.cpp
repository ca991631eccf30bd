// SPDX-License-Identifier: MIT
// Preloaded into a game (LD_PRELOAD): simulates a name server that does not answer. getaddrinfo of
// a name that begins with "slow." waits until the file named by HEDGEHOG_NAMES_KNOWN exists, then
// returns 127.0.0.1. A name that begins with "unknown." has no address, one that begins with
// "several." has 127.0.0.9 and 127.0.0.1.
#include <dlfcn.h>
#include <netdb.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

namespace {

bool begins(const char* text, const char* with) {
  return text != nullptr && std::strncmp(text, with, std::strlen(with)) == 0;
}

}  // namespace

extern "C" int getaddrinfo(const char* node, const char* service, const addrinfo* hints,
                           addrinfo** result) {
  using Lookup = int (*)(const char*, const char*, const addrinfo*, addrinfo**);
  static const auto original = reinterpret_cast<Lookup>(dlsym(RTLD_NEXT, "getaddrinfo"));
  if (begins(node, "unknown.")) return EAI_NONAME;
  const bool several = begins(node, "several.");
  if (!several && !begins(node, "slow.")) return original(node, service, hints, result);
  const char* const known = std::getenv("HEDGEHOG_NAMES_KNOWN");
  while (!several && known != nullptr && access(known, F_OK) != 0) usleep(1000);
  addrinfo numeric{};
  if (hints != nullptr) numeric = *hints;
  // Exists on a machine without a network too.
  numeric.ai_family = AF_INET;
  numeric.ai_flags = AI_NUMERICHOST;
  if (!several) return original("127.0.0.1", service, &numeric, result);
  const int failed = original("127.0.0.9", service, &numeric, result);
  return failed != 0 ? failed : original("127.0.0.1", service, &numeric, &(*result)->ai_next);
}
