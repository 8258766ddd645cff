#include "core/laser/dxf_file.h"

#include <array>
#include <charconv>
#include <cmath>

namespace kerf {

namespace {

constexpr double kMaxDxfNumber = 1e15;

std::string_view without_blanks(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

Error dxf_error(const std::string& file, size_t line, const std::string& what) {
  return bad_input(file + ", line " + std::to_string(line) + ", column 1: " + what);
}

// Reads the lines of a text, which end with LF, CRLF or CR.
class DxfLines {
 public:
  explicit DxfLines(std::string_view text) : text_(text) {}

  std::optional<std::string_view> next() {
    if (at_ >= text_.size()) return std::nullopt;
    const size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    const std::string_view line = text_.substr(at_, end - at_);
    at_ = end + 1;
    if (end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n') ++at_;
    ++number_;
    return line;
  }
  size_t number() const { return number_; }  // of the last line read

 private:
  std::string_view text_;
  size_t at_ = 0, number_ = 0;
};

// Metres in the units of $INSUNITS; millimetres for a drawing without a unit, or in one of astronomy.
double dxf_unit(int code) {
  constexpr std::array<double, 18> kUnits{0.001,     0.0254, 0.3048, 1609.344, 0.001, 0.01, 1,  1000, 2.54e-8,
                                          0.0000254, 0.9144, 1e-10,  1e-9,     1e-6,  0.1,  10, 100,  1e9};
  constexpr std::array<double, 4> kSurveyFeet{1, 1.0 / 12, 3, 5280};  // foot, inch, yard and mile, from 21
  if (0 <= code && code < 18) return kUnits[static_cast<size_t>(code)];
  return 21 <= code && code < 25 ? kSurveyFeet[static_cast<size_t>(code - 21)] * 1200 / 3937 : 0.001;
}

// Sorts the groups into sections, blocks and entities.
class DxfSections {
 public:
  explicit DxfSections(DxfFile& file) : file_(file) {}

  Status run() {
    const std::span<const DxfGroup> groups = file_.groups;
    for (size_t i = 0; i < groups.size();) {
      if (groups[i].code != 0) {
        ++i;  // a comment before the first section
        continue;
      }
      size_t end = i + 1;
      while (end < groups.size() && groups[end].code != 0) ++end;
      const DxfEntity entity(groups.subspan(i, end - i), file_.name);
      if (entity.type() == "EOF") return Done{};
      if (const Status s = add(entity); !s) return s;
      i = end;
    }
    return dxf_error(file_.name, groups.empty() ? 1 : groups.back().line,
                     "the file ends before EOF; it is incomplete");
  }

 private:
  Status add(const DxfEntity& entity) {
    const std::string_view type = entity.type();
    if (type == "SECTION") {
      section_ = entity.text(2);
      return section_ == "HEADER" ? read_header(entity) : Status(Done{});
    }
    if (type == "ENDSEC") {
      section_ = {};
      block_ = nullptr;
    } else if (section_ == "TABLES" && type == "LAYER") {
      return add_layer(entity);
    } else if (section_ == "BLOCKS" && type == "BLOCK") {
      block_ = &file_.blocks[entity.text(2)];
      return unpack(entity.point(10), block_->base);
    } else if (section_ == "BLOCKS" && type == "ENDBLK") {
      block_ = nullptr;
    } else if (section_ == "BLOCKS" && block_ != nullptr) {
      block_->entities.push_back(entity);
    } else if (section_ == "ENTITIES") {
      file_.entities.push_back(entity);
    }
    return Done{};
  }

  Status read_header(const DxfEntity& header) {
    const std::span<const DxfGroup> groups = header.groups();
    for (size_t i = 0; i + 1 < groups.size(); ++i) {
      if (groups[i].code != 9 || groups[i].value != "$INSUNITS") continue;
      const auto code = header.number(groups[i + 1]);
      if (!code) return code.error();
      file_.unit = dxf_unit(*code >= 0 && *code < 100 ? static_cast<int>(*code) : 0);
    }
    return Done{};
  }

  Status add_layer(const DxfEntity& layer) {
    const auto flags = layer.whole(70, 0), colour = layer.whole(62, 7);
    if (!flags) return flags.error();
    if (!colour) return colour.error();
    file_.hidden_layer[layer.text(2)] = (*flags & 1) != 0 || *colour < 0;
    return Done{};
  }

  DxfFile& file_;
  std::string_view section_;
  DxfBlock* block_ = nullptr;
};

}  // namespace

std::string_view DxfEntity::text(int code) const {
  for (const DxfGroup& group : groups_) {
    if (group.code == code) return group.value;
  }
  return {};
}

bool DxfEntity::has(int code) const {
  for (const DxfGroup& group : groups_) {
    if (group.code == code) return true;
  }
  return false;
}

Result<double> DxfEntity::number(const DxfGroup& group) const {
  const std::string_view text = group.value.substr(group.value.starts_with('+') ? 1 : 0);
  double value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size() || !(std::abs(value) <= kMaxDxfNumber))
    return dxf_error(*file_, group.line,
                     std::string(type()) + ": the group " + std::to_string(group.code) + " must be a number");
  return value;
}

Result<double> DxfEntity::number(int code, double missing) const {
  for (const DxfGroup& group : groups_) {
    if (group.code == code) return number(group);
  }
  return missing;
}

Result<int> DxfEntity::whole(int code, int missing) const {
  const auto value = number(code, missing);
  if (!value) return value.error();
  if (!(std::abs(*value) <= 1e9) || *value != std::floor(*value))
    return wrong("the group " + std::to_string(code) + " must be a whole number");
  return static_cast<int>(*value);
}

Result<Vec2> DxfEntity::point(int x) const {
  const auto first = number(x, 0), second = number(x + 10, 0);
  if (!first) return first.error();
  if (!second) return second.error();
  return Vec2(*first, *second);
}

Result<std::vector<Vec2>> DxfEntity::points(int x) const {
  std::vector<Vec2> points;
  for (const DxfGroup& group : groups_) {
    if (group.code != x && group.code != x + 10) continue;
    const auto value = number(group);
    if (!value) return value.error();
    if (group.code == x) {
      points.emplace_back(*value, 0);
    } else if (!points.empty()) {
      points.back().y = *value;
    }
  }
  return points;
}

Result<std::vector<double>> DxfEntity::numbers(int code) const {
  std::vector<double> values;
  for (const DxfGroup& group : groups_) {
    if (group.code != code) continue;
    const auto value = number(group);
    if (!value) return value.error();
    values.push_back(*value);
  }
  return values;
}

Error DxfEntity::wrong(const std::string& what) const {
  return dxf_error(*file_, groups_.front().line, std::string(type()) + ": " + what);
}

Status split_dxf(std::string_view text, const std::string& file, DxfFile& result) {
  result.name = file;
  if (text.starts_with("AutoCAD Binary DXF"))
    return bad_input(file + ": the file is a binary DXF; save it as text (ASCII)");
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  DxfLines lines(text);
  while (const auto first = lines.next()) {
    const std::string_view word = without_blanks(*first);
    DxfGroup group;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), group.code);
    if (fault != std::errc() || end != word.data() + word.size()) {
      if (!result.groups.empty() && result.groups.back().code == 0 && result.groups.back().value == "EOF")
        break;
      return dxf_error(file, lines.number(),
                       "expected a group code, a whole number; the file is no DXF or is damaged");
    }
    const auto value = lines.next();
    if (!value) return dxf_error(file, lines.number(), "the file ends after a group code; it is incomplete");
    group.value = without_blanks(*value);
    group.line = lines.number();
    if (group.code != 999) result.groups.push_back(group);
  }
  return DxfSections(result).run();
}

}  // namespace kerf
