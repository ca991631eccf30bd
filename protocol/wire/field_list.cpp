// SPDX-License-Identifier: MIT
#include "protocol/wire/field_list.h"

#include <utility>

namespace hedgehog::protocol {
namespace {

class FieldList final : public Fields {
 public:
  std::vector<FieldInfo> take() { return std::move(fields_); }

 private:
  bool open(std::string_view name, Presence, bool) override {
    fields_.push_back({.name = std::string(name)});
    return true;
  }
  void close() override {}
  bool begin_object() override { return false; }
  void end_object() override {}
  std::size_t begin_list(std::size_t, const Spec& spec) override {
    put(FieldType::kList, spec);
    return 0;
  }
  bool begin_item(std::size_t) override { return false; }
  void end_list() override {}
  void boolean(bool&) override { put(FieldType::kBoolean, {}); }
  void integer(std::int64_t&, const Spec& spec) override { put(FieldType::kNumber, spec); }
  void number(double&, const Spec& spec) override { put(FieldType::kNumber, spec); }
  void text(std::string&, const Spec& spec) override { put(FieldType::kText, spec); }
  void enumerator(std::size_t&, std::span<const std::string_view> names) override {
    put(FieldType::kEnumerator, {});
    fields_.back().names = names;
  }
  void numbers(std::span<double>, const Spec& spec) override { put(FieldType::kList, spec); }
  void direction(Direction&) override { put(FieldType::kDirection, {}); }

  void put(FieldType type, const Spec& spec) {
    fields_.back().type = type;
    fields_.back().spec = spec;
  }

  std::vector<FieldInfo> fields_{};
};

}  // namespace

std::vector<FieldInfo> list_fields(const std::function<void(Fields&)>& describe) {
  FieldList list;
  describe(list);
  return list.take();
}

}  // namespace hedgehog::protocol
