#pragma once

#include <functional>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace kerf {

// What a command line asks for; set by the subcommand that was given, run after parsing. Returns the exit
// status.
using Action = std::function<int()>;

// Each adds its subcommand to the command line. One pair of files a command, one line in commands.cpp.
void add_info_command(CLI::App& app, Action& action);
void add_cut_command(CLI::App& app, Action& action);
void add_render_command(CLI::App& app, Action& action);
void add_replay_command(CLI::App& app, Action& action);

// The editor is what runs without a subcommand.
void add_editor(CLI::App& app, Action& action);

}  // namespace kerf
