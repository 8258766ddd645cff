#pragma once

#include <string>

#include "core/document/commands/command.h"

namespace kerf {

// A description of the command for the user, for example "Stroke, radius 4 mm".
std::string words(const Command& command);

// The memory that a command occupies, in bytes.
size_t weight(const Command& command);

}  // namespace kerf
