#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/files/mesh_format.h"
#include "core/mesh/files/soup.h"

namespace kerf::fuzz {

using Reader = Result<Soup> (*)(std::string_view, const std::string&, const Progress*);

// What must hold of a reader whatever the bytes; aborts with one line where it does not:
// - it gives a soup whose indices are all there, or one line that begins with the name of the file;
// - triangles_in_file = triangles + invalid_faces_dropped, and building the mesh of a small soup drops no
// more
//   than it counts, keeps the faces in their order and turns none but those it counts;
// - the mesh, written in the same format and read again, has the same faces at bit-equal positions (STL:
//   rounded to float; glTF: to float relative to the middle, the faces by material).
void check_reader(Reader read, MeshFormat format, const uint8_t* data, size_t size);

}  // namespace kerf::fuzz
