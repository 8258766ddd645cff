#include "ui/render/picture.h"

#include "ui/gl/debug_output.h"
#include "ui/gl/framebuffer.h"
#include "ui/gl/offscreen_context.h"
#include "ui/render/png.h"
#include "ui/render/renderer.h"
#include "ui/render/scene_strokes.h"

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

Status render_picture(Scene scene, const PictureOptions& options, const std::filesystem::path& png) {
  if (std::min(options.width, options.height) < 1 || std::max(options.width, options.height) > kLargestSide) {
    return bad_input("the size of a picture must be from 1x1 to " + std::to_string(kLargestSide) + "x" +
                     std::to_string(kLargestSide));
  }
  auto context = gl::OffscreenContext::create();
  if (!context) return context.error();
  gl::report_gl_errors();
  const gl::Framebuffer picture({options.width, options.height, 1, false});
  if (!picture.complete())
    return failed("OpenGL has no room for a picture of this size; choose a smaller one");
  auto renderer = Renderer::create();
  if (!renderer) return renderer.error();

  renderer->show(scene.world, scene.paints);
  const CameraView view = chosen_view(options, scene.view, scene.world.bounds());
  Document document(std::move(scene.world));
  const Status cut = cut_strokes(document, scene.strokes, [&](const StepResult& step) {
    renderer->follow(step.delta);
    if (options.show.face_numbers) renderer->catch_up(document.world());
  });
  if (!cut) return cut.error();

  ViewOptions look;
  look.show = options.show;
  look.antialias = options.antialias;
  if (!scene.lights.empty()) look.lights = scene.lights;
  const Target target{picture.name(), 0, 0, options.width, options.height};
  renderer->draw(document.world(), view, look, std::nullopt, target);
  if (options.show.shadow_reference) renderer->draw_traced(document.world(), view, look, target);
  return write_png(read_pixels(picture.name(), options.width, options.height), png);
}

}  // namespace kerf
