#pragma once

#include <array>
#include <span>
#include <string>

#include "core/base/assert.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// The switches of the view, in the order in which menus and panels list them.
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

// A switch of the view: what menus, keys, panels, `--show` and the editor's report know of it. Most are off
// or on; one with more states is taken through them by its key.
struct ViewSwitch {
  SwitchId id;
  const char* show = "";    // the name that `--show` takes; empty: not one of its overlays
  const char* report = "";  // the key in the editor's report; empty: not in it
  const char* label = "";   // in menus and panels; empty: in neither
  char key = 0;             // the capital letter of the key that flips it; 0: none
  const char* tip = "";     // what it does, for people
  bool in_menu = true;
  bool in_view_panel = true;  // false where another panel has it
  bool ends_group = false;    // a line under it in the menu
  std::span<const char* const> states =
      kOffAndOn;                                // their names for people, off first; `--show` sets the last
  size_t (*get)(const ViewOptions&) = nullptr;  // the state, an index of `states`
  void (*set)(ViewOptions&, size_t) = nullptr;

  bool is_two_state() const { return states.size() == 2; }
  // Goes to the state after the present one, and from the last to the first.
  void flip(ViewOptions& look) const {
    KERF_ASSERT(get(look) < states.size());
    set(look, (get(look) + 1) % states.size());
  }
};

// The name of the action that flips it: "Shadows: none, ground, all", and its label where the states are off
// and on.
std::string action_name(const ViewSwitch& s);

// All switches, indexed by their ids.
std::span<const ViewSwitch> view_switches();
const ViewSwitch& view_switch(SwitchId id);

}  // namespace kerf
