// SPDX-License-Identifier: MIT
// Roles of the users of the Unix socket.
#include "access/unix_roles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>

namespace hedgehog::access {
namespace {

using protocol::Role;
using Kind = Principal::Kind;

constexpr std::uint32_t kDaemon = 990;

Principal user(std::uint32_t id) { return {Kind::kUser, id, std::to_string(id)}; }
Principal group(std::uint32_t id) { return {Kind::kGroup, id, "@" + std::to_string(id)}; }
Peer peer(std::uint32_t user, std::uint32_t group, std::vector<std::uint32_t> groups = {}) {
  return {user, group, std::move(groups), 1};
}
std::optional<Role> role(const UnixRoles& roles, const Peer& of) {
  return role_of(roles, &of, kDaemon);
}

TEST(UnixRoles, ByDefaultEveryUserOperates) {
  EXPECT_EQ(role({}, peer(1000, 1000)), Role::kOperate);
  EXPECT_EQ(role_of({}, nullptr, kDaemon), Role::kOperate);
}

TEST(UnixRoles, AUserHasThatOfItsNameOrItsGroups) {
  const UnixRoles roles{{group(100)}, {user(1000)}, {group(27)}};
  EXPECT_EQ(role(roles, peer(1000, 1000)), Role::kPlay);
  EXPECT_EQ(role(roles, peer(1000, 1000, {27})), Role::kOperate) << "a supplementary group";
  EXPECT_EQ(role(roles, peer(1001, 27)), Role::kOperate) << "its own group";
  EXPECT_EQ(role(roles, peer(1001, 1001, {4, 100})), Role::kObserve);
  EXPECT_EQ(role(roles, peer(1001, 1000)), std::nullopt) << "1000 is a user there, not a group";
  EXPECT_EQ(role(roles, peer(27, 1001, {1000})), std::nullopt) << "27 is a group there, not a user";
}

TEST(UnixRoles, RootAndTheDaemonsOwnUserAlwaysOperate) {
  const UnixRoles no_roles{{}, {}, {}};
  EXPECT_EQ(role(no_roles, peer(0, 5)), Role::kOperate);
  EXPECT_EQ(role(no_roles, peer(kDaemon, 5)), Role::kOperate);
  EXPECT_EQ(role(no_roles, peer(5, 0, {kDaemon})), std::nullopt) << "their groups do not";
}

TEST(UnixRoles, AnUnidentifiedUserHasOnlyTheRolesOfAllUsers) {
  EXPECT_EQ(role_of({{Principal{}}, {user(0)}, {group(0)}}, nullptr, kDaemon), Role::kObserve);
  EXPECT_EQ(role_of({{}, {user(0)}, {group(0)}}, nullptr, kDaemon), std::nullopt);
}

// A small range, so that some ids match, and short lists, so that not all do.
rc::Gen<std::uint32_t> some_id() { return rc::gen::inRange<std::uint32_t>(1, 8); }

rc::Gen<Principals> some_principals() {
  constexpr int kMaxEntries = 4;
  const auto principal = rc::gen::map(
      rc::gen::pair(rc::gen::inRange(0, 16), some_id()),
      [](const std::pair<int, std::uint32_t>& p) {
        return p.first == 0 ? Principal{} : p.first % 2 == 0 ? user(p.second) : group(p.second);
      });
  return rc::gen::resize(kMaxEntries, rc::gen::container<Principals>(principal));
}

rc::Gen<std::vector<std::uint32_t>> some_groups() {
  constexpr int kMaxGroups = 3;
  return rc::gen::resize(kMaxGroups, rc::gen::container<std::vector<std::uint32_t>>(some_id()));
}

RC_GTEST_PROP(UnixRoles, TheHighestRoleThatMatchesCounts, ()) {
  const UnixRoles roles{*some_principals(), *some_principals(), *some_principals()};
  const Peer peer_of_test = peer(*some_id(), *some_id(), *some_groups());
  // An independent implementation of the matching.
  const auto in = [&](const Principals& list) {
    int matches = 0;
    for (const Principal& one : list) {
      if (one.text == "*") ++matches;
      if (one.text == std::to_string(peer_of_test.user)) ++matches;
      if (one.text == "@" + std::to_string(peer_of_test.group)) ++matches;
      for (const std::uint32_t id : peer_of_test.groups)
        if (one.text == "@" + std::to_string(id)) ++matches;
    }
    return matches > 0;
  };
  std::optional<Role> highest;
  if (in(roles.observe)) highest = Role::kObserve;
  if (in(roles.play)) highest = Role::kPlay;
  if (in(roles.operate)) highest = Role::kOperate;
  RC_TAG(highest ? std::string(protocol::name(*highest)) : "none");
  RC_ASSERT(role(roles, peer_of_test) == highest);
}

RC_GTEST_PROP(UnixRoles, OneMoreEntryNeverLowersARole, ()) {
  UnixRoles roles{*some_principals(), *some_principals(), *some_principals()};
  const Peer peer_of_test = peer(*some_id(), *some_id());
  const auto before = role(roles, peer_of_test);
  const auto list = *rc::gen::element(&UnixRoles::observe, &UnixRoles::play, &UnixRoles::operate);
  (roles.*list).push_back(user(*some_id()));
  RC_ASSERT(role(roles, peer_of_test) >= before);
}

TEST(Principals, AreUsersGroupsNumbersOrAllUsers) {
  EXPECT_EQ(*parse_principal("*"), Principal{});
  EXPECT_EQ(*parse_principal("root"), (Principal{Kind::kUser, 0, "root"}));
  EXPECT_EQ(*parse_principal("@root"), (Principal{Kind::kGroup, 0, "@root"}));
  EXPECT_EQ(*parse_principal("1000"), user(1000));
  EXPECT_EQ(*parse_principal("@4294967294"), group(4294967294));
}

TEST(Principals, ThatDoNotExistAreRefusedWithAMessage) {
  EXPECT_EQ(parse_principal("no-such-user-here").error(), "there is no such user");
  EXPECT_EQ(parse_principal("@no-such-group-here").error(), "there is no such group");
  for (const std::string number : {"4294967295", "@99999999999999999999"})
    EXPECT_EQ(parse_principal(number).error(), "a number must be at most 4294967294") << number;
  for (const std::string text : {"", "@", "@@users", "a b", "a,b", "**", "@*", "a:b", "a\n"})
    EXPECT_THAT(parse_principal(text).error(), testing::StartsWith("must be a user")) << text;
  EXPECT_TRUE(parse_principal(std::string(300, 'a')).has_error());
  EXPECT_TRUE(parse_principal(std::string("root\0", 5)).has_error()) << "a NUL is not the end";
}

}  // namespace
}  // namespace hedgehog::access
