#include <cstdio>
#include <filesystem>
#include <system_error>

#include "core/api/api_internal.h"
#include "core/base/platform.h"
#include "core/document/history_step.h"
#include "core/document/journal.h"
#include "core/document/save.h"
#include "core/mesh/files/soup_file.h"
#include "core/mesh/mesh_file.h"

namespace kerf {

namespace {

// Returns the indices of the commands that were not undone, ascending.
std::vector<size_t> commands_done(std::span<const Command> journal) {
  std::vector<std::vector<size_t>> steps;
  size_t position = 0;
  for (size_t i = 0; i < journal.size(); ++i) {
    if (std::holds_alternative<Undo>(journal[i])) {
      --position;
      continue;
    }
    if (std::holds_alternative<Redo>(journal[i])) {
      ++position;
      continue;
    }
    std::optional<HistoryStep::Kind> last;
    if (position > 0) last = history_step_kind(journal[steps[position - 1].front()], std::nullopt);
    const bool begins = position == 0 || history_step_kind(journal[i], last);
    // A StopStroke keeps the undone steps; time that continues a step drops them.
    if (begins || history_step_kind(journal[i], std::nullopt)) steps.resize(position);
    if (begins) {
      steps.emplace_back();
      ++position;
    }
    steps[position - 1].push_back(i);
  }
  steps.resize(position);
  std::vector<size_t> done;
  for (const auto& step : steps) done.insert(done.end(), step.begin(), step.end());
  return done;
}

// Converts the journal of a world to one that a file can hold: without undone commands, and with bodies from
// files. Bodies that were added first become bodies of the scene. Ids of bodies follow, because they contain
// the number of a command.
class JournalFile {
 public:
  JournalFile(const kerf_world& world, const std::filesystem::path& file)
      : world_(world), file_(file), scene_(world.scene) {}

  Status save() {
    const std::vector<Command>& journal = world_.document.journal();
    inputs_.add_meshes(world_.scene);
    inputs_.add_meshes(journal);
    generations_.resize(journal.size() + 1);
    for (const size_t i : commands_done(journal)) {
      const auto added = world_.added.find(i);
      if (added != world_.added.end()) {
        if (const Status written = put_body(added->second, i); !written) return written;
      } else if (scene_.bodies.empty() && std::holds_alternative<SetEnvironment>(journal[i])) {
        waiting_.push_back(journal[i]);  // the scene needs a body, which does not depend on it
      } else {
        flush();
        put(journal[i], i);
      }
    }
    flush();
    if (scene_.bodies.empty()) return bad_input("the world has no mesh; add one before its journal is saved");
    if (const Status recorded = record_hashes(scene_); !recorded) return recorded;
    std::vector<StateMark> marks;
    // An opened journal may end within a stroke.
    const Document& document = world_.document;
    if (!document.queue().in_stroke() && document.waiting() == 0) marks.push_back(mark());
    return save_journal(file_, scene_, commands_, marks);
  }

 private:
  BodyId id(BodyId before) const {
    const bool known = before.generation < generations_.size();
    return {before.slot, known ? generations_[before.generation] : before.generation};
  }

  // Appends the commands that the scene could not express.
  void flush() {
    in_scene_ = false;
    commands_.insert(commands_.end(), waiting_.begin(), waiting_.end());
    waiting_.clear();
  }

  void put(Command command, size_t index) {
    generations_[index + 1] = static_cast<uint32_t>(commands_.size() + 1);
    std::visit(
        [&](auto& c) {
          if constexpr (requires { c.piece; }) c.piece.body = id(c.piece.body);
          if constexpr (requires { c.settings.bodies; }) {
            for (BodyId& body : c.settings.bodies) body = id(body);
          }
          if constexpr (requires { c.bodies.begin(); }) {
            for (BodyId& body : c.bodies) body = id(body);
          }
        },
        command);
    commands_.push_back(std::move(command));
  }

  Status put_body(const AddedBody& added, size_t index) {
    if (!in_scene_ && scene_.bodies.empty())
      return bad_input(
          "the world was simulated before its first mesh was added, which a journal cannot store; add a mesh "
          "before the first simulation");
    SceneBody body;
    const kerf_mesh& m = *added.mesh;
    const bool is_soup = m.looks.any() || m.surfaces || !m.parts.empty();  // more than OBJ holds
    char ending[24];
    do {
      std::snprintf(ending, sizeof ending, "-mesh-%04zu.", world_.scene.bodies.size() + ++meshes_);
      body.mesh = file_.parent_path() /
                  (file_.stem().string() + ending + (is_soup ? std::string(kSoupFileEnding) : "obj"));
    } while (!inputs_.check("", body.mesh));
    body.name = added.name;
    body.sheet = added.sheet;
    body.placement = added.placement;
    body.solid = added.solid ? Solidity::kSolid : Solidity::kSheet;
    const MeshView view{m.positions, m.triangles, m.materials, m.material_names, {}, {}, m.colours};
    const Status written = is_soup ? write_file_atomically(body.mesh, encode_soup(soup_of(m)))
                                   : write_mesh(view, body.mesh, MeshFormat::kObj);
    if (!written) return written;
    if (!in_scene_) put(AddMesh{body.mesh, body.name}, index);
    const PieceId piece{{added.slot, in_scene_ ? 0 : generations_[index + 1]}, 0};
    if (!in_scene_ && body.placement != Placement()) waiting_.push_back(MovePiece{piece, body.placement});
    if (!in_scene_ && body.sheet != Sheet()) waiting_.push_back(SetSheetProperties{piece, body.sheet});
    if (!in_scene_ && added.solid) waiting_.push_back(SetSolid{piece});
    if (added.hidden) waiting_.push_back(HidePiece{piece});
    if (added.pinned) waiting_.push_back(PinPiece{piece});
    if (in_scene_) {
      scene_.bodies.push_back(std::move(body));
    } else {
      flush();
    }
    return Done{};
  }

  StateMark mark() const {
    StateMark mark = state_mark(world_.document);
    mark.commands = commands_.size();
    for (BodyState& body : mark.bodies) body.id = id(body.id);
    for (NearPair& pair : mark.pairs) {
      pair.first = id(pair.first);
      pair.second = id(pair.second);
    }
    return mark;
  }

  const kerf_world& world_;
  const std::filesystem::path& file_;
  SceneDescription scene_;
  std::vector<Command> commands_;
  std::vector<Command> waiting_;       // of the last added bodies, and the environment before the first
  std::vector<uint32_t> generations_;  // in the file, by generation in the world
  size_t meshes_ = 0;
  InputFiles inputs_;     // which are not overwritten
  bool in_scene_ = true;  // only bodies were added so far, or the environment set before them
};

}  // namespace

Status save_journal_of(const kerf_world& world, const std::filesystem::path& file) {
  // If the journal cannot be written, its meshes must not be either.
  std::error_code error;
  const auto type = std::filesystem::status(file, error).type();
  if (!file.has_filename() ||
      (type != std::filesystem::file_type::regular && type != std::filesystem::file_type::not_found))
    return bad_input("path: must name a file, not a folder");
  return JournalFile(world, file).save();
}

}  // namespace kerf
