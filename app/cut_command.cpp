#include <algorithm>
#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "app/console.h"
#include "app/cut_options.h"
#include "app/cut_output.h"
#include "app/run_description.h"
#include "core/base/platform.h"
#include "core/base/result.h"
#include "core/cut/cut_step.h"
#include "core/cut/knife.h"
#include "core/cut/stopwatch.h"
#include "core/cut/thermal_step.h"
#include "core/document/command_queue.h"
#include "core/document/document.h"
#include "core/document/journal.h"
#include "core/document/material_table.h"
#include "core/document/stroke_path.h"
#include "core/document/text/json.h"
#include "core/mesh/mesh_file.h"

namespace kerf {

namespace {

// Returns a point near the centre. Its coordinates are multiples of the largest power of two that is at most
// the diagonal, which minimises the rounding of differences to it.
Vec3 near_origin(const World::Bounds& bounds) {
  const double diagonal = bounds.diagonal();
  if (!(diagonal > 0) || !std::isfinite(diagonal)) return bounds.min;
  const double unit = std::ldexp(1.0, std::ilogb(diagonal));
  return unit * glm::round((0.5 * bounds.min + 0.5 * bounds.max) / unit);
}

// One run of `kerf cut`, from its files to its folder.
class CutRun {
 public:
  explicit CutRun(CutOptions options) : options_(std::move(options)) {}

  Status run() {
    if (const auto s = open_inputs(); !s) return s;
    catch_interrupts();
    if (const auto s = merge_settings_file(options_); !s) return s;
    if (const auto s = check_cut_options(options_); !s) return s;
    if (const auto s = unpack(parse_unit(options_.unit.value_or("m")), unit_); !s) return s;
    record_mesh_unit(unit_);
    if (const auto s = read_scene_description(); !s) return s;
    if (const auto s = read_strokes(); !s) return s;
    if (const auto s = options_.knife.read(); !s) return s;
    if (const auto s = options_.job.read(!options_.path.empty(), options_.radius); !s) return s;
    const bool has_strokes = !strokes_.empty() || !options_.job.file().empty();
    if (const auto s = options_.setup.read(has_strokes); !s) return s;
    if (const auto s = read_material(); !s) return s;
    const PiecesFolder folder{
        options_.out,         options_.format.value_or("obj"),
        options_.split_all,   options_.solid,
        options_.provenance,  options_.colliders ? options_.collider_names.value_or("unreal") : "",
        options_.single_file, options_.outlines.value_or("")};
    if (const auto s = check_outputs(folder); !s) return s;
    if (const auto s = load(); !s) return s;
    if (const auto s = options_.job.add_strokes(bounds_, strokes_, job_); !s) return s;
    const MeshReading planned{scene_.bodies.front().unit, false};  // of the mesh of --fit
    if (const auto s = options_.setup.fit_strokes(document_.world(), planned, strokes_, job_); !s) return s;
    if (const auto s = check_knife_paths(); !s) return s;
    const auto line_of = [&](size_t stroke, size_t key) { return options_.job.line_of(stroke, key); };
    if (const auto s = options_.setup.check_nozzle(document_.world(), strokes_, line_of, job_); !s) return s;
    job_.follows_segments = true;
    if (const auto s = begin_outputs(folder); !s) return s;
    if (const auto s = cut_strokes(); !s) return s;
    if (const auto s = cut_planes(); !s) return s;
    if (const auto s = settle(); !s) return s;
    if (const auto s = lay_flat(); !s) return s;
    // If the journal cannot be written, the pieces are.
    const Status journal = end_journal();
    const StrokePath first = strokes_.empty() ? StrokePath{} : strokes_.front();
    const auto written = folder.write(job_, document_.world(), stroke_settings(options_, first, diagonal_));
    if (!written) return written.error();
    for (size_t i = loaded_notes_; i < job_.notes.size(); ++i) warn(job_.notes[i]);
    if (!job_.missed.empty()) warn(missed_text(job_, stroke_file()));
    summarize(cut_summary(job_, strokes_.size(), planes_, written->size(), options_.out));
    return journal;
  }

 private:
  using Clock = std::chrono::steady_clock;

  // Reads standard input if it is a mesh or the path.
  Status open_inputs() {
    std::vector<std::string> inputs = options_.meshes;
    for (const std::string& file : {options_.path, options_.job.drawing, options_.job.gcode}) {
      if (!file.empty()) inputs.push_back(file);
    }
    record_inputs(std::move(inputs));
    const bool streamed = std::ranges::find(options_.meshes, kStream) != options_.meshes.end();
    if (streamed && !options_.journal.empty())
      return bad_input(
          "--journal: a journal cannot name a mesh from standard input; save the mesh in a file");
    if (const Status s = unpack(input_file(options_.path), options_.path); !s) return s;
    for (std::string& mesh : options_.meshes) {
      if (const Status s = unpack(input_file(mesh), mesh); !s) return s;
    }
    return Done{};
  }

  const std::string& stroke_file() const {
    if (!options_.job.file().empty()) return options_.job.file();
    return options_.path.empty() ? options_.meshes.front() : options_.path;
  }

  // A scene must be the only file; its own strokes are cut unless --path is given.
  Status read_scene_description() {
    for (const std::string& file : options_.meshes) {
      auto scene = read_description(file, unit_);
      if (!scene) return scene.error();
      if (const std::string name = with_stream_names(file); name != file) scene->bodies.front().name = name;
      if (options_.meshes.size() == 1) {
        strokes_ = scene->strokes;
        scene_ = std::move(*scene);
      } else if (std::filesystem::path(file).extension() == ".json") {
        return bad_input(file +
                         ": a scene cannot be combined with other files; list the meshes in the scene");
      } else {
        scene_.bodies.push_back(std::move(scene->bodies.front()));
      }
    }
    return Done{};
  }

  Status read_strokes() {
    if (options_.path.empty()) return Done{};
    return unpack(read_path_file(options_.path), strokes_);
  }

  Status read_material() {
    if (!options_.material) return Done{};
    const auto materials = load_materials(assets_folder() / "materials.json");
    if (!materials) return materials.error();
    if (const Material* material = find_material(*materials, *options_.material)) {
      substance_ = material->substance;
      return Done{};
    }
    std::string names;
    for (const Material& material : *materials) names += (names.empty() ? "" : ", ") + material.name;
    return bad_input("--material: \"" + *options_.material + "\" is unknown; the materials are: " + names);
  }

  Status check_outputs(const PiecesFolder& folder) const {
    InputFiles inputs;
    for (const std::string& file : options_.meshes) inputs.add(file);
    inputs.add_meshes(scene_);
    for (const std::string& file : {options_.path, options_.settings, options_.job.file(),
                                    options_.job.layers, options_.job.axes, options_.setup.fit})
      inputs.add(file);
    if (options_.material) inputs.add(assets_folder() / "materials.json");
    if (const Status free = folder.check("--out", inputs); !free) return free;
    if (!options_.provenance.empty()) {
      if (folder.may_write(options_.provenance))
        return bad_input("--provenance: " + options_.provenance +
                         " is a name of a piece or of the report; use another name");
      if (const Status free = inputs.check("--provenance", options_.provenance); !free) return free;
    }
    if (options_.journal.empty()) return Done{};
    if (!options_.provenance.empty() && resolved(options_.journal) == resolved(options_.provenance))
      return bad_input("--journal: " + options_.journal + " is the file of --provenance; use another name");
    if (folder.may_write(options_.journal))
      return bad_input("--journal: " + options_.journal +
                       " is a name of a piece or of the report; use another name");
    return inputs.check("--journal", options_.journal);
  }

  Status load() {
    World world;
    for (size_t i = 0; i < scene_.bodies.size(); ++i) {
      SceneBody& body = scene_.bodies[i];
      if (interrupted()) return stopped();
      if (const Status same = check_hash(body); !same) return same;
      Result<BuiltMesh> built = [&] {
        const Stopwatch watch(job_.load_s);
        return load_mesh(body.mesh, {body.unit, !options_.provenance.empty()});
      }();
      if (!built) return built.error();
      if (options_.turn_shells) std::erase(built->report.warnings, built->report.overlap_warning);
      print_repairs(built->report);
      job_.record_loaded(built->report);
      job_.notes.insert(job_.notes.end(), built->report.warnings.begin(), built->report.warnings.end());
      loaded_notes_ = job_.notes.size();
      const Stopwatch watch(job_.build_tree_s);
      if (substance_) body.sheet.substance = *substance_;
      if (substance_) body.sheet.density = substance_->density;
      if (options_.thickness) body.sheet.thickness = *options_.thickness;
      if (options_.density) body.sheet.density = *options_.density;
      if (options_.solid) body.solid = Solidity::kSolid;
      if (options_.cut_material) body.cut_material = *options_.cut_material;
      const auto added = add_scene_body(body, make_body(body.name, std::move(*built)), world);
      if (!added) return added.error();
      if (!world.body(*added).solid) continue;
      const std::string where = options_.meshes.front() + ": /bodies/" + std::to_string(i) + "/solid";
      if (const Status s = prepare_for_walls(options_, where); !s) return s;
    }
    if (!options_.journal.empty()) {
      if (const auto noted = record_hashes(scene_); !noted) return noted;
    }
    job_.input_min_angle = smallest_angle(world);
    bounds_ = world.bounds();
    diagonal_ = bounds_.diagonal();
    if (options_.recentre) job_.origin = near_origin(bounds_);
    document_ = Document(std::move(world));
    document_.set_window(0);  // no undo here
    document_.set_face_budget(usual_face_budget(machine_memory()));
    return turn_shells();
  }

  Status turn_shells() {
    if (!options_.turn_shells) return Done{};
    ProgressLine line("turning shells");
    const Progress turning = line.progress();
    const std::vector<BodyId> bodies = document_.world().ids();
    for (const BodyId id : bodies) {
      const Outcome turned = document_.apply(TurnShells{{id, 0}}, &turning);
      if (!turned.ok()) return error_or_stopped(turned.error());
    }
    if (!options_.provenance.empty() && document_.world().ids() != bodies)
      return bad_input("--provenance: --turn-shells has turned shells; turn them first with kerf prepare");
    return Done{};
  }

  // Fails if a stroke of the knife has a strip that is not planar; names the line or the key.
  Status check_knife_paths() const {
    for (size_t i = 0; i < strokes_.size(); ++i) {
      const CutSettings settings = stroke_settings(options_, strokes_[i], diagonal_);
      if (settings.laser.radius > 0) continue;
      const auto key = first_pose_off_plane({strokes_[i].keys, settings.laser.range});
      if (!key) continue;
      const auto line = options_.job.line_of(i, *key);
      const std::string where = line ? "line " + std::to_string(*line)
                                     : "/strokes/" + std::to_string(i) + "/keys/" + std::to_string(*key);
      return bad_input(
          stroke_file() + ": " + where +
          ": the beam of the knife turns out of the plane of the key before; insert a key between "
          "them so that each strip is planar");
    }
    return Done{};
  }

  Status cut_strokes() {
    const Stopwatch watch(job_.cut_s);
    ProgressLine line("cutting");
    const Progress cutting = line.progress();
    const double share = 1 / std::max(1.0, static_cast<double>(strokes_.size()));
    for (size_t i = 0; i < strokes_.size(); ++i) {
      const double before = share * static_cast<double>(i);
      const Progress own = share_of(&cutting, before, before + share);
      const CutSettings settings = stroke_settings(options_, strokes_[i], diagonal_);
      const auto s = settings.laser.radius == 0 ? cut_by_knife(strokes_[i], settings, own)
                                                : cut(strokes_[i], settings, own);
      if (!s) return error_or_stopped(s.error());
      if (!options_.journal.empty()) mark_state(document_, marks_);
    }
    return Done{};
  }

  Status cut_by_knife(const StrokePath& stroke, const CutSettings& settings, const Progress& progress) {
    const Result<bool> met = run_knife(stroke_commands(stroke, settings).front(), progress);
    if (!met) return met.error();
    if (!*met) job_.missed.push_back(job_.strokes);
    ++job_.strokes;
    return Done{};
  }

  Status cut(const StrokePath& stroke, const CutSettings& settings, const Progress& progress) {
    job_.begin_stroke();
    job_.thermal = settings.model == Model::kThermal;
    const bool is_instant = job_.thermal && duration_of(stroke) <= 0;
    if (is_instant) {
      job_.notes.push_back("stroke " + std::to_string(job_.strokes) +
                           " lasts no time, so it emits no energy: give a second key with a later \"t\"");
    }
    if (job_.thermal && scales_removal(settings) && !warned_scaled_) {
      warned_scaled_ = true;
      std::cerr
          << "kerf: faces may be wider than the kerf (two radii) at this resolution: each is removed for "
             "the energy of a strip as wide as the kerf\n";
    }
    std::vector<size_t> segment_ends;  // in moves
    for (const Command& command : stroke_commands(stroke, settings)) {
      document_.apply(command);
      if (std::holds_alternative<MoveBeam>(command)) segment_ends.push_back(document_.waiting());
    }
    const size_t moves = document_.waiting();
    const size_t steps = options_.steps ? static_cast<size_t>(*options_.steps) : moves;
    const auto line = [&](size_t segment) { return options_.job.line_of(job_.strokes, segment + 1); };
    const size_t uncut = job_.uncut.size();
    std::vector<std::pair<size_t, size_t>> uncut_keys;  // first and last key
    size_t segment = 0;
    job_.segment.line = line(segment);
    StepStatistics before = job_.statistics;
    for (size_t i = 0; i < steps; ++i) {
      const auto done = [&](size_t n) { return static_cast<double>(n) / static_cast<double>(steps); };
      const Progress stepping = share_of(&progress, done(i), done(i + 1));
      if (!stepping.report(0)) return cancelled();
      if (const auto s = step(moves * (i + 1) / steps - moves * i / steps, stepping); !s) return s;
      const StepStatistics begun = before;  // of all segments that end in this step
      while (segment < segment_ends.size() && moves * (i + 1) / steps >= segment_ends[segment]) {
        ++segment;
        const bool is_same_line =
            segment < segment_ends.size() && line(segment) && line(segment) == job_.segment.line;
        if (is_same_line) continue;
        if (job_.thermal && job_.record_segment(begun))
          uncut_keys.emplace_back(job_.segment.segment, segment);
        before = job_.statistics;
        job_.segment = {job_.strokes, segment, line(segment)};
      }
    }
    // Heat lags behind the beam, so what remains under a segment is known at the end.
    for (size_t i = uncut_keys.size(); i-- > 0;) {
      const auto [first, last] = uncut_keys[i];
      const std::span<const Pose> keys = std::span(stroke.keys).subspan(first, last - first + 1);
      if (share_left(keys, settings.laser) > kUncutShare) continue;
      job_.uncut.erase(job_.uncut.begin() + static_cast<std::ptrdiff_t>(uncut + i));
    }
    job_.end_stroke();
    if (is_instant) std::erase(job_.missed, job_.strokes - 1);
    return Done{};
  }

  // Returns the share of the way between keys along which the axis of the beam still meets a face.
  double share_left(std::span<const Pose> keys, const Laser& laser) const {
    constexpr int kSamples = 32;  // of each move
    size_t met = 0, samples = 0;
    for (size_t k = 0; k + 1 < keys.size(); ++k) {
      for (int i = 0; i <= kSamples; ++i, ++samples) {
        const double share = static_cast<double>(i) / kSamples;
        const Pose pose{(1 - share) * keys[k].origin + share * keys[k + 1].origin,
                        glm::normalize((1 - share) * keys[k].direction + share * keys[k + 1].direction)};
        const std::vector<BodyId> bodies = document_.world().ids();
        met += std::ranges::any_of(bodies, [&](BodyId id) {
          const Body& body = document_.world().body(id);
          return body.tree.nearest(body.mesh, body.placement.to_body(pose), laser.range).has_value();
        });
      }
    }
    return samples > 0 ? static_cast<double>(met) / static_cast<double>(samples) : 0;
  }

  // Executes the given number of moves in as many steps as needed. After the last move it completes the
  // search for separated parts.
  Status step(size_t moves, const Progress& progress) {
    auto began = Clock::now();
    QueueRun how;
    how.moves_a_step = moves;
    how.leave = document_.waiting() - moves;
    how.progress = &progress;
    how.told = [&](const Result<StepResult>& step) -> Status {
      if (!step) return step.error();
      job_.record_step(*step, document_.world(), std::chrono::duration<double>(Clock::now() - began).count());
      began = Clock::now();
      return Done{};
    };
    const Status ran = run_queue(document_, how);
    if (ran) ++job_.steps;
    return ran;
  }

  Status cut_planes() {
    const Stopwatch watch(job_.cut_s);
    ProgressLine line("cutting");
    const Progress cutting = line.progress();
    const Status cut = options_.knife.cut(
        document_.world(),
        [&](const Command& command) {
          ++planes_;
          Result<bool> met = run_knife(command, cutting);
          if (met && !options_.journal.empty()) mark_state(document_, marks_);
          return met;
        },
        job_.notes);
    if (job_.solid.missing_pegs > 0)
      job_.notes.push_back("--pegs: there is room for " + std::to_string(job_.solid.pegs) + " of " +
                           count_text(job_.solid.pegs + job_.solid.missing_pegs, "peg"));
    return cut ? cut : error_or_stopped(cut.error());
  }

  // Executes a command of the knife. Returns false if it met nothing.
  Result<bool> run_knife(const Command& command, const Progress& progress) {
    const auto began = Clock::now();
    Outcome outcome = document_.apply(command, &progress);
    if (!outcome.ok()) return outcome.error();
    StepResult step;
    step.delta = std::move(outcome.delta);
    job_.record_step(step, document_.world(), std::chrono::duration<double>(Clock::now() - began).count());
    ++job_.steps;
    return !step.delta.empty();
  }

  // Simulates the falling pieces.
  Status settle() {
    if (!options_.settle) return Done{};
    ProgressLine line("falling");
    const Progress falling = line.progress();
    Environment around;
    around.ground = options_.ground.value_or(bounds_.min.y);
    document_.apply(Command(SetEnvironment{around}));
    document_.apply(Play{});
    document_.apply(AdvanceTime{static_cast<Ticks>(std::ceil(*options_.settle * kTicksPerSecond)), true});
    QueueRun how;
    how.progress = &falling;
    if (const Status ran = run_queue(document_, how); !ran) return error_or_stopped(ran.error());
    return Done{};
  }

  Status lay_flat() {
    const std::vector<Command> moves = options_.knife.lay_flat(document_.world());
    for (const Command& move : moves) {
      if (const Outcome laid = document_.apply(move); !laid.ok()) return laid.error();
    }
    if (options_.recentre && !moves.empty()) job_.origin = near_origin(document_.world().bounds());
    return Done{};
  }

  // Creates the folder of the pieces. Paths that cannot be written are reported before the cut.
  Status begin_outputs(const PiecesFolder& folder) {
    if (!options_.journal.empty() && folder.holds(options_.journal)) {
      if (const Status made = folder.make(); !made) return made;
    }
    if (const Status begun = begin_journal(); !begun) return begun;
    if (const Status made = folder.make(); !made) return made;
    return options_.provenance.empty() ? Status(Done{}) : check_writable(options_.provenance);
  }

  // Writes the head of the journal.
  Status begin_journal() {
    if (options_.journal.empty()) return Done{};
    auto file = AtomicFile::open(options_.journal);
    if (!file) return file.error();
    const auto head = journal_head(scene_, {}, journal_folder());
    if (!head) return head.error();
    if (const Status written = file->append(*head); !written) return written;
    journal_.emplace(std::move(*file));
    return Done{};
  }

  Status end_journal() {
    if (!journal_) return Done{};
    mark_state(document_, marks_, true);
    const auto lines = journal_lines(document_.journal(), marks_, journal_folder());
    if (!lines) return lines.error();
    if (const Status written = journal_->append(*lines); !written) return written;
    return journal_->commit();
  }

  std::filesystem::path journal_folder() const {
    return std::filesystem::absolute(options_.journal).parent_path();
  }

  CutOptions options_;
  std::vector<StrokePath> strokes_;
  FileUnit unit_ = FileUnit::kMetre;
  SceneDescription scene_;
  std::optional<Substance> substance_;  // of all bodies
  Document document_;
  std::vector<StateMark> marks_;
  std::optional<AtomicFile> journal_;
  World::Bounds bounds_;  // as loaded
  double diagonal_ = 0;
  CutJob job_;
  size_t planes_ = 0;        // that were cut, those of --fit-bed per body
  size_t loaded_notes_ = 0;  // the first notes of job_, reported on loading
  bool warned_scaled_ = false;
};

}  // namespace

void add_cut_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("cut", "Cut meshes along a path and write the pieces and a report");
  auto options = std::make_shared<CutOptions>();
  add_cut_options(*command, *options);
  on_call(
      *command, invocation, [options] { return CutRun(*options).run(); },
      "kerf cut assets/scenes/car-cut.json --out pieces --target-edge 0.01");
}

}  // namespace kerf
