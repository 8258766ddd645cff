#pragma once

#include <string>

#include "core/base/number_format.h"
#include "core/document/commands.h"
#include "core/document/single_step.h"
#include "core/mesh/files/mesh_format.h"

namespace kerf {

// Labels of commands, stages and lengths for the user. Lengths are given in file units and shown in the unit
// of the open document, `unit`.

// Returns the largest metric unit that does not exceed the length, or inches for files in inches; its size is
// in file units.
LengthUnit label_unit(double length, FileUnit unit);
// Formats a length in that unit with three significant digits: "2.75 mm", "0.3 in".
std::string length_label(double length, FileUnit unit);
// Formats a resolution: "edges of 3 mm", "within 0.1 mm", "2 levels".
std::string resolution_label(const Resolution& resolution, FileUnit unit);
// Formats the beam of a stroke: "radius 4 mm, four rays".
std::string beam_label(const Laser& laser, FileUnit unit);

// Describes a command: "Stroke, radius 4 mm". The piece is named `piece_name`, or by its number if that is
// empty.
std::string command_label(const Command& command, FileUnit unit, const std::string& piece_name = "");

// Describes a stage of a stroke in one sentence.
std::string stage_label(const StageRecord& record, FileUnit unit);

}  // namespace kerf
