#pragma once

#include <string>
#include <vector>

#include "core/mesh/build_mesh.h"

namespace kerf {

// Sentences for the user about the faces of a file, the most important first: what was dropped, what was
// changed, what it means for cuts, and then the reader's warnings. Empty for a file without faults. Welding
// and dropped vertices are not mentioned, because they change no face.
std::vector<std::string> load_notes(const MeshReport& report);

// Only the sentences about dropped faces.
std::vector<std::string> dropped_notes(const Repairs& repairs);

}  // namespace kerf
