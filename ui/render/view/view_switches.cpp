#include "ui/render/view/view_switches.h"

#include "core/base/assert.h"

namespace kerf {

namespace {

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
// The switch of a member.
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
    of<&ShowOptions::shadows>(
        {.id = SwitchId::kShadows,
         .show = "shadows",
         .report = "shadows",
         .label = "Shadows",
         .key = 'D',
         .tip = "None, only those that the sun casts on the ground, or those of everything on everything. "
                "The Light panel sets how they are cast.",
         .states = kShadowStates}),
    of<&ShowOptions::silhouette>(
        {.id = SwitchId::kSilhouette,
         .show = "silhouette",
         .report = "silhouette",
         .label = "Silhouette",
         .key = 'E',
         .tip = "The edges that bound the shadow of a light (figure 11 of the paper): pale where one "
                "side lies on them, blue where two do, violet where more."}),
    of<&ShowOptions::shadow_volumes>(
        {.id = SwitchId::kShadowVolumes,
         .show = "shadow-volumes",
         .report = "shadow_volumes",
         .label = "Shadow volumes",
         .key = 'V',
         .tip = "What the silhouette is extruded to (figure 12 of the paper): blue where it is seen from "
                "outside, orange from within."}),
    of<&ShowOptions::shadow_stencil>(
        {.id = SwitchId::kShadowCounts,
         .show = "shadow-stencil",
         .report = "shadow_counts",
         .label = "Shadow counts",
         .key = 'C',
         .tip = "How many surfaces keep the light away, in the colours of the legend."}),
    of<&ShowOptions::shadow_facing>({.id = SwitchId::kFacing,
                                     .show = "shadow-facing",
                                     .report = "shadow_facing",
                                     .label = "Facing the light",
                                     .key = 'T',
                                     .tip = "Polygons that face the light are pale, averted ones blue."}),
    of<&ShowOptions::shadow_compare>(
        {.id = SwitchId::kCompare,
         .show = "shadow-compare",
         .report = "shadow_compare",
         .label = "Compare two shadow methods",
         .key = 'X',
         .tip = "The method of the Light panel left of a line, another right of it, and the pixels that "
                "differ.",
         .in_view_panel = false}),
    of<&ShowOptions::shadow_reference>(
        {.id = SwitchId::kTrace,
         .show = "shadow-reference",
         .report = "shadow_rays",
         .label = "Trace shadow rays",
         .key = 'Y',
         .tip = "Traces the shadow of the chosen light pixel by pixel once the picture stands still, and "
                "marks in magenta where the picture has it otherwise.",
         .in_view_panel = false,
         .ends_group = true}),
    of<&ViewOptions::rim_glow>(
        {.id = SwitchId::kRimGlow,
         .report = "rim_glow",
         .label = "Glow of rims",
         .tip = "What is hot glows as hot metal does, and what was hot stays tinted. Where a cut left no "
                "heat, its rims glow, the more the nearer to the cut."}),
    of<&ViewOptions::shading>(
        {.id = SwitchId::kShading,
         .report = "shading",
         .label = "Shading",
         .tip = "By angle: smooth but for edges at which faces meet at 35 degrees and more. Smooth: "
                "everywhere, which calms scans with noise. Flat: every face as the plane that it is.",
         .states = kShadingStates}),
    of<&ShowOptions::wire>({.id = SwitchId::kWire,
                            .show = "wire",
                            .report = "wire",
                            .label = "Wire",
                            .key = 'W',
                            .tip = "Edges of the faces."}),
    of<&ShowOptions::section>(
        {.id = SwitchId::kSection,
         .show = "section",
         .report = "section",
         .label = "Section plane",
         .key = 'Z',
         .tip = "Opens the bodies at a plane to look inside; the pointer picks what is seen. What is not "
                "drawn is there still: it casts shadows, and the beam cuts it."}),
    of<&ShowOptions::aabb>(
        {.id = SwitchId::kBoxes,
         .show = "aabb",
         .report = "boxes",
         .label = "Boxes of the tree",
         .key = 'B',
         .tip = "The bounding boxes that find the faces under the beam: solid where the beam is or was, "
                "dotted where it never came, as in the paper's figure 2.",
         .in_view_panel = false}),
    ViewSwitch{.id = SwitchId::kBoxesHit,
               .show = "aabb-hit",
               .report = "boxes_hit",
               .in_menu = false,
               .in_view_panel = false,
               .get = shows_boxes_hit,
               .set = set<&ShowOptions::aabb_hit>},
    of<&ShowOptions::pieces>({.id = SwitchId::kPieces,
                              .show = "pieces",
                              .report = "pieces",
                              .label = "Piece colours",
                              .key = 'P',
                              .tip = "Every piece that came off in a strong colour of its own."}),
    of<&ShowOptions::sizes>(
        {.id = SwitchId::kSizes,
         .show = "sizes",
         .report = "sizes",
         .label = "Level colouring",
         .tip = "The paper's colours: the smaller a face against the one it was split from, the hotter."}),
    of<&ShowOptions::heat>(
        {.id = SwitchId::kHeat,
         .show = "heat",
         .report = "heat",
         .label = "Temperature",
         .tip = "The temperature of every face by the scale in the corner, up to where the material melts. "
                "Inspect shows it in numbers, and a click there keeps a curve of it."}),
    of<&ShowOptions::normals>({.id = SwitchId::kNormals,
                               .show = "normals",
                               .report = "normals",
                               .label = "Normals",
                               .key = 'N',
                               .tip = "A short line out of the front of every face."}),
    of<&ShowOptions::face_numbers>(
        {.id = SwitchId::kFaceNumbers,
         .show = "face-numbers",
         .report = "face_numbers",
         .label = "Face numbers",
         .key = 'I',
         .tip = "The number of each face, and in red of those that are gone (figure 8 of the paper)."}),
    of<&ShowOptions::graph>(
        {.id = SwitchId::kGraph,
         .show = "graph",
         .report = "graph",
         .label = "Component graph",
         .key = 'J',
         .tip = "A node on each face around the last cut and a link over each shared edge, in red where "
                "faces were removed (figures 8 and 9 of the paper). The Graph panel lays it out flat."}),
    of<&ShowOptions::contacts>(
        {.id = SwitchId::kContacts,
         .show = "contacts",
         .report = "contacts",
         .label = "Contacts",
         .tip = "Where bodies touch, as of the last tick: normals, the redder the larger the impulse."}),
    of<&ShowOptions::colliders>(
        {.id = SwitchId::kColliders,
         .show = "colliders",
         .report = "colliders",
         .label = "Colliders",
         .tip = "The points and chords by which bodies touch others. They are made when bodies begin to "
                "move."}),
    of<&ShowOptions::centres>({.id = SwitchId::kCentres,
                               .show = "centres",
                               .report = "centres",
                               .label = "Centres of mass",
                               .tip = "Of each body, coloured by whether it is awake, asleep or pinned."}),
    of<&ShowOptions::joints>(
        {.id = SwitchId::kJoints,
         .show = "joints",
         .report = "joints",
         .label = "Joints",
         .tip = "What holds parts together that do not hang together: axes of hinges and hubs, and crosses "
                "where parts are welded. A joint is gone once the faces that carry it are.",
         .ends_group = true}),
    of<&ViewOptions::ghost>({.id = SwitchId::kGhost,
                             .report = "ghost",
                             .label = "Ghost of what is gone",
                             .key = 'G',
                             .tip = "Removed faces stay as a faint veil."}),
    of<&ViewOptions::two_sided>({.id = SwitchId::kTwoSided,
                                 .report = "two_sided",
                                 .label = "Two-sided lighting",
                                 .tip = "Faces are lit from both sides; off, their backs are black.",
                                 .in_menu = false}),
    of<&ViewOptions::cull_backs>(
        {.id = SwitchId::kCullBacks,
         .report = "cull_backs",
         .label = "Cull backs",
         .tip = "Leaves out the faces that are seen from behind, as is usual for closed models and "
                "faster. The paper had to turn it off: once a hole is cut, one looks through it at the "
                "backs of the far side, and with culling there is nothing there.",
         .in_menu = false}),
    of<&ViewOptions::sparks>({.id = SwitchId::kSparks,
                              .report = "sparks",
                              .label = "Sparks and smoke",
                              .tip = "Sparks and smoke fly where the laser bites. They are only seen."}),
    of<&ViewOptions::antialias>({.id = SwitchId::kAntialias,
                                 .report = "antialias",
                                 .label = "Anti-aliasing",
                                 .tip = "Smooth edges; off is faster without a graphics card.",
                                 .ends_group = true}),
};

}  // namespace

std::string action_name(const ViewSwitch& s) {
  std::string name = s.label;
  for (size_t i = 0; !s.is_two_state() && i < s.states.size(); ++i)
    name += std::string(i == 0 ? ": " : ", ") + s.states[i];
  return name;
}

std::span<const ViewSwitch> view_switches() { return kSwitches; }

const ViewSwitch& view_switch(SwitchId id) {
  const ViewSwitch& found = kSwitches.at(static_cast<size_t>(id));
  KERF_ASSERT(found.id == id);
  return found;
}

}  // namespace kerf
