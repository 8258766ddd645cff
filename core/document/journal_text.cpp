#include "core/document/journal_text.h"

#include <algorithm>

#include "core/base/geometry.h"
#include "core/document/text/fields.h"
#include "core/document/text/hash.h"
#include "core/document/text/json.h"
#include "core/document/text/nearest_name.h"
#include "core/document/text/world_fields.h"

namespace kerf {

namespace {

// Checks that a move continues from the beam, if there is one.
void check_follows(Fields& f, const MoveBeam& move, const std::optional<BeamAt>& beam) {
  const BeamAt before = beam.value_or(BeamAt{move.pose, 0});
  f.check(!are_opposite(before.pose.direction, move.pose.direction), "direction",
          "is opposite to the previous direction");
  f.check(!f.present("t", false) || move.time >= before.time, "t", "must not be less than the previous time");
}

// The fields of a command and its name, which was read before.
template <typename C>
void fields_of(Fields& f, C& command, const std::optional<BeamAt>& beam) {
  std::string name = C::kName;
  f.text("do", name);
  if constexpr (!std::is_empty_v<C>) describe(f, command);
  if constexpr (std::is_same_v<C, MoveBeam>) check_follows(f, command, beam);
  f.end();
}

template <typename C>
Result<Command> read_command(const JsonValue& line, const std::filesystem::path& folder,
                             const std::optional<BeamAt>& beam) {
  C command;
  Fields::Pass pass{folder};
  Fields fields(line, pass);
  fields_of(fields, command, beam);
  if (!pass.status) return pass.status.error();
  return Command(std::move(command));
}

// Returns null if there is no such command.
template <typename... Kinds>
auto reader_of(std::variant<Kinds...>*, const std::string& name) {
  decltype(&read_command<Undo>) found = nullptr;
  ((name == Kinds::kName ? void(found = read_command<Kinds>) : void()), ...);
  return found;
}

template <typename... Kinds>
std::vector<std::string> names_of(std::variant<Kinds...>*) {
  return {Kinds::kName...};
}

}  // namespace

Result<std::string> command_text(const Command& command, const std::filesystem::path& folder) {
  return std::visit(
      [&](auto c) {
        return exact_text(visited_json(folder, [&](Fields& f) { fields_of(f, c, std::nullopt); }));
      },
      command);
}

Result<Command> parse_command(const JsonValue& value, const std::filesystem::path& folder,
                              const std::optional<BeamAt>& beam) {
  if (!value.has("do")) return value.wrong("needs \"do\"");
  const auto name = value["do"].text();
  if (!name) return name.error();
  const auto read = reader_of(static_cast<Command*>(nullptr), *name);
  if (read == nullptr)
    return value["do"].wrong("\"" + *name + "\" is no command of this version" +
                             nearest_name_hint(*name, names_of(static_cast<Command*>(nullptr))));
  return read(value, folder, beam);
}

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
