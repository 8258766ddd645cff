#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace kerf {

// What is drawn over the picture: one flag for each name that `--show` takes.
struct ShowOptions {
  bool aabb = false;              // all boxes of the tree
  bool aabb_hit = false;          // only those that the beam was in
  bool wire = false;              // edges of the faces
  bool face_numbers = false;      // of faces that live, and in red of those that are gone
  bool pieces = false;            // each piece in a strong colour of its own
  bool normals = false;           // a short line from the middle of every face
  bool shadows = false;           // of everything on everything; otherwise only on the ground
  bool silhouette = false;        // the edges that bound the shadow of a light, in blue by their multiplicity
  bool shadow_volumes = false;    // what is extruded from them, fronts and backs in different colours
  bool shadow_stencil = false;    // how many surfaces keep the light away, in colours, with a legend
  bool shadow_facing = false;     // polygons that face the light against those that are averted
  bool shadow_compare = false;    // two methods beside each other, and how many pixels differ
  bool shadow_reference = false;  // shadows by rays, and which pixels differ from those that are drawn
  friend bool operator==(const ShowOptions&, const ShowOptions&) = default;
};

// Names separated by commas; blanks around them and an empty list are fine. A name that is unknown or not
// offered yet is bad input, and the message lists what there is.
Result<ShowOptions> parse_show_list(std::string_view list);

// The names that parse_show_list takes, for --help: "aabb, aabb-hit, ...".
std::string offered_show_names();

}  // namespace kerf
