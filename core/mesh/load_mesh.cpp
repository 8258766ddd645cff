#include "core/mesh/load_mesh.h"

#include <new>

#include "core/mesh/files/scanner.h"
#include "core/mesh/read_mesh.h"

namespace kerf {

Result<BuiltMesh> load_mesh(const std::filesystem::path& file, const Progress* progress) {
  constexpr double kReading = 0.2;  // of the time; the rest is building
  const Progress reading = share_of(progress, 0, kReading), building = share_of(progress, kReading, 1);
  const auto soup = read_mesh(file, &reading);
  if (!soup) return soup.error();
  const std::string name = one_line(file.string());
  try {
    auto built = build_mesh(*soup, &building);
    if (!built && built.error().code == ErrorCode::kBadInput)
      return bad_input(name + ": " + built.error().message);
    return built;
  } catch (const std::bad_alloc&) {
    return failed(name + ": there is not enough memory to build its mesh.");
  }
}

}  // namespace kerf
