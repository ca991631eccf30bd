// SPDX-License-Identifier: MIT
#include <cmath>

#include "core/json.h"

namespace hedgehog::unreal {

namespace {

/// Parser of one text; every function advances past what it has read, or returns nullopt.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  std::optional<Json> whole() {
    std::optional<Json> value = any(0);
    skip_blanks();
    return at_ == text_.size() ? value : std::nullopt;
  }

 private:
  std::optional<Json> any(int depth) {
    if (depth > Json::kMaxDepth) return std::nullopt;
    skip_blanks();
    if (at_ >= text_.size()) return std::nullopt;
    switch (text_[at_]) {
      case '{':
        return object(depth);
      case '[':
        return array(depth);
      case '"': {
        std::optional<std::string> read = string();
        return read ? std::optional<Json>(Json(*std::move(read))) : std::nullopt;
      }
      case 't':
        return word("true", Json(true));
      case 'f':
        return word("false", Json(false));
      case 'n':
        return word("null", Json());
      default:
        return number();
    }
  }

  std::optional<Json> object(int depth) {
    ++at_;
    std::vector<Json::Field> fields;
    if (next_is('}')) return Json::object();
    do {
      skip_blanks();
      std::optional<std::string> name = string();
      if (!name || !next_is(':')) return std::nullopt;
      std::optional<Json> value = any(depth + 1);
      if (!value) return std::nullopt;
      fields.emplace_back(*std::move(name), *std::move(value));
    } while (next_is(','));
    return next_is('}') ? std::optional<Json>(Json::object(std::move(fields))) : std::nullopt;
  }

  std::optional<Json> array(int depth) {
    ++at_;
    std::vector<Json> items;
    if (next_is(']')) return Json::array();
    do {
      std::optional<Json> value = any(depth + 1);
      if (!value) return std::nullopt;
      items.push_back(*std::move(value));
    } while (next_is(','));
    return next_is(']') ? std::optional<Json>(Json::array(std::move(items))) : std::nullopt;
  }

  std::optional<std::string> string() {
    if (at_ >= text_.size() || text_[at_] != '"') return std::nullopt;
    std::string read;
    for (++at_; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '"') {
        ++at_;
        return read;
      }
      if (static_cast<unsigned char>(c) < 0x20) return std::nullopt;
      if (c != '\\')
        read += c;
      else if (!escape(read))
        return std::nullopt;
    }
    return std::nullopt;
  }

  /// Starts at a backslash; ends at the escape's last character.
  bool escape(std::string& out) {
    static constexpr std::string_view kEscapes = "\"\\/bfnrt";
    static constexpr std::string_view kMeant = "\"\\/\b\f\n\r\t";
    if (++at_ >= text_.size()) return false;
    const std::size_t simple = kEscapes.find(text_[at_]);
    if (simple != std::string_view::npos) {
      out += kMeant[simple];
      return true;
    }
    std::optional<unsigned> code = text_[at_] == 'u' ? hexadecimal() : std::nullopt;
    if (!code) return false;
    if (*code >= 0xD800 && *code < 0xDC00) {
      if (text_.substr(at_ + 1, 2) != "\\u") return false;
      at_ += 2;
      const std::optional<unsigned> low = hexadecimal();
      if (!low || *low < 0xDC00 || *low > 0xDFFF) return false;
      code = 0x10000 + ((*code - 0xD800) << 10) + (*low - 0xDC00);
    } else if (*code >= 0xDC00 && *code <= 0xDFFF) {
      return false;
    }
    append_utf8(*code, out);
    return true;
  }

  /// Reads four digits after the character at `at_`.
  std::optional<unsigned> hexadecimal() {
    unsigned code = 0;
    for (int i = 0; i < 4; ++i) {
      if (++at_ >= text_.size()) return std::nullopt;
      const char c = text_[at_];
      const bool digit = c >= '0' && c <= '9';
      const char lower = static_cast<char>(c | 0x20);
      if (!digit && (lower < 'a' || lower > 'f')) return std::nullopt;
      code = code * 16 + static_cast<unsigned>(digit ? c - '0' : lower - 'a' + 10);
    }
    return code;
  }

  static void append_utf8(unsigned code, std::string& out) {
    const auto add = [&out](unsigned byte) { out += static_cast<char>(byte); };
    if (code < 0x80) {
      add(code);
    } else if (code < 0x800) {
      add(0xC0 | (code >> 6));
      add(0x80 | (code & 0x3F));
    } else {
      if (code < 0x10000) {
        add(0xE0 | (code >> 12));
      } else {
        add(0xF0 | (code >> 18));
        add(0x80 | ((code >> 12) & 0x3F));
      }
      add(0x80 | ((code >> 6) & 0x3F));
      add(0x80 | (code & 0x3F));
    }
  }

  std::optional<Json> number() {
    const bool negative = at_ < text_.size() && text_[at_] == '-';
    if (negative) ++at_;
    int exponent = 0;
    double value = 0.0;
    const std::size_t begin = at_;
    digits(value, exponent, 0);
    if (at_ == begin || (text_[begin] == '0' && at_ > begin + 1)) return std::nullopt;
    if (at_ < text_.size() && text_[at_] == '.') {
      const std::size_t point = ++at_;
      digits(value, exponent, -1);
      if (at_ == point) return std::nullopt;
    }
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      ++at_;
      const bool down = at_ < text_.size() && text_[at_] == '-';
      if (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) ++at_;
      const std::size_t first = at_;
      int power = 0;
      for (; is_digit(); ++at_)
        if (power < 10000) power = power * 10 + (text_[at_] - '0');
      if (at_ == first) return std::nullopt;
      exponent += down ? -power : power;
    }
    // Dividing by an exact power rounds only once, as required for decimal numbers.
    if (exponent < 0)
      value /= std::pow(10.0, -exponent);
    else if (value > 0.0)
      value *= std::pow(10.0, exponent);
    if (!std::isfinite(value)) return std::nullopt;
    return Json(negative ? -value : value);
  }

  /// `per_digit`: change of the exponent per digit.
  void digits(double& value, int& exponent, int per_digit) {
    constexpr double kExact = 900719925474099.0;
    for (; is_digit(); ++at_) {
      // Digits beyond the precision of a double are ignored.
      if (value < kExact) {
        value = value * 10.0 + (text_[at_] - '0');
        exponent += per_digit;
      } else {
        exponent += per_digit + 1;
      }
    }
  }

  bool is_digit() const { return at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9'; }

  std::optional<Json> word(std::string_view word, Json value) {
    if (text_.substr(at_, word.size()) != word) return std::nullopt;
    at_ += word.size();
    return value;
  }

  bool next_is(char c) {
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  void skip_blanks() {
    while (at_ < text_.size() &&
           std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos)
      ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<Json> Json::parse(std::string_view text) { return Parser(text).whole(); }

}  // namespace hedgehog::unreal
