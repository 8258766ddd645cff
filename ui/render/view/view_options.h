#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/ids.h"
#include "core/base/vec3.h"
#include "core/document/files/scene.h"
#include "core/joints/piece_groups.h"
#include "core/shadow/shadow_volume.h"
#include "ui/render/view/scalar_field.h"
#include "ui/render/view/section_plane.h"
#include "ui/render/view/show_options.h"

namespace kerf {

// The two colours of the tree's boxes: where the beam is or was, and untouched.
enum class BoxPalette {
  kRedAndGreen,    // the paper's: #ff6a4d solid, #3fbf7f dotted
  kOrangeAndBlue,  // for the colour-blind: #e69f00 solid, #56b4e9 dotted
};

// How kRobust draws the near caps of its volumes. A lit surface has to fail the depth test against its own
// cap, which has the same depth. All values but kExact give wrong shadows; tests use them to show that they
// detect such errors.
enum class NearCaps {
  kExact,
  kLessOrEqual,  // equal depths pass
  kDisplaced,    // by one unit of depth towards the eye
};

// How shadows are drawn if ShowOptions enables them.
struct ShadowOptions {
  ShadowMethod method = ShadowMethod::kRobust;
  NearCaps near_caps = NearCaps::kExact;
  // Length of the paper's volumes in diagonals of the world; those of kRobust extend to infinity.
  double extrusion = 4;
  // Whether shadows are drawn as half-transparent black, as in the paper, instead of omitting the light.
  bool paper_look = false;
  // The method to the right of the split if ShowOptions compares two; `split` is a fraction of the picture's
  // width.
  ShadowMethod beside = ShadowMethod::kPaperOneVolume;
  double split = 0.5;
  size_t inspected = 0;  // the light whose silhouette, volumes and counts are shown
  friend bool operator==(const ShadowOptions&, const ShadowOptions&) = default;
};

// Which boxes of the tree are drawn when ShowOptions asks for them.
struct TreeOverlay {
  int deepest = 64;  // levels under the root
  bool leaves_only = false;
  bool hit_only = false;
  std::optional<BodyId> body;  // the only body whose boxes are drawn; nothing: all
  BoxPalette palette = BoxPalette::kRedAndGreen;
  friend bool operator==(const TreeOverlay&, const TreeOverlay&) = default;
};

// How a piece is drawn. This does not change the world.
struct PieceLook {
  bool hidden = false;
  bool selected = false;  // drawn with an outline
  uint32_t number = 0;    // determines its colour; 0: its label does
  // A point p of the world is drawn at turn * p + offset; the offset is in metres, along the axes of the
  // world.
  glm::dquat turn{1, 0, 0, 0};
  Vec3 offset{0};
  bool is_away() const { return offset != Vec3(0) || is_turned(); }
  bool is_turned() const { return turn != glm::dquat(1, 0, 0, 0); }
  friend bool operator==(const PieceLook&, const PieceLook&) = default;
};

struct DrawnGraph;
struct StageMarks;
struct BodyMarks;
struct Effects;
struct DrawnWire;

// A face of a body.
struct FaceOfBody {
  BodyId body;
  FaceId face;
  friend bool operator==(const FaceOfBody&, const FaceOfBody&) = default;
};

// Which normals surfaces are shaded by.
enum class Shading {
  kByAngle,  // smooth where faces meet at less than 35 degrees (see BaseFaces)
  kSmooth,   // smooth everywhere
  kFlat,     // each face by its plane
};

// How the world is drawn.
struct ViewOptions {
  ShowOptions show;
  bool rim_glow = true;     // the rims of cuts glow
  bool sparks = true;       // sparks and smoke fly where the laser of the editor bites
  bool antialias = true;    // four samples per pixel
  bool two_sided = true;    // faces are lit on both sides; otherwise the back is black
  bool cull_backs = false;  // backs are not drawn, as the paper first had it
  bool ghost = false;       // removed faces are drawn as a faint veil
  bool tint_pieces = true;  // what was cut off has a colour of its own; otherwise it keeps its paint
  bool legends = true;      // colours of overlays are explained in the picture, by strips
  Shading shading = Shading::kByAngle;
  double mark_scale = 1;                // of numbers and lines over the picture; 1 is for a screen
  bool by_day = false;                  // the environment are bright, otherwise dark
  std::optional<SectionPlane> section;  // where ShowOptions::section cuts; see shown_section()
  TreeOverlay tree;
  std::vector<Light> lights = std::vector<Light>(1);  // only the first kMostLights are used
  ShadowOptions shadow;
  std::shared_ptr<const DrawnGraph> graph;    // what ShowOptions::graph draws; null: nothing
  std::shared_ptr<const ScalarField> scalar;  // colours the faces; null: their paints do
  std::optional<FaceOfBody> lit_face;         // outlined, if it is live
  std::shared_ptr<const StageMarks> stage;    // what a stage of a cut did; null: nothing
  std::shared_ptr<const BodyMarks> bodies;    // of the physics; null: nothing
  std::shared_ptr<const Effects> effects;     // of lasers; null: nothing
  std::shared_ptr<const DrawnWire> wire;      // of what pieces may become; null: nothing
  std::map<PieceId, PieceLook> pieces;        // pieces that are not drawn with the default look
  // The groups of faces of bodies whose pieces are drawn apart, for the present world; see spread_pieces().
  // Values are not null.
  std::map<BodyId, std::shared_ptr<const PieceGroups>> groups;
};

}  // namespace kerf
