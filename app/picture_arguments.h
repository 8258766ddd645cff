#pragma once

#include <string>

#include "ui/render/picture.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace kerf {

// What a command line says of how pictures are taken.
struct PictureArguments {
  std::string size = "1280x720", eye, target, show;

  void add_to(CLI::App& command);
  Result<PictureOptions> parse() const;
};

// Sets what is shown where the command line names nothing: what the scene in `file` asks for.
Status show_as_asked(const PictureArguments& arguments, const Scene& scene, const std::string& file,
                     PictureOptions& options);

}  // namespace kerf
