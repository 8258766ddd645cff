#include "ui/editor/shared/files/document_head.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/assert.h"

namespace kerf {

namespace {

nlohmann::json head_of(const SceneDescription& scene) {
  nlohmann::json head = nlohmann::json::parse(scene.others, nullptr, false);
  return head.is_object() ? head : nlohmann::json::object();
}

}  // namespace

nlohmann::json head_entry(const SceneDescription& scene, const char* key) {
  return head_of(scene).value(key, nlohmann::json());
}

void set_head_entry(SceneDescription& scene, const char* key, const nlohmann::json& entry) {
  KERF_ASSERT(std::ranges::any_of(kEditorKeys, [&](std::string_view known) { return known == key; }));
  nlohmann::json head = head_of(scene);
  if (entry.is_null()) {
    head.erase(key);
  } else {
    head[key] = entry;
  }
  scene.others = head.dump();
}

}  // namespace kerf
