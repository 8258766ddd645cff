#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "core/base/deterministic_math.h"
#include "core/laser/drawing.h"
#include "core/laser/svg_path.h"

namespace kerf {

namespace {

constexpr double kCssPixel = 0.0254 / 96;  // m

// A length or share of an attribute, in CSS pixels.
struct SvgUnit {
  std::string_view name;
  double pixels;
};
constexpr std::array<SvgUnit, 11> kSvgUnits{{{"", 1},
                                             {"px", 1},
                                             {"pt", 96.0 / 72},
                                             {"pc", 16},
                                             {"mm", 96 / 25.4},
                                             {"cm", 96 / 2.54},
                                             {"in", 96},
                                             {"q", 96 / 101.6},
                                             {"em", 16},
                                             {"rem", 16},
                                             {"ex", 8}}};

// Elements that draw nothing or only describe the drawing.
constexpr std::array<std::string_view, 22> kSilentElements{
    {"defs",           "symbol",         "title",   "desc",       "metadata", "style",
     "linearGradient", "radialGradient", "marker",  "clipPath",   "mask",     "pattern",
     "filter",         "view",           "cursor",  "solidColor", "stop",     "meshgradient",
     "color-profile",  "font",           "animate", "set"}};

// Returns a name without the prefix of SVG: that of the root, or the usual one.
std::string_view local_name(std::string_view name, std::string_view prefix) {
  if (!prefix.empty() && name.starts_with(prefix)) return name.substr(prefix.size());
  return name.starts_with("svg:") ? name.substr(4) : name;
}

// Returns true for elements without shapes, and for those of another namespace.
bool is_silent(std::string_view local) {
  return std::ranges::find(kSilentElements, local) != kSilentElements.end() ||
         local.find(':') != std::string_view::npos;
}

// Returns the value of a property, from the attribute style or the attribute of that name.
std::string_view property(const pugi::xml_node& node, std::string_view name) {
  std::string_view style = node.attribute("style").value();
  std::string_view found = node.attribute(std::string(name).c_str()).value();
  while (!style.empty()) {
    const size_t end = std::min(style.find(';'), style.size());
    const std::string_view entry = style.substr(0, end);
    style.remove_prefix(std::min(end + 1, style.size()));
    const size_t colon = entry.find(':');
    if (colon == std::string_view::npos || SvgValue(entry.substr(0, colon)).rest() != name) continue;
    found = SvgValue(entry.substr(colon + 1)).rest();
  }
  return found;
}

// Returns a colour rgb(R, G, B), in levels up to 255 or in percent, as "#rrggbb"; "" for any other text.
std::string hexadecimal_colour(std::string_view colour) {
  if (!colour.starts_with("rgb(")) return {};
  constexpr std::string_view kDigits = "0123456789abcdef";
  SvgValue value(colour.substr(4));
  std::string name = "#";
  for (int i = 0; i < 3; ++i) {
    const std::optional<double> given = value.number();
    if (!given) return {};
    const double level = value.consume('%') ? *given * 255 / 100 : *given;
    const auto rounded = static_cast<size_t>(std::clamp(level, 0.0, 255.0) + 0.5);
    name += {kDigits[rounded / 16], kDigits[rounded % 16]};
  }
  return value.consume(')') ? name : std::string();
}

// Returns a colour in lower case, and one of numbers as "#rrggbb".
std::string colour_name(std::string_view colour) {
  std::string name(colour.substr(0, 40));
  for (char& c : name) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (name.size() == 4 && name[0] == '#') name = {'#', name[1], name[1], name[2], name[2], name[3], name[3]};
  if (std::string levels = hexadecimal_colour(name); !levels.empty()) return levels;
  return name == "none" ? std::string() : name;
}

// Interprets the elements of an SVG file.
class SvgReader {
 public:
  SvgReader(std::string_view text, const std::string& file, double tolerance)
      : text_(text), file_(file), builder_(tolerance) {}

  Result<Drawing> read() {
    if (text_.starts_with("\xff\xfe") || text_.starts_with("\xfe\xff"))
      return bad_input(file_ + ": the file is UTF-16; save it as UTF-8");
    if (text_.find('\0') != std::string_view::npos)
      return bad_input(file_ + ": the file is binary; save it as plain SVG");
    const pugi::xml_parse_result parsed =
        document_.load_buffer(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!parsed)
      return wrong_at(static_cast<size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0)),
                      std::string("invalid XML: ") + parsed.description());
    const pugi::xml_node root = document_.document_element();
    const std::string_view root_name = root.name();
    prefix_ = root_name.substr(0, root_name.find(':') + 1);
    if (local_name(root_name, prefix_) != "svg")
      return wrong(root, "", {0, "the file is not an SVG file: its root element is not <svg>"});
    if (const Status s = collect_ids(); !s) return s.error();
    Frame frame;
    inherit(root, frame);
    if (const std::string_view turned = property(root, "transform"); !turned.empty() && turned != "none")
      builder_.leave_out("transform of the page");
    if (const Status s = read_page(root, frame); !s) return s.error();
    if (const Status s = children(root, frame, 0); !s) return s.error();
    if (!builder_.fault().empty()) return bad_input(file_ + ": " + builder_.fault());
    Drawing drawing = builder_.take();
    drawing.middle = page_middle_;
    if (!has_page_) {
      if (const auto bounds = bounds_of(drawing.lines)) drawing.middle = 0.5 * (bounds->min + bounds->max);
    }
    return drawing;
  }

 private:
  // The map from the units of an element to the drawing, and the size of its viewport in these units.
  struct Frame {
    PlaneMap map;
    Vec2 viewport{300, 150};
    bool hidden = false;        // by the property visibility, which is inherited
    std::string_view stroke{};  // colour, which is inherited
  };

  Error wrong_at(size_t offset, const std::string& what) const {
    return bad_input(file_ + ", " + text_position(text_, offset) + ": " + what);
  }

  // Returns an error in an element or, with a name, in the value of one of its attributes.
  Error wrong(const pugi::xml_node& node, const std::string& attribute, const SvgFault& fault) const {
    size_t offset = static_cast<size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
    if (!attribute.empty()) {
      for (size_t at = text_.find(attribute, offset); at != std::string_view::npos;
           at = text_.find(attribute, at + 1)) {
        size_t next = at + attribute.size();
        while (next < text_.size() &&
               std::string_view(" \t\r\n=").find(text_[next]) != std::string_view::npos)
          ++next;
        const bool begins =
            at > 0 && std::string_view(" \t\r\n").find(text_[at - 1]) != std::string_view::npos;
        if (!begins || next >= text_.size() || (text_[next] != '"' && text_[next] != '\'')) continue;
        offset = next + 1 + fault.at;
        break;
      }
    }
    return wrong_at(offset, (attribute.empty() ? "" : attribute + ": ") + fault.what);
  }

  // Collects the elements that <use> can refer to, in a walk without recursion.
  Status collect_ids() {
    int depth = 0;
    for (pugi::xml_node node = document_.document_element(); node;) {
      if (const char* id = node.attribute("id").value(); *id != 0) ids_.emplace(id, node);
      if (local_name(node.name(), prefix_) == "style" && *node.child_value() != 0)
        builder_.leave_out("style sheet");
      if (node.first_child()) {
        node = node.first_child();
        if (++depth > DrawingLimits::kMaxDepth) return wrong(node, "", {0, "elements are nested too deeply"});
        continue;
      }
      while (node && !node.next_sibling()) {
        node = node.parent();
        --depth;
      }
      node = node.next_sibling();
    }
    return Done{};
  }

  // Reads a length in CSS pixels; `whole` is the length of 100 %. Keeps the value if there is no such
  // attribute.
  Status length(const pugi::xml_node& node, const char* name, double whole, double& value) const {
    const std::string_view text = node.attribute(name).value();
    if (text.empty() || text == "auto") return Done{};
    SvgValue words(text);
    const auto number = words.number();
    if (!number) return wrong(node, name, {0, "expected a length, such as 20mm"});
    const size_t at = words.position();
    std::string unit(words.rest());
    for (char& c : unit) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (unit == "%") {
      value = 0.01 * *number * whole;
      return Done{};
    }
    if (unit == "em" || unit == "rem" || unit == "ex") {
      for (pugi::xml_node of = node; of; of = of.parent()) {
        if (!property(of, "font-size").empty())
          return wrong(node, name, {at, "font sizes are not read: give the length in px or mm"});
      }
    }
    for (const SvgUnit& row : kSvgUnits) {
      if (unit != row.name) continue;
      value = *number * row.pixels;
      return Done{};
    }
    return wrong(node, name, {at, "the unit must be px, pt, pc, mm, cm, in, Q, em, rem, ex or %"});
  }

  Status lengths(const pugi::xml_node& node, const Frame& frame, const char* x, const char* y,
                 Vec2& value) const {
    if (const Status s = length(node, x, frame.viewport.x, value.x); !s) return s;
    return length(node, y, frame.viewport.y, value.y);
  }

  // Reads the attribute viewBox; leaves `box` empty if there is none.
  Status view_box(const pugi::xml_node& node, std::optional<std::array<double, 4>>& box) const {
    const std::string_view text = node.attribute("viewBox").value();
    if (text.empty()) return Done{};
    SvgValue words(text);
    std::array<double, 4> numbers{};
    for (double& number : numbers) {
      const auto next = words.number();
      if (!next) return wrong(node, "viewBox", words.fault("must be four numbers"));
      number = *next;
    }
    if (!words.at_end() || numbers[2] < 0 || numbers[3] < 0)
      return wrong(node, "viewBox", {0, "must be four numbers, x, y, width and height, with a size"});
    if (numbers[2] > 0 && numbers[3] > 0) box = numbers;
    return Done{};
  }

  // Maps the view box into a viewport of this size, according to preserveAspectRatio.
  void fit_view_box(const pugi::xml_node& node, const std::array<double, 4>& box, Vec2 size,
                    Frame& frame) const {
    std::string_view rule = node.attribute("preserveAspectRatio").value();
    if (rule.empty()) rule = "xMidYMid";
    Vec2 scale{size.x / box[2], size.y / box[3]};
    if (!rule.starts_with("none")) {
      const bool slice = rule.find("slice") != std::string_view::npos;
      scale = Vec2(slice ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y));
    }
    const auto share = [&](std::string_view axis) {
      const size_t at = rule.find(axis);
      const std::string_view place = at == std::string_view::npos ? "Min" : rule.substr(at + 1, 3);
      return place == "Mid" ? 0.5 : place == "Max" ? 1.0 : 0.0;
    };
    const Vec2 spare = size - scale * Vec2(box[2], box[3]);
    const Vec2 shift = spare * (rule.starts_with("none") ? Vec2(0) : Vec2(share("x"), share("Y")));
    frame.map = frame.map * PlaneMap::translation(shift) * PlaneMap::scaling(scale) *
                PlaneMap::translation({-box[0], -box[1]});
    frame.viewport = {box[2], box[3]};
  }

  // Sets the frame and the middle of the page from the root.
  Status read_page(const pugi::xml_node& root, Frame& frame) {
    std::optional<std::array<double, 4>> box;
    if (const Status s = view_box(root, box); !s) return s;
    Vec2 size = box ? Vec2((*box)[2], (*box)[3]) : frame.viewport;
    // A width alone scales the height along.
    const Vec2 usual = size;
    Vec2 given{-1, -1};
    const Vec2 whole = box ? usual : Vec2(0);  // shares of a window of unknown size are no size
    if (const Status s = lengths(root, {{}, whole, false}, "width", "height", given); !s) return s;
    if (given.x > 0) size.x = given.x;
    if (given.y > 0) size.y = given.y;
    if (given.x > 0 && !(given.y > 0) && box) size.y = given.x * usual.y / usual.x;
    if (given.y > 0 && !(given.x > 0) && box) size.x = given.y * usual.x / usual.y;
    has_page_ = box || (given.x > 0 && given.y > 0);
    frame.map = PlaneMap::scaling({kCssPixel, -kCssPixel});
    frame.viewport = size;
    page_middle_ = frame.map.point(0.5 * size);
    if (box) fit_view_box(root, *box, size, frame);
    return Done{};
  }

  Status children(const pugi::xml_node& parent, const Frame& frame, int depth) {
    for (const pugi::xml_node& node : parent.children()) {
      if (node.type() != pugi::node_element) continue;
      if (const Status s = element(node, frame, depth + 1); !s) return s;
    }
    return Done{};
  }

  // Sets the inherited properties that an element gives.
  static void inherit(const pugi::xml_node& node, Frame& frame) {
    const auto given = [](std::string_view value) { return !value.empty() && value != "inherit"; };
    const std::string_view visibility = property(node, "visibility"), stroke = property(node, "stroke");
    if (given(visibility)) frame.hidden = visibility != "visible";
    if (given(stroke)) frame.stroke = stroke;
  }

  // Counts the properties of an element that have no effect here.
  void count_effects(const pugi::xml_node& node) {
    for (const char* const effect : {"clip-path", "mask", "stroke-dasharray"}) {
      const std::string_view value = property(node, effect);
      if (!value.empty() && value != "none") builder_.leave_out(effect);
    }
    const std::string_view applied = node.attribute("transform").value();
    const std::string_view transform = property(node, "transform");
    if (transform != applied && transform != "none") builder_.leave_out("transform in style");
    if (!applied.empty() && !property(node, "transform-origin").empty())
      builder_.leave_out("transform-origin");
  }

  // `user`: the <use> that refers to this one directly, if any.
  Status element(const pugi::xml_node& node, Frame frame, int depth, const pugi::xml_node& user = {}) {
    if (depth > DrawingLimits::kMaxDepth) return wrong(node, "", {0, "elements are nested too deeply"});
    if (!builder_.count_element()) return bad_input(file_ + ": " + builder_.fault());
    const std::string_view name = local_name(node.name(), prefix_);
    if (is_silent(name)) return Done{};
    if (property(node, "display") == "none") return Done{};
    inherit(node, frame);
    if (const pugi::xml_attribute transform = node.attribute("transform")) {
      if (const auto fault = parse_svg_transform(transform.value(), frame.map))
        return wrong(node, "transform", *fault);
    }
    count_effects(node);
    if (name == "g" || name == "a") return children(node, frame, depth);
    if (name == "switch") return first_drawable(node, frame, depth);
    if (name == "svg") return inner_svg(node, node, frame, depth, user);
    if (name == "use") return use(node, frame, depth);
    return shape(node, name, frame);
  }

  // Draws the first child of a <switch> that needs no extension, in whatever language it is, and a
  // foreignObject only if there is no other: it holds no shapes.
  Status first_drawable(const pugi::xml_node& parent, const Frame& frame, int depth) {
    pugi::xml_node selected;
    for (const pugi::xml_node& node : parent.children()) {
      const std::string_view name = local_name(node.name(), prefix_);
      if (node.type() != pugi::node_element || is_silent(name) ||
          !node.attribute("requiredExtensions").empty())
        continue;
      selected = node;
      if (name != "foreignObject") break;
    }
    return selected ? element(selected, frame, depth + 1) : Status(Done{});
  }

  // Draws the children of an inner <svg>, or of a <symbol> for which `sized` gives place and size. A size of
  // `user` replaces that of an <svg>.
  Status inner_svg(const pugi::xml_node& node, const pugi::xml_node& sized, Frame frame, int depth,
                   const pugi::xml_node& user = {}) {
    Vec2 at{0}, size = frame.viewport;
    if (const Status s = lengths(sized, frame, "x", "y", at); !s) return s;
    if (const Status s = lengths(sized, frame, "width", "height", size); !s) return s;
    if (const Status s = lengths(user, frame, "width", "height", size); !s) return s;
    frame.map = frame.map * PlaneMap::translation(at);
    std::optional<std::array<double, 4>> box;
    if (const Status s = view_box(node, box); !s) return s;
    frame.viewport = size;
    if (box) fit_view_box(node, *box, size, frame);
    return children(node, frame, depth);
  }

  Status use(const pugi::xml_node& node, Frame frame, int depth) {
    std::string_view target = node.attribute("href").value();
    if (target.empty()) target = node.attribute("xlink:href").value();
    const auto found = target.starts_with('#') ? ids_.find(target.substr(1)) : ids_.end();
    if (found == ids_.end()) {
      builder_.leave_out("use of an element that is not in the file");
      return Done{};
    }
    if (local_name(found->second.name(), prefix_) == "symbol") {
      inherit(found->second, frame);
      return inner_svg(found->second, node, frame, depth);
    }
    Vec2 at{0};
    if (const Status s = lengths(node, frame, "x", "y", at); !s) return s;
    frame.map = frame.map * PlaneMap::translation(at);
    return element(found->second, frame, depth + 1, node);
  }

  Status shape(const pugi::xml_node& node, std::string_view name, const Frame& frame) {
    if (frame.hidden) return Done{};
    builder_.set_layer(colour_name(frame.stroke));
    if (name == "path") {
      if (const auto fault = add_svg_path(node.attribute("d").value(), frame.map, builder_))
        return wrong(node, "d", *fault);
      return Done{};
    }
    if (name == "rect") return rectangle(node, frame);
    if (name == "circle" || name == "ellipse") return ellipse(node, name == "circle", frame);
    if (name == "line") return line(node, frame);
    if (name == "polyline" || name == "polygon") return polygon(node, name == "polygon", frame);
    builder_.leave_out(std::string(name.substr(0, 40)));
    return Done{};
  }

  Status rectangle(const pugi::xml_node& node, const Frame& frame) {
    Vec2 at{0}, size{0}, round{-1};
    if (const Status s = lengths(node, frame, "x", "y", at); !s) return s;
    if (const Status s = lengths(node, frame, "width", "height", size); !s) return s;
    if (const Status s = lengths(node, frame, "rx", "ry", round); !s) return s;
    if (!(size.x > 0 && size.y > 0)) return Done{};
    if (round.x < 0) round.x = round.y;
    if (round.y < 0) round.y = round.x;
    round = glm::clamp(round, Vec2(0), 0.5 * size);
    if (round.x == 0 || round.y == 0) round = Vec2(0);
    // The corners clockwise on the page from the upper left, each with its side before and after.
    const std::array<Vec2, 4> corners{at, at + Vec2(size.x, 0), at + size, at + Vec2(0, size.y)};
    constexpr std::array<Vec2, 4> kInward{Vec2(1, 1), Vec2(-1, 1), Vec2(-1, -1), Vec2(1, -1)};
    const auto to = [&](Vec2 p) { return frame.map.point(p); };
    builder_.move_to(to(at + Vec2(round.x, 0)));
    for (size_t i = 1; i <= 4; ++i) {
      const size_t k = i % 4;
      const Vec2 centre = corners[k] + kInward[k] * round;
      const double from = 0.5 * kPi * (static_cast<double>(k) - 2);
      const EllipseArc arc{centre, {round.x, 0}, {0, round.y}, from, 0.5 * kPi};
      const bool upright = k == 0 || k == 2;  // the arc begins on an upright side
      const Vec2 begin = centre - kInward[k] * (upright ? Vec2(round.x, 0) : Vec2(0, round.y));
      const Vec2 end = centre - kInward[k] * (upright ? Vec2(0, round.y) : Vec2(round.x, 0));
      builder_.line_to(to(begin));
      if (round.x > 0) builder_.arc_to(arc.mapped(frame.map), to(end));
    }
    builder_.close();
    return Done{};
  }

  Status ellipse(const pugi::xml_node& node, bool circle, const Frame& frame) {
    Vec2 centre{0}, radii{-1};
    if (const Status s = lengths(node, frame, "cx", "cy", centre); !s) return s;
    if (circle) {
      const double whole = glm::length(frame.viewport) / std::sqrt(2.0);
      if (const Status s = length(node, "r", whole, radii.x); !s) return s;
      radii.y = radii.x;
    } else if (const Status s = lengths(node, frame, "rx", "ry", radii); !s) {
      return s;
    }
    if (radii.x < 0) radii.x = radii.y;
    if (radii.y < 0) radii.y = radii.x;
    if (radii.x > 0 && radii.y > 0)
      builder_.ellipse(EllipseArc{centre, {radii.x, 0}, {0, radii.y}, 0, 2 * kPi}.mapped(frame.map));
    return Done{};
  }

  Status line(const pugi::xml_node& node, const Frame& frame) {
    Vec2 from{0}, to{0};
    if (const Status s = lengths(node, frame, "x1", "y1", from); !s) return s;
    if (const Status s = lengths(node, frame, "x2", "y2", to); !s) return s;
    builder_.move_to(frame.map.point(from));
    builder_.line_to(frame.map.point(to));
    builder_.end_line();
    return Done{};
  }

  Status polygon(const pugi::xml_node& node, bool closed, const Frame& frame) {
    SvgValue words(node.attribute("points").value());
    bool first = true;
    while (!words.at_end()) {
      const auto x = words.number(), y = x ? words.number() : std::nullopt;
      if (!y) return wrong(node, "points", words.fault("expected a pair of numbers"));
      const Vec2 point = frame.map.point({*x, *y});
      if (first) builder_.move_to(point);
      if (!first) builder_.line_to(point);
      first = false;
    }
    if (closed && !first) builder_.close();
    builder_.end_line();
    return Done{};
  }

  std::string_view text_;
  const std::string& file_;
  DrawingBuilder builder_;
  pugi::xml_document document_;
  std::map<std::string_view, pugi::xml_node> ids_;
  std::string_view prefix_;  // of the names of SVG, with its colon
  Vec2 page_middle_{0};
  bool has_page_ = false;
};

}  // namespace

Result<Drawing> read_svg(std::string_view text, const std::string& file, double tolerance) {
  return SvgReader(text, file, tolerance).read();
}

}  // namespace kerf
