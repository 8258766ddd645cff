#include <malloc.h>
#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string_view>

#include "app/arguments.h"
#include "app/console.h"
#include "app/run_description.h"
#include "app/version.h"
#include "core/base/parallel.h"
#include "core/document/text/json.h"
#include "core/mesh/files/scanner.h"
#include "core/tree/walks.h"
#include "ui/screen/stop_signals.h"

namespace {

// Prints the error on standard error and returns the exit status: 130 or 143 after Ctrl-C or SIGTERM, 2 for
// bad input, 1 for any other failure.
int report_error(const kerf::Error& error) {
  std::cerr << "kerf: " << kerf::one_line(kerf::with_stream_names(error.message)) << '\n';
  if (kerf::interrupted()) return kerf::interrupt_status();
  return error.code == kerf::ErrorCode::kBadInput ? 2 : 1;
}

// Returns the limit in the environment variable KERF_THREADS, if set. Fails if it is not a whole number from
// 1 to 1024.
kerf::Result<std::optional<kerf::ThreadLimit>> threads_of_environment() {
  constexpr size_t kMost = 1024;
  const char* value = std::getenv("KERF_THREADS");
  if (value == nullptr) return std::optional<kerf::ThreadLimit>();
  const std::string_view text = value;
  size_t threads = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), threads);
  if (fault != std::errc() || end != text.data() + text.size() || threads < 1 || threads > kMost)
    return kerf::bad_input("the environment variable KERF_THREADS must be a whole number from 1 to 1024");
  return std::optional(kerf::ThreadLimit(threads));
}

// Fails if the environment variable KERF_SIMD names no instruction set of this processor.
kerf::Status check_simd_of_environment() {
  const char* value = std::getenv("KERF_SIMD");
  if (value == nullptr) return kerf::Done{};
  const auto simd = kerf::simd_named(value);
  if (!simd) return kerf::bad_input("the environment variable KERF_SIMD must be plain, sse4 or avx2");
  if (!kerf::is_supported(*simd))
    return kerf::bad_input("the environment variable KERF_SIMD is " + std::string(value) +
                           ", which this processor does not support; set it to plain, or not at all");
  return kerf::Done{};
}

// Returns the given command for a hint at its help: "kerf cut", or "kerf" without one.
std::string asked_of(const CLI::App& app) {
  std::string name = app.get_name();
  for (const CLI::App* command : app.get_subcommands()) name += " " + command->get_name();
  return name;
}

// Returns the error of an invalid command line, with the nearest option to a misspelt one.
kerf::Error parse_error(const CLI::App& app, const CLI::ParseError& wrong) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  std::vector<std::string> unknown = app.remaining(true), names;
  std::erase_if(unknown, [](const std::string& word) { return !word.starts_with("--"); });
  for (const CLI::Option* option : command->get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  const std::string hint =
      unknown.size() == 1 ? kerf::nearest_name_hint(unknown[0].substr(0, unknown[0].find('=')), names) : "";
  return kerf::bad_input(std::string(wrong.what()) + hint + " (see " + asked_of(app) + " --help)");
}

// Fails if an option or an argument is empty, such as the value of an unset variable of a shell.
kerf::Status check_no_empty_words(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  for (const CLI::Option* option : command->get_options()) {
    if (std::ranges::find(option->results(), "") != option->results().end())
      return kerf::bad_input(option->get_name() + ": must not be empty (see " + asked_of(app) + " --help)");
  }
  return kerf::Done{};
}

// Turns "help COMMAND" into "COMMAND --help". Fails for an unknown command.
kerf::Status rewrite_help(const CLI::App& app, std::vector<std::string>& arguments) {
  arguments.erase(arguments.begin());
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (!arguments.empty() && !arguments[0].starts_with('-') &&
      std::ranges::find(names, arguments[0]) == names.end())
    return kerf::bad_input("help: \"" + arguments[0] + "\" is not a command" +
                           kerf::nearest_name_hint(arguments[0], names) + " (see kerf --help)");
  arguments.emplace_back("--help");
  return kerf::Done{};
}

int parse_and_run(int argc, char** argv) {
  CLI::App app("Kerf: cut triangle meshes with a laser, live.", "kerf");
  app.get_formatter()->column_width(34);  // the longest option with its argument and what it needs
  app.set_version_flag("-V,--version", kerf::version_text());
  app.set_help_flag("-h,--help", "Show this help");
  app.footer("kerf help COMMAND shows the options of a command.");
  kerf::Invocation invocation;
  kerf::add_editor(app, invocation);
  kerf::add_info_command(app, invocation);
  kerf::add_cut_command(app, invocation);
  kerf::add_path_command(app, invocation);
  kerf::add_compare_command(app, invocation);
  kerf::add_inspect_command(app, invocation);
  kerf::add_render_command(app, invocation);
  kerf::add_replay_command(app, invocation);
  kerf::add_figures_command(app, invocation);
  kerf::add_play_command(app, invocation);
  kerf::add_prepare_command(app, invocation);
  kerf::add_materials_command(app, invocation);
  for (CLI::App* command : app.get_subcommands({}))
    command->add_flag_callback("-q,--quiet", kerf::set_quiet, "Print no progress and no summary");
  kerf::record_command({argv, argv + argc});
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  if (!arguments.empty() && arguments.front() == "help") {
    if (const kerf::Status s = rewrite_help(app, arguments); !s) return report_error(s.error());
  }
  // CLI11 takes the last argument first.
  std::reverse(arguments.begin(), arguments.end());
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::Success& asked) {  // --help, --version
    app.exit(asked);
    const kerf::Status written = kerf::flush_output();
    return written ? 0 : report_error(written.error());
  } catch (const CLI::ParseError& wrong) {
    return report_error(parse_error(app, wrong));
  }
  if (const kerf::Status s = check_no_empty_words(app); !s) return report_error(s.error());
  const auto threads = threads_of_environment();
  if (!threads) return report_error(threads.error());
  if (const kerf::Status s = check_simd_of_environment(); !s) return report_error(s.error());
  const kerf::Status done = invocation();
  if (!done) return report_error(done.error());
  return kerf::StopSignals::last() != 0 ? kerf::kSignalStatus + kerf::StopSignals::last() : 0;
}

}  // namespace

int main(int argc, char** argv) {
  kerf::open_standard_streams();
  // An exceeded quota and a closed pipe become failed writes instead of signals.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  kerf::end_on_interrupt();
  // A fixed threshold returns large arrays to the system when they are freed; glibc would raise it otherwise.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  // Keeps the memory that a software renderer frees and allocates again with each frame.
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
  try {
    return parse_and_run(argc, argv);
  } catch (const std::bad_alloc&) {
    return report_error(kerf::failed("out of memory"));
  } catch (const std::exception& fault) {
    return report_error(kerf::failed(std::string("unexpected error: ") + fault.what()));
  }
}
