#include "core/document/journal.h"

#include "core/document/document.h"
#include "core/document/journal_text.h"
#include "core/document/scene_text.h"
#include "core/document/text/fields.h"
#include "core/document/text/json.h"
#include "core/physics/physics.h"
#include "core/world/world.h"

namespace kerf {

namespace {

constexpr const char* kKind = "journal";

// The beam after a command that moves it; nullopt after other commands.
std::optional<BeamAt> beam_after(const Command& command) {
  using At = std::optional<BeamAt>;
  return std::visit(Overloaded{
                        [](const BeginStroke& c) -> At {
                          return BeamAt{c.pose, 0};
                        },
                        [](const MoveBeam& c) -> At {
                          return BeamAt{c.pose, c.time};
                        },
                        [](const auto&) -> At { return std::nullopt; },
                    },
                    command);
}

class JournalReader {
 public:
  JournalReader(const std::filesystem::path& file, std::string_view text)
      : file_(file), folder_(file.parent_path()), rest_(text) {}

  Result<Journal> read() {
    if (const auto head = read_head(); !head) return head.error();
    while (!rest_.empty()) {
      const bool torn = rest_.find('\n') == std::string_view::npos;
      const auto taken = take_line(next_line());
      if (taken) continue;
      journal_.torn = torn;
      journal_.damage = torn ? where() + ": the last line is incomplete and was ignored"
                             : taken.error().message + "; the journal was ignored from this line on";
      break;
    }
    return std::move(journal_);
  }

 private:
  std::string where() const { return file_.string() + ": line " + std::to_string(line_); }

  std::string_view next_line() {
    ++line_;
    const size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return line;
  }

  Status read_head() {
    nlohmann::json json = nlohmann::json::parse(next_line(), nullptr, false);
    if (!json.is_object() || json.value("kerf", nlohmann::json()) != kKind)
      return bad_input(where() + ": not a journal: the first line must have \"kerf\": \"journal\"");
    if (const Status format = check_format(json); !format) return format;
    for (const char* const key : {"kerf", "format", "program"}) json.erase(key);
    if (json.contains("work_of") && json["work_of"].is_string()) {
      journal_.work_of = json["work_of"].get<std::string>();
      json.erase("work_of");
    }
    if (json.contains("opened") && json["opened"].is_array()) {
      for (const nlohmann::json& file : json["opened"]) {
        if (file.is_string()) journal_.opened.emplace_back(file.get<std::string>());
      }
      json.erase("opened");
    }
    auto scene = parse_scene(JsonValue(json, where()), folder_);
    if (!scene) return scene.error();
    journal_.scene = std::move(*scene);
    return Done{};
  }

  Status check_format(const nlohmann::json& json) {
    const JsonValue head(json, where());
    Fields::Pass pass{folder_};
    Fields fields(head, pass);
    fields.format(kJournalFormat);
    return pass.status;
  }

  Status take_line(std::string_view line) {
    if (line.empty()) return Done{};
    const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
    const JsonValue value(json, where());
    if (!json.is_object()) return value.wrong("this is not a JSON object");
    return value.has("hash") ? take_mark(value) : take_command(value);
  }

  Status take_mark(const JsonValue& value) {
    StateMark mark{journal_.commands.size(), 0, line_};
    if (const Status read = read_fields(value, folder_, mark); !read) return read;
    journal_.marks.push_back(std::move(mark));
    return Done{};
  }

  Status take_command(const JsonValue& value) {
    auto command = parse_command(value, folder_, beam_);
    if (!command) return command.error();
    if (const auto beam = beam_after(*command)) beam_ = beam;
    journal_.commands.push_back(std::move(*command));
    return Done{};
  }

  const std::filesystem::path& file_;
  std::filesystem::path folder_;
  std::string_view rest_;
  size_t line_ = 0;
  std::optional<BeamAt> beam_;  // of the last stroke
  Journal journal_;
};

}  // namespace

Result<Journal> read_journal(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return JournalReader(file, *text).read();
}

Result<std::string> journal_head(const SceneDescription& scene, const std::filesystem::path& work_of,
                                 const std::filesystem::path& folder,
                                 std::span<const std::filesystem::path> opened) {
  nlohmann::ordered_json json{{"kerf", kKind}};
  json.update(visited_json(folder, [](Fields& f) { f.format(kJournalFormat); }));
  SceneDescription without_strokes = scene;
  without_strokes.strokes.clear();
  nlohmann::ordered_json described = scene_json(without_strokes, folder);
  described.erase("version");
  json.update(described);
  if (!work_of.empty()) json["work_of"] = path_text(work_of, {});
  for (const std::filesystem::path& file : opened) json["opened"].push_back(path_text(file, {}));
  for (const SceneBody& body : scene.bodies) {
    if (!body.hash)
      return bad_input(body.mesh.string() + ": a journal needs a mesh file that can be read again");
  }
  const auto text = dump_json(json);
  if (!text) return text.error();
  return *text + "\n";
}

Result<std::string> journal_lines(std::span<const Command> commands, std::span<const StateMark> marks,
                                  const std::filesystem::path& folder) {
  std::string lines;
  for (size_t i = 0;; ++i) {
    for (; !marks.empty() && marks.front().commands == i; marks = marks.subspan(1))
      lines += fields_json(marks.front(), folder).dump() + '\n';
    if (i == commands.size()) return lines;
    const auto line = command_text(commands[i], folder);
    if (!line) return line.error();
    lines += *line + '\n';
  }
}

StateMark state_mark(const Document& document) {
  KERF_ASSERT(!document.queue().in_stroke() && document.waiting() == 0);
  const World& world = document.world();
  StateMark mark{document.journal().size(), state_hash(world), 0, {}, moved_bodies(world)};
  if (!mark.bodies.empty()) {
    mark.machine = machine_kind();
    mark.pairs = known_pairs(world);
    mark.clock = world.clock();
  }
  return mark;
}

bool mark_state(Document& document, std::vector<StateMark>& marks, bool always) {
  const size_t commands = document.journal().size();
  const size_t last = marks.empty() ? 0 : marks.back().commands;
  const bool marked = !marks.empty() && last == commands;
  if (document.queue().in_stroke() || document.waiting() > 0 || marked) return false;
  if (!always && commands < last + kCommandsBetweenMarks) return false;
  document.seal_journal();
  marks.push_back(state_mark(document));
  return true;
}

bool is_journal(const std::filesystem::path& file) {
  return file.extension() == ".kerf" || file.extension() == ".kerf~";
}

Result<OpenedFile> open_journal(const std::filesystem::path& file, const Progress* progress) {
  auto journal = read_journal(file);
  if (!journal) return journal.error();
  auto scene = load_scene(journal->scene, progress);
  if (!scene) return scene.error();
  return OpenedFile{std::move(*scene), std::move(*journal)};
}

Result<OpenedFile> open_file(const std::filesystem::path& file, const Progress* progress) {
  if (is_journal(file)) return open_journal(file, progress);
  auto scene = read_scene(file, progress);
  if (!scene) return scene.error();
  return OpenedFile{std::move(*scene), {}};
}

}  // namespace kerf
