// SPDX-License-Identifier: MIT
#include "base/keys/json_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "base/nul_byte.h"

namespace hedgehog::keys {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxLevels = 16;

/// Position of the lexer, which reads one character beyond a number.
struct Place {
  int line = 1;
  bool after_line_feed = false;
};

/// Counts lines for nlohmann's lexer, whose events contain no positions.
class CountingIterator {
 public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, Place* place) : at_(at), place_(place) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    place_->after_line_feed = *at_ == '\n';
    if (place_->after_line_feed) ++place_->line;
    ++at_;
    return *this;
  }
  CountingIterator operator++(int) {
    const CountingIterator before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const CountingIterator& a, const CountingIterator& b) {
    return a.at_ == b.at_;
  }

 private:
  const char* at_;
  Place* place_;
};

/// Builds the tree from the parser's events. The open containers are a stack of values, closed by
/// moving the last into the one before.
class Builder final : public Json::json_sax_t {
 public:
  explicit Builder(const Place& place) : place_(place) {}

  bool null() override { return add(Value{}, place_.line); }
  bool boolean(bool b) override { return add(Value::of(b), place_.line); }
  bool number_integer(number_integer_t n) override { return number(static_cast<double>(n)); }
  bool number_unsigned(number_unsigned_t n) override { return number(static_cast<double>(n)); }
  bool number_float(number_float_t n, const string_t&) override { return number(n); }
  bool string(string_t& s) override { return add(Value::of(std::move(s)), place_.line); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Value::object()); }
  bool start_array(std::size_t) override { return open(Value::array({})); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    open_.back().value.keys.push_back(std::move(name));
    open_.back().key_line = place_.line;
    return true;
  }
  bool parse_error(std::size_t, const std::string&,
                   const nlohmann::detail::exception& error) override {
    reason = error.what();
    return false;
  }

  Value root;
  std::string reason;
  bool too_deep = false;

 private:
  struct Open {
    Value value;
    int key_line = 0;
  };

  bool number(double n) {
    return add(Value::of(n), place_.line - (place_.after_line_feed ? 1 : 0));
  }

  bool add(Value value, int line) {
    if (value.line == 0) value.line = line;
    if (open_.empty()) {
      root = std::move(value);
      return true;
    }
    Open& parent = open_.back();
    if (parent.value.kind == Value::Kind::kObject) value.line = parent.key_line;
    parent.value.elements.push_back(std::move(value));
    return true;
  }

  bool open(Value value) {
    if (open_.size() == kMaxLevels) {
      too_deep = true;
      return false;
    }
    value.line = place_.line;
    open_.push_back({std::move(value), 0});
    return true;
  }

  bool close() {
    Value value = std::move(open_.back().value);
    open_.pop_back();
    const int line = value.line;
    return add(std::move(value), line);
  }

  const Place& place_;
  std::vector<Open> open_;
};

/// nlohmann's message is "[json.exception…] parse error at line 3, column 5: syntax error while
/// parsing x - why": extracts the line, and the text after "parsing" for the user.
FileError syntax_error(const std::string& what, const std::string& file, int line_read) {
  FileError error{file, line_read, "", what};
  constexpr std::string_view kLine = "at line ";
  if (const std::size_t at = what.find(kLine); at != std::string::npos)
    error.line = std::atoi(what.c_str() + at + kLine.size());
  constexpr std::string_view kParsing = "while parsing ";
  if (const std::size_t at = what.find(kParsing); at != std::string::npos)
    error.reason = what.substr(at + kParsing.size());
  else if (const std::size_t bracket = what.find("] "); bracket != std::string::npos)
    error.reason = what.substr(bracket + 2);
  error.reason = "not valid JSON: " + error.reason;
  return error;
}

Json to_library(const Value& value) {
  switch (value.kind) {
    case Value::Kind::kNull:
      break;
    case Value::Kind::kBoolean:
      return value.boolean;
    case Value::Kind::kNumber:
      // 15 rather than 15.0; both read back the same.
      if (std::abs(value.number) < 1e15 && value.number == std::floor(value.number))
        return static_cast<std::int64_t>(value.number);
      return value.number;
    case Value::Kind::kText:
      return value.text;
    case Value::Kind::kArray: {
      Json array = Json::array();
      for (const Value& element : value.elements) array.push_back(to_library(element));
      return array;
    }
    case Value::Kind::kObject: {
      Json object = Json::object();
      for (std::size_t i = 0; i < value.keys.size(); ++i)
        object[value.keys[i]] = to_library(value.elements[i]);
      return object;
    }
  }
  return nullptr;
}

}  // namespace

boost::system::result<Value, FileError> parse_json(std::string_view text, const std::string& file) {
  if (text.size() > kMaxFileBytes) return FileError{file, 0, "", "is larger than 1 MiB"};
  if (const auto nul = base::first_nul(text)) {
    const auto lines =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(*nul), '\n');
    return FileError{file, 1 + static_cast<int>(lines), "",
                     "not valid JSON: " + std::string(base::kHasNul)};
  }
  Place place;
  Builder builder(place);
  const CountingIterator begin(text.data(), &place);
  const CountingIterator end(text.data() + text.size(), &place);
  if (Json::sax_parse(begin, end, &builder, Json::input_format_t::json, true, true))
    return std::move(builder.root);
  if (builder.too_deep) return FileError{file, place.line, "", "more than 16 levels deep"};
  return syntax_error(builder.reason, file, place.line);
}

std::string to_json(const Value& value) {
  return to_library(value).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hedgehog::keys
