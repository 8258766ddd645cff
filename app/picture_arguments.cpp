#include "app/picture_arguments.h"

#include <algorithm>
#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/parse_values.h"

namespace kerf {

void PictureArguments::add_to(CLI::App& command) {
  command.add_option("--size", size, "Width and height in pixels, WxH (1280x720)");
  command.add_option("--eye", eye, "Where the camera stands, x,y,z in metres");
  command.add_option("--target", target, "What it looks at, x,y,z in metres");
  command.add_option("--section", section,
                     "Draws what lies under a plane alone: its point and its normal, \"x,y,z x,y,z\", as the "
                     "editor copies them");
  command.add_option(
      "--show", show,
      "Overlays, separated by commas (shadows, unless the scene says otherwise): " + offered_show_names());
}

Result<PictureOptions> PictureArguments::parse() const {
  PictureOptions options;
  const auto pixels = parse_size(size);
  if (!pixels) return pixels.error();
  options.width = pixels->width;
  options.height = pixels->height;
  if (!eye.empty()) {
    if (const Status s = unpack(parse_point("--eye", eye), options.eye); !s) return s.error();
  }
  if (!target.empty()) {
    if (const Status s = unpack(parse_point("--target", target), options.target); !s) return s.error();
  }
  if (const Status s = unpack(parse_show_list(show), options.show); !s) return s.error();
  if (!section.empty()) {
    const auto plane = parse_section(section);
    if (!plane) return bad_input("--section: " + plane.error().message);
    options.section = *plane;
  }
  return options;
}

Status show_as_asked(const PictureArguments& arguments, const Scene& scene, const std::string& file,
                     PictureOptions& options) {
  if (arguments.show.empty()) {
    const auto wanted = parse_show_list(scene.show);
    if (!wanted) return bad_input(file + ": /show: " + wanted.error().message);
    options.show = scene.show.empty() ? default_show() : *wanted;
  }
  options.show.section = options.show.section || options.section.has_value();
  return Done{};
}

Status check_picture_name(const std::string& option, const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (ending.empty() || ending == ".png") return Done{};
  return bad_input(option + ": " + file +
                   ": pictures are written as PNG only; choose a name that ends in .png");
}

}  // namespace kerf
