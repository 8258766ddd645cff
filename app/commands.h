#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "core/base/result.h"

namespace kerf {

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
