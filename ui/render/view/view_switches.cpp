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
         .tip =
             "Shadows on nothing, on the ground only, or on all surfaces. The Light panel sets the method.",
         .states = kShadowStates}),
    of<&ShowOptions::silhouette>({.id = SwitchId::kSilhouette,
                                  .show = "silhouette",
                                  .report = "silhouette",
                                  .label = "Silhouette",
                                  .key = 'E',
                                  .tip = "Edges that bound the shadow of a light: pale with one volume side, "
                                         "blue with two, violet with more."}),
    of<&ShowOptions::shadow_volumes>(
        {.id = SwitchId::kShadowVolumes,
         .show = "shadow-volumes",
         .report = "shadow_volumes",
         .label = "Shadow Volumes",
         .key = 'V',
         .tip = "Volumes extruded from the silhouette: blue seen from outside, orange from inside."}),
    of<&ShowOptions::shadow_stencil>(
        {.id = SwitchId::kShadowCounts,
         .show = "shadow-stencil",
         .report = "shadow_counts",
         .label = "Stencil Count",
         .key = 'C',
         .tip = "Number of surfaces that occlude the light, in the colours of the legend."}),
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
                            .tip = "Bounding boxes of the AABB tree: solid if hit by the beam, dotted if "
                                   "not, as in figure 2 of the paper.",
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
                             .tip = "Nodes on the faces around the last cut, links over shared edges; "
                                    "removed faces red. Graph panel: flat layout."}),
    of<&ShowOptions::contacts>({.id = SwitchId::kContacts,
                                .show = "contacts",
                                .report = "contacts",
                                .label = "Contacts",
                                .tip = "Contact normals of the last tick, redder for larger impulses."}),
    of<&ShowOptions::colliders>(
        {.id = SwitchId::kColliders,
         .show = "colliders",
         .report = "colliders",
         .label = "Colliders",
         .tip = "Points and chords of collision shapes, which are created when bodies begin to move."}),
    of<&ShowOptions::centres>(
        {.id = SwitchId::kCentres,
         .show = "centres",
         .report = "centres",
         .label = "Centres of Mass",
         .tip = "Marks the centre of mass of each body, coloured by awake, asleep or pinned."}),
    of<&ShowOptions::joints>({.id = SwitchId::kJoints,
                              .show = "joints",
                              .report = "joints",
                              .label = "Joints",
                              .tip = "Axes of hinges and hubs, and crosses at welds. A joint is removed with "
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
                                  .tip = "Skips back faces: faster, but holes then show nothing inside. Off "
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
