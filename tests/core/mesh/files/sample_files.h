#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/files/mesh_format.h"
#include "core/mesh/files/soup.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {

using Reader = Result<Soup> (*)(std::string_view, const std::string&, const Progress*);

Reader reader_of(MeshFormat format);

// A small valid file of each kind: a square of two triangles, with the extras of the format.
struct Sample {
  const char* name;
  MeshFormat format;
  std::string bytes;
};
std::vector<Sample> sample_files();

// Sum of the areas of the triangles whose corners are finite.
double area(const Soup& soup);

// Returns true if an error is one nonempty line that begins with the name of the file.
bool is_one_line_about(const Error& error, const std::string& file_name);

}  // namespace kerf::test
