#include "core/document/files/path_file.h"

#include <cmath>

#include "core/base/assert.h"
#include "core/document/files/path_text.h"
#include "core/document/text/fields.h"
#include "core/document/text/json_value.h"

namespace kerf {

static void describe(Fields& f, std::vector<StrokePath>& strokes) { f.list("strokes", "strokes", strokes); }

Vec3 beam_direction(const Vec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  KERF_ASSERT(largest > 0);
  return glm::normalize(v / largest);
}

Result<std::vector<StrokePath>> read_path_file(const std::filesystem::path& file) {
  return read_described<std::vector<StrokePath>>(file);
}

Result<std::vector<StrokePath>> read_path_text(std::string_view text, const std::string& where) {
  std::vector<StrokePath> strokes;
  const Status read = read_text_fields(text, where, {}, [&](Fields& f) { describe(f, strokes); });
  if (!read) return read.error();
  return strokes;
}

bool is_path_file(const std::filesystem::path& file) {
  if (file.extension() != ".json") return false;
  const auto text = read_text_file(file);
  if (!text) return false;
  const auto json = parse_json(*text, file.string());
  return json && json->is_object() && json->contains("strokes") && !json->contains("bodies");
}

}  // namespace kerf
