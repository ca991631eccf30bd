// SPDX-License-Identifier: MIT
#include "protocol/wire/json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

#include "base/nul_byte.h"
#include "protocol/wire/names.h"
#include "protocol/wire/plain_json.h"

namespace hedgehog::protocol {
namespace {

/// Builds the tree while parsing, so that excessive nesting and duplicate names are rejected early.
class Builder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit Builder(std::size_t max_nesting) : max_nesting_(max_nesting) {}

  bool null() override { return put({nullptr}); }
  bool boolean(bool value) override { return put({value}); }
  bool number_integer(number_integer_t value) override { return put({value}); }
  bool number_unsigned(number_unsigned_t value) override {
    if (value <= static_cast<number_unsigned_t>(INT64_MAX))
      return put({static_cast<std::int64_t>(value)});
    return put({static_cast<double>(value)});
  }
  bool number_float(number_float_t value, const string_t&) override { return put({value}); }
  bool string(string_t& value) override { return put({std::move(value)}); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open({Json::Object{}}); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open({Json::List{}}); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    Level& level = levels_.back();
    if (!level.names.insert(name).second) {
      problem_ = "the name '" + shortened(name) + "' occurs twice in one object";
      return false;
    }
    std::get<Json::Object>(level.json.value).emplace_back(std::move(name), Json{});
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    problem_ = error.id == 406 ? "it has a number that is too large"
                               : "truncated or invalid at byte " + std::to_string(position);
    return false;
  }

  /// Records why the text is rejected. Returns false.
  bool refuse(std::string problem) {
    problem_ = std::move(problem);
    return false;
  }

  Result<Json> finish(bool good) && {
    if (good) return std::move(root_);
    return error(ErrorCode::kParseError, "parse_error: the line is not JSON: " + problem_);
  }

 private:
  struct Level {
    Json json;
    std::set<std::string, std::less<>> names{};
  };

  bool open(Json&& json) {
    if (levels_.size() == max_nesting_) {
      problem_ = "it is nested more than " + std::to_string(max_nesting_) + " deep";
      return false;
    }
    levels_.push_back({std::move(json)});
    return true;
  }
  bool close() {
    Json json = std::move(levels_.back().json);
    levels_.pop_back();
    return put(std::move(json));
  }
  // Not inlined: at -O2 g++ 12 warns that the variant's other alternatives are uninitialised.
  [[gnu::noinline]] bool put(Json&& json) {
    if (levels_.empty())
      root_ = std::move(json);
    else if (auto* list = std::get_if<Json::List>(&levels_.back().json.value))
      list->push_back(std::move(json));
    else
      std::get<Json::Object>(levels_.back().json.value).back().second = std::move(json);
    return true;
  }

  std::size_t max_nesting_;
  std::vector<Level> levels_{};
  Json root_{};
  std::string problem_{};
};

}  // namespace

const Json* Json::find(std::string_view name) const noexcept {
  const Object* object = as<Object>();
  if (object == nullptr) return nullptr;
  const auto found = std::find_if(object->begin(), object->end(),
                                  [&](const auto& member) { return member.first == name; });
  return found == object->end() ? nullptr : &found->second;
}

std::string_view Json::kind() const noexcept {
  constexpr std::string_view kKinds[] = {"null",     "true or false", "a number", "a number",
                                         "a string", "a list",        "an object"};
  return kKinds[value.index()];
}

Result<Json> parse_json(std::string_view text, std::size_t max_nesting) {
  if (auto plain = parse_plain_json(text, max_nesting)) return *std::move(plain);
  Builder builder(max_nesting);
  const auto nul = base::first_nul(text);
  const bool good = nul ? builder.refuse("it has a NUL at byte " + std::to_string(*nul + 1))
                        : nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  return std::move(builder).finish(good);
}

}  // namespace hedgehog::protocol
