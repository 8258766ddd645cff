#include "tests/bench/table.h"

#include <cmath>
#include <cstdio>
#include <fstream>

#include "core/base/json.h"

namespace kerf::bench {

namespace {

double rounded(double x) {
  if (x == 0) return 0;
  const double step = std::pow(10, std::floor(std::log10(std::abs(x))) - 3);
  return std::round(x / step) * step;
}

}  // namespace

void print_header() {
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
