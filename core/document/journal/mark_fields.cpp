#include "core/document/journal/mark_fields.h"

#include <algorithm>

#include "core/document/text/fields.h"
#include "core/document/text/hash_text.h"
#include "core/document/text/json_value.h"
#include "core/document/text/world_fields.h"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

Status read_body(const JsonValue& value, BodyId& id) {
  const auto n = value.whole_numbers({2});
  if (!n) return value.wrong("must be two whole numbers: a body's slot and its generation");
  id = {n->front(), n->back()};
  return Done{};
}

Status read_pairs(const JsonValue& value, std::vector<NearPair>& pairs) {
  if (const Status list = value.array("pairs of bodies"); !list) return list;
  for (size_t i = 0; i < value.json().size(); ++i) {
    const auto n = value[i].whole_numbers({4, 6});
    if (!n) return value[i].wrong("must be four or six whole numbers: one body or two, and how they touch");
    NearPair& pair = pairs.emplace_back();
    pair.first = {(*n)[0], (*n)[1]};
    if (n->size() == 6) pair.second = {(*n)[2], (*n)[3]};
    pair.touching = (*n)[n->size() - 2] != 0;
    pair.crossed = n->back();
  }
  std::sort(pairs.begin(), pairs.end(), [](const NearPair& a, const NearPair& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
  return Done{};
}

Json pairs_json(const std::vector<NearPair>& pairs) {
  Json list = Json::array();
  for (const NearPair& p : pairs) {
    Json& entry = list.emplace_back(Json{p.first.slot, p.first.generation});
    if (p.second.valid()) entry.insert(entry.end(), {p.second.slot, p.second.generation});
    entry.insert(entry.end(), {p.touching ? 1 : 0, p.crossed});
  }
  return list;
}

}  // namespace

static void describe(Fields& f, BodyState& state) {
  f.value(
      "body", [&](const JsonValue& value) { return read_body(value, state.id); },
      [&] {
        return Json{state.id.slot, state.id.generation};
      });
  describe(f, state.placement);
  f.vector("velocity", state.motion.velocity);
  f.vector("spin", state.motion.spin);
  f.whole("quiet", state.motion.quiet, 0, kNoIndex - 1);
  f.flag("asleep", state.motion.asleep);
}

void describe(Fields& f, StateMark& mark) {
  f.coded("hash", mark.hash, parse_hash, hash_text, kHashRule);
  if (!f.reading() && mark.bodies.empty()) return;
  f.text("machine", mark.machine, kOptional);
  f.whole("clock", mark.clock, 0, std::numeric_limits<Ticks>::max(), kOptional);
  f.list("bodies", "bodies", mark.bodies, kOptional);
  f.value(
      "pairs", [&](const JsonValue& value) { return read_pairs(value, mark.pairs); },
      [&] { return pairs_json(mark.pairs); }, kOptional);
}

}  // namespace kerf
