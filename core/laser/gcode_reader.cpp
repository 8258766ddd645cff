#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/deterministic_math.h"
#include "core/laser/drawing.h"
#include "core/laser/gcode.h"

namespace kerf {

namespace {

constexpr double kMaxGcodeNumber = 1e9;
constexpr double kMaxTurns = 1000;  // of one arc
constexpr double kFullTurn = 5e-7;  // rad, as in GRBL: an arc with I and J that turns by less is a full turn
constexpr double kMaxDuration = 1e9;  // s
constexpr const char* kTooManyPoints = "the program has more than 4 000 000 points";

// A word of a block: a letter and a number.
struct GcodeWord {
  char letter = 0;
  double value = 0;
  size_t at = 0;  // offset in the file
};

// Modal groups of G and M words; a block has at most one word of each.
enum class ModalGroup {
  kMotion,
  kDwell,
  kPlane,
  kUnits,
  kDistance,
  kArcDistance,
  kFeed,
  kOffsets,
  kTool,
  kPath,
  kMachine,
  kHome,
  kSetPosition,
  kStop,
  kSpindle,
  kCoolant
};

// A supported word. Numbers are stored in tenths: G90.1 is 901.
struct KnownWord {
  char letter;
  int tenths;
  ModalGroup group;
};
constexpr std::array<KnownWord, 37> kKnownWords{
    {{'G', 0, ModalGroup::kMotion},        {'G', 10, ModalGroup::kMotion},
     {'G', 20, ModalGroup::kMotion},       {'G', 30, ModalGroup::kMotion},
     {'G', 40, ModalGroup::kDwell},        {'G', 170, ModalGroup::kPlane},
     {'G', 180, ModalGroup::kPlane},       {'G', 190, ModalGroup::kPlane},
     {'G', 200, ModalGroup::kUnits},       {'G', 210, ModalGroup::kUnits},
     {'G', 280, ModalGroup::kHome},        {'G', 430, ModalGroup::kTool},
     {'G', 530, ModalGroup::kMachine},     {'G', 540, ModalGroup::kOffsets},
     {'G', 550, ModalGroup::kOffsets},     {'G', 560, ModalGroup::kOffsets},
     {'G', 570, ModalGroup::kOffsets},     {'G', 580, ModalGroup::kOffsets},
     {'G', 590, ModalGroup::kOffsets},     {'G', 640, ModalGroup::kPath},
     {'G', 900, ModalGroup::kDistance},    {'G', 910, ModalGroup::kDistance},
     {'G', 901, ModalGroup::kArcDistance}, {'G', 911, ModalGroup::kArcDistance},
     {'G', 920, ModalGroup::kSetPosition}, {'G', 930, ModalGroup::kFeed},
     {'G', 940, ModalGroup::kFeed},        {'M', 0, ModalGroup::kStop},
     {'M', 10, ModalGroup::kStop},         {'M', 20, ModalGroup::kStop},
     {'M', 300, ModalGroup::kStop},        {'M', 30, ModalGroup::kSpindle},
     {'M', 40, ModalGroup::kSpindle},      {'M', 50, ModalGroup::kSpindle},
     {'M', 70, ModalGroup::kCoolant},      {'M', 80, ModalGroup::kCoolant},
     {'M', 90, ModalGroup::kCoolant}}};

const KnownWord* known_word(char letter, double value) {
  const double tenths = std::round(10 * value);
  if (!(std::abs(10 * value - tenths) < 1e-6)) return nullptr;
  for (const KnownWord& word : kKnownWords) {
    if (word.letter == letter && tenths == word.tenths) return &word;
  }
  return nullptr;
}

// The words of one line, by letter or modal group.
struct GcodeBlock {
  std::array<std::optional<GcodeWord>, 26> letters;  // without G and M
  std::array<std::optional<GcodeWord>, static_cast<size_t>(ModalGroup::kCoolant) + 1> modal;
  size_t at = 0;  // offset of the first word

  const std::optional<GcodeWord>& letter(char c) const { return letters[static_cast<size_t>(c - 'A')]; }
  // Returns the word of the group in tenths; -1 if there is none.
  int word(ModalGroup group) const {
    const auto& found = modal[static_cast<size_t>(group)];
    return found ? static_cast<int>(std::lround(10 * found->value)) : -1;
  }
  bool has_axis() const {
    return std::ranges::any_of(std::string_view("XYZABC"), [&](char c) { return letter(c).has_value(); });
  }
};

enum class GcodeMotion { kRapid = 0, kFeed = 1, kClockwise = 2, kCounterClockwise = 3 };

// Reads and executes a program line by line.
class GcodeReader {
 public:
  GcodeReader(std::string_view text, const std::string& file, double tolerance, const RotaryAxes& rotary)
      : text_(text), file_(file), tolerance_(tolerance), rotary_(rotary) {}

  Result<Program> read() {
    if (text_.find('\0') != std::string_view::npos)
      return bad_input(file_ + ": the file is binary, not G-code");
    size_t at = text_.starts_with("\xef\xbb\xbf") ? 3 : 0;
    while (at < text_.size() && !ended_) {
      const size_t end = std::min(text_.find_first_of("\r\n", at), text_.size());
      GcodeBlock block;
      if (const Status s = parse(at, end, block); !s) return s.error();
      if (!block_is_empty_) {
        if (const Status s = execute(block); !s) return s.error();
      }
      at = end + 1;
      if (end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n') ++at;
      ++line_;
    }
    end_stroke();
    if (!found_word_) return bad_input(file_ + ": the file has no words of G-code");
    program_.duration = time_;
    program_.rotary = rotary_;
    for (const std::string& note : notes_) program_.notes.push_back(note);
    return std::move(program_);
  }

 private:
  Error wrong(size_t at, const std::string& what) const {
    return bad_input(file_ + ", " + text_position(text_, at) + ": " + what);
  }

  // Splits a line into words. Comments are in parentheses or follow a semicolon.
  Status parse(size_t at, size_t end, GcodeBlock& block) {
    block_is_empty_ = true;
    while (at < end) {
      const char c = text_[at];
      if (c == ';') break;
      if (c == '(') {
        const size_t close = text_.find(')', at);
        if (close >= end) return wrong(at, "the comment has no ')'");
        at = close + 1;
        continue;
      }
      if (c == ' ' || c == '\t' || c == '%') {
        ++at;
        continue;
      }
      GcodeWord word;
      if (const Status s = parse_word(at, end, word); !s) return s;
      if (const Status s = add_word(word, block); !s) return s;
    }
    return Done{};
  }

  Status parse_word(size_t& at, size_t end, GcodeWord& word) const {
    word.at = at;
    word.letter = text_[at];
    if ('a' <= word.letter && word.letter <= 'z') word.letter = static_cast<char>(word.letter - 'a' + 'A');
    if (word.letter < 'A' || word.letter > 'Z') return wrong(at, "expected a word, a letter with a number");
    ++at;
    while (at < end && (text_[at] == ' ' || text_[at] == '\t')) ++at;
    if (at < end && text_[at] == '+') ++at;
    const auto [stop, fault] =
        std::from_chars(text_.data() + at, text_.data() + end, word.value, std::chars_format::fixed);
    if (fault != std::errc() || !(std::abs(word.value) <= kMaxGcodeNumber))
      return wrong(word.at, std::string("the letter ") + word.letter + " must be followed by a number");
    at = static_cast<size_t>(stop - text_.data());
    return Done{};
  }

  std::string shown(const GcodeWord& word, size_t end) const {
    return std::string(text_.substr(word.at, std::min<size_t>(end - word.at, 20)));
  }

  Status add_word(const GcodeWord& word, GcodeBlock& block) {
    found_word_ = true;
    if (word.letter == 'N') return Done{};
    if (block_is_empty_) block.at = word.at;
    block_is_empty_ = false;
    std::optional<GcodeWord>* place = nullptr;
    if (word.letter == 'G' || word.letter == 'M') {
      const KnownWord* known = known_word(word.letter, word.value);
      if (known == nullptr) return unknown(word);
      place = &block.modal[static_cast<size_t>(known->group)];
    } else {
      if (std::string_view("FHIJKPRSXYZ").find(word.letter) == std::string_view::npos &&
          !rotary_.has(word.letter))
        return unknown(word);
      place = &block.letters[static_cast<size_t>(word.letter - 'A')];
    }
    // Two kinds of coolant may be on at once.
    const bool is_coolant = word.letter == 'M' && word.value >= 7 && word.value <= 9;
    if (*place && !is_coolant) return wrong(word.at, "the line has two mutually exclusive words");
    *place = word;
    return Done{};
  }

  Error unknown(const GcodeWord& word) const {
    size_t end = word.at + 1;
    while (end < text_.size() && std::string_view("0123456789.-+").find(text_[end]) != std::string_view::npos)
      ++end;
    const bool is_rotary = 'A' <= word.letter && word.letter <= 'C';
    return wrong(word.at,
                 shown(word, end) + (is_rotary ? " is not supported without a description of this axis "
                                                 "by --axes"
                                               : " is not supported; remove the word or use another "
                                                 "post-processor"));
  }

  // Executes the words of a line in the order of RS274.
  Status execute(const GcodeBlock& block) {
    if (const int feed = block.word(ModalGroup::kFeed); feed >= 0) {
      if (inverse_time_ != (feed == 930)) feed_ = turn_feed_ = 0;
      inverse_time_ = feed == 930;
    }
    if (const int units = block.word(ModalGroup::kUnits); units >= 0) unit_ = units == 200 ? 0.0254 : 0.001;
    if (const Status s = set_feed_and_power(block); !s) return s;
    if (const int spindle = block.word(ModalGroup::kSpindle); spindle >= 0) {
      enabled_ = spindle != 50;
      constant_ = spindle == 30;
    }
    if (!(enabled_ && power_ > 0)) end_stroke();
    if (block.word(ModalGroup::kDwell) >= 0) {
      if (const Status s = dwell(block); !s) return s;
    }
    if (const int plane = block.word(ModalGroup::kPlane); plane >= 0) plane_ = plane;
    if (const int mode = block.word(ModalGroup::kDistance); mode >= 0) relative_ = mode == 910;
    if (const int mode = block.word(ModalGroup::kArcDistance); mode >= 0) absolute_centre_ = mode == 901;
    if (block.word(ModalGroup::kTool) >= 0) notes_.insert("G43: offsets of tools count as zero");
    if (const int offsets = block.word(ModalGroup::kOffsets); offsets > 540)
      notes_.insert("G55 to G59: offsets of workpieces count as zero");
    if (const Status s = move(block); !s) return s;
    if (!rotary_.axes.empty() && point_count_ > DrawingLimits::kMaxPoints)
      return wrong(block.at, kTooManyPoints);
    if (const int stop = block.word(ModalGroup::kStop); stop >= 20) ended_ = true;
    return time_ <= kMaxDuration ? Status(Done{}) : wrong(block.at, "the program takes longer than 1e9 s");
  }

  Status set_feed_and_power(const GcodeBlock& block) {
    if (const auto& feed = block.letter('F')) {
      if (!(feed->value > 0)) return wrong(feed->at, "F must be greater than zero");
      turn_feed_ = feed->value / 60;
      feed_ = inverse_time_ ? turn_feed_ : feed->value * unit_ / 60;
    } else if (inverse_time_) {
      feed_ = 0;  // G93 needs an F in each line
    }
    if (const auto& power = block.letter('S')) {
      if (!(power->value >= 0)) return wrong(power->at, "S must not be negative");
      if (power->value != power_) end_stroke();
      power_ = power->value;
    }
    return Done{};
  }

  Status dwell(const GcodeBlock& block) {
    const auto& seconds = block.letter('P');
    if (!seconds || !(seconds->value >= 0)) return wrong(block.at, "G4 needs P, the seconds of the dwell");
    time_ += seconds->value;
    const bool is_on = enabled_ && constant_ && power_ > 0 && motion_ != GcodeMotion::kRapid;
    if (!is_on) {
      end_stroke();
    } else if (stroke_.points.empty()) {
      begin_stroke(time_ - seconds->value);
      if (seconds->value > 0) add_point(position_);
    } else if (seconds->value > 0) {
      add_point(position_);
    }
    return Done{};
  }

  // Returns the position that the axes of a block give, in the coordinates of the machine.
  MachinePosition target(const GcodeBlock& block) const {
    MachinePosition to = position_;
    const bool machine = block.word(ModalGroup::kMachine) >= 0;
    const auto take = [&](char first, double unit, Vec3 MachinePosition::*part) {
      for (int i = 0; i < 3; ++i) {
        const auto& word = block.letter(static_cast<char>(first + i));
        if (!word) continue;
        const double value = word->value * unit;
        (to.*part)[i] = machine     ? value
                        : relative_ ? (position_.*part)[i] + value
                                    : value + (offset_.*part)[i];
      }
    };
    take('X', unit_, &MachinePosition::point);
    take('A', 1, &MachinePosition::angles);
    return to;
  }

  // Returns the position after G28: the axes of the block at home, or all if it names none.
  MachinePosition home(const GcodeBlock& block) const {
    if (!block.has_axis()) return {};
    MachinePosition to = position_;
    for (int i = 0; i < 3; ++i) {
      if (block.letter(static_cast<char>('X' + i))) to.point[i] = 0;
      if (block.letter(static_cast<char>('A' + i))) to.angles[i] = 0;
    }
    return to;
  }

  Status move(const GcodeBlock& block) {
    const int motion = block.word(ModalGroup::kMotion);
    if (motion >= 0) motion_ = static_cast<GcodeMotion>(motion / 10);
    if (block.word(ModalGroup::kSetPosition) >= 0) return set_position(block);
    if (block.word(ModalGroup::kHome) >= 0) {
      if (block.has_axis()) rapid(target(block));
      rapid(home(block));
      return Done{};
    }
    const bool is_arc = motion_ == GcodeMotion::kClockwise || motion_ == GcodeMotion::kCounterClockwise;
    if (motion_ == GcodeMotion::kRapid) {
      if (block.has_axis() || motion >= 0) rapid(target(block));
      return Done{};
    }
    const bool has_centre = block.letter('I') || block.letter('J') || block.letter('K') || block.letter('R');
    if (!block.has_axis() && !(is_arc && has_centre)) return Done{};
    if (!(feed_ > 0)) return wrong(block.at, "a feed move needs F, the speed");
    if (block.word(ModalGroup::kMachine) >= 0 && is_arc) return wrong(block.at, "G53 allows G0 and G1 only");
    if (is_arc) return arc(block, target(block));
    const MachinePosition to = target(block);
    feed_along({to}, glm::length(to.point - position_.point));
    return Done{};
  }

  // G92: the current position gets these coordinates.
  Status set_position(const GcodeBlock& block) {
    if (!block.has_axis()) return wrong(block.at, "G92 needs X, Y, Z or a rotary axis");
    for (int i = 0; i < 3; ++i) {
      if (const auto& word = block.letter(static_cast<char>('X' + i)))
        offset_.point[i] = position_.point[i] - word->value * unit_;
      if (const auto& word = block.letter(static_cast<char>('A' + i)))
        offset_.angles[i] = position_.angles[i] - word->value;
    }
    return Done{};
  }

  void rapid(const MachinePosition& to) {
    end_stroke();
    time_ += std::max(glm::length(to.point - position_.point) / kRapidSpeed,
                      glm::length(to.angles - position_.angles) / kRapidTurn);
    position_ = to;
  }

  // Moves through positions, at equal times, along a path of this length at the feed.
  void feed_along(const std::vector<MachinePosition>& path, double length) {
    const double turn = glm::length(path.back().angles - position_.angles);
    const double seconds = inverse_time_             ? 1 / feed_
                           : length > 0 || turn == 0 ? length / feed_
                                                     : turn / turn_feed_;
    const bool is_on = enabled_ && power_ > 0;
    const double begin = time_;
    if (is_on && stroke_.points.empty()) begin_stroke(begin);
    for (size_t i = 0; i < path.size(); ++i) {
      const double share = 1 / static_cast<double>(path.size());
      if (is_on) add_parts(path[i], begin + seconds * share * static_cast<double>(i), seconds * share);
      time_ = begin + seconds * (static_cast<double>(i + 1) / static_cast<double>(path.size()));
      position_ = path[i];
      if (is_on) add_point(position_);
    }
    if (!is_on) end_stroke();
  }

  // Adds the points that divide a straight move with rotations.
  void add_parts(const MachinePosition& to, double begin, double seconds) {
    if (rotary_.axes.empty()) return;
    const double parts =
        std::min(rotary_.parts(position_, to, tolerance_), double{DrawingLimits::kMaxPoints});
    const MachinePosition from = position_;
    for (double k = 1; k < parts && point_count_ <= DrawingLimits::kMaxPoints; ++k) {
      const double share = k / parts;
      time_ = begin + seconds * share;
      add_point(
          {from.point + share * (to.point - from.point), from.angles + share * (to.angles - from.angles)});
    }
  }

  // The axes of the plane of arcs, and the axis of helices.
  std::array<int, 3> plane_axes() const {
    if (plane_ == 180) return {2, 0, 1};
    if (plane_ == 190) return {1, 2, 0};
    return {0, 1, 2};
  }

  Status arc(const GcodeBlock& block, const MachinePosition& target) {
    const auto [u, v, w] = plane_axes();
    const Vec3 &from = position_.point, &to = target.point;
    const Vec2 from2{from[u], from[v]}, to2{to[u], to[v]};
    Vec2 centre{0};
    if (block.letter('R')) {
      if (const Status s = centre_of_radius(block, from2, to2, centre); !s) return s;
    } else if (const Status s = centre_of_offsets(block, from2, to2, centre); !s) {
      return s;
    }
    double turns = 1;
    if (const auto& word = block.letter('P')) {
      turns = word->value;
      if (!(turns >= 1 && turns <= kMaxTurns) || turns != std::floor(turns))
        return wrong(word->at, "P of an arc must be a whole number of turns from 1 to 1000");
    }
    const Vec2 begin = from2 - centre, end = to2 - centre;
    const double first = glm::length(begin), last = glm::length(end);
    double sweep = det::atan2(cross2(begin, end), glm::dot(begin, end));
    const bool left = motion_ == GcodeMotion::kCounterClockwise;
    // Rounding of a program may separate the ends of a full turn.
    if (!block.letter('R') && std::abs(sweep) <= kFullTurn) sweep = 0;
    if (left && sweep <= 0) sweep += 2 * kPi;
    if (!left && sweep >= 0) sweep -= 2 * kPi;
    sweep += (left ? 2 : -2) * kPi * (turns - 1);
    const double radius = std::max(first, last);
    if (point_count_ >= DrawingLimits::kMaxPoints) return wrong(block.at, kTooManyPoints);
    const size_t n = std::max<size_t>(
        chord_count(sweep * sweep * radius, tolerance_, DrawingLimits::kMaxPoints - point_count_),
        static_cast<size_t>(std::ceil(std::abs(sweep) / (2 * kPi / 3))));
    std::vector<MachinePosition> path;
    const double angle = det::atan2(begin.y, begin.x);
    for (size_t i = 1; i < n; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(n);
      const auto [sin, cos] = sin_cos(angle + share * sweep);
      const Vec2 point = centre + ((1 - share) * first + share * last) * Vec2(cos, sin);
      MachinePosition next;
      next.point[u] = point.x;
      next.point[v] = point.y;
      next.point[w] = (1 - share) * from[w] + share * to[w];
      next.angles = (1 - share) * position_.angles + share * target.angles;
      path.push_back(next);
    }
    path.push_back(target);
    const double climb = to[w] - from[w], round = 0.5 * (first + last) * std::abs(sweep);
    feed_along(path, std::sqrt(round * round + climb * climb));
    return Done{};
  }

  Status centre_of_radius(const GcodeBlock& block, Vec2 from, Vec2 to, Vec2& centre) const {
    const double radius = block.letter('R')->value * unit_;
    const Vec2 chord = to - from;
    const double half = 0.5 * glm::length(chord);
    if (!(half > 0))
      return wrong(block.at, "an arc with R must end at another point; use I and J for a full turn");
    // A radius that is too short by rounding of the program counts as half the chord.
    if (std::abs(radius) < half && half - std::abs(radius) > 1e-3 * half + 5e-6)
      return wrong(block.letter('R')->at, "R is smaller than half the distance between the end points");
    const double height = std::sqrt(std::max(0.0, radius * radius - half * half)) / (2 * half);
    const bool left = (motion_ == GcodeMotion::kCounterClockwise) == (radius > 0);
    centre = 0.5 * (from + to) + (left ? height : -height) * Vec2(-chord.y, chord.x);
    return Done{};
  }

  Status centre_of_offsets(const GcodeBlock& block, Vec2 from, Vec2 to, Vec2& centre) const {
    const auto [u, v, w] = plane_axes();
    const auto offset = [&](int axis, double start, double zero) {
      const auto& word = block.letter(static_cast<char>('I' + axis));
      if (!word) return absolute_centre_ ? zero : start;
      return absolute_centre_ ? word->value * unit_ + zero : start + word->value * unit_;
    };
    if (block.letter(static_cast<char>('I' + w)))
      return wrong(block.letter(static_cast<char>('I' + w))->at,
                   "this offset is not in the plane of the arc");
    if (!block.letter(static_cast<char>('I' + u)) && !block.letter(static_cast<char>('I' + v)))
      return wrong(block.at, "an arc needs its centre (I, J, K) or its radius (R)");
    centre = {offset(u, from.x, offset_.point[u]), offset(v, from.y, offset_.point[v])};
    // The tolerance of GRBL: 0.5 mm, and 0.005 mm or a thousandth of the radius.
    const double radius = glm::length(from - centre), error = std::abs(glm::length(to - centre) - radius);
    if (!(radius > 0)) return wrong(block.at, "the arc starts at its centre");
    if (error > 0.0005 || (error > 0.000005 && error > 0.001 * radius))
      return wrong(block.at, "the start and the end of the arc are at different distances from its centre");
    return Done{};
  }

  void begin_stroke(double time) {
    stroke_ = {{position_.point}, {time}, power_, line_, {}, {line_}};
    if (!rotary_.axes.empty()) stroke_.angles.push_back(position_.angles);
    ++point_count_;
  }

  void add_point(const MachinePosition& at) {
    const bool is_same =
        at.point == stroke_.points.back() && (rotary_.axes.empty() || at.angles == stroke_.angles.back());
    if (is_same && !(time_ > stroke_.times.back())) return;
    // Times ascend even if the feed takes less time than a double can tell.
    time_ = std::max(time_, std::nextafter(stroke_.times.back(), 2 * kMaxDuration));
    stroke_.points.push_back(at.point);
    stroke_.times.push_back(time_);
    stroke_.lines.push_back(line_);
    if (!rotary_.axes.empty()) stroke_.angles.push_back(at.angles);
    ++point_count_;
  }

  void end_stroke() {
    if (!stroke_.points.empty()) program_.strokes.push_back(std::move(stroke_));
    stroke_ = {};
  }

  std::string_view text_;
  const std::string& file_;
  double tolerance_;
  const RotaryAxes& rotary_;
  Program program_;
  std::set<std::string> notes_;
  ProgramStroke stroke_;
  size_t line_ = 1, point_count_ = 0;
  bool ended_ = false, block_is_empty_ = true, found_word_ = false;

  // The state of the machine. Lengths are in metres, times in seconds.
  MachinePosition position_, offset_;
  double time_ = 0, unit_ = 0.001, power_ = 0;
  double feed_ = 0;       // m/s, or with G93 moves per second
  double turn_feed_ = 0;  // degrees/s, or with G93 moves per second
  GcodeMotion motion_ = GcodeMotion::kRapid;
  int plane_ = 170;
  bool relative_ = false, absolute_centre_ = false, inverse_time_ = false;
  bool enabled_ = true, constant_ = true;
};

}  // namespace

Result<Program> read_gcode(std::string_view text, const std::string& file, double tolerance,
                           const RotaryAxes& rotary) {
  return GcodeReader(text, file, tolerance, rotary).read();
}

}  // namespace kerf
