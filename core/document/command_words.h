#pragma once

#include <string>

#include "core/document/command.h"

namespace kerf {

// What a command does, for people: "Stroke, radius 4 mm".
std::string words(const Command& command);

// What a command takes up in memory, bytes.
size_t weight(const Command& command);

}  // namespace kerf
