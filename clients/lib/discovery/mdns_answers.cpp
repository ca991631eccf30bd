// SPDX-License-Identifier: MIT
#include "clients/lib/discovery/mdns_answers.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace hedgehog::client::mdns {
namespace {

const std::string& service_name() {
  using namespace std::string_literals;
  static const std::string kName = "\x09_hedgehog\x04_tcp\x05local\0"s;
  return kName;
}

/// One label before the service's name.
bool is_instance(const std::string& key) {
  const std::size_t label = key.empty() ? 0 : static_cast<unsigned char>(key[0]);
  return label > 0 && label < key.size() && key.substr(1 + label) == service_name();
}

template <class Value>
void insert_first(std::map<std::string, Value>& known, const std::string& key, Value value) {
  if (known.size() < Answers::kMaxNames) known.emplace(key, std::move(value));
}

std::string host_text(std::string_view name) {
  std::string text;
  for (const std::string_view label : labels_of(name))
    text += (text.empty() ? "" : ".") + printable(label);
  return text;
}

}  // namespace

std::string Answers::query() const {
  std::vector<Question> questions{{service_name(), Kind::kPtr}};
  for (const auto& [key, instance] : instances_) {
    const auto service = services_.find(key);
    if (service == services_.end())
      questions.push_back({instance, Kind::kSrv});
    else if (!addresses_.contains(key_of(service->second.host)))
      questions.push_back({service->second.host, Kind::kA});
    if (!texts_.contains(key)) questions.push_back({instance, Kind::kTxt});
  }
  return make_query(id_, questions);
}

bool Answers::read(std::string_view packet) {
  std::vector<Record> records = read_response(packet, id_);
  for (Record& record : records) keep(std::move(record));
  return !records.empty();
}

void Answers::keep(Record record) {
  const std::string key = key_of(std::move(record.name));
  switch (record.kind) {
    case Kind::kPtr: {
      const std::string instance = key_of(record.target);
      if (key == service_name() && is_instance(instance))
        insert_first(instances_, instance, std::move(record.target));
      break;
    }
    case Kind::kSrv:
      insert_first(services_, key, {std::move(record.target), record.port});
      break;
    case Kind::kTxt:
      insert_first(texts_, key, std::move(record.entries));
      break;
    case Kind::kA:
    case Kind::kAaaa: {
      insert_first(addresses_, key, {});
      const auto known = addresses_.find(key);
      if (known == addresses_.end()) break;
      auto& all = known->second;
      if (all.size() < kMaxAddresses &&
          std::find(all.begin(), all.end(), record.address) == all.end())
        all.push_back(std::move(record.address));
      break;
    }
  }
}

std::vector<DiscoveredBall> Answers::balls() const {
  std::vector<DiscoveredBall> found;
  for (const auto& [key, instance] : instances_) {
    const auto service = services_.find(key);
    if (service == services_.end() || service->second.port == 0) continue;
    const auto addresses = addresses_.find(key_of(service->second.host));
    if (addresses == addresses_.end()) continue;
    DiscoveredBall ball;
    ball.name = printable(labels_of(instance).front());
    ball.host = host_text(service->second.host);
    ball.address.port = service->second.port;
    if (const auto text = texts_.find(key); text != texts_.end()) {
      const auto entry = [&](const char* name) {
        const auto value = text->second.find(name);
        return value == text->second.end() ? std::nullopt : std::optional(printable(value->second));
      };
      ball.serial = entry("serial");
      ball.protocol = entry("protocol");
      ball.address.tls = entry("tls") == "1";
    }
    for (const std::string& address : addresses->second) {
      ball.address.host = address;
      found.push_back(ball);
    }
  }
  const auto order = [](const DiscoveredBall& ball) {
    const std::string& host = ball.address.host;
    return std::tuple<const std::string&, bool, const std::string&>(
        ball.name, host.find(':') != host.npos, host);
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const auto& a, const auto& b) { return order(a) < order(b); });
  return found;
}

}  // namespace hedgehog::client::mdns
