#include "ui/render/view/view_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/deterministic_math.h"
#include "core/document/text/json.h"
#include "ui/render/view/colours.h"

namespace kerf {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr double kUnitLengthError = 1e-12;  // maximum error of the length of a unit vector

std::string_view trimmed(std::string_view text, std::string_view what) {
  const size_t first = text.find_first_not_of(what);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(what) - first + 1);
}

// Takes one of three numbers from the front of a text, with the comma or the blanks before it.
bool take_number(std::string_view& text, double& value) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || !std::isfinite(value)) return false;
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return true;
}

bool take_comma(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  if (!text.starts_with(',')) return false;
  text.remove_prefix(1);
  return true;
}

bool take_vector(std::string_view& text, Vec3& v) {
  return take_number(text, v.x) && take_comma(text) && take_number(text, v.y) && take_comma(text) &&
         take_number(text, v.z);
}

void append(std::string& text, const Vec3& v) {
  for (int i = 0; i < 3; ++i) {
    if (i > 0) text += ',';
    append_number(text, v[i] + 0.0);  // without the sign of a zero
  }
}

constexpr float kHitCounts = 5;  // factor of a hit box's size

struct Seen {
  float size = 0;  // of its diagonal, over its distance
  uint32_t box = 0;
};

// The row of the matrix that gives a coordinate; the length of its first three numbers is that of one unit
// of the body.
glm::vec4 row(const glm::mat4& m, int i) { return {m[0][i], m[1][i], m[2][i], m[3][i]}; }

std::string_view trimmed(std::string_view word) {
  const size_t first = word.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return word.substr(first, word.find_last_not_of(" \t") - first + 1);
}

const PieceGroups& groups_of(const World& world, BodyId id, ViewOptions& look) {
  std::shared_ptr<const PieceGroups>& groups = look.groups[id];
  if (!groups) groups = std::make_shared<const PieceGroups>(group_pieces(world.body(id)));
  return *groups;
}

// The member of a switch: a flag or an enumeration, of ShowOptions or of ViewOptions.
template <auto member, typename Look>
auto& member_of(Look& look) {
  if constexpr (requires { look.show.*member; }) {
    return look.show.*member;
  } else {
    return look.*member;
  }
}
template <auto member>
size_t get(const ViewOptions& look) {
  return static_cast<size_t>(member_of<member>(look));
}
template <auto member>
void set(ViewOptions& look, size_t state) {
  auto& value = member_of<member>(look);
  value = static_cast<std::remove_reference_t<decltype(value)>>(state);
}
template <auto member>
constexpr ViewSwitch of(ViewSwitch s) {
  s.get = get<member>;
  s.set = set<member>;
  return s;
}

size_t shows_boxes_hit(const ViewOptions& look) { return look.show.aabb_hit || look.tree.hit_only ? 1 : 0; }

// In the order of Shadows.
constexpr std::array kShadowStates{"none", "ground", "all"};

// In the order of Shading.
constexpr std::array kShadingStates{"by angle", "smooth", "flat"};

constexpr std::array kSwitches{
    of<&ShowOptions::shadows>({.id = SwitchId::kShadows,
                               .show = "shadows",
                               .report = "shadows",
                               .label = "Shadows",
                               .key = 'D',
                               .tip = "Draws shadows on nothing, on the ground only, or on all surfaces. The "
                                      "Light panel sets the method.",
                               .states = kShadowStates}),
    of<&ShowOptions::silhouette>(
        {.id = SwitchId::kSilhouette,
         .show = "silhouette",
         .report = "silhouette",
         .label = "Silhouette",
         .key = 'E',
         .tip = "Draws the edges that bound the shadow of a light: pale with one volume side, "
                "blue with two, violet with more."}),
    of<&ShowOptions::shadow_volumes>(
        {.id = SwitchId::kShadowVolumes,
         .show = "shadow-volumes",
         .report = "shadow_volumes",
         .label = "Shadow Volumes",
         .key = 'V',
         .tip =
             "Draws the volumes extruded from the silhouette: blue seen from outside, orange from inside."}),
    of<&ShowOptions::shadow_stencil>(
        {.id = SwitchId::kShadowCounts,
         .show = "shadow-stencil",
         .report = "shadow_counts",
         .label = "Stencil Count",
         .key = 'C',
         .tip = "Shows the number of surfaces that occlude the light, in the colours of the legend."}),
    of<&ShowOptions::shadow_facing>({.id = SwitchId::kFacing,
                                     .show = "shadow-facing",
                                     .report = "shadow_facing",
                                     .label = "Light-Facing",
                                     .key = 'T',
                                     .tip = "Shows light-facing polygons pale and back-facing ones blue."}),
    of<&ShowOptions::shadow_compare>({.id = SwitchId::kCompare,
                                      .show = "shadow-compare",
                                      .report = "shadow_compare",
                                      .label = "Compare Shadow Methods",
                                      .key = 'X',
                                      .tip = "Draws the method of the Light panel left of a line, another "
                                             "right of it, and the pixels that differ.",
                                      .in_view_panel = false}),
    of<&ShowOptions::shadow_reference>(
        {.id = SwitchId::kTrace,
         .show = "shadow-reference",
         .report = "shadow_rays",
         .label = "Ray-Traced Shadows",
         .key = 'Y',
         .tip = "Traces the shadow of the selected light in a static view and marks wrong pixels in magenta.",
         .in_view_panel = false}),
    of<&ViewOptions::rim_glow>(
        {.id = SwitchId::kRimGlow,
         .report = "rim_glow",
         .label = "Edge Glow",
         .tip = "Hot surfaces glow and keep a temper tint. Rims without heat glow near the cut."}),
    of<&ViewOptions::shading>({.id = SwitchId::kShading,
                               .report = "shading",
                               .label = "Shading",
                               .tip = "By angle: edges of 35 degrees or more stay sharp. Smooth: no sharp "
                                      "edges, for noisy scans. Flat: no smoothing.",
                               .states = kShadingStates}),
    of<&ViewOptions::textures>(
        {.id = SwitchId::kTextures,
         .report = "textures",
         .label = "Textures",
         .tip = "Draws the maps of materials as loaded; if off, their plain colours."}),
    of<&ShowOptions::wire>({.id = SwitchId::kWire,
                            .show = "wire",
                            .report = "wire",
                            .label = "Wireframe",
                            .key = 'W',
                            .tip = "Draws the edges of the faces."}),
    of<&ShowOptions::section>(
        {.id = SwitchId::kSection,
         .show = "section",
         .report = "section",
         .label = "Section Plane",
         .key = 'Z',
         .tip = "Hides one side of a plane to look inside. Hidden parts still cast shadows and can be cut."}),
    of<&ShowOptions::aabb>({.id = SwitchId::kBoxes,
                            .show = "aabb",
                            .report = "boxes",
                            .label = "AABB Tree",
                            .key = 'B',
                            .tip =
                                "Draws the boxes of the AABB tree in the colours of the legend: hit by the "
                                "beam, or not.",
                            .in_view_panel = false}),
    ViewSwitch{.id = SwitchId::kBoxesHit,
               .show = "aabb-hit",
               .report = "boxes_hit",
               .in_view_panel = false,
               .get = shows_boxes_hit,
               .set = set<&ShowOptions::aabb_hit>},
    of<&ShowOptions::pieces>({.id = SwitchId::kPieces,
                              .show = "pieces",
                              .report = "pieces",
                              .label = "Colour by Piece",
                              .key = 'P',
                              .tip = "Gives every piece that was cut off a strong colour of its own."}),
    of<&ShowOptions::sizes>(
        {.id = SwitchId::kSizes,
         .show = "sizes",
         .report = "sizes",
         .label = "Refinement Level",
         .tip = "Colours faces as in the paper: the smaller a face relative to its original, the warmer."}),
    of<&ShowOptions::heat>({.id = SwitchId::kHeat,
                            .show = "heat",
                            .report = "heat",
                            .label = "Temperature",
                            .tip = "Colours faces by temperature, up to the melting point. Inspect shows "
                                   "values and, on a click, a curve."}),
    of<&ShowOptions::normals>({.id = SwitchId::kNormals,
                               .show = "normals",
                               .report = "normals",
                               .label = "Normals",
                               .key = 'N',
                               .tip = "Draws a short line from the front of every face."}),
    of<&ShowOptions::face_numbers>(
        {.id = SwitchId::kFaceNumbers,
         .show = "face-numbers",
         .report = "face_numbers",
         .label = "Face Numbers",
         .key = 'I',
         .tip = "Shows the number of each face, red for removed faces (figure 8 of the paper)."}),
    of<&ShowOptions::graph>({.id = SwitchId::kGraph,
                             .show = "graph",
                             .report = "graph",
                             .label = "Component Graph",
                             .key = 'J',
                             .tip = "Draws faces around the last cut as nodes, and shared edges as links. "
                                    "The Graph panel has a flat layout."}),
    of<&ShowOptions::contacts>(
        {.id = SwitchId::kContacts,
         .show = "contacts",
         .report = "contacts",
         .label = "Contacts",
         .tip = "Draws the contact normals of the last tick, redder for larger impulses."}),
    of<&ShowOptions::colliders>(
        {.id = SwitchId::kColliders,
         .show = "colliders",
         .report = "colliders",
         .label = "Colliders",
         .tip = "Draws points and chords of collision shapes, which are created when bodies begin to move."}),
    of<&ShowOptions::centres>(
        {.id = SwitchId::kCentres,
         .show = "centres",
         .report = "centres",
         .label = "Centres of Mass",
         .tip = "Marks the centre of mass of each body, coloured by awake, asleep or pinned."}),
    of<&ShowOptions::joints>(
        {.id = SwitchId::kJoints,
         .show = "joints",
         .report = "joints",
         .label = "Joints",
         .tip = "Draws axes of hinges and hubs, and crosses at welds. A joint is removed with "
                "the faces that carry it."}),
    of<&ViewOptions::ghost>({.id = SwitchId::kGhost,
                             .report = "ghost",
                             .label = "Removed Faces",
                             .key = 'G',
                             .tip = "Shows removed faces as a faint veil."}),
    of<&ViewOptions::two_sided>({.id = SwitchId::kTwoSided,
                                 .report = "two_sided",
                                 .label = "Two-Sided Lighting",
                                 .tip = "Lights faces from both sides; if off, their backs are black."}),
    of<&ViewOptions::cull_backs>({.id = SwitchId::kCullBacks,
                                  .report = "cull_backs",
                                  .label = "Backface Culling",
                                  .tip = "Skips back faces: faster, but nothing is visible inside holes. Off "
                                         "in the paper for this reason."}),
    of<&ViewOptions::sparks>({.id = SwitchId::kSparks,
                              .report = "sparks",
                              .label = "Sparks and Smoke",
                              .tip = "Shows sparks and smoke at the cut. Visual only."}),
    of<&ViewOptions::antialias>({.id = SwitchId::kAntialias,
                                 .report = "antialias",
                                 .label = "Anti-Aliasing",
                                 .tip = "Smooths edges. Turn it off for speed without a graphics card."}),
};

}  // namespace

SectionPlane SectionPlane::facing(const Vec3& point, const Vec3& way) {
  const double largest = std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)});
  KERF_ASSERT(largest > 0);
  const bool unit =
      std::abs(glm::length(way) - 1) < kUnitLengthError;  // so that reading a plane back does not change it
  return {point, unit ? way : glm::normalize(way / largest)};
}

Interval SectionPlane::kept_along(const Pose& ray) const {
  constexpr double kEndless = std::numeric_limits<double>::max();
  const double height = height_of(ray.origin), rise = glm::dot(normal, ray.direction);
  if (rise == 0) return {0, height <= 0 ? kEndless : -1};
  const double meets = -height / rise;
  if (rise > 0) return {0, std::min(meets, kEndless)};
  return {std::max(meets, 0.0), kEndless};
}

SectionPlane section_through(const World::Bounds& bounds, const Vec3& to_eye) {
  int nearest = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(to_eye[i]) > std::abs(to_eye[nearest])) nearest = i;
  }
  SectionPlane plane{bounds.min + 0.5 * (bounds.max - bounds.min), Vec3(0)};
  plane.normal[nearest] = to_eye[nearest] < 0 ? -1 : 1;
  return plane;
}

const SectionPlane* shown_section(const ViewOptions& options) {
  return options.show.section && options.section ? &*options.section : nullptr;
}

std::string section_text(const SectionPlane& plane) {
  std::string text;
  append(text, plane.point);
  text += ' ';
  append(text, plane.normal);
  return text;
}

Result<SectionPlane> parse_section(std::string_view text) {
  const auto wrong =
      bad_input("a section plane needs a point and a normal, x,y,z x,y,z, such as \"0,0.5,0 0,1,0\"");
  constexpr std::string_view kOption = "--section";
  text = trimmed(text, kBlanks);
  if (text.starts_with(kOption)) text.remove_prefix(kOption.size());
  text = trimmed(text, " \t\r\n=\"'");
  SectionPlane plane;
  if (!take_vector(text, plane.point)) return wrong;
  if (text.empty() || kBlanks.find(text.front()) == std::string_view::npos) return wrong;
  if (!take_vector(text, plane.normal) || !trimmed(text, kBlanks).empty()) return wrong;
  if (plane.normal == Vec3(0)) return bad_input("the normal of a section plane must not be 0,0,0");
  return SectionPlane::facing(plane.point, plane.normal);
}

// Cold colours, not to be mistaken for heat; lightness rises while the hue turns.
static glm::dvec3 sequential_oklab(double s) {
  return oklab_of(0.27 + 0.66 * s, 0.07 + 0.03 * std::sin(kPi * s), 305 - 197 * s);
}

// Two hues that red-green blindness does not confuse; lightness peaks at the middle.
static glm::dvec3 diverging_oklab(double s) {
  const double from_middle = std::abs(2 * s - 1);
  return oklab_of(0.93 - 0.43 * from_middle, 0.12 * from_middle, s < 0.5 ? 255 : 50);
}

glm::dvec3 linear_scalar_colour(ColourScale scale, double t) {
  return linear_along(scale == ColourScale::kDiverging ? diverging_oklab : sequential_oklab, t);
}

glm::vec3 scalar_colour(ColourScale scale, double t) {
  return glm::vec3(screen_from_linear(linear_scalar_colour(scale, t)));
}

std::vector<BoxLine> select_boxes(std::span<const BoxLine> boxes, const glm::mat4& clip_from_body,
                                  size_t most) {
  const glm::vec4 x = row(clip_from_body, 0), y = row(clip_from_body, 1), w = row(clip_from_body, 3);
  const float unit_x = glm::length(glm::vec3(x)), unit_y = glm::length(glm::vec3(y)),
              unit_w = glm::length(glm::vec3(w));
  std::vector<Seen> seen;
  seen.reserve(boxes.size());
  for (uint32_t i = 0; i < boxes.size(); ++i) {
    const glm::vec4 middle(0.5f * (boxes[i].low + boxes[i].high), 1);
    const float half = 0.5f * glm::length(boxes[i].high - boxes[i].low);
    const float nearest = glm::dot(w, middle) + half * unit_w;
    if (nearest <= 0 || std::abs(glm::dot(x, middle)) - half * unit_x > nearest ||
        std::abs(glm::dot(y, middle)) - half * unit_y > nearest)
      continue;
    const float counts = boxes[i].style.x > 0 ? kHitCounts : 1;
    seen.push_back({counts * half / std::max(nearest - half * unit_w, half * unit_w), i});
  }
  const auto larger = [](const Seen& a, const Seen& b) {
    return a.size != b.size ? a.size > b.size : a.box < b.box;
  };
  const auto end = seen.begin() + static_cast<std::ptrdiff_t>(std::min(most, seen.size()));
  std::partial_sort(seen.begin(), end, seen.end(), larger);
  std::vector<BoxLine> selected;
  for (auto s = seen.begin(); s != end; ++s) selected.push_back(boxes[s->box]);
  return selected;
}

std::string offered_show_names() {
  std::string all;
  for (const ViewSwitch& s : view_switches()) {
    if (s.show[0] != '\0') all += (all.empty() ? "" : ", ") + std::string(s.show);
  }
  return all;
}

ShowOptions default_show() {
  ShowOptions show;
  show.shadows = Shadows::kAll;
  return show;
}

Result<ShowOptions> parse_show_list(std::string_view list) {
  ViewOptions look;
  while (!list.empty()) {
    const size_t comma = std::min(list.find(','), list.size());
    const std::string_view word = trimmed(list.substr(0, comma));
    list.remove_prefix(std::min(comma + 1, list.size()));
    if (word.empty()) continue;
    const std::span<const ViewSwitch> all = view_switches();
    const auto known = std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.show == word; });
    if (known != all.end()) {
      known->set(look, known->states.size() - 1);
      continue;
    }
    return bad_input("'" + std::string(word) + "' is not an overlay; valid names: " + offered_show_names());
  }
  return look.show;
}

void spread_pieces(const World& world, double spread, ViewOptions& look) {
  look.groups.clear();
  spread_further(world, spread, look);
}

void spread_further(const World& world, double spread, ViewOptions& look) {
  KERF_ASSERT(spread >= 0);
  for (auto& [id, piece] : look.pieces) piece.offset = Vec3(0);
  if (spread > 0) {
    const World::Bounds bounds = world.bounds();
    const Vec3 middle = 0.5 * (bounds.min + bounds.max);
    for (const BodyId id : world.ids()) {
      const Body& body = world.body(id);
      const PieceGroups& groups = groups_of(world, id, look);
      KERF_ASSERT(groups.middles.size() == body.pieces.size());
      for (uint32_t label = 0; label < body.pieces.size(); ++label) {
        if (body.pieces[label].faces == 0) continue;
        look.pieces[{id, label}].offset = spread * (body.placement.to_world(groups.middles[label]) - middle);
      }
    }
  } else {
    look.groups.clear();
  }
  std::erase_if(look.pieces, [](const auto& entry) { return entry.second == PieceLook(); });
}

void ViewSwitch::flip(ViewOptions& look) const {
  KERF_ASSERT(get(look) < states.size());
  set(look, (get(look) + 1) % states.size());
  if (get(look) == 0) return;
  if (id == SwitchId::kShadowVolumes) look.show.shadow_stencil = false;
  if (id == SwitchId::kShadowCounts) look.show.shadow_volumes = false;
}

void reset_overlays(ViewOptions& look) {
  ViewOptions initial;
  initial.show = default_show();
  for (const ViewSwitch& s : view_switches()) {
    if (s.show[0] != '\0') s.set(look, s.get(initial));
  }
}

std::string action_id(const ViewSwitch& s) { return std::string("view.") + s.report; }

std::string action_name(const ViewSwitch& s) {
  return s.is_two_state() ? s.label : std::string("Cycle ") + s.label;
}

std::span<const ViewSwitch> view_switches() { return kSwitches; }

const ViewSwitch& view_switch(SwitchId id) {
  const ViewSwitch& found = kSwitches.at(static_cast<size_t>(id));
  KERF_ASSERT(found.id == id);
  return found;
}

}  // namespace kerf
