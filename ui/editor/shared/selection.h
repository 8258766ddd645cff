#pragma once

#include "ui/editor/shared/workspace.h"

namespace kerf {

// The tool that chooses pieces; with Ctrl each tool does.
inline constexpr const char* kPickTool = "Pick pieces";
inline bool picks(const Workspace& on, const Press& press) { return on.tool == kPickTool || press.control; }

// What a click does: chooses the piece under the pointer, with `add` beside those that are chosen.
void choose_under_pointer(Workspace& on, bool add);

// The chosen pieces in the order of their ids.
std::vector<PieceId> chosen_ids(const PieceMap& looks);

}  // namespace kerf
