#include "ui/render/picture/studio.h"

#include "core/document/history/last_cut_graph.h"
#include "ui/render/bodies/body_marks.h"
#include "ui/render/picture/png.h"

namespace kerf {

namespace {

constexpr int kLargestSide = 16384;

CameraView chosen_view(const PictureOptions& options, const std::optional<View>& scene,
                       const World::Bounds& bounds) {
  const double aspect = static_cast<double>(options.width) / options.height;
  const Vec3 middle = bounds.min + (bounds.max - bounds.min) * 0.5;
  if (options.eye) return look_at(*options.eye, options.target.value_or(middle), aspect);
  if (scene) return look_at(scene->eye, options.target.value_or(scene->target), aspect);
  Camera camera;
  camera.frame_default(bounds, aspect);
  camera.finish();
  const CameraView view = camera.view(aspect);
  return options.target ? look_at(view.eye, *options.target, aspect) : view;
}

}  // namespace

Studio::Studio(gl::OffscreenContext context, gl::Framebuffer picture, Renderer renderer)
    : context_(std::move(context)), picture_(std::move(picture)), renderer_(std::move(renderer)) {}

Result<Studio> Studio::open(const Scene& scene, const PictureOptions& options) {
  if (std::min(options.width, options.height) < 1 || std::max(options.width, options.height) > kLargestSide) {
    return bad_input("the size of a picture must be from 1x1 to " + std::to_string(kLargestSide) + "x" +
                     std::to_string(kLargestSide));
  }
  auto context = gl::OffscreenContext::create();
  if (!context) return context.error();
  gl::Framebuffer picture({options.width, options.height, 1, false});
  if (!picture.complete())
    return failed("OpenGL has no room for a picture of this size; choose a smaller one");
  auto renderer = Renderer::create();
  if (!renderer) return renderer.error();

  Studio studio(std::move(*context), std::move(picture), std::move(*renderer));
  studio.renderer_.show(scene.world, scene.paints);
  studio.view_ = chosen_view(options, scene.view, scene.world.bounds());
  studio.look_.show = options.show;
  studio.look_.section =
      options.section.value_or(section_through(scene.world.bounds(), -studio.view_.forward));
  studio.look_.antialias = options.antialias;
  studio.look_.mark_scale = options.mark_scale;
  studio.look_.legends = options.legends;
  if (!scene.lights.empty()) studio.look_.lights = scene.lights;
  return studio;
}

void Studio::follow(const World& world, const StepResult* step) {
  if (step == nullptr) return renderer_.resend(world);
  renderer_.follow(world, step->delta);
  if (look_.show.face_numbers) renderer_.send_faces(world);
}

void Studio::show_graph(const Document& document) {
  if (!look_.show.graph) return;
  std::optional<DrawnGraph> graph = graph_around_last_cut(document);
  look_.graph = graph ? std::make_shared<DrawnGraph>(std::move(*graph)) : nullptr;
}

void Studio::show_bodies(const Document& document) {
  look_.bodies = gather_body_marks(document.world(), document.execution().physics(), look_.show);
}

void Studio::show_bodies_ahead(const World& world) { look_.bodies = body_marks_ahead(world, look_.show); }

void Studio::draw(const World& world, const std::optional<BeamPicture>& beam) {
  const Target target{picture_.name(), 0, 0, picture_.shape().width, picture_.shape().height};
  renderer_.draw(world, view_, look_, beam, target);
  if (look_.show.shadow_reference) renderer_.draw_traced(world, view_, look_, target);
}

Status Studio::write(const std::filesystem::path& png) const {
  return write_png(read_pixels(picture_.name(), picture_.shape().width, picture_.shape().height), png);
}

}  // namespace kerf
