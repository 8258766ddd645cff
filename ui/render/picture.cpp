#include "ui/render/picture.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/document/command_log.h"
#include "core/document/cut_effects.h"
#include "core/document/replay.h"
#include "core/mesh/mesh_file.h"
#include "ui/gl/image.h"
#include "ui/render/bodies/overlay_marks.h"
#include "ui/render/passes/beam_effects.h"

namespace kerf {

Status cut_strokes(Document& document, const std::vector<StrokePath>& strokes,
                   const std::function<void(const StepResult&)>& told, const Progress* progress) {
  const double diagonal = document.world().bounds().diagonal();
  for (size_t i = 0; i < strokes.size(); ++i) {
    for (const Command& command : scene_stroke_commands(strokes[i], diagonal)) document.apply(command);
    const double share = 1 / static_cast<double>(strokes.size()), before = share * static_cast<double>(i);
    const Progress cutting = share_of(progress, before, before + share);
    QueueRun how;
    how.progress = &cutting;
    how.told = [&](const Result<StepResult>& step) -> Status {
      if (!step) return step.error();
      told(*step);
      return Done{};
    };
    if (const Status ran = run_queue(document, how); !ran) return ran;
  }
  return Done{};
}

namespace {

// A step that fails here also failed when the journal was made.
void replay_all(const Journal& journal, Document& document,
                const std::function<void(const StepResult*)>& told) {
  Replay replay(journal, document);
  QueueRun how;
  how.told = [&](const Result<StepResult>& step) -> Status {
    told(step ? &*step : nullptr);
    return Done{};
  };
  (void)replay.run(how);  // never stopped
}

constexpr int kMaxSide = 16384;

// Returns the bounds of an uncut scene and of the meshes that lasting commands of a journal add, where they
// are added: a move that follows places them. Omits files that cannot be read.
World::Bounds framed_bounds(const World& world, const Journal& journal) {
  World::Bounds all = world.ids().empty() ? World::Bounds::none() : world.bounds();
  const std::vector<Command>& commands = journal.commands;
  const std::vector<bool> lasting = lasting_commands(commands);
  for (size_t i = 0; i < commands.size(); ++i) {
    const auto* added = std::get_if<AddMesh>(&commands[i]);
    if (added == nullptr || !lasting[i]) continue;
    const auto built = load_mesh(added->file, nullptr);
    if (!built) continue;
    const auto* move = i + 1 < commands.size() ? std::get_if<MovePiece>(&commands[i + 1]) : nullptr;
    const bool is_placed = move != nullptr && move->piece.body.generation == i + 1;
    const Placement placement = is_placed ? move->to : Placement();
    const Vec3 ends[] = {built->report.min, built->report.max};
    for (int corner = 0; corner < 8; ++corner)
      all.add(placement.to_world({ends[corner & 1].x, ends[corner >> 1 & 1].y, ends[corner >> 2].z}));
  }
  return all.is_none() ? world.bounds() : all;
}

// Fails if the eye is the target, so that the view has no direction.
Result<CameraView> selected_view(const PictureOptions& options, const Scene& scene, const Journal& journal) {
  const World::Bounds bounds = scene.world.bounds();
  const double aspect = static_cast<double>(options.width) / options.height;
  const Vec3 middle = bounds.min + (bounds.max - bounds.min) * 0.5;
  const auto view_from = [&](const Vec3& eye, const Vec3& otherwise) -> Result<CameraView> {
    const Vec3 target = options.target.value_or(otherwise);
    if (eye == target)
      return bad_input("the camera is at the centre of its view; give another --eye or --target");
    return look_at(eye, target, aspect);
  };
  if (options.eye) return view_from(*options.eye, middle);
  if (scene.view) return view_from(scene.view->eye, scene.view->target);
  Camera camera;
  camera.frame_default(options.target ? bounds : framed_bounds(scene.world, journal), aspect);
  camera.finish();
  const CameraView view = camera.view(aspect);
  return options.target ? view_from(view.eye, *options.target) : view;
}

constexpr double kSecondsAcross = 4;
constexpr double kRest = 0.5, kRestAtEnd = 1;  // s

// Returns true if a body would stop in mid-air if no time passed.
bool is_in_motion(const World& world) {
  const std::vector<BodyId> ids = world.ids();
  return std::any_of(ids.begin(), ids.end(), [&](BodyId id) {
    const Motion& motion = world.body(id).motion;
    return !motion.asleep && !motion.at_rest();
  });
}

Vec3 at_distance(const Pose& pose, double distance) { return pose.origin + pose.direction * distance; }

}  // namespace

Result<PictureOptions> options_for(const std::filesystem::path& file, const Scene& scene, int width,
                                   int height) {
  const auto show = parse_show_list(scene.show);
  if (!show) return bad_input(file.string() + ": /show: " + show.error().message);
  PictureOptions options;
  options.width = width;
  options.height = height;
  options.show = scene.show.empty() ? default_show() : *show;
  return options;
}

Result<RenderedImage> draw_picture(OpenedFile work, const PictureOptions& options) {
  auto opened = OffscreenRenderer::open(work.scene, options, work.journal);
  if (!opened) return opened.error();
  const auto renderer = std::make_shared<OffscreenRenderer>(std::move(*opened));
  const auto kept = std::make_shared<Document>(document_of(std::move(work.scene.world), work.scene));
  Document& document = *kept;
  std::optional<Pose> beam;
  const auto follow = [&](const StepResult* step) {
    renderer->follow(document.world(), step);
    if (step && step->last) beam = step->last->to;
  };
  const Status cut =
      cut_strokes(document, work.scene.strokes, [&](const StepResult& step) { follow(&step); });
  if (!cut) return cut.error();
  replay_all(work.journal, document, follow);
  renderer->show_graph(document);
  renderer->show_bodies_ahead(document.world());
  renderer->spread(document.world(), options.spread);
  std::optional<BeamPicture> drawn;
  if (options.beam && beam && document.history().last_cut()) {
    const double far =
        glm::length(renderer->view().eye - beam->origin) + document.world().bounds().diagonal();
    drawn = picture_of_beam(document.world(), document.history().last_settings(), *beam, far);
  }
  renderer->draw(document.world(), drawn);
  return RenderedImage{kept, renderer};
}

Status render_picture(OpenedFile work, const PictureOptions& options, const std::filesystem::path& png) {
  const auto picture = draw_picture(std::move(work), options);
  return picture ? picture->renderer->write(png) : Status(picture.error());
}

OffscreenRenderer::OffscreenRenderer(gl::OffscreenContext context, gl::Framebuffer picture, Renderer renderer)
    : context_(std::move(context)), picture_(std::move(picture)), renderer_(std::move(renderer)) {}

Result<OffscreenRenderer> OffscreenRenderer::open(const Scene& scene, const PictureOptions& options,
                                                  const Journal& journal) {
  if (std::min(options.width, options.height) < 1 || std::max(options.width, options.height) > kMaxSide) {
    return bad_input("the size of an image must be from 1x1 to " + std::to_string(kMaxSide) + "x" +
                     std::to_string(kMaxSide));
  }
  const auto view = selected_view(options, scene, journal);
  if (!view) return view.error();
  auto context = gl::OffscreenContext::create();
  if (!context) return context.error();
  gl::Framebuffer picture({options.width, options.height, 1, false});
  if (!picture.complete()) return failed("OpenGL has no memory for an image of this size; use a smaller one");
  const auto antialias = affordable_antialias(options.width, options.height, options.antialias);
  if (!antialias) return antialias.error();
  auto made = Renderer::create();
  if (!made) return made.error();

  OffscreenRenderer renderer(std::move(*context), std::move(picture), std::move(*made));
  renderer.renderer_.show(scene.world, scene.paints);
  renderer.view_ = *view;
  renderer.look_.show = options.show;
  renderer.look_.section =
      options.section.value_or(section_through(scene.world.bounds(), -renderer.view_.forward));
  renderer.look_.antialias = *antialias;
  renderer.look_.mark_scale = options.mark_scale;
  renderer.look_.legends = options.legends;
  if (!scene.lights.empty()) renderer.look_.lights = scene.lights;
  return renderer;
}

void OffscreenRenderer::follow(const World& world, const StepResult* step) {
  if (step == nullptr) return renderer_.resend(world);
  renderer_.follow(world, step->delta);
  if (look_.show.face_numbers) renderer_.send_faces(world);
}

void OffscreenRenderer::show_graph(const Document& document) {
  if (!look_.show.graph) return;
  std::optional<DrawnGraph> graph = graph_around_last_cut(document);
  look_.graph = graph ? std::make_shared<DrawnGraph>(std::move(*graph)) : nullptr;
}

void OffscreenRenderer::show_bodies(const Document& document) {
  look_.bodies = gather_body_marks(document.world(), document.queue().physics(), look_.show);
}

void OffscreenRenderer::show_bodies_ahead(const World& world) {
  look_.bodies = body_marks_ahead(world, look_.show);
}

void OffscreenRenderer::draw(const World& world, const std::optional<BeamPicture>& beam) {
  const Target target{picture_.name(), 0, 0, picture_.shape().width, picture_.shape().height};
  renderer_.draw(world, view_, look_, beam, target);
  if (look_.show.shadow_reference) renderer_.draw_traced(world, view_, look_, target);
}

Status OffscreenRenderer::write(const std::filesystem::path& png) const {
  return write_png(read_pixels(picture_.name(), picture_.shape().width, picture_.shape().height), png);
}

Film::Film(OffscreenRenderer renderer, FilmOptions options, const World::Bounds& bounds)
    : renderer_(std::move(renderer)),
      options_(std::move(options)),
      middle_(bounds.min + (bounds.max - bounds.min) * 0.5),
      speed_(bounds.diagonal() / kSecondsAcross) {}

Result<Film> Film::begin(const Scene& scene, FilmOptions options, const Journal& journal) {
  KERF_ASSERT(options.frames_per_second > 0);
  auto renderer = OffscreenRenderer::open(scene, options.picture, journal);
  if (!renderer) return renderer.error();

  Film film(std::move(*renderer), std::move(options), scene.world.bounds());
  if (const Status rested = film.pass(kRest, scene.world, std::nullopt); !rested) return rested.error();
  return film;
}

Status Film::follow(const Document& document, const StepResult* step) {
  const World& world = document.world();
  renderer_.follow(world, step);
  renderer_.show_graph(document);
  renderer_.show_bodies(document);
  if (world.clock() > ticks_) return pass_ticks(document);
  ticks_ = world.clock();  // an undo turns it back
  if (step && step->last) {
    const double seconds = seconds_of(*step->last), shown = std::min(seconds, ahead_);
    ahead_ -= shown;
    beam_ = step->last->to;
    const auto beam = beam_picture(document, beam_);
    if (const Status moved = pass(seconds - shown, world, beam); !moved) return moved;
  }
  const bool rests = document.waiting() == 0 && !document.queue().in_stroke() && !is_in_motion(world);
  if (!rests) return Done{};
  ahead_ = 0;
  return pass(kRest, world, std::nullopt);
}

void Film::skip(const Document& document, const StepResult* step) {
  renderer_.follow(document.world(), step);
  renderer_.show_graph(document);
  renderer_.show_bodies(document);
  ticks_ = document.world().clock();
  ahead_ = 0;
}

Status Film::pass_ticks(const Document& document) {
  const double seconds = seconds_of_ticks(document.world().clock() - ticks_);
  ticks_ = document.world().clock();
  if (!document.queue().in_stroke()) return pass(seconds, document.world(), std::nullopt);
  ahead_ += seconds;
  return pass(seconds, document.world(), beam_picture(document, beam_));
}

Status Film::end(const Document& document) {
  const Status rested = pass(kRestAtEnd, document.world(), std::nullopt);
  return rested ? remove_later_frames(options_.folder, frames_) : rested;
}

double Film::seconds_of(const BeamMove& move) const {
  const double distance = glm::length(middle_ - move.from.origin);
  const double way = std::max(glm::length(move.to.origin - move.from.origin),
                              glm::length(at_distance(move.to, distance) - at_distance(move.from, distance)));
  return speed_ > 0 ? way / speed_ : 0;
}

std::optional<BeamPicture> Film::beam_picture(const Document& document, const Pose& beam) const {
  const double far = glm::length(middle_ - beam.origin) + kSecondsAcross * speed_;
  return picture_of_beam(document.world(), document.history().last_settings(), beam, far);
}

// Advances the film and writes the frames that are due.
Status Film::pass(double seconds, const World& world, const std::optional<BeamPicture>& beam) {
  KERF_ASSERT(seconds >= 0);
  clock_ += seconds;
  bool drawn = false;
  for (; static_cast<double>(frames_) < clock_ * options_.frames_per_second; ++frames_) {
    if (!drawn) renderer_.draw(world, beam);
    drawn = true;
    if (const Status written = renderer_.write(frame_file(options_.folder, frames_)); !written)
      return written;
  }
  return Done{};
}

}  // namespace kerf
