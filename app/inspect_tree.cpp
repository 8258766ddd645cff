#include "app/inspect_tree.h"

#include "core/document/text/json_value.h"

namespace kerf {

nlohmann::ordered_json tree_json(const World& world) {
  auto bodies = nlohmann::ordered_json::array();
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    auto boxes = nlohmann::ordered_json::array();
    body.tree.for_each_box([&](const AabbTree::Box& box) {
      boxes.push_back({{"min", vector_json(box.min)},
                       {"max", vector_json(box.max)},
                       {"depth", box.depth},
                       {"leaf", box.leaf},
                       {"hit", box.hit}});
    });
    bodies.push_back({{"body", body.name}, {"faces", body.tree.leaf_count()}, {"boxes", std::move(boxes)}});
  }
  return {{"bodies", std::move(bodies)}};
}

}  // namespace kerf
