#include "core/document/journal.h"

#include <algorithm>

#include "core/base/geometry.h"
#include "core/document/document.h"
#include "core/document/text/fields.h"
#include "core/document/text/hash.h"
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

// Checks that a move continues from the beam, if there is one.
void check_follows(Fields& f, const MoveBeam& move, const std::optional<BeamAt>& beam) {
  const BeamAt before = beam.value_or(BeamAt{move.pose, 0});
  f.check(!are_opposite(before.pose.direction, move.pose.direction), "direction",
          "is opposite to the previous direction");
  f.check(move.time >= before.time, "t",
          f.present("t", false) ? "must not be less than the previous time"
                                : "needs \"t\", because the move before has one");
}

// The fields of a command and its name, which was read before.
template <typename C>
void fields_of(Fields& f, C& command, const std::optional<BeamAt>& beam) {
  std::string name = C::kName;
  f.text("do", name);
  if constexpr (!std::is_empty_v<C>) describe(f, command);
  if constexpr (std::is_same_v<C, MoveBeam>) check_follows(f, command, beam);
  f.end();
}

template <typename C>
Result<Command> read_command(const JsonValue& line, const std::filesystem::path& folder,
                             const std::optional<BeamAt>& beam) {
  C command;
  Fields::Pass pass{folder};
  Fields fields(line, pass);
  fields_of(fields, command, beam);
  if (!pass.status) return pass.status.error();
  return Command(std::move(command));
}

// Returns null if there is no such command.
template <typename... Kinds>
auto reader_of(std::variant<Kinds...>*, const std::string& name) {
  decltype(&read_command<Undo>) found = nullptr;
  ((name == Kinds::kName ? void(found = read_command<Kinds>) : void()), ...);
  return found;
}

template <typename... Kinds>
std::vector<std::string> names_of(std::variant<Kinds...>*) {
  return {Kinds::kName...};
}

using Json = nlohmann::ordered_json;

Status read_body(const JsonValue& value, BodyId& id) {
  const auto n = value.whole_numbers({2});
  if (!n) return value.wrong("must be two whole numbers: a body's slot and its generation");
  id = {n->front(), n->back()};
  return Done{};
}

Status read_pairs(const JsonValue& value, std::vector<NearPair>& pairs) {
  if (const Status list = value.array("pairs of bodies"); !list) return list;
  for (size_t i = 0; i < value.json().size(); ++i) {
    const auto n = value[i].whole_numbers({4, 6});
    if (!n) return value[i].wrong("must be four or six whole numbers: one body or two, and how they touch");
    NearPair& pair = pairs.emplace_back();
    pair.first = {(*n)[0], (*n)[1]};
    if (n->size() == 6) pair.second = {(*n)[2], (*n)[3]};
    pair.touching = (*n)[n->size() - 2] != 0;
    pair.crossed = n->back();
  }
  std::sort(pairs.begin(), pairs.end(), [](const NearPair& a, const NearPair& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
  return Done{};
}

Json pairs_json(const std::vector<NearPair>& pairs) {
  Json list = Json::array();
  for (const NearPair& p : pairs) {
    Json& entry = list.emplace_back(Json{p.first.slot, p.first.generation});
    if (p.second.valid()) entry.insert(entry.end(), {p.second.slot, p.second.generation});
    entry.insert(entry.end(), {p.touching ? 1 : 0, p.crossed});
  }
  return list;
}

// Returns true if bodies moved in time in a step of the history that is not undone.
bool have_bodies_moved(const Document& document) {
  if (document.world().clock() == 0) return false;
  const UndoStack& history = document.history();
  for (size_t i = 0; i < history.position(); ++i) {
    if (std::ranges::any_of(history.step(i).commands(), moves_bodies)) return true;
  }
  return false;
}

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
    for (; !marks.empty() && marks.front().commands == i; marks = marks.subspan(1)) {
      const auto mark = dump_json(fields_json(marks.front(), folder));
      if (!mark) return mark.error();
      lines += *mark + '\n';
    }
    if (i == commands.size()) return lines;
    const auto line = command_text(commands[i], folder);
    if (!line) return line.error();
    lines += *line + '\n';
  }
}

StateMark state_mark(const Document& document) {
  KERF_ASSERT(!document.queue().in_stroke() && document.waiting() == 0);
  const World& world = document.world();
  const bool in_time = have_bodies_moved(document);
  StateMark mark{document.journal().size(), state_hash(world), 0, {}, moved_bodies(world, in_time)};
  mark.looks = looks_hash(world);
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

void mark_group(Document& document, std::vector<StateMark>& marks, size_t from, size_t to, std::string name) {
  KERF_ASSERT(from < to);
  document.seal_journal();
  StateMark& mark = marks.emplace_back(state_mark(document));
  mark.group_from = from;
  mark.group_to = to;
  mark.group = std::move(name);
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

Result<OpenedFile> open_file(const std::filesystem::path& file, const Progress* progress, FileUnit unit) {
  if (is_journal(file)) return unit == FileUnit::kMetre ? open_journal(file, progress) : states_units(file);
  auto scene = read_scene(file, progress, unit);
  if (!scene) return scene.error();
  return OpenedFile{std::move(*scene), {}};
}

Result<std::string> command_text(const Command& command, const std::filesystem::path& folder) {
  return std::visit(
      [&](auto c) {
        return exact_text(visited_json(folder, [&](Fields& f) { fields_of(f, c, std::nullopt); }));
      },
      command);
}

Result<Command> parse_command(const JsonValue& value, const std::filesystem::path& folder,
                              const std::optional<BeamAt>& beam) {
  if (!value.has("do")) return value.wrong("needs \"do\"");
  const auto name = value["do"].text();
  if (!name) return name.error();
  const auto read = reader_of(static_cast<Command*>(nullptr), *name);
  if (read == nullptr)
    return value["do"].wrong("\"" + *name + "\" is not a command of this version" +
                             nearest_name_hint(*name, names_of(static_cast<Command*>(nullptr))));
  return read(value, folder, beam);
}

static void describe(Fields& f, BodyState& state) {
  f.value(
      "body", [&](const JsonValue& value) { return read_body(value, state.id); },
      [&] {
        return Json{state.id.slot, state.id.generation};
      });
  describe(f, state.placement);
  f.vector("velocity", state.motion.velocity);
  f.vector("spin", state.motion.spin);
  f.whole("quiet", state.motion.quiet, 0, kNoIndex - 1);
  f.flag("asleep", state.motion.asleep);
}

void describe(Fields& f, StateMark& mark) {
  f.coded("hash", mark.hash, parse_hash, hash_text, kHashRule);
  f.coded("looks", mark.looks, parse_hash, hash_text, kHashRule);
  if (f.present("group", mark.group_from < mark.group_to)) {
    f.filled_text("group", mark.group);
    f.whole("group-from", mark.group_from, 0, std::numeric_limits<size_t>::max());
    f.whole("group-to", mark.group_to, mark.group_from, std::numeric_limits<size_t>::max());
  }
  if (!f.reading() && mark.bodies.empty()) return;
  f.text("machine", mark.machine, kOptional);
  f.whole("clock", mark.clock, 0, std::numeric_limits<Ticks>::max(), kOptional);
  f.list("bodies", "bodies", mark.bodies, kOptional);
  f.value(
      "pairs", [&](const JsonValue& value) { return read_pairs(value, mark.pairs); },
      [&] { return pairs_json(mark.pairs); }, kOptional);
}

}  // namespace kerf
