#include "core/api/api_internal.h"

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <locale>
#include <memory>
#include <new>
#include <span>
#include <sstream>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/platform.h"
#include "core/document/command_queue.h"
#include "core/document/cut_effects.h"
#include "core/document/extract.h"
#include "core/document/journal.h"
#include "core/document/replay.h"
#include "core/document/save.h"
#include "core/document/stroke_path.h"
#include "core/document/text/hash.h"
#include "core/document/text/json.h"
#include "core/graph/component_graph.h"
#include "core/mesh/mesh_file.h"
#include "core/world/world.h"

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace kerf {

namespace {

constexpr unsigned kMaxThreads = 1024;

constexpr const char* kNoMemory = "out of memory";

// Message of this thread; kNoMemory if there was too little memory to store one.
struct StoredError {
  std::string text;
  bool lacks_memory = false;
};
StoredError& stored_error() {
  static thread_local StoredError message;
  return message;
}

// Sets rounding to nearest and no flushing of denormals (as -ffast-math sets it) during its lifetime. On
// arm64 the environment includes the flushing.
class DefaultArithmetic {
 public:
  DefaultArithmetic() {
    std::fegetenv(&environment_);
    std::fesetenv(FE_DFL_ENV);
#ifdef __SSE__
    _mm_setcsr(kDefault);
#endif
  }
  ~DefaultArithmetic() {
    std::fesetenv(&environment_);
#ifdef __SSE__
    _mm_setcsr(control_);
#endif
  }
  DefaultArithmetic(const DefaultArithmetic&) = delete;
  DefaultArithmetic& operator=(const DefaultArithmetic&) = delete;

 private:
  std::fenv_t environment_{};
#ifdef __SSE__
  static constexpr unsigned kDefault = 0x1f80;
  unsigned control_ = _mm_getcsr();
#endif
};

}  // namespace

char* copy_of(const std::string& text) {
  auto copy = std::make_unique<char[]>(text.size() + 1);
  std::memcpy(copy.get(), text.c_str(), text.size() + 1);
  return copy.release();
}

kerf_result set_error(kerf_result result, const char* message) noexcept {
  try {
    stored_error() = {message, false};
    // A name in it, such as that of a file, may contain line breaks.
    std::ranges::replace_if(
        stored_error().text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  } catch (const std::bad_alloc&) {
    stored_error().lacks_memory = true;
  }
  return result;
}

const char* last_message() { return stored_error().lacks_memory ? kNoMemory : stored_error().text.c_str(); }

kerf_result Call::run(const std::function<Status(const Progress&)>& work) {
  const Result<kerf_call_options> read = read_struct(options_, KERF_CALL_OPTIONS_INIT, "options");
  if (!read) return set_error(KERF_INVALID_ARGUMENT, read.error().message.c_str());
  const kerf_call_options options = *read;
  if (options.threads > kMaxThreads)
    return set_error(KERF_INVALID_ARGUMENT, "threads: must be from 0 to 1024");
  const DefaultArithmetic arithmetic;
  const Progress progress{[&](double share) {
    stopped_ = stopped_ || (options.progress != nullptr && options.progress(share, options.user) != 0);
    return !stopped_;
  }};
  try {
    Status status = Done{};
    with_threads(options.threads, [&] { status = work(progress); });
    if (status) return KERF_OK;
    if (stopped_) return set_error(KERF_CANCELLED, "cancelled");
    const bool bad = status.error().code == ErrorCode::kBadInput;
    return set_error(bad ? KERF_INVALID_ARGUMENT : KERF_FAILED, status.error().message.c_str());
  } catch (const std::bad_alloc&) {
    return set_error(KERF_FAILED, kNoMemory);
  } catch (const std::exception& fault) {
    return set_error(KERF_FAILED, fault.what());
  } catch (...) {
    return set_error(KERF_FAILED, "the call failed with an unknown exception");
  }
}

bool WorldUsers::begin_reading() {
  int users = users_.load(std::memory_order_relaxed);
  while (users != kChanging) {
    if (users_.compare_exchange_weak(users, users + 1, std::memory_order_acquire)) return true;
  }
  return false;
}

bool WorldUsers::begin_changing() {
  int none = 0;
  return users_.compare_exchange_strong(none, kChanging, std::memory_order_acquire);
}

kerf_result read_world(const kerf_world* world, const kerf_call_options* options,
                       const std::function<Status(const Document&, const Progress&)>& work) {
  if (world == nullptr) return set_error(KERF_INVALID_ARGUMENT, "world: must not be null");
  if (!world->users.begin_reading())
    return set_error(KERF_BUSY,
                     "the world is in use by a call that changes it; try again after that call has returned");
  const kerf_result result =
      Call(options).run([&](const Progress& progress) { return work(world->document, progress); });
  world->users.end_reading();
  return result;
}

kerf_result use_exclusively(kerf_world* world, const kerf_call_options* options,
                            const std::function<Status(const Progress&)>& work) {
  if (world == nullptr) return set_error(KERF_INVALID_ARGUMENT, "world: must not be null");
  if (!world->users.begin_changing())
    return set_error(KERF_BUSY,
                     "the world is in use by another call; try again after that call has returned");
  const kerf_result result = Call(options).run(work);
  world->users.end_changing();
  return result;
}

kerf_result change_world(kerf_world* world, const kerf_call_options* options,
                         const std::function<Status(const Progress&)>& work) {
  bool in_stroke = false;
  const kerf_result result = use_exclusively(world, options, [&](const Progress& progress) -> Status {
    in_stroke = world->stroke.has_value();
    if (in_stroke) return failed("a stroke is being cut in steps; finish or cancel it first");
    return work(progress);
  });
  return in_stroke ? KERF_BUSY : result;
}

kerf_result change_stroke(kerf_world* world, const std::function<Status(RunningStroke&)>& work) {
  return use_exclusively(world, nullptr, [&](const Progress&) -> Status {
    if (!world->stroke) return bad_input("no stroke is being cut in steps; begin one first");
    return work(*world->stroke);
  });
}

namespace {

// Records the bodies that a command has added, at the places where they were added.
void record_added(kerf_world& world, std::span<const Command> commands, size_t i, const Delta& delta) {
  const auto* moved = i + 1 < commands.size() ? std::get_if<MovePiece>(&commands[i + 1]) : nullptr;
  for (const BodyId id : delta.created) {
    const Body& body = world.document.world().body(id);
    const bool is_placed = moved != nullptr && moved->piece == PieceId{id, 0};
    world.record_loaded(body, is_placed ? moved->to : body.placement);
  }
}

// Executes the commands of a journal, and keeps the bounds after each for undo and redo.
Status replay_journal(const Journal& journal, kerf_world& world, const Progress& progress) {
  Replay replay(journal, world.document);
  QueueRun how;
  how.progress = &progress;
  size_t followed = 0;  // commands
  how.told = [&](const Result<StepResult>& step) -> Status {
    if (!step || replay.applied() == 0) return Done{};
    const size_t i = replay.applied() - 1;
    const Command& command = journal.commands[i];
    if (std::holds_alternative<Undo>(command) || std::holds_alternative<Redo>(command)) {
      // Strokes that are undone next are not executed, but replace the steps that could be redone.
      const auto begins = [](const Command& c) {
        return std::holds_alternative<BeginStroke>(c) || std::holds_alternative<Recut>(c);
      };
      const size_t position = world.document.history().position();
      const auto begun = static_cast<size_t>(
          followed < i ? std::count_if(&journal.commands[followed], &command, begins) : 0);
      if (begun > 0) world.kept.resize(std::min(world.kept.size(), position + 2 - begun));
      world.restore();
    } else if (std::holds_alternative<AddMesh>(command)) {
      record_added(world, journal.commands, i, step->delta);
    }
    world.keep();
    followed = i + 1;
    return Done{};
  };
  if (const Status done = replay.run(how); !done) return done;
  world.keep();
  return Done{};
}

// Cuts the strokes of a scene, and keeps the values after each for undo and redo.
Status cut_strokes(std::span<const StrokePath> strokes, kerf_world& world, const Progress& progress) {
  const double diagonal = world.bounds->diagonal();
  ProgressShares shares(&progress);
  for (const StrokePath& stroke : strokes) {
    const Progress own = shares.next(1 / static_cast<double>(strokes.size()));
    const Outcome cut = world.document.run_whole(scene_stroke_commands(stroke, diagonal), &own);
    if (!cut) return cut.error();
    world.keep();
  }
  return Done{};
}

Status open_world(const char* path, kerf_world& to, const Progress& progress) {
  ProgressShares shares(&progress);
  const Progress opening = shares.next(0.45), hashing = shares.next(0.05), replaying = shares.next(0.5);
  auto file = open_file(path, &opening);
  if (!file) return file.error();
  const Journal& journal = file->journal;
  if (!journal.damage.empty() && !journal.torn) return bad_input(journal.damage);
  to.scene = file->scene;
  to.scene.strokes.clear();  // which are commands of the document
  // For journals to be saved: the files may change before. Saving reports what is no regular file.
  if (const Status recorded = record_hashes(to.scene, &hashing);
      !recorded && recorded.error().code != ErrorCode::kBadInput)
    return recorded;
  Document& document = to.document;
  const size_t window = document.history().window();
  document = document_of(std::move(file->scene.world), file->scene);
  document.set_window(window);
  // As in `kerf cut`. A journal is replayed without a limit, as in `kerf replay`.
  if (journal.commands.empty()) document.set_face_budget(usual_face_budget(machine_memory()));
  for (const BodyId id : document.world().ids()) to.job.record_loaded(document.world().body(id).loaded);
  to.bounds = document.world().bounds();
  to.keep();
  if (const Status cut = cut_strokes(file->scene.strokes, to, replaying); !cut) return cut;
  if (const Status replayed = replay_journal(journal, to, replaying); !replayed) return replayed;
  document.drop_origin();  // the files may change later
  return Done{};
}

// Converts a piece for the report.
WrittenPiece as_written(const kerf_mesh& mesh) {
  const kerf_mesh_info& info = mesh.info;
  WrittenPiece piece;
  piece.file = mesh.name;
  piece.faces = mesh.triangles.size();
  piece.vertices = mesh.positions.size();
  piece.boundary_edges = info.boundary_edges;
  piece.area = info.area;
  const auto vector = [](const double(&v)[3]) { return Vec3(v[0], v[1], v[2]); };
  piece.centroid = vector(info.centroid);
  if (info.is_closed) piece.volume = info.volume;
  piece.mass.mass = info.mass;
  const double(&i)[6] = info.inertia;
  piece.mass.inertia = glm::dmat3(i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2]);
  piece.placement.position = vector(info.position);
  const double(&q)[4] = info.orientation;
  piece.placement.orientation = glm::dquat(q[0], q[1], q[2], q[3]);
  return piece;
}

}  // namespace
}  // namespace kerf

kerf_result kerf_world_create(kerf_world** out) {
  if (out == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "out: must not be null");
  return kerf::Call(nullptr).run([&](const kerf::Progress&) -> kerf::Status {
    *out = new kerf_world;
    return kerf::Done{};
  });
}

kerf_result kerf_world_open(const char* path, const kerf_call_options* options, kerf_world** out) {
  if (path == nullptr || out == nullptr)
    return kerf::set_error(KERF_INVALID_ARGUMENT, "path and out: must not be null");
  return kerf::Call(options).run([&](const kerf::Progress& progress) -> kerf::Status {
    auto world = std::make_unique<kerf_world>();
    const kerf::Status opened = kerf::open_world(path, *world, progress);
    if (opened) *out = world.release();
    return opened;
  });
}

void kerf_world_destroy(kerf_world* world) { delete world; }

kerf_result kerf_world_save_scene(const kerf_world* world, const char* folder) {
  if (folder == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "folder: must not be null");
  return kerf::read_world(
      world, nullptr, [&](const kerf::Document& document, const kerf::Progress&) -> kerf::Status {
        const kerf::World& in = document.world();
        const auto has_faces = [&](kerf::BodyId id) { return in.body(id).mesh.live_faces() > 0; };
        if (std::ranges::none_of(kerf::cuttable(in), has_faces))
          return kerf::bad_input("the world has no visible face to save");
        const auto saved = kerf::save_world_as_scene(document.world(), {}, folder);
        return saved ? kerf::Status(kerf::Done{}) : saved.error();
      });
}

kerf_result kerf_world_save_journal(const kerf_world* world, const char* path) {
  if (path == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "path: must not be null");
  return kerf::read_world(world, nullptr, [&](const kerf::Document&, const kerf::Progress&) {
    return kerf::save_journal_of(*world, path);
  });
}

kerf_result kerf_world_report(const kerf_world* world, const kerf_call_options* options, char** out) {
  if (out == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "out: must not be null");
  return kerf::read_world(
      world, options, [&](const kerf::Document& document, const kerf::Progress& progress) -> kerf::Status {
        auto pieces = kerf::pieces_of(document.world(), progress);
        if (!pieces) return pieces.error();
        std::vector<kerf::WrittenPiece> written;
        for (const auto& piece : *pieces) written.push_back(kerf::as_written(*piece));
        const auto text =
            kerf::dump_json(kerf::cut_report(world->job, document.world(), world->settings, written), 2);
        if (!text) return text.error();
        *out = kerf::copy_of(*text);
        return kerf::Done{};
      });
}

kerf_result kerf_world_hash(const kerf_world* world, char out[17]) {
  if (out == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "out: must not be null");
  return kerf::read_world(world, nullptr,
                          [&](const kerf::Document& document, const kerf::Progress&) -> kerf::Status {
                            const std::string text = kerf::hash_text(kerf::state_hash(document.world()));
                            std::memcpy(out, text.c_str(), text.size() + 1);
                            return kerf::Done{};
                          });
}

kerf_result kerf_world_graph(const kerf_world* world, char** out) {
  if (out == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "out: must not be null");
  return kerf::read_world(world, nullptr,
                          [&](const kerf::Document& document, const kerf::Progress&) -> kerf::Status {
                            std::ostringstream text;
                            text.imbue(std::locale::classic());
                            kerf::write_graph_json(kerf::component_graph(document.world()),
                                                   kerf::piece_origins(document), document.world(), text);
                            *out = kerf::copy_of(text.str());
                            return kerf::Done{};
                          });
}

void kerf_text_free(char* text) { delete[] text; }
