#include "tests/bench/table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <map>
#include <thread>

#include "core/base/json.h"
#include "tests/support/checkout.h"
#include "tests/support/temporary_folder.h"

namespace kerf::bench {

namespace {

double rounded(double x) {
  if (x == 0) return 0;
  const double step = std::pow(10, std::floor(std::log10(std::abs(x))) - 3);
  return std::round(x / step) * step;
}

// The first line that a command prints; empty if it fails.
std::string first_line_of(const std::string& command) {
  char line[256] = "";
  FILE* const out = popen(command.c_str(), "r");
  if (!out) return line;
  if (!std::fgets(line, sizeof line, out)) line[0] = 0;
  pclose(out);
  const std::string text = line;
  return text.substr(0, text.find('\n'));
}

// The columns of the meshes on the page; other inputs have the last one, with their name in the first.
constexpr std::array kMeshes{"torus", "bunny", "big_bunny"};
size_t column_of(const Row& row) {
  return static_cast<size_t>(std::find(kMeshes.begin(), kMeshes.end(), row.mesh) - kMeshes.begin());
}

// Three significant digits, without an exponent for large numbers.
std::string figure(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value < 999.5 ? "%.3g" : "%.0f", value);
  return text;
}

std::string entry_of(const Row& row) {
  const char* const bold = row.holds() ? "" : "**";
  return figure(row.ours) + " / " + figure(row.peer) + " " + row.unit + " = " + bold + figure(row.ratio()) +
         bold;
}

// A line of the page's table.
struct Line {
  std::string name, bar;
  std::array<std::string, kMeshes.size() + 1> entries;
};

std::vector<Line> lines_of(const std::vector<Row>& rows) {
  std::vector<Line> lines;
  std::map<std::string, size_t> index;
  for (const Row& row : rows) {
    const size_t column = column_of(row);
    const std::string name = column < kMeshes.size() ? row.row : row.mesh + ": " + row.row;
    const auto [at, is_new] = index.try_emplace(name, lines.size());
    if (is_new) lines.push_back({name, "", {}});
    Line& line = lines[at->second];
    line.entries[column] = entry_of(row);
    if (row.bar) line.bar = figure(*row.bar);
  }
  return lines;
}

std::string page_table(const std::vector<Row>& rows) {
  std::string text = machine_and_commit() +
                     ".\n\n| quantity | torus, 276 k | bunny, 70 k | bunny, 1.1 M | other | target |\n"
                     "|---|---|---|---|---|---|\n";
  for (const Line& line : lines_of(rows)) {
    text += "| " + line.name + " |";
    for (const std::string& entry : line.entries) text += " " + entry + " |";
    text += " " + line.bar + " |\n";
  }
  return text;
}

}  // namespace

std::string machine_and_commit() {
  const std::string model = first_line_of("sed -n 's/^model name[^:]*: //p' /proc/cpuinfo"),
                    commit = first_line_of("git -C '" + test::checkout().string() +
                                           "' describe --always --abbrev=8 --dirty 2>/dev/null");
  char date[32];
  const std::time_t now = std::time(nullptr);
  std::strftime(date, sizeof date, "%d %b %Y", std::localtime(&now));
  return (model.empty() ? "Unknown processor" : model) + ", " +
         std::to_string(std::thread::hardware_concurrency()) + " processors, commit " +
         (commit.empty() ? "unknown" : commit) + ", " + date;
}

bool write_page(const std::vector<Row>& rows, const std::filesystem::path& page) {
  const std::string begin = "<!-- table -->\n", end = "<!-- end of table -->";
  std::string text = test::read_text(page);
  const size_t from = text.find(begin), to = text.find(end);
  if (from == std::string::npos || to == std::string::npos) return false;
  text.replace(from + begin.size(), to - from - begin.size(), page_table(rows));
  std::ofstream out(page);
  out << text;
  return out.good();
}

void print_header() {
  std::printf("%s\n", machine_and_commit().c_str());
  std::printf("%-58s %-10s %-9s %12s %12s %9s %9s\n", "row", "mesh", "unit", "ours", "peer", "ratio", "bar");
}

void print(const Row& r) {
  char bar[32] = "";
  if (r.bar) std::snprintf(bar, sizeof bar, "%.4g", *r.bar);
  std::printf("%-58s %-10s %-9s %12.5g %12.5g %9.4g %9s%s\n", r.row.c_str(), r.mesh.c_str(), r.unit.c_str(),
              r.ours, r.peer, r.ratio(), bar, r.holds() ? "" : "  falls short");
  std::fflush(stdout);
}

bool write_json(const std::vector<Row>& rows, const std::filesystem::path& file) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Row& r : rows) {
    nlohmann::ordered_json bar;
    if (r.bar) bar = *r.bar;
    list.push_back({{"row", r.row},
                    {"mesh", r.mesh},
                    {"unit", r.unit},
                    {"ours", rounded(r.ours)},
                    {"peer", rounded(r.peer)},
                    {"ratio", rounded(r.ratio())},
                    {"bar", bar},
                    {"holds", r.holds()}});
  }
  std::ofstream out(file);
  out << list.dump(1) << '\n';
  return out.good();
}

}  // namespace kerf::bench
