// SPDX-License-Identifier: MIT
#include "daemon/config/keys/unix_role_keys.h"

#include <array>
#include <utility>

namespace hedgehog::config {

using namespace keys;

namespace {

struct UnixRoleField {
  const char* path;
  access::Principals access::UnixRoles::*member;
};

/// The highest role first.
constexpr std::array<UnixRoleField, 3> kUnixRoleFields{
    {{"access.unix.operate", &access::UnixRoles::operate},
     {"access.unix.play", &access::UnixRoles::play},
     {"access.unix.observe", &access::UnixRoles::observe}}};

Reason read_principals(const Value& value, access::Principals& out) {
  const std::string shape = R"(a list of users and groups such as ["alice", "@users"], or ["*"])";
  if (value.kind != Value::Kind::kArray || value.elements.size() > access::kMaxPrincipals)
    return must_be(shape, value);
  access::Principals principals;
  for (const Value& element : value.elements) {
    if (element.kind != Value::Kind::kText) return must_be(shape, element);
    auto principal = access::parse_principal(element.text);
    if (!principal) return describe(element) + ": " + principal.error();
    principals.push_back(*std::move(principal));
  }
  out = std::move(principals);
  return {};
}

Value write_principals(const access::Principals& principals) {
  std::vector<Value> texts;
  texts.reserve(principals.size());
  for (const access::Principal& principal : principals) texts.push_back(Value::of(principal.text));
  return Value::array(std::move(texts));
}

}  // namespace

void add_unix_role_keys(std::vector<Key<Draft>>& keys) {
  for (const auto& [path, member] : kUnixRoleFields)
    keys.push_back({path,
                    [member = member](Draft& draft, const Value& value) {
                      return read_principals(value, draft.config.access.unix_roles.*member);
                    },
                    [member = member](const Draft& draft) {
                      return write_principals(draft.config.access.unix_roles.*member);
                    }});
}

void check_unix_roles(const access::UnixRoles& roles, const Origins& origins,
                      const std::string& file, FileErrors& errors) {
  const char* everybody = nullptr;
  for (const auto& [path, member] : kUnixRoleFields) {
    const access::Principals& principals = roles.*member;
    if (everybody != nullptr && !principals.empty())
      errors.push_back(error_at(origins, path,
                                std::string("has no effect, because ") + everybody +
                                    " has \"*\"; list the permitted users there instead",
                                file));
    if (everybody == nullptr && access::has_everybody(principals)) everybody = path;
  }
}

}  // namespace hedgehog::config
