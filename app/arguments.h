#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>

#include "core/base/geometry.h"
#include "core/base/number_format.h"
#include "core/base/result.h"
#include "core/cut/knife.h"
#include "core/mesh/files/mesh_format.h"
#include "ui/render/picture.h"

namespace kerf {

// Image size in pixels.
struct PixelSize {
  int width = 0, height = 0;
};

// Parses "WxH", each number from 1 to 16384.
Result<PixelSize> parse_size(const std::string& text);

// Parses "x,y,z", three finite numbers. The error names `option`.
Result<Vec3> parse_point(const std::string& option, const std::string& text);

// Parses "NX,NY,NZ,D", the plane of the points x with N.x = D [m]; the error names --plane.
Result<KnifePlane> parse_plane(const std::string& text);

// Returns true and sets `value` if the text is one finite number.
bool parse_number(std::string_view text, double& value);

// Returns "" if the text is a number within the range, else what it must be.
std::string check_number(const std::string& text, const NumberRange& range, bool whole);

// Removes leading zeros of a whole number: CLI11 reads such numbers as octal.
std::string without_leading_zeros(std::string text);

// Returns the absolute path of a file, which need not exist, without links; the given path if it is invalid.
std::filesystem::path resolved(const std::filesystem::path& file);

// Returns the help of an option with the limits appended.
std::string help_with_limits(const std::string& help, const NumberRange& range);

template <typename T>
struct NumberOf {
  using Type = T;
};
template <typename T>
struct NumberOf<std::optional<T>> {
  using Type = T;
};

// Adds an option for a number, optional or not. Its help ends with the limits, and parsing rejects values
// outside them.
template <typename T>
CLI::Option* add_number(CLI::App& command, const std::string& name, T& x, const NumberRange& range,
                        const std::string& help) {
  constexpr bool kWhole = std::is_integral_v<typename NumberOf<T>::Type>;
  CLI::Option* const option = command.add_option(name, x, help_with_limits(help, range));
  if (kWhole) option->transform(without_leading_zeros);
  return option->check([range](const std::string& text) { return check_number(text, range, kWhole); });
}

// Adds the option --unit for mesh files that state no unit; parsing fills `unit`.
void add_unit_option(CLI::App& command, std::string& unit);
// Parses the value of --unit; the error lists the values.
Result<FileUnit> parse_unit(const std::string& unit);

// Command line options for rendering an image.
struct PictureArguments {
  std::string size = "1280x720", eye, target, section, show;

  // Adds the options to a subcommand. Parsing fills this object, and rejects the options without `needed`,
  // unless that is null.
  void add_to(CLI::App& command, CLI::Option* needed = nullptr);
  // Checks the options. The error names the first wrong one.
  Result<PictureOptions> parse() const;
};

// Sets the overlays if --show is not given: those of the scene or, if it has none, the defaults of the
// editor. The error names `file`, the file of the scene.
Status show_as_asked(const PictureArguments& arguments, const Scene& scene, const std::string& file,
                     PictureOptions& options);

// Checks that the extension of an image file is .png or missing.
Status check_picture_name(const std::string& option, const std::string& file);

// The work of the given subcommand, which sets it during parsing; called after parsing.
using Invocation = std::function<Status()>;

// Makes a subcommand set `invocation` to `run`, and ends its help with an example that works from the root of
// the checkout. `invocation` must outlive parsing.
inline void on_call(CLI::App& command, Invocation& invocation, Invocation run, const std::string& example) {
  const std::string footer = command.get_footer();
  command.footer(footer + (footer.empty() ? "" : "\n\n") + "Example:\n  " + example);
  command.callback([&invocation, asked = std::move(run)] { invocation = asked; });
}

// Each function adds its subcommand, which is one source file, one line here and one in main.cpp. `app` and
// `invocation` must outlive parsing.
void add_info_command(CLI::App& app, Invocation& invocation);
void add_cut_command(CLI::App& app, Invocation& invocation);
void add_path_command(CLI::App& app, Invocation& invocation);
void add_compare_command(CLI::App& app, Invocation& invocation);
void add_inspect_command(CLI::App& app, Invocation& invocation);
void add_render_command(CLI::App& app, Invocation& invocation);
void add_replay_command(CLI::App& app, Invocation& invocation);
void add_figures_command(CLI::App& app, Invocation& invocation);
void add_play_command(CLI::App& app, Invocation& invocation);
void add_prepare_command(CLI::App& app, Invocation& invocation);
void add_materials_command(CLI::App& app, Invocation& invocation);
// Adds the editor, which runs if no subcommand is given.
void add_editor(CLI::App& app, Invocation& invocation);

}  // namespace kerf
