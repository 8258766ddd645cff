#include "core/laser/svg_path.h"

#include <array>
#include <charconv>
#include <cmath>
#include <span>

#include "core/base/deterministic_math.h"

namespace kerf {

namespace {

constexpr double kMaxSvgNumber = 1e30;

bool is_svg_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_svg_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); }

// Returns the arc of SVG's end point form (SVG 1.1, appendix F.6), from `start` to `end`; nullopt if it is a
// straight line.
std::optional<EllipseArc> endpoint_arc(Vec2 start, Vec2 radii, double turn, bool large, bool sweep,
                                       Vec2 end) {
  radii = glm::abs(radii);
  if (start == end || radii.x == 0 || radii.y == 0) return std::nullopt;
  const auto [sin, cos] = sin_cos(turn);
  const Vec2 half = 0.5 * (start - end);
  // In the frame of the ellipse, scaled to the unit circle.
  const Vec2 p{(cos * half.x + sin * half.y) / radii.x, (cos * half.y - sin * half.x) / radii.y};
  const double length2 = glm::dot(p, p);
  if (!(length2 > 0) || !std::isfinite(length2)) return std::nullopt;
  if (length2 > 1) radii *= std::sqrt(length2);
  const Vec2 q = length2 > 1 ? p / std::sqrt(length2) : p;
  const double height = length2 > 1 ? 0 : std::sqrt(std::max(0.0, 1 / length2 - 1));
  const Vec2 c = (large == sweep ? -height : height) * Vec2(q.y, -q.x);
  EllipseArc arc;
  arc.x_axis = radii.x * Vec2(cos, sin);
  arc.y_axis = radii.y * Vec2(-sin, cos);
  arc.centre = 0.5 * (start + end) + c.x * arc.x_axis + c.y * arc.y_axis;
  arc.from = det::atan2(q.y - c.y, q.x - c.x);
  arc.sweep = det::atan2(-q.y - c.y, -q.x - c.x) - arc.from;
  if (sweep && arc.sweep < 0) arc.sweep += 2 * kPi;
  if (!sweep && arc.sweep > 0) arc.sweep -= 2 * kPi;
  return arc;
}

// Interprets path data.
class SvgPath {
 public:
  SvgPath(std::string_view data, const PlaneMap& map, DrawingBuilder& builder)
      : value_(data), map_(map), builder_(builder) {}

  std::optional<SvgFault> run() {
    while (!value_.at_end()) {
      const size_t at = value_.position();
      const char letter = value_.letter();
      if (letter == 0) return value_.fault("expected a command of a path");
      if (at_start_ && letter != 'M' && letter != 'm') return SvgFault{at, "a path must begin with M"};
      const bool relative = letter >= 'a';
      const char command = relative ? static_cast<char>(letter - 'a' + 'A') : letter;
      if (command == 'Z') {
        close();
        continue;
      }
      if (std::string_view("MLHVCSQTA").find(command) == std::string_view::npos)
        return SvgFault{at, std::string("'") + letter + "' is no command of a path"};
      if (auto fault = segments(command, relative)) return fault;
    }
    builder_.end_line();
    return std::nullopt;
  }

 private:
  // Reads the arguments of a command, repeated until the next command.
  std::optional<SvgFault> segments(char command, bool relative) {
    do {
      if (auto fault = segment(command, relative)) return fault;
      if (command == 'M') command = 'L';
      at_start_ = false;
    } while (!value_.at_end() && !next_is_letter());
    return std::nullopt;
  }

  bool next_is_letter() {
    SvgValue ahead = value_;
    return ahead.letter() != 0;
  }

  std::optional<SvgFault> segment(char command, bool relative) {
    std::array<double, 7> n{};
    const size_t count = command == 'H' || command == 'V'   ? 1
                         : command == 'A'                   ? 7
                         : command == 'C'                   ? 6
                         : command == 'S' || command == 'Q' ? 4
                                                            : 2;
    for (size_t i = 0; i < count; ++i) {
      const bool is_flag = command == 'A' && (i == 3 || i == 4);
      std::optional<double> number;
      if (is_flag) {
        if (const auto flag = value_.flag()) number = *flag ? 1 : 0;
      } else {
        number = value_.number();
      }
      if (!number) return value_.fault(is_flag ? "expected a flag of an arc, 0 or 1" : "expected a number");
      n[i] = *number;
    }
    const Vec2 base = relative ? here_ : Vec2(0);
    draw(command, std::span(n).first(count), base);
    return std::nullopt;
  }

  void draw(char command, std::span<const double> n, Vec2 base) {
    const auto point = [&](size_t i) { return base + Vec2(n[i], n[i + 1]); };
    if (command == 'M') {
      builder_.move_to(map_.point(point(0)));
      begun_ = here_ = control_ = point(0);
      open_ = true;
      last_ = command;
      return;
    }
    if (!open_) builder_.move_to(map_.point(here_));
    open_ = true;
    const Vec2 reflected = 2.0 * here_ - control_;
    Vec2 end = here_, control = here_;
    switch (command) {
      case 'L':
        end = point(0);
        break;
      case 'H':
        end.x = base.x + n[0];
        break;
      case 'V':
        end.y = base.y + n[0];
        break;
      case 'C':
        control = point(2), end = point(4);
        builder_.cubic_to(map_.point(point(0)), map_.point(control), map_.point(end));
        break;
      case 'S':
        control = point(0), end = point(2);
        builder_.cubic_to(map_.point(last_ == 'C' || last_ == 'S' ? reflected : here_), map_.point(control),
                          map_.point(end));
        break;
      case 'Q':
        control = point(0), end = point(2);
        builder_.quadratic_to(map_.point(control), map_.point(end));
        break;
      case 'T':
        control = last_ == 'Q' || last_ == 'T' ? reflected : here_;
        end = point(0);
        builder_.quadratic_to(map_.point(control), map_.point(end));
        break;
      default: {
        end = base + Vec2(n[5], n[6]);
        const auto arc =
            endpoint_arc(here_, {n[0], n[1]}, radians_of(std::fmod(n[2], 360)), n[3] != 0, n[4] != 0, end);
        if (arc) builder_.arc_to(arc->mapped(map_), map_.point(end));
      }
    }
    builder_.line_to(map_.point(end));
    here_ = end;
    control_ = std::string_view("CSQT").find(command) != std::string_view::npos ? control : end;
    last_ = command;
  }

  void close() {
    builder_.close();
    here_ = control_ = begun_;
    open_ = false;
    last_ = 'Z';
  }

  SvgValue value_;
  const PlaneMap& map_;
  DrawingBuilder& builder_;
  Vec2 begun_{0}, here_{0}, control_{0};  // start of the line, current point, last control point
  bool at_start_ = true, open_ = false;
  char last_ = 'Z';
};

// Returns the map of one function of a transform list; nullopt for a wrong number of arguments.
std::optional<PlaneMap> transform_function(std::string_view name, std::span<const double> n) {
  const auto angle = [&] { return radians_of(std::fmod(n[0], 360)); };
  if (name == "matrix" && n.size() == 6) return PlaneMap{{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}};
  if (name == "translate" && (n.size() == 1 || n.size() == 2))
    return PlaneMap::translation({n[0], n.size() == 2 ? n[1] : 0});
  if (name == "scale" && (n.size() == 1 || n.size() == 2))
    return PlaneMap::scaling({n[0], n.size() == 2 ? n[1] : n[0]});
  if (name == "rotate" && n.size() == 1) return PlaneMap::rotation(angle());
  if (name == "rotate" && n.size() == 3) {
    const Vec2 about{n[1], n[2]};
    return PlaneMap::translation(about) * PlaneMap::rotation(angle()) * PlaneMap::translation(-about);
  }
  if ((name == "skewX" || name == "skewY") && n.size() == 1) {
    const auto [sin, cos] = sin_cos(angle());
    if (name == "skewX") return PlaneMap{{1, 0}, {sin / cos, 1}, Vec2(0)};
    return PlaneMap{{1, sin / cos}, {0, 1}, Vec2(0)};
  }
  return std::nullopt;
}

}  // namespace

void SvgValue::skip_blanks() {
  while (at_ < text_.size() && is_svg_blank(text_[at_])) ++at_;
}

bool SvgValue::at_end() {
  skip_blanks();
  if (at_ < text_.size() && text_[at_] == ',') ++at_;
  skip_blanks();
  return at_ == text_.size();
}

std::optional<double> SvgValue::number() {
  if (at_end()) return std::nullopt;
  const size_t sign = text_[at_] == '+' ? 1 : 0;
  const char* const begin = text_.data() + at_ + sign;
  const char* const end = text_.data() + text_.size();
  if (begin == end || is_svg_letter(*begin) || (sign == 1 && *begin == '-')) return std::nullopt;  // inf, nan
  double value = 0;
  const auto [stop, fault] = std::from_chars(begin, end, value);
  if (fault != std::errc() || !(std::abs(value) <= kMaxSvgNumber)) return std::nullopt;
  at_ = static_cast<size_t>(stop - text_.data());
  return value;
}

std::optional<bool> SvgValue::flag() {
  if (at_end() || (text_[at_] != '0' && text_[at_] != '1')) return std::nullopt;
  return text_[at_++] == '1';
}

std::string_view SvgValue::word() {
  if (at_end()) return {};
  const size_t begin = at_;
  while (at_ < text_.size() && is_svg_letter(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

char SvgValue::letter() {
  if (at_end() || !is_svg_letter(text_[at_])) return 0;
  return text_[at_++];
}

bool SvgValue::consume(char c) {
  skip_blanks();
  if (at_ == text_.size() || text_[at_] != c) return false;
  ++at_;
  return true;
}

std::string_view SvgValue::rest() {
  skip_blanks();
  size_t end = text_.size();
  while (end > at_ && is_svg_blank(text_[end - 1])) --end;
  const std::string_view rest = text_.substr(at_, end - at_);
  at_ = text_.size();
  return rest;
}

std::optional<SvgFault> add_svg_path(std::string_view data, const PlaneMap& map, DrawingBuilder& builder) {
  if (data == "none") return std::nullopt;
  return SvgPath(data, map, builder).run();
}

std::optional<SvgFault> parse_svg_transform(std::string_view text, PlaneMap& map) {
  SvgValue value(text);
  if (text == "none") return std::nullopt;
  while (!value.at_end()) {
    const size_t at = value.position();
    const std::string_view name = value.word();
    if (name.empty() || !value.consume('(')) return SvgFault{at, "expected a transform, such as rotate(30)"};
    std::array<double, 6> numbers{};
    size_t count = 0;
    while (!value.consume(')')) {
      const auto number = value.number();
      if (!number || count == numbers.size()) return value.fault("expected a number or ')'");
      numbers[count++] = *number;
    }
    const auto function = transform_function(name, std::span(numbers).first(count));
    if (!function) return SvgFault{at, "this is no transform with as many numbers"};
    map = map * *function;
  }
  return std::nullopt;
}

}  // namespace kerf
