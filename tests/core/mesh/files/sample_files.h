#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/files/mesh_format.h"
#include "core/mesh/soup.h"

namespace kerf::test {

using Reader = Result<Soup> (*)(std::string_view, const std::string&, const Progress*);

Reader reader_of(MeshFormat format);

// A small valid file of each kind: a square of two triangles, with whatever extras the format has.
struct Sample {
  const char* name;
  MeshFormat format;
  std::string bytes;
};
std::vector<Sample> sample_files();

// A folder of its own for a test, removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

void write_bytes(const std::filesystem::path& path, const std::string& bytes);
std::string read_bytes(const std::filesystem::path& path);

// Sum of the areas of the triangles whose corners are finite.
double area(const Soup& soup);

// Whether an error is one nonempty line that begins with the name of the file.
bool is_one_line_about(const Error& error, const std::string& file_name);

}  // namespace kerf::test
