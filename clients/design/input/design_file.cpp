// SPDX-License-Identifier: MIT
#include "clients/design/input/design_file.h"

#include <algorithm>

#include "base/keys/json_text.h"
#include "base/keys/key_tree.h"
#include "clients/common/file_problem.h"
#include "clients/design/output/tool.h"

namespace hedgehog::design {
namespace {

using keys::Key;
using keys::Reason;
using keys::Value;

constexpr double kMaxId = 100'000;

Key<Design> text_key(std::string path, std::string Design::*member) {
  return {std::move(path),
          [member](Design& design, const Value& value) -> Reason {
            if (value.kind != Value::Kind::kText) return keys::must_be("a text", value);
            design.*member = value.text;
            return {};
          },
          [member](const Design& design) { return Value::of(design.*member); }};
}

Key<Design> size_key(std::string path, Size Design::*member) {
  return {std::move(path),
          [member](Design& design, const Value& value) -> Reason {
            if (value.kind != Value::Kind::kText)
              return keys::must_be("a text such as \"8x10\"", value);
            const auto size = parse_size(value.text, "");
            if (!size) return size.error().message.substr(2);
            design.*member = *size;
            return {};
          },
          [member](const Design& design) { return Value::of(to_text(design.*member)); }};
}

Key<Design> ids_key(std::string path, std::vector<int> Design::*member) {
  return {std::move(path),
          [member](Design& design, const Value& value) -> Reason {
            if (value.kind != Value::Kind::kArray) return keys::must_be("a list of ids", value);
            std::vector<int> ids;
            for (const Value& element : value.elements) {
              double id = 0.0;
              if (Reason reason = keys::read_integer(element, 0, kMaxId, id); !reason.empty())
                return "must be a list of ids; each " + reason;
              ids.push_back(static_cast<int>(id));
            }
            std::sort(ids.begin(), ids.end());
            ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
            design.*member = std::move(ids);
            return {};
          },
          [member](const Design& design) {
            std::vector<Value> ids;
            for (const int id : design.*member) ids.push_back(Value::of(static_cast<double>(id)));
            return Value::array(std::move(ids));
          }};
}

const std::vector<Key<Design>>& design_keys() {
  const auto of = [](auto member) {
    return [member](auto& design) -> auto& { return design.*member; };
  };
  using keys::number_key;
  static const std::vector<Key<Design>> kKeys{
      text_key("array", &Design::array),
      text_key("positions", &Design::positions),
      size_key("magnet", &Design::magnet),
      size_key("shield", &Design::shield),
      number_key<Design>("sphere_mm", kMinSphereMm, kMaxSphereMm, of(&Design::sphere_mm)),
      number_key<Design>("remanence_t", 0.01, 2, of(&Design::remanence_t)),
      ids_key("removed_pins", &Design::removed_pins),
      ids_key("removed_shields", &Design::removed_shields),
      number_key<Design>("coil_force_n", 0.001, 100, of(&Design::coil_force_n)),
      {"made_by", [](Design&, const Value&) { return Reason(); },
       [](const Design&) { return Value::of(std::string("hedgehog-design " HEDGEHOG_VERSION)); }},
  };
  return kKeys;
}

}  // namespace

Result<Design> parse_design(const std::string& text, const std::string& name) {
  const auto root = keys::parse_json(text, name);
  if (root.has_error()) return problem_of(kBadData, {root.error()});
  Design design;
  keys::Origins origins;
  keys::FileErrors errors;
  keys::read_keys(*root, name, design_keys(), design, origins, errors);
  if (!errors.empty()) return problem_of(kBadData, errors);
  return design;
}

Result<Design> load_design(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return text.error();
  auto design = parse_design(*text, path);
  if (!design) return design.error();
  // A nonexistent array or id is an error in the file, not on the command line.
  const auto array = arrangement_of(*design);
  if (!array && array.error().exit_code == kUsage)
    return Problem{kBadData, path + ": " + array.error().message};
  return design;
}

Result<void> protect_design(const std::string& path) {
  const auto text = read_file(path);
  if (!text || !parse_design(*text, path)) return {};
  return Problem{
      kUsage,
      path + " is a design file and is not written over; the design comes first, as in: export " +
          path + " --json"};
}

std::string design_text(const Design& design) {
  return keys::to_json(keys::write_keys(design_keys(), design));
}

}  // namespace hedgehog::design
