#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace kerf::bench {

// One comparison: a figure of ours and the peer's, less is better, and what their ratio may be at most.
struct Row {
  std::string row;
  std::string mesh;
  std::string unit;
  double ours = 0;
  double peer = 0;
  std::optional<double> bar;  // none: reported only

  double ratio() const { return ours / peer; }
  bool holds() const { return !bar || ratio() <= *bar; }
};

// The processor, its number of processors in use, the commit and the date.
std::string machine_and_commit();
void print_header();
void print(const Row& row);
// A JSON list of objects. Whether it could be written.
bool write_json(const std::vector<Row>& rows, const std::filesystem::path& file);

// Replaces the lines of a page between `<!-- table -->` and `<!-- end of table -->` by the rows, as one table
// with a column a mesh. Returns true on success.
bool write_page(const std::vector<Row>& rows, const std::filesystem::path& page);

}  // namespace kerf::bench
