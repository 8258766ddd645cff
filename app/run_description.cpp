#include "app/run_description.h"

#include <algorithm>

#include "core/base/version.h"

namespace kerf {

namespace {

std::vector<std::string> command_words, named_inputs;
FileUnit mesh_unit = FileUnit::kMetre;

// Quotes a word for a shell if needed.
std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain = "-_./,:=+@%";
  const auto is_plain = [&](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
           kPlain.find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

std::string command_line() {
  std::string line = "kerf";
  for (size_t i = 1; i < command_words.size(); ++i) line += " " + shell_word(command_words[i]);
  return line;
}

}  // namespace

void record_command(std::vector<std::string> words) { command_words = std::move(words); }

void record_inputs(std::vector<std::string> files) { named_inputs = std::move(files); }

void record_mesh_unit(FileUnit unit) { mesh_unit = unit; }

nlohmann::ordered_json units_json() {
  return {{"length", "m"},     {"area", "m2"},       {"volume", "m3"},
          {"mass", "kg"},      {"inertia", "kg m2"}, {"energy", "J"},
          {"angle", "degree"}, {"time", "ms"},       {"mesh_files", unit_symbol(mesh_unit)}};
}

nlohmann::ordered_json with_run_description(const nlohmann::ordered_json& report) {
  nlohmann::ordered_json all = {
      {"version", kVersion}, {"command", command_line()}, {"inputs", named_inputs}, {"units", units_json()}};
  all.update(report);
  return all;
}

}  // namespace kerf
