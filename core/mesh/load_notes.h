#pragma once

#include <string>
#include <vector>

#include "core/mesh/build_mesh.h"

namespace kerf {

// What happened to the faces of a file, in sentences for people, the most important first: what was dropped,
// what was changed, what to expect of a cut; then what the reader warned of. Nothing for what did not happen;
// empty for a file without fault. Welding and vertices are not mentioned: they change no face.
std::vector<std::string> load_notes(const MeshReport& report);

// Of these the ones about faces of the file that are not in the mesh.
std::vector<std::string> dropped_notes(const Repairs& repairs);

}  // namespace kerf
