#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/document/journal.h"
#include "core/document/material_table.h"
#include "core/document/save.h"
#include "core/document/scene.h"
#include "core/document/stroke_path.h"
#include "core/game/arena/arena.h"
#include "core/game/match/recording.h"
#include "core/game/match/rules.h"
#include "core/game/vehicle/vehicle_model.h"
#include "ui/editor/shared/settings.h"
#include "ui/figures/figure.h"

namespace kerf::fuzz {
namespace {

namespace fs = std::filesystem;

void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "kerf: broken: %s\n", what.c_str());
  std::abort();
}

// A folder of this process, on a disk of memory where there is one.
const fs::path& folder() {
  static const fs::path made = [] {
    const fs::path memory = "/dev/shm";
    const fs::path base = fs::is_directory(memory) ? memory : fs::temp_directory_path();
    const fs::path own = base / ("kerf-fuzz-" + std::to_string(::getpid()));
    fs::create_directories(own);
    std::atexit([] { fs::remove_all(folder()); });
    return own;
  }();
  return made;
}

template <typename T>
void check_outcome(const Result<T>& result) {
  if (result) return;
  const Error& error = result.error();
  require(!error.message.empty(), "an error without a sentence");
  require(error.message.find_first_of("\r\n") == std::string::npos, "an error of several lines");
  require(error.code == ErrorCode::kBadInput, "an error that is not of the input: " + error.message);
}

void check_scene(const fs::path& file) { check_outcome(read_description(file)); }

// What was read is written, and read again the same.
void check_path(const fs::path& file) {
  const auto strokes = read_path_file(file);
  check_outcome(strokes);
  if (!strokes) return;
  const fs::path again = folder() / "again.json";
  require(save_path(again, *strokes).ok(), "a path that cannot be written");
  const auto back = read_path_file(again);
  require(back.ok() && back->size() == strokes->size(), "a path that is not read back");
  for (size_t i = 0; i < strokes->size(); ++i) {
    require((*back)[i].times == (*strokes)[i].times && (*back)[i].keys.size() == (*strokes)[i].keys.size(),
            "other keys when read back");
    for (size_t k = 0; k < (*strokes)[i].keys.size(); ++k)
      require((*back)[i].keys[k].origin == (*strokes)[i].keys[k].origin, "another origin when read back");
  }
}

void check_journal(const fs::path& file) {
  const auto journal = read_journal(file);
  check_outcome(journal);
  if (!journal) return;
  require(journal->damage.find_first_of("\r\n") == std::string::npos, "damage told in several lines");
  const auto lines = journal_lines(journal->commands, journal->marks, folder());
  require(lines.ok(), "commands that cannot be written");
  const fs::path again = folder() / "again.kerf";
  std::ofstream(again, std::ios::binary)
      << R"({"kerf":"journal","format":1,"program":"0.2.0","bodies":[]})" << '\n'
      << *lines;
  const auto back = read_journal(again);
  if (!back) return;  // a journal without bodies
  require(back->commands.size() == journal->commands.size() && back->damage.empty(),
          "commands that are not read back: " + back->damage);
}

void check_materials(const fs::path& file) { check_outcome(load_materials(file)); }
void check_arena(const fs::path& file) { check_outcome(read_arena(file)); }
void check_rules(const fs::path& file) { check_outcome(read_rules(file)); }
void check_vehicle(const fs::path& file) { check_outcome(read_vehicle(file)); }
void check_recording(const fs::path& file) {
  const auto recording = read_recording(file);
  check_outcome(recording);
  if (recording) require(recording_text(*recording, folder()).ok(), "a recording that cannot be written");
}

void check_figures(const fs::path& file) { check_outcome(read_figures(file)); }

// Settings are never a reason not to start; what was read is written, and read again the same.
void check_settings(const fs::path& file) {
  const LoadedSettings loaded = read_settings(file);
  require(loaded.fault.find_first_of("\r\n") == std::string::npos, "a fault told in several lines");
  const fs::path again = folder() / "again.json";
  require(write_settings(loaded.settings, again).ok(), "settings that cannot be written");
  const LoadedSettings back = read_settings(again);
  require(back.fault.empty(), "settings that are not read back: " + back.fault);
  require(back.settings == loaded.settings, "other settings when read back");
}

struct Kind {
  const char* name;
  void (*check)(const fs::path&);
};
// By the first byte of an input, a digit, the remainder of which is the file.
constexpr std::array<Kind, 10> kKinds{{{"scene.json", check_scene},
                                       {"path.json", check_path},
                                       {"journal.kerf", check_journal},
                                       {"materials.json", check_materials},
                                       {"arena.json", check_arena},
                                       {"rules.json", check_rules},
                                       {"vehicle.json", check_vehicle},
                                       {"match.kerf", check_recording},
                                       {"settings.json", check_settings},
                                       {"figures.json", check_figures}}};

}  // namespace
}  // namespace kerf::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {  // NOLINT: libFuzzer's name
  if (size == 0) return 0;
  const auto& kind = kerf::fuzz::kKinds[static_cast<uint8_t>(data[0] - '0') % kerf::fuzz::kKinds.size()];
  const auto file = kerf::fuzz::folder() / kind.name;
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data + 1), static_cast<std::streamsize>(size - 1));
  kind.check(file);
  return 0;
}
