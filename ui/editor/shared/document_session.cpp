#include "ui/editor/shared/document_session.h"

#include <algorithm>
#include <string_view>

#include "core/base/json.h"
#include "core/base/platform.h"
#include "core/document/command_queue.h"
#include "core/document/replay.h"
#include "core/mesh/mesh_file.h"
#include "ui/render/picture.h"

namespace kerf {

namespace {

nlohmann::json head_of(const SceneDescription& scene) {
  nlohmann::json head = nlohmann::json::parse(scene.others, nullptr, false);
  return head.is_object() ? head : nlohmann::json::object();
}

constexpr std::chrono::milliseconds kBetweenCopies(250);
constexpr int kCopyShare = 8;  // inverse of the maximum share of time for copies

// Is never stopped, so it does not fail.
PartialReplay copy_of(const SceneDescription& scene, const World& world, const PreparedBodies& prepared) {
  LoadedShadings shadings;
  for (const auto& [id, body] : prepared) shadings.emplace(id, LoadedShading{body.frame, body.bases});
  PartialReplay copy{scene, world, {}};
  for (const BodyId id : world.ids()) copy.prepared.emplace(id, prepare_shading(world.body(id), shadings));
  const Status cast = prepare_shadows(world, copy.prepared, nullptr);
  KERF_ASSERT(cast.ok());
  return copy;
}

constexpr size_t kShadowsLater = 200'000;  // faces; the first frame of a larger world has no shadows

// The shares of the time for reading, hashes, smooth normals and shadows, and the share of the whole for
// strokes and a journal, if any.
constexpr double kReading = 0.48, kHashing = 0.01, kShading = 0.25, kShadows = 0.26, kCutting = 0.3;

// The longest time without a beam that is simulated, which takes a few seconds.
constexpr Ticks kTicksToSkip = 20 * kTicksPerSecond;

bool is_over(const std::future<Result<LoadedFiles>>& result, double seconds) {
  return result.wait_for(std::chrono::duration<double>(seconds)) == std::future_status::ready;
}

Result<Scene> read_beside_others(const std::filesystem::path& file, const Progress* progress) {
  if (is_journal(file)) return bad_input(file.string() + ": a journal cannot be opened with other files");
  return read_scene(file, progress);
}

void put_into(Scene& scene, Scene more) {
  for (const BodyId id : more.world.ids()) scene.world.add(std::move(more.world.body(id)));
  scene.bodies.insert(scene.bodies.end(), more.bodies.begin(), more.bodies.end());
  scene.paints.merge(more.paints);
  scene.strokes.insert(scene.strokes.end(), more.strokes.begin(), more.strokes.end());
}

// Reads several files as one scene. Unreadable ones are removed from `files`, with a reason each in
// `refused`. Fails if none can be read.
Result<OpenedFile> read_together(std::vector<std::filesystem::path>& files, std::vector<std::string>& refused,
                                 const Progress* progress) {
  bool stopped = false;
  const Progress watched{[&](double fraction) {
    stopped = progress != nullptr && !progress->report(fraction);
    return !stopped;
  }};
  OpenedFile all;
  std::vector<std::filesystem::path> good;
  std::optional<Error> fault;
  const double share = 1 / static_cast<double>(files.size());
  for (size_t i = 0; i < files.size(); ++i) {
    const double before = share * static_cast<double>(i);
    const Progress reading = share_of(&watched, before, before + share);
    Result<Scene> more = read_beside_others(files[i], &reading);
    if (stopped) return cancelled();
    if (more) {
      put_into(all.scene, std::move(*more));
      good.push_back(files[i]);
    } else {
      if (!fault) fault = more.error();
      refused.push_back(more.error().message);
    }
  }
  if (good.empty()) return *fault;
  files = std::move(good);
  return all;
}

// Reads a single file or recoverable work; meshes that moved get their new paths.
Result<Journal> read_without_meshes(const LoadRequest& order) {
  Journal journal;
  if (order.left) {
    journal = *order.left;
  } else if (const std::filesystem::path& file = order.files.front(); is_journal(file)) {
    Result<Journal> read = read_journal(file);
    if (!read) return read.error();
    journal = std::move(*read);
  } else {
    Result<SceneDescription> read = read_description(file);
    if (!read) return read.error();
    journal.scene = std::move(*read);
  }
  for (SceneBody& body : journal.scene.bodies) {
    if (const auto moved = order.moved.find(body.mesh); moved != order.moved.end()) body.mesh = moved->second;
  }
  return journal;
}

Result<OpenedFile> read_order(LoadRequest& order, std::vector<std::string>& refused,
                              const Progress* progress) {
  if (!order.left && order.files.size() > 1) return read_together(order.files, refused, progress);
  Result<Journal> journal = read_without_meshes(order);
  if (!journal) return journal.error();
  Result<Scene> scene = load_scene(journal->scene, progress);
  if (!scene) return scene.error();
  return OpenedFile{std::move(*scene), std::move(*journal)};
}

std::string notes_of(const World& world) {
  for (const BodyId id : world.ids()) {
    const std::vector<std::string> notes = load_notes(world.body(id).loaded);
    if (!notes.empty()) return notes.front();
  }
  return "";
}

// Prepares the shading of bodies with a new mesh as long as they are uncut.
void shade_created(const Delta& delta, LoadedFiles& loaded) {
  const World& world = loaded.document.world();
  for (const BodyId id : delta.created) {
    if (!world.contains(id) || loaded.prepared.contains(id)) continue;
    const Body& body = world.body(id);
    if (body.loaded_as == id && body.loaded_faces.empty()) loaded.prepared.emplace(id, prepare_shading(body));
  }
}

using AfterStep = std::function<void(const Delta&)>;

// Prepares the shading of new bodies, and publishes the progress of the replay.
AfterStep shown_by(LoadProgress* news, LoadedFiles& loaded) {
  return [news, &loaded](const Delta& delta) {
    shade_created(delta, loaded);
    if (news != nullptr) news->show(loaded.scene, loaded.document.world(), loaded.prepared);
  };
}

// Ends a stroke that was being drawn when the editor crashed, because no pointer continues it.
Status end_stroke(Document& document, const QueueRun& how) {
  document.apply(EndStroke{});
  return run_queue(document, how);
}

// Fails if it was stopped, or if the file of an added mesh cannot be read. A step that fails here also failed
// in the recording.
Status replay_all(const Journal& journal, LoadedFiles& loaded, const Progress& progress,
                  const AfterStep& after_step) {
  Replay replay(journal, loaded.document, time_skips(journal, kTicksToSkip));
  QueueRun how;
  how.told = [&](const Result<StepResult>& step) -> Status {
    return after_step(step ? step->delta : Delta{}), Done{};
  };
  how.progress = &progress;
  if (const Status ran = replay.run(how); !ran) return ran;
  if (loaded.order.left) {
    if (const Status ended = end_stroke(loaded.document, how); !ended) return ended;
  }
  loaded.marks = journal.marks;
  loaded.damaged = !journal.damage.empty();
  if (loaded.damaged) {
    loaded.fault = journal.damage;
  } else if (replay.difference()) {
    loaded.fault = "The state differs from the one that the journal recorded";
  } else if (!replay.other_machine().empty()) {
    loaded.fault =
        replay.cut_otherwise()
            ? "Recorded on another kind of machine: bodies were placed as recorded, but a stroke drawn "
              "while they moved cut differently here"
            : "Recorded on another kind of machine: bodies were placed as recorded";
  } else if (replay.skipped() > 0) {
    loaded.skipped = replay.skipped();
  }
  return Done{};
}

Status cut_all(const Journal& journal, LoadedFiles& loaded, const Progress& progress,
               const AfterStep& after_step) {
  bool stopped = false;
  const Progress watched{[&](double fraction) { return !(stopped = !progress.report(fraction)); }};
  const double middle = loaded.scene.strokes.empty() ? 0 : (journal.commands.empty() ? 1 : 0.5);
  const Progress strokes = share_of(&watched, 0, middle), commands = share_of(&watched, middle, 1);
  const auto told = [&](const StepResult& step) { after_step(step.delta); };
  const Status cut = cut_strokes(loaded.document, loaded.scene.strokes, told, &strokes);
  if (stopped) return cancelled();
  if (!cut) loaded.fault = cut.error().message;
  return replay_all(journal, loaded, commands, after_step);
}

// Records a fault in `loaded`; fails only if stopped.
Status hash_all(LoadedFiles& loaded, const Progress& progress) {
  bool stopped = false;
  const Progress watched{[&](double fraction) { return !(stopped = !progress.report(fraction)); }};
  const Status noted = record_hashes(loaded.scene, &watched);
  if (stopped) return cancelled();
  if (!noted) loaded.cannot_be_kept = noted.error();
  return Done{};
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

void LoadProgress::show(const SceneDescription& scene, const World& world, const PreparedBodies& prepared) {
  const Clock::time_point began = Clock::now();
  if (!watched_ || began < next_ || world.live_faces() > Document::kMaxFacesToCopy) return;
  {
    const std::lock_guard lock(mutex_);
    if (partial_replay_) return;
  }
  PartialReplay copy = copy_of(scene, world, prepared);
  const Clock::time_point ended = Clock::now();
  next_ = ended + std::max<Clock::duration>(kBetweenCopies, kCopyShare * (ended - began));
  const std::lock_guard lock(mutex_);
  partial_replay_ = std::move(copy);
}

std::optional<PartialReplay> LoadProgress::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(partial_replay_, std::nullopt);
}

std::string LoadRequest::name() const {
  if (left) return "recovered work";
  std::string name = files.front().filename().string();
  if (files.size() > 1) name += " and " + std::to_string(files.size() - 1) + " more";
  return name;
}

std::optional<std::filesystem::path> missing_mesh(const LoadRequest& order) {
  if (!order.left && (order.files.size() > 1 || mesh_format(order.files.front().extension().string())))
    return std::nullopt;
  const Result<Journal> journal = read_without_meshes(order);
  if (!journal) return std::nullopt;
  for (const SceneBody& body : journal->scene.bodies) {
    std::error_code unknown;
    if (!std::filesystem::exists(body.mesh, unknown) && !unknown) return body.mesh;
  }
  return std::nullopt;
}

Result<LoadedFiles> load_files(LoadRequest order, const Progress* progress, LoadProgress* news) {
  KERF_ASSERT(order.left || !order.files.empty());
  const auto set_task = [news](const char* what) {
    if (news != nullptr) news->set_task(what);
  };
  set_task("reading");
  const bool journal = order.left || (order.files.size() == 1 && is_journal(order.files.front()));
  ProgressShares shares(progress);
  const double cutting = journal ? kCutting : 0, rest = 1 - cutting;
  const Progress reading = shares.next(rest * kReading), hashing = shares.next(rest * kHashing),
                 shading = shares.next(rest * kShading), deeds = shares.next(cutting),
                 shadows = shares.next(rest * kShadows),
                 drawing = share_of(progress, rest * (kReading + kHashing), rest),
                 afterwards = share_of(progress, rest, 1);
  LoadedFiles loaded;
  Result<OpenedFile> work = read_order(order, loaded.refused, &reading);
  if (!work) return work.error();
  Scene& scene = work->scene;
  loaded.order = std::move(order);
  loaded.notes = notes_of(scene.world);
  loaded.scene = scene;
  if (const Status hashed = hash_all(loaded, hashing); !hashed) return hashed.error();
  set_task("shading");
  const bool uncut = loaded.scene.strokes.empty() && work->journal.commands.empty();
  loaded.shadows_later = uncut && scene.world.live_faces() > kShadowsLater;
  const Progress& shading_alone = uncut ? drawing : shading;
  Result<PreparedBodies> prepared = uncut && !loaded.shadows_later
                                        ? prepare_drawing(scene.world, &drawing)
                                        : prepare_shading(scene.world, &shading_alone);
  if (!prepared) return prepared.error();
  loaded.prepared = std::move(*prepared);
  if (scene.world.live_faces() <= Document::kMaxFacesToCopy) loaded.as_loaded = scene.world;
  loaded.document = document_of(std::move(scene.world), loaded.scene);
  loaded.document.set_window(loaded.order.history_bytes);
  if (!uncut) set_task("recutting");
  const AfterStep after_step = shown_by(uncut ? nullptr : news, loaded);
  after_step({});
  const Status cut = cut_all(work->journal, loaded, uncut ? afterwards : deeds, after_step);
  if (!cut) return cut.error();
  loaded.document.set_face_budget(usual_face_budget(machine_memory()));
  if (uncut) return loaded;
  set_task("shadows");
  const Status cast = prepare_shadows(loaded.document.world(), loaded.prepared, &shadows);
  if (!cast) return cast.error();
  return loaded;
}

std::filesystem::path file_to_save(const LoadedFiles& loaded) {
  const LoadRequest& order = loaded.order;
  if (order.left) {
    std::error_code missing;
    const auto saved_at = std::filesystem::last_write_time(order.left->work_of, missing);
    return missing || saved_at <= order.left_at ? order.left->work_of : std::filesystem::path();
  }
  const std::filesystem::path& file = order.files.front();
  return file.extension() == ".kerf" && !loaded.damaged ? file : std::filesystem::path();
}

std::string words_on_recovery(const LoadedFiles& loaded) {
  KERF_ASSERT(loaded.order.left);
  const std::filesystem::path& file = loaded.order.left->work_of;
  const std::string words = "Recovered unsaved work";
  return file_to_save(loaded) == file
             ? words
             : words + "; " + file.filename().string() + " was saved later, so Save asks for a name";
}

void FileLoader::start(LoadRequest order, bool watched) {
  cancel();
  job_ = std::make_unique<Job>();
  job_->order = std::move(order);
  if (watched) job_->news.watch();
  job_->result = std::async(std::launch::async, [job = job_.get()] {
    const Progress progress{[job](double fraction) {
      job->fraction = fraction;
      return !job->cancelled;
    }};
    return load_files(job->order, &progress, &job->news);
  });
}

void FileLoader::cancel() {
  if (!job_) return;
  job_->cancelled = true;
  if (kerf::is_over(job_->result, 0)) return job_.reset();
  cancelled_.push_back(std::move(job_));
}

bool FileLoader::is_over(double seconds) const {
  KERF_ASSERT(busy());
  return kerf::is_over(job_->result, seconds);
}

std::optional<Result<LoadedFiles>> FileLoader::take() {
  std::erase_if(cancelled_, [](const auto& job) { return kerf::is_over(job->result, 0); });
  if (!job_ || !is_over(0)) return std::nullopt;
  const std::unique_ptr<Job> job = std::move(job_);
  return job->result.get();
}

void cancel_opening(Opening& opening, Message& message) {
  KERF_ASSERT(opening.loader.busy());
  message.info("Cancelled opening " + opening.loader.order().name() + ".");
  opening.loader.cancel();
  opening.recoverable.clear();  // offered at the next start
}

}  // namespace kerf
