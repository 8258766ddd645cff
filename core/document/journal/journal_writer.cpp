#include "core/document/commands/command_text.h"
#include "core/document/files/scene_text.h"
#include "core/document/history/document.h"
#include "core/document/journal/mark_fields.h"
#include "core/document/text/fields.h"
#include "core/document/text/json_text.h"
#include "core/physics/machine_kind.h"
#include "core/world/state_hash.h"

namespace kerf {

Result<std::string> journal_head(const SceneDescription& scene, const std::filesystem::path& work_of,
                                 const std::filesystem::path& folder) {
  nlohmann::ordered_json json{{"kerf", "journal"}};
  SceneDescription without_strokes = scene;
  without_strokes.strokes.clear();
  json.update(scene_json(without_strokes, folder));
  if (!work_of.empty()) json["work_of"] = path_text(work_of, {});
  for (const SceneBody& body : scene.bodies) {
    if (!body.hash)
      return bad_input(body.mesh.string() + ": a journal needs a mesh file that can be read again");
  }
  const auto text = dump_json(json);
  if (!text) return text.error();
  return *text + "\n";
}

Result<std::string> journal_lines(std::span<const Command> commands, std::span<const StateMark> marks,
                                  const std::filesystem::path& folder) {
  std::string lines;
  for (size_t i = 0;; ++i) {
    for (; !marks.empty() && marks.front().commands == i; marks = marks.subspan(1))
      lines += fields_json(marks.front(), folder).dump() + '\n';
    if (i == commands.size()) return lines;
    const auto line = command_text(commands[i], folder);
    if (!line) return line.error();
    lines += *line + '\n';
  }
}

bool mark_state(Document& document, std::vector<StateMark>& marks, bool always) {
  const size_t commands = document.journal().size();
  const size_t last = marks.empty() ? 0 : marks.back().commands;
  const bool marked = !marks.empty() && last == commands;
  if (document.execution().in_stroke() || document.waiting() > 0 || marked) return false;
  if (!always && commands < last + kCommandsBetweenMarks) return false;
  document.seal_journal();
  const World& world = document.world();
  StateMark mark{commands, state_hash(world), 0, {}, moved_bodies(world)};
  if (!mark.bodies.empty()) {
    mark.machine = machine_kind();
    mark.pairs = known_pairs(world);
    mark.clock = world.clock();
  }
  marks.push_back(std::move(mark));
  return true;
}

}  // namespace kerf
