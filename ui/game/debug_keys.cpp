#include "ui/game/debug_keys.h"

#include <algorithm>
#include <array>

namespace kerf {

namespace {

// By digit, from 1.
constexpr std::array kViews{SwitchId::kBoxes,         SwitchId::kSizes,        SwitchId::kWire,
                            SwitchId::kPieces,        SwitchId::kGraph,        SwitchId::kContacts,
                            SwitchId::kShadowVolumes, SwitchId::kShadowCounts, SwitchId::kSilhouette};
static_assert(kViews.size() <= 9);

}  // namespace

bool is_debug_view(const ViewSwitch& s) {
  switch (s.id) {
    case SwitchId::kShadows:
    case SwitchId::kAntialias:
    case SwitchId::kSection:
    case SwitchId::kSparks:
      return false;
    default:
      return s.is_two_state() && s.label[0] != '\0';
  }
}

std::optional<char> digit_of(SwitchId view) {
  const auto at = std::find(kViews.begin(), kViews.end(), view);
  if (at == kViews.end()) return std::nullopt;
  return static_cast<char>('1' + (at - kViews.begin()));
}

std::string press_digit(char digit, ViewOptions& look) {
  if (digit == '0') {
    for (const ViewSwitch& s : view_switches()) {
      if (is_debug_view(s)) s.set(look, s.get(ViewOptions()));
    }
    return "Debug views off";
  }
  const auto index = static_cast<size_t>(digit - '1');
  if (digit < '1' || index >= kViews.size()) return {};
  const ViewSwitch& s = view_switch(kViews[index]);
  s.flip(look);
  return std::string(s.label) + " " + s.states[s.get(look)];
}

}  // namespace kerf
