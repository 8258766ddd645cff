#include "ui/window/number_text.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "ui/window/layout.h"
#include "ui/window/widgets.h"

namespace kerf {

std::string NumberFormat::unit() const {
  const std::string_view text(text_);
  size_t at = 0;
  while (at < text.size() && text[at] != '%') ++at;
  while (at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) == 0) ++at;
  std::string unit;
  for (++at; at < text.size(); ++at) {
    if (text[at] == ' ' && unit.empty()) continue;
    if (text[at] == '%') ++at;
    unit += text[at];
  }
  while (!unit.empty() && unit.back() == ' ') unit.pop_back();
  return unit;
}

std::string area_text(double square_metres) {
  if (square_metres == 0) return "none";
  struct Unit {
    const char* name;
    double size;
  };
  constexpr std::array kUnits{Unit{"\xc2\xb5m\xc2\xb2", 1e-12}, Unit{"mm\xc2\xb2", 1e-6},
                              Unit{"cm\xc2\xb2", 1e-4}, Unit{"m\xc2\xb2", 1}};
  Unit best = kUnits.front();
  for (const Unit& unit : kUnits) {
    if (square_metres >= 0.1 * unit.size) best = unit;
  }
  std::array<char, 48> text{};
  const double value = square_metres / best.size;
  std::snprintf(text.data(), text.size(), value >= 100 ? "%.0f %s" : "%.3g %s", value, best.name);
  return text.data();
}

bool is_noise(double value, double scale) {
  constexpr double kNoise = 1e-12;
  return std::abs(value) < kNoise * std::abs(scale);
}

std::string number_text(double value, const RealFormat& format, double scale) {
  std::array<char, 256> text{};
  const double shown = is_noise(value, scale) ? 0 : value;
  ImGui::DataTypeFormatString(text.data(), static_cast<int>(text.size()), ImGuiDataType_Double, &shown,
                              format.c_str());
  std::string number = text.data();
  // printf keeps the sign of a negative number rounded to 0.
  const size_t digit = number.find_first_of("0123456789");
  if (digit == std::string::npos || digit == 0 || number[digit - 1] != '-') return number;
  const size_t end = number.find_first_not_of("0.", digit);
  if (end == std::string::npos || std::string_view("123456789e").find(number[end]) == std::string_view::npos)
    number.erase(digit - 1, 1);
  return number;
}

std::string text_of(const char* format, ...) {
  std::array<char, 256> text{};
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(text.data(), text.size(), format, values);
  va_end(values);
  return text.data();
}

namespace {

constexpr size_t kGroup = 3;  // digits between two spaces

struct UnitName {
  const char* name;
  double size;       // metres, radians or watts
  bool told = true;  // listed in messages
};
constexpr std::array kLengths{UnitName{"mm", 1e-3},
                              UnitName{"cm", 1e-2},
                              UnitName{"m", 1},
                              UnitName{"in", 0.0254},
                              UnitName{"ft", 0.3048},
                              UnitName{"nm", 1e-9, false},
                              UnitName{"um", 1e-6, false},
                              UnitName{"\xc2\xb5m", 1e-6, false},
                              UnitName{"km", 1e3, false}};
constexpr std::array kAngles{UnitName{"\xc2\xb0", kPi / 180}, UnitName{"deg", kPi / 180}, UnitName{"rad", 1}};
constexpr std::array kPowers{UnitName{"W", 1}, UnitName{"kW", 1000}};

std::span<const UnitName> units_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::kPlain:
      break;
    case Quantity::kLength:
      return kLengths;
    case Quantity::kAngle:
      return kAngles;
    case Quantity::kPower:
      return kPowers;
  }
  return {};
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool same(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) { return lower(x) == lower(y); });
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::string quoted(std::string_view text) { return '"' + std::string(text) + '"'; }

// Returns the size of a unit relative to the field's; nullopt if the field does not accept it.
std::optional<double> factor_of(std::string_view name, const NumberUnit& unit) {
  if (!unit.name.empty() && same(name, trimmed(unit.name))) return 1;
  for (const UnitName& known : units_of(unit.quantity)) {
    if (same(name, known.name) || (!unit.per.empty() && same(name, known.name + unit.per)))
      return known.size / unit.size;
  }
  return std::nullopt;
}

// Returns "the units are mm, cm, m, in and ft"; empty if the field has none.
std::string units_text(const NumberUnit& unit) {
  std::vector<std::string> names;
  for (const UnitName& known : units_of(unit.quantity)) {
    if (known.told) names.push_back(known.name + unit.per);
  }
  if (names.empty() && trimmed(unit.name).empty()) return "";
  if (names.empty()) return "the unit is " + std::string(trimmed(unit.name));
  std::string text = "the units are " + names.front();
  for (size_t i = 1; i < names.size(); ++i) text += (i + 1 < names.size() ? ", " : " and ") + names[i];
  return text;
}

// A recursive descent parser; stops at the first error.
class Parser {
 public:
  Parser(std::string_view text, const NumberUnit& unit) : text_(text), unit_(unit) {}

  Result<double> run() {
    skip_spaces();
    if (at_ == text_.size()) return bad_input("the field is empty");
    double value = sum();
    if (fault_.empty()) value *= suffix();
    if (fault_.empty() && !std::isfinite(value)) fault_ = "the value is too large";
    if (!fault_.empty()) return bad_input(fault_);
    return value;
  }

 private:
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  char peek(size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool take(char c) {
    if (peek() != c || !fault_.empty()) return false;
    ++at_;
    skip_spaces();
    return true;
  }
  void skip_spaces() {
    while (peek() == ' ') ++at_;
  }
  double fail(std::string fault) {
    if (fault_.empty()) fault_ = std::move(fault);
    return 0;
  }
  double finite(double value) { return std::isfinite(value) ? value : fail("the value is too large"); }

  double sum() {
    double value = product();
    while (fault_.empty()) {
      if (take('+')) {
        value = finite(value + product());
      } else if (take('-')) {
        value = finite(value - product());
      } else {
        break;
      }
    }
    return value;
  }

  double product() {
    double value = factor();
    while (fault_.empty()) {
      if (take('*')) {
        value = finite(value * factor());
      } else if (take('/')) {
        const double by = factor();
        value = by == 0 ? fail("division by zero") : finite(value / by);
      } else {
        break;
      }
    }
    return value;
  }

  double factor() {
    bool negative = false;
    for (;;) {
      if (take('-')) {
        negative = !negative;
      } else if (!take('+')) {
        break;
      }
    }
    const double value = primary();
    return negative ? -value : value;
  }

  double primary() {
    if (is_digit(peek()) || (peek() == '.' && is_digit(peek(1)))) return number();
    if (!take('(')) return fail(missing_number());
    if (++depth_ > kMaxBrackets) return fail("too many nested brackets");
    const double value = sum();
    --depth_;
    if (fault_.empty() && !take(')')) fail(at_ == text_.size() ? "a \")\" is missing" : unread());
    return value;
  }

  // Appends digits to `digits`; if `grouped`, they may be in groups of three.
  void take_digits(std::string& digits, bool grouped) {
    const size_t begin = digits.size();
    while (is_digit(peek())) digits += text_[at_++];
    const size_t first = digits.size() - begin;
    while (grouped && first <= kGroup && first > 0 && follows_group()) {
      digits += text_.substr(at_ + 1, kGroup);
      at_ += 1 + kGroup;
    }
  }
  bool follows_group() const {
    if (peek() != ' ') return false;
    for (size_t i = 1; i <= kGroup; ++i) {
      if (!is_digit(peek(i))) return false;
    }
    return !is_digit(peek(1 + kGroup));
  }

  double number() {
    const size_t begin = at_;
    std::string digits;
    take_digits(digits, true);
    if (peek() == '.') {
      digits += text_[at_++];
      take_digits(digits, false);
    }
    const size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
    if (lower(peek()) == 'e' && is_digit(peek(1 + sign))) {
      digits += 'e';
      if (peek(1) == '-') digits += '-';
      at_ += 1 + sign;
      take_digits(digits, false);
    }
    const std::string_view as_typed = text_.substr(begin, at_ - begin);
    skip_spaces();
    if (peek() == '.' || is_digit(peek())) {
      at_ = begin;
      return fail(unread());
    }
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::result_out_of_range)
      return fail(quoted(as_typed) + (is_tiny(digits) ? " is too close to zero" : " is too large"));
    KERF_ASSERT(error == std::errc() && end == digits.data() + digits.size());
    return value;
  }
  // Distinguishes the two kinds of out-of-range numbers.
  static bool is_tiny(const std::string& digits) { return std::strtod(digits.c_str(), nullptr) < 1; }

  std::string missing_number() const {
    if (at_ == text_.size()) return "a number is missing at the end";
    if (peek() == ',') return unread();
    return quoted(word()) + " is not a number";
  }

  // The text at the current position, up to the next space or operator.
  std::string_view word() const {
    const std::string_view rest = text_.substr(at_);
    const size_t end = rest.find_first_of(" +-*/()", 1);
    return rest.substr(0, end);
  }

  // Returns the factor of the unit at the end.
  double suffix() {
    const std::string_view name = trimmed(text_.substr(at_));
    if (name.empty()) return 1;
    if (const auto factor = factor_of(name, unit_)) return *factor;
    return fail(unread());
  }

  // The reason why the rest of the text is invalid here.
  std::string unread() const {
    const std::string_view rest = text_.substr(at_);
    if (rest.find(',') != std::string_view::npos)
      return "commas are not supported: use a decimal point, and spaces between thousands";
    if (peek() == ')') return "a \")\" has no \"(\"";
    if (is_digit(peek()) || peek() == '.' || peek() == '(')
      return quoted(trimmed(rest)) + " is not one number";
    const bool goes_on = rest.find_first_of("0123456789(", word().size()) != std::string_view::npos;
    if (goes_on && factor_of(word(), unit_))
      return "the unit must be at the end; it applies to the whole expression";
    const std::string known = units_text(unit_);
    return quoted(trimmed(rest)) +
           " is not understood: " + (known.empty() ? "the number has no unit" : known);
  }

  std::string_view text_;
  const NumberUnit& unit_;
  size_t at_ = 0;
  int depth_ = 0;
  std::string fault_;
};

// Global like ImGui's current context.
Message*& entry_message() {
  static Message* message = nullptr;
  return message;
}

float room_in_field() { return ImGui::CalcItemWidth() - 2 * ImGui::GetStyle().FramePadding.x; }

// The tooltip of the last item, with the full text if it is shortened.
void explain(const std::string& shown, const std::string& fitted, const char* meaning) {
  tooltip(fitted == shown ? meaning : (shown + '\n' + meaning).c_str());
}

// The unit for reading, which includes the one in the format.
NumberUnit read_unit(const NumberEntry& entry) {
  NumberUnit unit = entry.unit;
  if (const std::string own = entry.format.unit(); !own.empty()) unit.name = own;
  return unit;
}

}  // namespace

NumberUnit length_unit(std::string name, std::string per) {
  const auto known = std::ranges::find_if(kLengths, [&](const UnitName& unit) { return name == unit.name; });
  KERF_ASSERT(known != kLengths.end());
  return {Quantity::kLength, known->size, name + per, std::move(per)};
}

Result<double> evaluate_number(std::string_view text, const NumberUnit& unit) {
  KERF_ASSERT(unit.size > 0);
  return Parser(text, unit).run();
}

void report_entries_to(Message* message) { entry_message() = message; }

void report_refused_entry(std::string sentence) {
  if (Message* message = entry_message()) message->object(std::move(sentence));
}

std::string NumberEntry::shown(double value) const { return number_text(value, format, scale) + unit.name; }

std::optional<double> NumberEntry::entered(std::string_view text, double present) const {
  Message* message = entry_message();
  const auto refuse = [&](const std::string& reason) {
    if (message != nullptr) message->object(std::string(name) + " stays " + shown(present) + ": " + reason);
    return std::nullopt;
  };
  const Result<double> value = evaluate_number(text, read_unit(*this));
  if (!value) return refuse(value.error().message);
  if (range.positive && !(*value > 0)) return refuse("it must be more than 0");
  if (message != nullptr) message->drop_objection();
  if (range.contains(*value)) return *value;
  const bool low = *value < range.least;
  const double limited = low ? range.least : range.most;
  if (message != nullptr)
    message->info_before_change(std::string(name) + " is limited to " + shown(limited) + ", the " +
                                (low ? "minimum" : "maximum") + " value");
  return limited;
}

void EditedText::begin(uint32_t id, std::string shown) {
  before_ = std::exchange(begun_, {id, std::move(shown)});
}

bool EditedText::was_active(uint32_t id) const {
  return typed_at_ == ImGui::GetFrameCount() - 1 && ImGui::GetCurrentContext()->ActiveIdPreviousFrame == id;
}

bool EditedText::is_active() const {
  return typed_at_ >= ImGui::GetFrameCount() - 1 && ImGui::GetActiveID() != 0;
}

std::optional<std::string> EditedText::draw(const char* id, const std::string& shown,
                                            const std::string& fitted) {
  std::array<char, std::tuple_size_v<decltype(typed_)>> text{};
  std::copy_n(shown.begin(), std::min(shown.size(), text.size() - 1), text.begin());
  const ImGuiID own = ImGui::GetID(id);
  const bool active = ImGui::GetActiveID() == own;
  const bool shortened = fitted != shown && !active;
  if (shortened) ImGui::PushStyleColor(ImGuiCol_Text, 0);  // only hidden, so that it remains editable
  const bool changed = ImGui::InputText(id, text.data(), text.size(), ImGuiInputTextFlags_AutoSelectAll);
  if (shortened) ImGui::PopStyleColor();
  if (ImGui::IsItemActivated()) begin(own, shown);
  if (changed || active) typed_ = text;  // a text equal to the shown one is not reported as a change
  if (active) typed_at_ = ImGui::GetFrameCount();
  const std::string& from = begun_.id == own ? begun_.text : before_.text;
  const bool entered = ImGui::IsItemDeactivatedAfterEdit() && from != typed_.data();
  if (shortened) {
    const ImVec2 at = ImGui::GetItemRectMin(), padding = ImGui::GetStyle().FramePadding;
    ImGui::GetWindowDrawList()->AddText({at.x + padding.x, at.y + padding.y},
                                        ImGui::GetColorU32(ImGuiCol_Text), fitted.c_str());
  }
  return entered ? std::optional<std::string>(typed_.data()) : std::nullopt;
}

bool NumberFields::field(double& value, const NumberEntry& entry, const char* meaning) {
  const std::string shown = entry.shown(value);
  const std::string fitted =
      fitted_number(value, entry.format, entry.unit.name, entry.scale, room_in_field());
  const std::optional<std::string> text = text_.draw("##field", shown, fitted);
  explain(shown, fitted, meaning);
  const std::optional<double> typed = text ? entry.entered(*text, value) : std::nullopt;
  if (typed) value = *typed;
  return typed.has_value();
}

bool NumberFields::count(const char* name, size_t& value, const char* meaning, size_t least, size_t most) {
  property(name);
  const std::string shown = grouped(value);
  const std::string fitted = fitted_text(shown, room_in_field());
  ImGui::PushID(name);
  const std::optional<std::string> text = text_.draw("##field", shown, fitted);
  mark_last_item(name);
  explain(shown, fitted, meaning);
  ImGui::PopID();
  if (!text) return false;
  const NumberRange range{static_cast<double>(least), static_cast<double>(most)};
  const NumberEntry entry{name, RealFormat("%.0f"), {}, range};
  const std::optional<double> typed = entry.entered(*text, static_cast<double>(value));
  if (typed) value = static_cast<size_t>(std::round(*typed));
  return typed.has_value();
}

bool NumberFields::vector(const char* name, Vec3& values, const RealFormat& format, const char* meaning,
                          const NumberUnit& unit, double scale) {
  property(name);
  bool entered = false;
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  const double size = std::max(scale, glm::length(values));
  ImGui::PushID(name);
  for (int i = 0; i < 3; ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(width);
    ImGui::PushID(i);
    entered = field(values[i], {name, format, unit, kFinite, size}, meaning) || entered;
    mark_last_item(name, i);
    ImGui::PopID();
  }
  ImGui::PopID();
  return entered;
}

bool NumberFields::number(const char* name, double& value, const RealFormat& format, const char* meaning,
                          const NumberUnit& unit, const NumberRange& range) {
  property(name);
  ImGui::PushID(name);
  const bool entered = field(value, {name, format, unit, range}, meaning);
  mark_last_item(name);
  ImGui::PopID();
  return entered;
}

}  // namespace kerf
