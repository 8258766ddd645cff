#include "ui/editor/file_loader.h"

#include <cassert>
#include <chrono>

namespace kerf {

namespace {

constexpr uintmax_t kBytesAtOnce = 4 << 20;
constexpr double kReading = 0.48;  // of the time; the rest is what pictures need
constexpr double kHashing = 0.01;  // of that rest

bool is_over(const std::future<Result<LoadedFiles>>& result) {
  return result.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

Result<Work> read_all(std::span<const std::filesystem::path> files, const Progress* progress) {
  if (files.size() == 1) return read_work(files.front(), progress);
  Work all;
  Scene& scene = all.scene;
  const double share = 1 / static_cast<double>(files.size());
  for (size_t i = 0; i < files.size(); ++i) {
    if (is_journal(files[i])) return bad_input(files[i].string() + ": a journal is opened alone");
    const double before = share * static_cast<double>(i);
    const Progress reading = share_of(progress, before, before + share);
    Result<Scene> more = read_scene(files[i], &reading);
    if (!more) return more.error();
    for (const BodyId id : more->world.ids()) scene.world.add(std::move(more->world.body(id)));
    scene.bodies.insert(scene.bodies.end(), more->bodies.begin(), more->bodies.end());
    scene.paints.merge(more->paints);
    scene.strokes.insert(scene.strokes.end(), more->strokes.begin(), more->strokes.end());
  }
  return all;
}

}  // namespace

Status prepare(LoadedFiles& loaded, const Progress* progress) {
  bool stopped = false;
  const Progress whole{[&](double fraction) { return !(stopped = progress && !progress->report(fraction)); }};
  const Progress hashing = share_of(&whole, 0, kHashing), preparing = share_of(&whole, kHashing, 1);
  const Status noted = note_hashes(loaded.work.scene, &hashing);
  if (stopped) return cancelled();
  if (!noted) loaded.cannot_be_kept = noted.error();
  Result<PreparedBodies> prepared = prepare_bodies(loaded.work.scene.world, &preparing);
  if (!prepared) return prepared.error();
  loaded.prepared = std::move(*prepared);
  return Done{};
}

void prepare(LoadedFiles& loaded) {
  const Status done = prepare(loaded, nullptr);
  assert(done.ok());
}

Result<LoadedFiles> load_files(std::vector<std::filesystem::path> files, const Progress* progress) {
  const Progress reading = share_of(progress, 0, kReading), preparing = share_of(progress, kReading, 1);
  Result<Work> work = read_all(files, &reading);
  if (!work) return work.error();
  LoadedFiles loaded{std::move(files), std::move(*work), {}, {}};
  if (const Status done = prepare(loaded, &preparing); !done) return done.error();
  return loaded;
}

void FileLoader::start(std::vector<std::filesystem::path> files) {
  cancel();
  job_ = std::make_unique<Job>();
  job_->files = std::move(files);
  job_->result = std::async(std::launch::async, [job = job_.get()] {
    const Progress progress{[job](double fraction) {
      job->fraction = fraction;
      return !job->given_up;
    }};
    return load_files(job->files, &progress);
  });
}

void FileLoader::cancel() {
  if (!job_) return;
  job_->given_up = true;
  given_up_.push_back(std::move(job_));
}

std::string FileLoader::name() const {
  std::string name = job_->files.front().filename().string();
  if (job_->files.size() > 1) name += " and " + std::to_string(job_->files.size() - 1) + " more";
  return name;
}

double FileLoader::fraction() const { return job_->fraction; }

std::optional<Result<LoadedFiles>> FileLoader::take() {
  std::erase_if(given_up_, [](const auto& job) { return is_over(job->result); });
  if (!job_ || !is_over(job_->result)) return std::nullopt;
  const std::unique_ptr<Job> job = std::move(job_);
  return job->result.get();
}

bool opens_at_once(std::span<const std::filesystem::path> files) {
  uintmax_t bytes = 0;
  for (const std::filesystem::path& file : files) {
    std::error_code error;
    const uintmax_t size = std::filesystem::file_size(file, error);
    if (!error) bytes += size;
  }
  return bytes <= kBytesAtOnce;
}

}  // namespace kerf
