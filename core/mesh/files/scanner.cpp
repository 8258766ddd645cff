#include "core/mesh/files/scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// std::from_chars does not accept '+'.
std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
  return word;
}

// Returns the value of a number outside the range of double: infinity or zero, determined by the decimal
// exponent of its first significant digit.
double out_of_range_value(std::string_view word) {
  const bool negative = word.starts_with('-');
  if (negative) word.remove_prefix(1);
  const size_t exponent_at = std::min(word.find_first_of("eE"), word.size());
  const std::string_view mantissa = word.substr(0, exponent_at);
  const size_t point = std::min(mantissa.find('.'), mantissa.size());
  const size_t first = std::min(mantissa.find_first_of("123456789"), mantissa.size());
  const int64_t exponent = parse_integer(word.substr(std::min(exponent_at + 1, word.size()))).value_or(0);
  const int64_t shift = static_cast<int64_t>(point) - static_cast<int64_t>(first);
  const double magnitude = exponent > -shift ? kInfinity : 0.0;
  return negative ? -magnitude : magnitude;
}

bool is_garbled_number(std::string_view word) {
  return word.find_first_not_of("0123456789+-.eE") == std::string_view::npos &&
         std::any_of(word.begin(), word.end(), is_digit);
}

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr size_t kMaxQuote = 40;
constexpr size_t kReports = 200;  // calls of Progress::report for one file

bool is_blank_or_break(char c) { return static_cast<unsigned char>(c) <= ' '; }
bool is_break(char c) { return c == '\n' || c == '\r'; }

}  // namespace

bool continues_microsoft_nan(std::string_view text) {
  return text.starts_with("#IND") || text.starts_with("#INF") || text.starts_with("#QNAN") ||
         text.starts_with("#SNAN");
}

std::optional<double> parse_number(std::string_view word) {
  const std::string_view digits = without_plus(word);
  const char* const end = digits.data() + digits.size();
  double value = 0;
  const auto [stop, code] = std::from_chars(digits.data(), end, value);
  if (stop == end && code == std::errc()) return value;
  if (stop == end && code == std::errc::result_out_of_range) return out_of_range_value(digits);
  if (continues_microsoft_nan({stop, end}) || is_garbled_number(word)) return kNaN;
  return std::nullopt;
}

std::optional<int64_t> parse_integer(std::string_view word) {
  const std::string_view digits = without_plus(word);
  const char* const end = digits.data() + digits.size();
  int64_t value = 0;
  const auto [stop, code] = std::from_chars(digits.data(), end, value);
  if (stop != end || code == std::errc::invalid_argument) return std::nullopt;
  if (code == std::errc()) return value;
  return digits.starts_with('-') ? std::numeric_limits<int64_t>::min() : std::numeric_limits<int64_t>::max();
}

std::string one_line(std::string_view name) {
  std::string line(name);
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7f; }, '?');
  return line;
}

std::string in_quotes(std::string_view word) {
  std::string line = one_line(word.substr(0, kMaxQuote));
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) > 0x7e; }, '?');
  if (word.size() > kMaxQuote) line += "...";
  return line.insert(0, 1, '\'') += '\'';
}

std::string listed(std::span<const std::string> names, std::string_view last) {
  std::string list;
  for (size_t i = 0; i < names.size(); ++i)
    list.append(i == 0 ? "" : i + 1 == names.size() ? last : ", ").append(names[i]);
  return list;
}

Scanner::Scanner(std::string_view bytes, std::string_view file_name, Syntax syntax, const Progress* progress)
    : bytes_(bytes), file_name_(one_line(file_name)), syntax_(syntax), progress_(progress) {
  if (bytes_.starts_with(kByteOrderMark)) position_ = last_ = kByteOrderMark.size();
}

bool Scanner::is_word_end(size_t at) const {
  if (at == bytes_.size()) return true;
  const char c = bytes_[at];
  if (is_blank_or_break(c)) return true;
  if (c == '#' && syntax_.comments) return !continues_microsoft_nan(bytes_.substr(at, 5));
  return c == '\\' && syntax_.continuations && (at + 1 == bytes_.size() || is_break(bytes_[at + 1]));
}

bool Scanner::skip_continuation() {
  if (!syntax_.continuations || bytes_[position_] != '\\') return false;
  if (position_ + 1 < bytes_.size() && !is_break(bytes_[position_ + 1])) return false;
  position_ = std::min(position_ + 2, bytes_.size());
  if (bytes_[position_ - 1] == '\r' && position_ < bytes_.size() && bytes_[position_] == '\n') ++position_;
  return true;
}

bool Scanner::at_line_end() {
  while (position_ < bytes_.size()) {
    const char c = bytes_[position_];
    if (is_break(c) || (c == '#' && syntax_.comments)) return true;
    if (is_blank_or_break(c)) {
      ++position_;
    } else if (!skip_continuation()) {
      return false;
    }
  }
  return true;
}

bool Scanner::at_end() {
  while (at_line_end()) {
    if (position_ == bytes_.size()) return true;
    skip_line();
  }
  return false;
}

void Scanner::skip_line() {
  bool comment = false;
  while (position_ < bytes_.size() && !is_break(bytes_[position_])) {
    comment = comment || (bytes_[position_] == '#' && syntax_.comments);
    if (comment || !skip_continuation()) ++position_;
  }
  if (position_ == bytes_.size()) return;
  const bool carriage_return = bytes_[position_++] == '\r';
  if (carriage_return && position_ < bytes_.size() && bytes_[position_] == '\n') ++position_;
}

std::string_view Scanner::word() {
  const bool none = at_line_end();
  last_ = position_;
  if (none) return {};
  while (!is_word_end(position_)) ++position_;
  return bytes_.substr(last_, position_ - last_);
}

std::string_view Scanner::name() {
  const bool comments = std::exchange(syntax_.comments, false);
  const std::string_view name = word();
  syntax_.comments = comments;
  return name;
}

std::string_view Scanner::rest_of_line() {
  while (position_ < bytes_.size() && is_blank_or_break(bytes_[position_]) && !is_break(bytes_[position_])) {
    ++position_;
  }
  last_ = position_;
  while (position_ < bytes_.size() && !is_break(bytes_[position_])) ++position_;
  std::string_view rest = bytes_.substr(last_, position_ - last_);
  while (!rest.empty() && is_blank_or_break(rest.back())) rest.remove_suffix(1);
  return rest;
}

std::optional<double> Scanner::number() {
  if (at_line_end()) {
    last_ = position_;
    return std::nullopt;
  }
  double value = 0;
  const char* const begin = bytes_.data();
  const auto [stop, code] = std::from_chars(begin + position_, begin + bytes_.size(), value);
  if (code == std::errc() && is_word_end(static_cast<size_t>(stop - begin))) {
    last_ = position_;
    position_ = static_cast<size_t>(stop - begin);
    return value;
  }
  const std::string_view text = word();
  const std::optional<double> parsed = parse_number(text);
  const bool garbled = parsed && std::isnan(*parsed) && text.find_first_of("nN") == std::string_view::npos;
  if (garbled && garbled_numbers_++ == 0) first_garbled_ = last_;
  return parsed;
}

std::optional<int64_t> Scanner::integer() { return parse_integer(word()); }

const char* Scanner::take(size_t n) {
  KERF_ASSERT(n <= left());
  last_ = position_;
  position_ += n;
  return bytes_.data() + last_;
}

bool Scanner::cancelled() {
  if (!progress_ || position_ < next_report_) return false;
  next_report_ = position_ + bytes_.size() / kReports + 1;
  return !progress_->report(static_cast<double>(position_) / static_cast<double>(bytes_.size()));
}

std::string Scanner::garbled_numbers_warning() const {
  KERF_ASSERT(garbled_numbers_ > 0);
  const std::string line = std::to_string(line_of(first_garbled_));
  if (garbled_numbers_ == 1) return "1 garbled number, in line " + line + ", counts as not finite.";
  return std::to_string(garbled_numbers_) + " garbled numbers, the first in line " + line +
         ", count as not finite.";
}

size_t Scanner::line_of(size_t position) const {
  size_t line = 1;
  for (size_t i = 0; i < position; ++i) {
    const bool inside_crlf = bytes_[i] == '\r' && i + 1 < bytes_.size() && bytes_[i + 1] == '\n';
    if (is_break(bytes_[i]) && !inside_crlf) ++line;
  }
  return line;
}

Error Scanner::line_error(const std::string& what) const {
  return bad_input(file_name_ + ", line " + std::to_string(line_of(last_)) + ": " + what + ".");
}

Error Scanner::byte_error(const std::string& what) const {
  return bad_input(file_name_ + ", byte " + std::to_string(last_) + ": " + what + ".");
}

Error Scanner::file_error(const std::string& what) const { return bad_input(file_name_ + ": " + what + "."); }

Error Scanner::expected(const std::string& what) const {
  size_t end = last_;
  while (!is_word_end(end)) ++end;
  const std::string_view text = bytes_.substr(last_, end - last_);
  if (text.empty() && last_ == bytes_.size()) {
    return line_error("the file ends where " + what + " is expected; it is truncated");
  }
  if (text.empty()) return line_error("the line ends where " + what + " is expected");
  const bool comma = text.find(',') != std::string_view::npos && text.find_first_of("0123456789") == 0;
  return line_error("expected " + what + ", found " + in_quotes(text) +
                    (comma ? "; write decimal points, not commas" : ""));
}

std::optional<Error> Scanner::refuse_binary(std::string_view format) const {
  const size_t zero = bytes_.find('\0');
  if (zero == std::string_view::npos) return std::nullopt;
  if (bytes_.starts_with("\xff\xfe") || bytes_.starts_with("\xfe\xff")) {
    return file_error("this is UTF-16 text; save it as UTF-8");
  }
  return bad_input(file_name_ + ", byte " + std::to_string(zero) + ": a zero byte, so this is not " +
                   std::string(format) + " text.");
}

}  // namespace kerf
