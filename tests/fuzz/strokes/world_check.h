#pragma once

#include <string>

#include "core/world/world.h"

namespace kerf::fuzz {

// Ends the program with one line where `holds` is false.
void require(bool holds, const std::string& what);

// What must hold of a world in which nothing waits: every mesh is conforming, its positions are finite and no
// face has its three corners at one place, the tree finds what a search of all faces does, labels and counts
// of pieces are those of a complete search, and the ledger of energy is closed.
void check_world(const World& world);

// What must hold of solid bodies of which nothing was left open: every side of a face has another face.
void check_closed(const World& world);

}  // namespace kerf::fuzz
