#include "core/document/text/json_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/assert.h"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

void append_exactly(std::string& text, const Json& json) {
  if (json.is_number_float()) return append_number(text, json.get<double>());
  if (!json.is_structured()) {
    text += json.is_number_unsigned() ? std::to_string(json.get<uint64_t>()) : json.dump();
    return;
  }
  text += json.is_object() ? '{' : '[';
  for (auto item = json.begin(); item != json.end(); ++item) {
    if (item != json.begin()) text += ',';
    if (json.is_object()) text += '"' + item.key() + "\":";
    append_exactly(text, *item);
  }
  text += json.is_object() ? '}' : ']';
}

template <typename ToText>
Result<std::string> utf8_text(ToText to_text) {
  try {
    return to_text();
  } catch (const Json::exception&) {
    return bad_input("a name in it is not UTF-8, which JSON cannot hold: rename that file or piece");
  }
}

}  // namespace

void append_number(std::string& text, double x) {
  KERF_ASSERT(std::isfinite(x));
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr;
  const std::string_view number(digits.data(), static_cast<size_t>(end - digits.data()));
  text += number;
  if (number.find_first_of(".e") == std::string_view::npos) text += ".0";
}

Result<std::string> dump_json(const Json& json, int indent) {
  return utf8_text([&] { return json.dump(indent); });
}

Result<std::string> exact_text(const Json& json) {
  return utf8_text([&] {
    std::string text;
    append_exactly(text, json);
    return text;
  });
}

std::string path_text(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  fs::path whole = fs::weakly_canonical(fs::absolute(file, error), error);
  if (error) whole = file;
  if (folder.empty()) return whole.string();
  const fs::path from = fs::weakly_canonical(fs::absolute(folder, error), error);
  const fs::path relative = error ? fs::path() : whole.lexically_relative(from);
  const auto ups = std::count(relative.begin(), relative.end(), "..");
  const bool beside = ups == 0 || (ups == 1 && from.parent_path() != from.root_path());
  return relative.empty() || !beside ? whole.string() : relative.string();
}

}  // namespace kerf
