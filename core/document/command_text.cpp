#include "core/document/command_text.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/document/exact_number.h"
#include "core/document/scene_text.h"
#include "core/document/settings_text.h"

namespace kerf {

namespace {

constexpr double kUnitSlack = 1e-9;  // of a squared length that should be 1
constexpr double kOpposite = 1e-9;   // length of the sum of two unit directions that turn straight round

void add_numbers(std::string& text, const char* key, std::initializer_list<double> numbers) {
  text += std::string(",\"") + key + "\":";
  char before = '[';
  for (const double x : numbers) {
    text += before;
    append_number(text, x);
    before = ',';
  }
  text += ']';
}

void add_vector(std::string& text, const char* key, const Vec3& v) {
  add_numbers(text, key, {v.x, v.y, v.z});
}

void add_pose(std::string& text, const Pose& pose) {
  add_vector(text, "origin", pose.origin);
  add_vector(text, "direction", pose.direction);
}

void add_piece(std::string& text, const PieceId& piece) {
  text += ",\"piece\":[" + std::to_string(piece.body.slot) + ',';
  if (piece.body.generation != BodyId::kUnknownGeneration)
    text += std::to_string(piece.body.generation) + ',';
  text += std::to_string(piece.label) + ']';
}

Status add_text(std::string& text, const char* key, const std::string& value) {
  const auto quoted = dump_json(nlohmann::ordered_json(value));
  if (!quoted) return quoted.error();
  text += std::string(",\"") + key + "\":" + *quoted;
  return Done{};
}

// Writes what stands behind "do", and says what stands there.
struct Writer {
  const std::filesystem::path& folder;
  std::string& text;
  Status status = Done{};

  const char* operator()(const BeginStroke& c) {
    text += ",\"settings\":" + settings_text(c.settings);
    add_pose(text, c.pose);
    return "begin";
  }
  const char* operator()(const MoveStroke& c) {
    add_pose(text, c.pose);
    return "move";
  }
  const char* operator()(const EndStroke&) { return "end"; }
  const char* operator()(const Recut& c) {
    text += ",\"settings\":" + settings_text(c.settings);
    return "recut";
  }
  const char* operator()(const AddMesh& c) {
    status = add_text(text, "mesh", path_text(c.file, folder));
    if (status) status = add_text(text, "name", c.name);
    return "add-mesh";
  }
  const char* operator()(const MovePiece& c) {
    add_piece(text, c.piece);
    add_vector(text, "position", c.to.position);
    const glm::dquat& q = c.to.orientation;
    add_numbers(text, "orientation", {q.w, q.x, q.y, q.z});
    return "move-piece";
  }
  const char* operator()(const HidePiece& c) {
    add_piece(text, c.piece);
    text += c.hidden ? ",\"hidden\":true" : ",\"hidden\":false";
    return "hide-piece";
  }
  const char* operator()(const DeletePiece& c) {
    add_piece(text, c.piece);
    return "delete-piece";
  }
  const char* operator()(const RenamePiece& c) {
    add_piece(text, c.piece);
    status = add_text(text, "name", c.name);
    return "rename-piece";
  }
  const char* operator()(const Undo&) { return "undo"; }
  const char* operator()(const Redo&) { return "redo"; }
};

// What parse needs besides the line itself.
struct Context {
  const JsonValue& line;
  const std::filesystem::path& folder;
  const std::optional<Pose>& last;
};

bool is_unit(double squared_length) { return std::abs(squared_length - 1) < kUnitSlack; }

Result<Pose> parse_pose(const Context& c) {
  const auto origin = c.line["origin"].vector();
  if (!origin) return origin.error();
  const auto direction = c.line["direction"].vector();
  if (!direction) return direction.error();
  if (!is_unit(glm::dot(*direction, *direction))) return c.line["direction"].wrong("must have length 1");
  return Pose{*origin, *direction};
}

// [slot, generation, label]; or [number, label], as journals had it before bodies had generations.
Result<PieceId> parse_piece(const Context& c) {
  const JsonValue piece = c.line["piece"];
  const nlohmann::json& json = piece.json();
  const auto wrong = piece.wrong("must be three whole numbers: a body's slot, its generation and a label");
  if (!json.is_array() || (json.size() != 2 && json.size() != 3)) return wrong;
  for (const nlohmann::json& n : json) {
    if (!n.is_number_unsigned() || n.get<uint64_t>() >= BodyId::kNone) return wrong;
  }
  const uint32_t slot = json.front().get<uint32_t>(), label = json.back().get<uint32_t>();
  const uint32_t generation = json.size() == 3 ? json[1].get<uint32_t>() : BodyId::kUnknownGeneration;
  return PieceId{{slot, generation}, label};
}

Result<Placement> parse_placement(const Context& c) {
  const auto position = c.line["position"].vector();
  if (!position) return position.error();
  const JsonValue value = c.line["orientation"];
  if (!value.json().is_array() || value.json().size() != 4) return value.wrong("must be four numbers");
  glm::dquat turn;
  size_t i = 0;
  for (double* part : {&turn.w, &turn.x, &turn.y, &turn.z}) {
    const auto n = value[i++].number();
    if (!n) return n.error();
    *part = *n;
  }
  if (!is_unit(glm::dot(turn, turn))) return value.wrong("must have length 1");
  return Placement{*position, turn};
}

Result<Command> parse_begin(const Context& c) {
  const auto settings = parse_settings(c.line["settings"]);
  if (!settings) return settings.error();
  const auto pose = parse_pose(c);
  if (!pose) return pose.error();
  return Command(BeginStroke{*settings, *pose});
}

Result<Command> parse_move(const Context& c) {
  const auto pose = parse_pose(c);
  if (!pose) return pose.error();
  if (c.last && glm::length(c.last->direction + pose->direction) < kOpposite)
    return c.line["direction"].wrong("is opposite to the one before");
  return Command(MoveStroke{*pose});
}

Result<Command> parse_recut(const Context& c) {
  const auto settings = parse_settings(c.line["settings"]);
  if (!settings) return settings.error();
  return Command(Recut{*settings});
}

Result<Command> parse_add_mesh(const Context& c) {
  const auto mesh = c.line["mesh"].text();
  if (!mesh) return mesh.error();
  const auto name = c.line["name"].text();
  if (!name) return name.error();
  return Command(AddMesh{c.folder / *mesh, *name});
}

Result<Command> parse_move_piece(const Context& c) {
  const auto piece = parse_piece(c);
  if (!piece) return piece.error();
  const auto to = parse_placement(c);
  if (!to) return to.error();
  return Command(MovePiece{*piece, *to});
}

Result<Command> parse_hide_piece(const Context& c) {
  const auto piece = parse_piece(c);
  if (!piece) return piece.error();
  if (!c.line["hidden"].json().is_boolean()) return c.line["hidden"].wrong("must be true or false");
  return Command(HidePiece{*piece, c.line["hidden"].json().get<bool>()});
}

Result<Command> parse_delete_piece(const Context& c) {
  const auto piece = parse_piece(c);
  if (!piece) return piece.error();
  return Command(DeletePiece{*piece});
}

Result<Command> parse_rename_piece(const Context& c) {
  const auto piece = parse_piece(c);
  if (!piece) return piece.error();
  const auto name = c.line["name"].text();
  if (!name) return name.error();
  return Command(RenamePiece{*piece, *name});
}

// A command as lines name it, the keys that it has besides "do", all of which must be there, and its parser.
struct Kind {
  const char* name;
  std::array<const char*, 3> keys;  // null: no more
  Result<Command> (*parse)(const Context&);
};
constexpr std::array kKinds{
    Kind{"begin", {"settings", "origin", "direction"}, parse_begin},
    Kind{"move", {"origin", "direction"}, parse_move},
    Kind{"end", {}, [](const Context&) { return Result<Command>(EndStroke{}); }},
    Kind{"recut", {"settings"}, parse_recut},
    Kind{"add-mesh", {"mesh", "name"}, parse_add_mesh},
    Kind{"move-piece", {"piece", "position", "orientation"}, parse_move_piece},
    Kind{"hide-piece", {"piece", "hidden"}, parse_hide_piece},
    Kind{"delete-piece", {"piece"}, parse_delete_piece},
    Kind{"rename-piece", {"piece", "name"}, parse_rename_piece},
    Kind{"undo", {}, [](const Context&) { return Result<Command>(Undo{}); }},
    Kind{"redo", {}, [](const Context&) { return Result<Command>(Redo{}); }},
};

Status check_keys(const JsonValue& line, const Kind& kind) {
  const auto has = [&](const std::string& key) {
    return std::any_of(kind.keys.begin(), kind.keys.end(),
                       [&](const char* k) { return k != nullptr && key == k; });
  };
  for (const char* key : kind.keys) {
    if (key != nullptr && !line.has(key)) return line.wrong(std::string("needs \"") + key + "\"");
  }
  for (const auto& item : line.json().items()) {
    if (item.key() != "do" && !has(item.key()))
      return line[item.key()].wrong(std::string("\"") + kind.name + "\" has no such key");
  }
  return Done{};
}

}  // namespace

Result<std::string> command_text(const Command& command, const std::filesystem::path& folder) {
  std::string rest;
  Writer writer{folder, rest};
  const std::string name = std::visit(writer, command);
  if (!writer.status) return writer.status.error();
  return "{\"do\":\"" + name + '"' + rest + '}';
}

Result<Command> parse_command(const JsonValue& value, const std::filesystem::path& folder,
                              const std::optional<Pose>& last) {
  if (!value.has("do")) return value.wrong("needs \"do\"");
  const auto name = value["do"].text();
  if (!name) return name.error();
  const auto kind =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& k) { return *name == k.name; });
  if (kind == kKinds.end()) return value["do"].wrong("is no command that this version has");
  if (const auto keys = check_keys(value, *kind); !keys) return keys.error();
  return kind->parse({value, folder, last});
}

}  // namespace kerf
