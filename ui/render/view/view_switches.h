#pragma once

#include <array>
#include <span>
#include <string>

#include "core/base/assert.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// The switches of the view, in the order of panels.
enum class SwitchId {
  kShadows,
  kSilhouette,
  kShadowVolumes,
  kShadowCounts,
  kFacing,
  kCompare,
  kTrace,
  kRimGlow,
  kShading,
  kTextures,
  kWire,
  kSection,
  kBoxes,
  kBoxesHit,
  kPieces,
  kSizes,
  kHeat,
  kNormals,
  kFaceNumbers,
  kGraph,
  kContacts,
  kColliders,
  kCentres,
  kJoints,
  kGhost,
  kTwoSided,
  kCullBacks,
  kSparks,
  kAntialias
};

inline constexpr std::array kOffAndOn{"off", "on"};

// A switch of the view, as used by menus, keys, panels, `--show` and the editor's report. Most have two
// states, off and on; the key of others cycles through their states.
struct ViewSwitch {
  SwitchId id;
  const char* show = "";      // name in `--show`; empty: none of its overlays
  const char* report = "";    // key in the editor's report, and id of its action; empty: not in it
  const char* label = "";     // in menus and panels; empty: in neither
  char key = 0;               // capital letter of its key; 0: none
  const char* tip = "";       // tooltip
  bool in_view_panel = true;  // false: in another panel
  std::span<const char* const> states = kOffAndOn;  // display names, off first; `--show` sets the last
  size_t (*get)(const ViewOptions&) = nullptr;      // the state, an index of `states`
  void (*set)(ViewOptions&, size_t) = nullptr;

  bool is_two_state() const { return states.size() == 2; }
  // Advances to the next state, cyclically.
  void flip(ViewOptions& look) const {
    KERF_ASSERT(get(look) < states.size());
    set(look, (get(look) + 1) % states.size());
  }
};

// The id of its action: "view.wire".
std::string action_id(const ViewSwitch& s);
// The name of its action: "Cycle Shadows", or its label for the states off and on.
std::string action_name(const ViewSwitch& s);

// All switches, indexed by their ids.
std::span<const ViewSwitch> view_switches();
const ViewSwitch& view_switch(SwitchId id);

}  // namespace kerf
