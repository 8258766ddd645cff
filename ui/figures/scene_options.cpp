#include "ui/figures/scene_options.h"

namespace kerf {

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

}  // namespace kerf
