#include <malloc.h>
#include <CLI/CLI.hpp>

#include <csignal>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/threads.h"

namespace {

int parse_and_run(int argc, char** argv) {
  CLI::App app("Kerf: a laser drills through any triangle mesh, live.", "kerf");
  app.set_version_flag("--version", "kerf " KERF_VERSION);
  app.set_help_flag("--help", "Show this help");
  kerf::Invocation invocation;
  kerf::add_editor(app, invocation);
  kerf::add_info_command(app, invocation);
  kerf::add_cut_command(app, invocation);
  kerf::add_inspect_command(app, invocation);
  kerf::add_render_command(app, invocation);
  kerf::add_replay_command(app, invocation);
  kerf::add_figures_command(app, invocation);
  kerf::add_play_command(app, invocation);
  kerf::add_prepare_command(app, invocation);
  kerf::add_materials_command(app, invocation);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    return app.exit(asked);
  } catch (const CLI::ParseError& wrong) {
    return kerf::report_error(kerf::bad_input(std::string(wrong.what()) + " (see kerf --help)"));
  }
  const auto threads = kerf::threads_of_environment();
  if (!threads) return kerf::report_error(threads.error());
  return invocation();
}

}  // namespace

int main(int argc, char** argv) {
  // An exceeded quota and a closed pipe are reported as failed writes instead of ending the program by a
  // signal.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  // A fixed threshold returns large arrays to the system when they are freed; glibc would raise it otherwise.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  try {
    return parse_and_run(argc, argv);
  } catch (const std::bad_alloc&) {
    return kerf::report_error(kerf::failed("there is not enough memory for this"));
  } catch (const std::exception& fault) {
    return kerf::report_error(kerf::failed(std::string("stopped by an unexpected fault: ") + fault.what()));
  }
}
