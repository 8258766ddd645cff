#include "core/document/text/json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <system_error>

#include "core/base/ids.h"
#include "core/mesh/files/mesh_format.h"
#include "core/mesh/files/scanner.h"

namespace kerf {
namespace fs = std::filesystem;

namespace {

// Maximum number of letters compared, so that the cost of a key of a megabyte is bounded.
constexpr size_t kComparedLetters = 64;

std::string folded(std::string_view name) {
  std::string text(name.substr(0, kComparedLetters));
  for (char& c : text) {
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

size_t distance(const std::string& a, const std::string& b) {
  if (!a.empty() && !b.empty() && a != b && (a.starts_with(b) || b.starts_with(a))) return 1;
  // Row i holds the distances of the first i letters of a; the two rows before it are kept.
  std::vector<size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

// Returns the number of the line at an offset, from 1.
std::string line_at(std::string_view text, size_t offset) {
  return std::to_string(1 + std::ranges::count(text.substr(0, offset), '\n'));
}

using Json = nlohmann::ordered_json;

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
    return bad_input("a name is not UTF-8, which JSON requires: rename that file or piece");
  }
}

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string> names) {
  const std::string wanted = folded(name);
  const std::string* nearest = nullptr;
  size_t least = 0;
  for (const std::string& candidate : names) {
    const size_t d = distance(wanted, folded(candidate));
    if (nearest != nullptr && d >= least) continue;
    nearest = &candidate;
    least = d;
  }
  return nearest != nullptr ? *nearest : "";
}

std::string nearest_name_hint(std::string_view name, std::span<const std::string> names) {
  if (names.empty()) return "";
  return "; the nearest name is \"" + nearest_name(name, names) + "\"";
}

Error JsonValue::wrong(const std::string& what) const {
  return bad_input(one_line(file_ + ": " + (pointer_.empty() ? "" : pointer_ + ": ") + what));
}

Result<double> JsonValue::number() const {
  if (!value_->is_number() || !std::isfinite(value_->get<double>())) return wrong("must be a finite number");
  return value_->get<double>();
}

Result<double> JsonValue::positive_number() const {
  const auto n = number();
  if (n && !(*n > 0)) return wrong("must be greater than zero");
  return n;
}

Result<Vec3> JsonValue::vector() const {
  if (!value_->is_array() || value_->size() != 3) return wrong("must be three numbers");
  Vec3 v{0};
  for (int i = 0; i < 3; ++i) {
    const auto n = (*this)[static_cast<size_t>(i)].number();
    if (!n) return n.error();
    v[i] = *n;
  }
  return v;
}

Result<glm::dquat> JsonValue::orientation() const {
  if (!json().is_array() || json().size() != 4) return wrong("must be four numbers");
  glm::dquat turn;
  size_t i = 0;
  for (double* part : {&turn.w, &turn.x, &turn.y, &turn.z}) {
    const auto n = (*this)[i++].number();
    if (!n) return n.error();
    *part = *n;
  }
  if (!is_unit_length2(glm::dot(turn, turn))) return wrong("must have length 1");
  return turn;
}

Result<Interval> JsonValue::pair() const {
  if (!value_->is_array() || value_->size() != 2) return wrong("must be two numbers");
  const auto first = (*this)[size_t{0}].number(), second = (*this)[size_t{1}].number();
  if (!first) return first.error();
  if (!second) return second.error();
  return Interval{*first, *second};
}

Result<Interval> JsonValue::interval() const {
  const auto range = pair();
  if (range && (range->low > range->high || range->low < 0))
    return wrong("must be [min, max] with 0 <= min <= max");
  return range;
}

Result<std::string> JsonValue::text() const {
  if (!value_->is_string()) return wrong("must be a string");
  return value_->get<std::string>();
}

Result<bool> JsonValue::flag() const {
  if (!value_->is_boolean()) return wrong("must be true or false");
  return value_->get<bool>();
}

std::optional<std::vector<uint32_t>> JsonValue::whole_numbers(std::initializer_list<size_t> lengths) const {
  if (!value_->is_array() || std::find(lengths.begin(), lengths.end(), value_->size()) == lengths.end())
    return std::nullopt;
  std::vector<uint32_t> numbers;
  for (const nlohmann::json& n : *value_) {
    if (!n.is_number_unsigned() || n.get<uint64_t>() >= kNoIndex) return std::nullopt;
    numbers.push_back(n.get<uint32_t>());
  }
  return numbers;
}

Status JsonValue::array(const char* of_what) const {
  if (!value_->is_array()) return wrong(std::string("must be an array of ") + of_what);
  return Done{};
}

Status JsonValue::object() const {
  if (!value_->is_object()) return wrong("must be an object");
  return Done{};
}

Result<nlohmann::json> parse_json(std::string_view text, const std::string& file) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& fault) {
    const size_t at = std::min(text.size(), fault.byte > 0 ? fault.byte - 1 : 0);
    const size_t first = text.find_first_not_of(" \t\r\n");
    const bool begins_as_json = first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
    const std::string_view kind = begins_as_json ? std::string_view() : kind_of_file(text);
    return bad_input(file + ": line " + line_at(text, at) + ": this is " +
                     (kind.empty() ? "not JSON" : std::string(kind) + ", not JSON"));
  } catch (const nlohmann::json::out_of_range& fault) {
    // "[..] number overflow parsing '1e999'"
    const std::string_view what = fault.what();
    const std::string_view number = what.substr(what.find('\'') + 1, what.rfind('\'') - what.find('\'') - 1);
    return bad_input(file + ": line " + line_at(text, std::min(text.find(number), text.size())) +
                     ": the number " + std::string(number.substr(0, kComparedLetters)) + " is too large");
  } catch (const std::exception&) {
    return bad_input(file + ": this is not valid JSON");
  }
}

Status check_unique_keys(std::string_view text, const std::string& file) {
  text = text.substr(0, text.find('\0'));  // parse_json() reads no further
  std::vector<std::string_view> keys;      // of all open objects
  std::vector<size_t> firsts;              // of each open object
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '{') firsts.push_back(keys.size());
    if (text[i] == '}') {
      const auto first = keys.begin() + static_cast<std::ptrdiff_t>(firsts.back());
      std::sort(first, keys.end());
      const auto twice = std::adjacent_find(first, keys.end());
      if (twice != keys.end()) {
        const auto later = std::max(twice[0].data(), twice[1].data()) - text.data();
        return bad_input(file + ": line " + line_at(text, static_cast<size_t>(later)) + ": the key \"" +
                         std::string(twice->substr(0, kComparedLetters)) + "\" is in this object twice");
      }
      keys.erase(first, keys.end());
      firsts.pop_back();
    }
    if (text[i] != '"') continue;
    const size_t begin = i + 1;
    for (++i; text[i] != '"'; ++i) i += text[i] == '\\' ? 1 : 0;
    const size_t next = text.find_first_not_of(" \t\r\n", i + 1);
    if (next != std::string_view::npos && text[next] == ':') keys.push_back(text.substr(begin, i - begin));
  }
  return Done{};
}

Result<std::string> read_text_file(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) return bad_input(file.string() + ": no such file");
  if (!std::filesystem::is_regular_file(status))
    return bad_input(file.string() + ": this is not a regular file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return bad_input(file.string() + ": cannot be opened for reading");
  std::ostringstream text;
  stream >> text.rdbuf();
  if (!stream.eof()) return failed(file.string() + ": reading failed before the end");
  return std::move(text).str();
}

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
