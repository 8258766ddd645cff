#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace kerf {

// A file in a ZIP archive.
struct ZipEntry {
  std::string_view name;
  std::string_view content;  // compressed
  uint16_t method = 0;       // 0: stored, 8: deflated
  uint16_t flags = 0;
  uint64_t size = 0;            // declared, of the uncompressed content
  size_t head = 0, record = 0;  // bytes of its local header and of its record in the directory
};

// Lists the entries of an archive (PKWARE, APPNOTE 6.3), also with ZIP64. Fails with one sentence that names
// the file if the archive is damaged. Linear in the number of entries.
Result<std::vector<ZipEntry>> zip_entries(std::string_view archive, const std::string& name);

// Checks what lib3mf does not: that the entries of a 3MF file have their declared sizes, in total at most
// 4 GiB and, above 64 MiB, 200 times their compressed size, and are not encrypted, that the names of its
// models end with ".model", and that its objects have at most kMaxThreeMfObjects components at most
// kMaxThreeMfDepth levels deep. lib3mf visits all of them, in recursion. Linear in the uncompressed size.
Status check_3mf_entries(const std::vector<ZipEntry>& entries, const std::string& name);
inline constexpr uint64_t kMaxThreeMfObjects = 1'000'000;
inline constexpr int kMaxThreeMfDepth = 100;

// Owns an object of lib3mf.
struct ReleaseThreeMf {
  void operator()(void** object) const;
};
using ThreeMf = std::unique_ptr<void*, ReleaseThreeMf>;

// Calls a function of lib3mf whose last argument returns a new object. Returns null if it fails.
template <typename Function, typename... Arguments>
ThreeMf three_mf_object(Function function, Arguments... arguments) {
  void** object = nullptr;
  if (function(arguments..., &object) != 0 || !object) return nullptr;
  return ThreeMf(object);
}

}  // namespace kerf
