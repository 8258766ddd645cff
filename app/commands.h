#pragma once

#include <functional>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace kerf {

// What the command line asks for: set by the subcommand that was given and called after parsing. Returns the
// exit status.
using Invocation = std::function<int()>;

// Each function adds its subcommand to the command line. A subcommand consists of one source file, one line
// here and one line in main.cpp. `app` and `invocation` must outlive parsing.
void add_info_command(CLI::App& app, Invocation& invocation);
void add_cut_command(CLI::App& app, Invocation& invocation);
void add_inspect_command(CLI::App& app, Invocation& invocation);
void add_render_command(CLI::App& app, Invocation& invocation);
void add_replay_command(CLI::App& app, Invocation& invocation);
void add_figures_command(CLI::App& app, Invocation& invocation);
void add_play_command(CLI::App& app, Invocation& invocation);
void add_prepare_command(CLI::App& app, Invocation& invocation);
void add_materials_command(CLI::App& app, Invocation& invocation);

// Adds the editor, which runs when no subcommand is given.
void add_editor(CLI::App& app, Invocation& invocation);

}  // namespace kerf
