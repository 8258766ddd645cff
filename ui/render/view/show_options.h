#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace kerf {

// On what surfaces shadows are drawn.
enum class Shadows {
  kNone,
  kGround,  // only on the ground, those of directional lights that shine from above
  kAll,     // on all surfaces
};

// What is drawn in addition to the picture: one flag for each name that `--show` accepts.
struct ShowOptions {
  bool aabb = false;                   // all boxes of the tree
  bool aabb_hit = false;               // only those that the beam has hit
  bool wire = false;                   // edges of the faces
  bool face_numbers = false;           // of live faces, and in red of removed ones
  bool graph = false;                  // nodes and links of ViewOptions::graph
  bool pieces = false;                 // each piece in a colour of its own
  bool sizes = false;                  // small faces warm, as the paper colours them
  bool heat = false;                   // temperatures by a scale, with a bar
  bool section = false;                // only what lies under the section plane
  bool contacts = false;               // where bodies touch, as of the last tick; see BodyMarks
  bool colliders = false;              // points and chords by which bodies touch
  bool centres = false;                // centres of mass, and which bodies sleep or are pinned
  bool joints = false;                 // the joints that hold
  bool normals = false;                // a short line from the middle of every face
  Shadows shadows = Shadows::kGround;  // `--show shadows` asks for kAll
  bool silhouette = false;             // edges of a light's silhouette, coloured by their multiplicity
  bool shadow_volumes = false;         // the volumes, fronts and backs in different colours
  bool shadow_stencil = false;         // number of occluding surfaces as colours, with a legend
  bool shadow_facing = false;          // polygons that face the light and those that face away
  bool shadow_compare = false;         // two methods side by side, and the number of differing pixels
  bool shadow_reference = false;       // ray-traced shadows, and the pixels that differ
  friend bool operator==(const ShowOptions&, const ShowOptions&) = default;
};

// What the editor shows at first, and pictures for which nothing else is asked: shadows on all surfaces.
ShowOptions default_show();

// Parses names separated by commas; blanks around them and an empty list are accepted. The error for an
// unknown name lists the valid ones.
Result<ShowOptions> parse_show_list(std::string_view list);

// The names that parse_show_list accepts, for --help: "aabb, aabb-hit, ...".
std::string offered_show_names();

}  // namespace kerf
