#pragma once

#include <string>

#include "ui/render/picture/picture.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace kerf {

// The options of the command line for rendering a picture.
struct PictureArguments {
  std::string size = "1280x720", eye, target, section, show;

  // Adds the options to a subcommand; parsing fills this object.
  void add_to(CLI::App& command);
  // Checks the options. The error names the first wrong one.
  Result<PictureOptions> parse() const;
};

// If the command line does not say what to show, sets what the scene asks for, or if that does not say it
// either, what the editor shows at first. The error names `file`, the scene's file.
Status show_as_asked(const PictureArguments& arguments, const Scene& scene, const std::string& file,
                     PictureOptions& options);

// Checks that a file for a picture does not have the ending of another format: only PNG is written.
Status check_picture_name(const std::string& option, const std::string& file);

}  // namespace kerf
