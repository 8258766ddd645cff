#include "tests/fuzz/library/session.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <utility>

namespace kerf::fuzz {

namespace {

constexpr size_t kMaxWorlds = 3, kMaxMeshes = 6;
constexpr int kMaxPatience = 100;  // calls of a progress function, so that a run stays short

void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "kerf: broken: %s\n", what.c_str());
  std::abort();
}

// Returns the result of a call that has returned. One that failed has a sentence of one line.
kerf_result checked(kerf_result result) {
  require(result >= KERF_OK && result <= KERF_BUSY, "a result that does not exist");
  if (result == KERF_OK) return result;
  const std::string message = kerf_last_error();
  require(!message.empty(), "a failure without a sentence");
  require(message.find_first_of("\r\n") == std::string::npos, "a message of several lines: " + message);
  return result;
}

std::string hash_of(const kerf_world* world) {
  char hash[17] = "";
  if (world != nullptr) require(kerf_world_hash(world, hash) == KERF_OK, "a world without a hash");
  return hash;
}

// Reads all that a mesh gives.
void visit(const kerf_mesh* mesh) {
  const size_t vertices = kerf_mesh_vertex_count(mesh), faces = kerf_mesh_face_count(mesh);
  for (size_t i = 0; i < 3 * vertices; ++i)
    require(std::isfinite(kerf_mesh_vertices(mesh)[i]), "a position that is not finite");
  for (size_t i = 0; i < 3 * faces; ++i)
    require(kerf_mesh_faces(mesh)[i] < vertices, "a face with a vertex that is not there");
  const double* temperatures = kerf_mesh_face_temperatures(mesh);
  for (size_t i = 0; temperatures != nullptr && i < faces; ++i)
    require(temperatures[i] >= 0, "a temperature below 0 K");
  std::vector<float> values(12 * faces);
  for (size_t i = 0; i < kerf_mesh_attribute_count(mesh); ++i)
    require(kerf_mesh_get_attribute(mesh, i, values.data()) == KERF_OK, "an attribute that cannot be copied");
  kerf_mesh_info info = KERF_MESH_INFO_INIT;
  checked(kerf_mesh_get_info(mesh, &info));
  int64_t euler = 0;
  checked(kerf_mesh_euler_number(mesh, &euler));
  require(info.name != nullptr, "a mesh whose name is null");
}

// A plate of n by n squares in the plane y = 0.
void append_plate(uint32_t n, std::vector<double>& vertices, std::vector<uint32_t>& faces) {
  for (uint32_t i = 0; i <= n; ++i) {
    for (uint32_t k = 0; k <= n; ++k) vertices.insert(vertices.end(), {double(i) / n, 0, double(k) / n});
  }
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t k = 0; k < n; ++k) {
      const uint32_t a = i * (n + 1) + k, b = a + n + 1;
      faces.insert(faces.end(), {a, a + 1, b, b, a + 1, b + 1});
    }
  }
}

}  // namespace

Session::Session(ByteSource& bytes, std::filesystem::path folder)
    : bytes_(bytes), folder_(std::move(folder)) {
  std::vector<double> vertices;
  std::vector<uint32_t> faces;
  append_plate(1 + static_cast<uint32_t>(bytes_.below(6)), vertices, faces);
  kerf_mesh* plate = nullptr;
  kerf_world* made = nullptr;
  checked(kerf_mesh_create(vertices.data(), vertices.size() / 3, faces.data(), faces.size() / 3, &plate));
  checked(kerf_world_create(&made));
  require(kerf_world_add(made, plate, nullptr, nullptr, nullptr) == KERF_OK, "a plate that cannot be added");
  keep(plate);
  keep(made);
}

Session::~Session() {
  for (kerf_world* world : worlds_) kerf_world_destroy(world);
  for (kerf_mesh* mesh : meshes_) kerf_mesh_destroy(mesh);
}

void Session::act() {
  switch (bytes_.below(32)) {
    case 0:
    case 1:
      return make_mesh();
    case 2:
      return read_mesh();
    case 3:
      return write_mesh();
    case 4:
      return inspect_mesh();
    case 5:
    case 6:
      return make_world();
    case 7:
      return open_world();
    case 8:
    case 9:
      return add();
    case 10:
    case 11:
    case 12:
      return cut();
    case 13:
      return take_pieces();
    case 14:
    case 15:
      return cast_rays();
    case 16:
      return save_scene();
    case 17:
      return save_journal();
    case 18:
      return report();
    case 19:
    case 20:
    case 21:
      return cut_in_steps();
    case 22:
    case 23:
    case 24:
      return edit();
    case 25:
    case 26:
    case 27:
      return travel();
    case 28:
    case 29:
      return take_changes();
    case 30:
      return convert_mesh();
    default:
      if (chance(2)) free_one();
  }
}

// -- Arguments

double Session::number() {
  using Limits = std::numeric_limits<double>;
  constexpr double kSpecial[] = {0.0,
                                 -0.0,
                                 1.0,
                                 -1.0,
                                 Limits::quiet_NaN(),
                                 Limits::infinity(),
                                 -1e308,
                                 1e308,
                                 1e200,
                                 -1e100,
                                 1e-100,
                                 Limits::denorm_min(),
                                 1e18,
                                 -1e7,
                                 1e-7,
                                 300.0};
  const uint8_t byte = bytes_.byte();
  return byte < std::size(kSpecial) ? kSpecial[byte] : -2 + byte / 64.0;
}

double Session::length() {
  const uint8_t byte = bytes_.byte();
  if (byte < 32) return number();
  return byte < 96 ? 0 : (byte - 95) / 320.0;
}

std::vector<double> Session::numbers(size_t count) {
  std::vector<double> all(count);
  for (double& x : all) x = number();
  return all;
}

std::string Session::path() {
  const std::string kNames[] = {"a.obj",
                                "a.ply",
                                "a.stl",
                                "a.off",
                                "a.glb",
                                "a.gltf",
                                "b.obj",
                                "w.kerf",
                                "v.kerf",
                                "scene",
                                "scene/scene.json",
                                "no/such.obj",
                                "",
                                "two\nlines.obj",
                                "\xff.obj",
                                std::string(300, 'x') + ".obj"};
  const size_t which = bytes_.below(std::size(kNames) + 2);
  if (which == std::size(kNames)) return "/dev/null";
  if (which > std::size(kNames)) return "/dev/full";
  return kNames[which].empty() ? "" : folder_ / kNames[which];
}

kerf_world* Session::world() {
  if (worlds_.empty() || chance(32)) return nullptr;
  return worlds_[bytes_.below(worlds_.size())];
}

kerf_mesh* Session::mesh() {
  if (meshes_.empty() || chance(32)) return nullptr;
  return meshes_[bytes_.below(meshes_.size())];
}

kerf_body Session::body(const kerf_world* of) {
  size_t count = 0;
  if (of == nullptr || kerf_world_bodies(of, nullptr, 0, &count) != KERF_OK || count == 0 || chance(32))
    return bytes_.byte();
  std::vector<kerf_body> all(count);
  kerf_world_bodies(of, all.data(), count, &count);
  return all[bytes_.below(count)];
}

int Session::on_progress(double share, void* user) {
  Patience& patience = *static_cast<Patience*>(user);
  require(share >= 0 && share <= 1, "a share of the work out of range");
  if (patience.calls_with != nullptr) {
    char hash[17];
    const kerf_result asked = checked(kerf_world_hash(patience.calls_with, hash));
    require(asked == KERF_OK || asked == KERF_BUSY, "a query within a call that is neither done nor busy");
    require(checked(kerf_world_add(patience.calls_with, nullptr, nullptr, nullptr, nullptr)) ==
                KERF_INVALID_ARGUMENT,
            "null");
    require(checked(kerf_world_cut(patience.calls_with, nullptr, 0, nullptr, nullptr, nullptr)) == KERF_BUSY,
            "a world that is changed while it is in use");
  }
  return --patience.calls_left < 0;
}

const kerf_call_options* Session::control(kerf_world* in_use) {
  constexpr unsigned kThreads[] = {0, 1, 2, 3, 1024, 1025, ~0u};
  patience_ = {kMaxPatience, nullptr};
  if (chance(4)) patience_.calls_left = static_cast<int>(bytes_.below(32));
  if (chance(8)) patience_.calls_with = in_use;
  control_ = {chance(64) ? bytes_.below(99) : sizeof control_, &Session::on_progress, &patience_, 1};
  if (chance(4)) control_.threads = kThreads[bytes_.below(std::size(kThreads))];
  return &control_;
}

kerf_stroke Session::stroke() {
  std::vector<kerf_keyframe>& keys = keys_.emplace_back();
  const size_t count = bytes_.below(5);
  const bool is_usual = !chance(8);
  for (size_t k = 0; k < count; ++k) {
    kerf_keyframe key{static_cast<double>(k), {0, 1, 0}, {0, -1, 0}};
    key.origin[0] = bytes_.between(-1, 2);
    key.origin[2] = bytes_.between(-1, 2);
    if (!is_usual) {
      for (double& x : key.origin) x = number();
      for (double& x : key.direction) x = number();
    }
    if (chance(8)) key.time = number();
    keys.push_back(key);
  }
  kerf_stroke stroke = KERF_STROKE_INIT;
  if (chance(64)) stroke.size = bytes_.below(200);
  stroke.keys = chance(32) ? nullptr : keys.data();
  stroke.key_count = count;
  stroke.radius = length();
  if (chance(4)) stroke.range[0] = length();
  if (chance(4)) stroke.range[1] = length();
  for (double* member : {&stroke.power, &stroke.wavelength, &stroke.focus, &stroke.pulse_rate, &stroke.duty})
    if (chance(8)) *member = number();
  return stroke;
}

kerf_cut_settings Session::settings() {
  kerf_cut_settings settings = KERF_CUT_SETTINGS_INIT;
  const auto select = [&](auto& field, int number) { std::memcpy(&field, &number, sizeof number); };
  select(settings.rim, static_cast<int>(bytes_.below(2)));
  select(settings.scheme, static_cast<int>(bytes_.below(2)));
  if (chance(8)) select(settings.rim, bytes_.byte() - 8);
  if (chance(8)) select(settings.scheme, bytes_.byte() - 8);
  if (chance(4)) select(settings.model, static_cast<int>(bytes_.below(2)));
  if (chance(32)) select(settings.model, bytes_.byte() - 8);
  if (chance(4)) select(settings.resolution, static_cast<int>(bytes_.below(4)));
  if (chance(32)) select(settings.resolution, bytes_.byte() - 8);
  settings.target_edge = length();
  settings.tolerance = length();
  settings.max_level = static_cast<int>(bytes_.below(30)) - 2;
  if (chance(64)) settings.size = bytes_.below(200);
  return settings;
}

void Session::keep(kerf_mesh* mesh) {
  visit(mesh);
  if (meshes_.size() == kMaxMeshes) {
    kerf_mesh_destroy(meshes_.front());
    meshes_.erase(meshes_.begin());
  }
  meshes_.push_back(mesh);
}

void Session::keep(kerf_world* world) {
  if (worlds_.size() == kMaxWorlds) {
    kerf_world_destroy(worlds_.front());
    worlds_.erase(worlds_.begin());
  }
  worlds_.push_back(world);
}

kerf_result Session::change(kerf_world* world, const std::function<kerf_result()>& call) {
  const std::string before = hash_of(world);
  const kerf_result result = checked(call());
  const std::string message = kerf_last_error();
  if (result != KERF_OK)
    require(hash_of(world) == before, "a call that failed and changed the world: " + message);
  return result;
}

// -- Meshes

void Session::make_mesh() {
  constexpr double kScales[] = {1, 1, 1, 1, 1e-3, 1e6, 1e-30, 1e30, 1e-170, 1e170};
  std::vector<double> vertices;
  std::vector<uint32_t> faces;
  if (chance(3)) {
    vertices = numbers(3 * bytes_.below(9));
    for (size_t i = 3 * bytes_.below(9); i > 0; --i) faces.push_back(static_cast<uint32_t>(bytes_.below(10)));
  } else {
    append_plate(1 + static_cast<uint32_t>(bytes_.below(4)), vertices, faces);
    const double scale = kScales[bytes_.below(std::size(kScales))], shift = chance(4) ? number() : 0;
    for (double& x : vertices) x = scale * x + shift;
  }
  kerf_mesh* made = nullptr;
  const double* positions = or_null(vertices.data());
  const uint32_t* corners = or_null(faces.data());
  kerf_mesh** out = or_null(&made);
  const kerf_result result =
      checked(kerf_mesh_create(positions, vertices.size() / 3, corners, faces.size() / 3, out));
  require((result == KERF_OK) == (made != nullptr), "a mesh without a result");
  if (made != nullptr) keep(made);
}

void Session::read_mesh() {
  const std::string file = path();
  const char* name = or_null(file.c_str());
  kerf_mesh* read = nullptr;
  kerf_mesh** out = or_null(&read);
  const kerf_result result = checked(kerf_mesh_read(name, control(nullptr), out));
  require((result == KERF_OK) == (read != nullptr), "a mesh without a result");
  if (read != nullptr) keep(read);
}

void Session::write_mesh() {
  const std::string file = path();
  const char* name = or_null(file.c_str());
  checked(kerf_mesh_write(mesh(), name));
}

// Through memory: buffers of any layout, and bytes of each format.
void Session::convert_mesh() {
  const char* kFormats[] = {"obj", "ply", "stl", "off", "glb", "gltf", "3mf", "fbx"};
  const kerf_mesh* of = mesh();
  const size_t vertices = kerf_mesh_vertex_count(of), faces = kerf_mesh_face_count(of);
  kerf_layout layout = KERF_LAYOUT_INIT;
  layout.is_float = static_cast<int>(bytes_.below(2));
  layout.is_16_bit = static_cast<int>(bytes_.below(2));
  if (chance(2)) layout.vertex_stride = bytes_.below(64);
  if (chance(2)) layout.face_stride = bytes_.below(64);
  std::vector<char> positions(64 * (vertices + 1)), indices(64 * (faces + 1));
  kerf_mesh *copy = nullptr, *decoded = nullptr;  // kept last, because that may destroy the mesh
  if (checked(kerf_mesh_copy_to(of, &layout, positions.data(), indices.data())) == KERF_OK)
    checked(
        kerf_mesh_create_from(positions.data(), vertices, indices.data(), faces, or_null(&layout), &copy));
  char* encoded = nullptr;
  size_t count = 0;
  const char* format = kFormats[bytes_.below(std::size(kFormats))];
  if (checked(kerf_mesh_encode(of, or_null(format), &encoded, &count)) == KERF_OK) {
    if (chance(4)) count = bytes_.below(count);
    if (chance(4)) encoded[bytes_.below(count + 1)] = static_cast<char>(bytes_.byte());
    checked(kerf_mesh_decode(encoded, count, chance(2) ? nullptr : format, control(nullptr), &decoded));
    kerf_text_free(encoded);
  }
  for (kerf_mesh* made : {copy, decoded})
    if (made != nullptr) keep(made);
}

void Session::inspect_mesh() {
  checked(kerf_mesh_get_info(mesh(), nullptr));
  visit(mesh());
  require(std::strlen(kerf_version()) > 0 && kerf_last_error() != nullptr, "no version");
}

// -- Worlds

void Session::make_world() {
  checked(kerf_world_create(nullptr));
  kerf_world* made = nullptr;
  if (checked(kerf_world_create(&made)) == KERF_OK) keep(made);
}

void Session::open_world() {
  const std::string file = path();
  const char* name = or_null(file.c_str());
  kerf_world* opened = nullptr;
  kerf_world** out = or_null(&opened);
  const kerf_result result = checked(kerf_world_open(name, control(nullptr), out));
  require((result == KERF_OK) == (opened != nullptr), "a world without a result");
  if (opened != nullptr) keep(opened);
}

void Session::add() {
  const std::string kNames[] = {
      "plate", "", "a/b#c d", "two\nlines", "\xff", "\xc3\xa4", std::string(1000, 'x')};
  const std::string name = kNames[bytes_.below(std::size(kNames))];
  kerf_world* to = world();
  const kerf_mesh* added = mesh();
  const char* given = or_null(name.c_str());
  const kerf_call_options* how = control(to);
  kerf_body_desc desc = KERF_BODY_DESC_INIT;
  desc.name = given;
  desc.is_solid = chance(4);
  desc.is_hidden = chance(8);
  if (chance(4)) desc.position[0] = bytes_.between(-5, 5);  // a far mesh loses its faces in a file
  for (double* member : {&desc.thickness, &desc.density, &desc.orientation[0]})
    if (chance(16)) *member = number();
  kerf_body body = KERF_NO_BODY;
  change(to, [&] { return kerf_world_add(to, added, or_null(&desc), how, &body); });
}

void Session::cut() {
  const char* kMaterials[] = {"copper", "mild-steel", "cheese", "", "\xff"};
  keys_.clear();
  std::vector<kerf_stroke> strokes;
  for (size_t i = bytes_.below(4); i > 0; --i) strokes.push_back(stroke());
  kerf_cut_settings settings = this->settings();
  if (chance(8)) settings.material = kMaterials[bytes_.below(std::size(kMaterials))];
  kerf_world* in = world();
  const kerf_call_options* how = control(in);
  kerf_cut_result done = KERF_CUT_RESULT_INIT;
  done.seconds = 7;
  const kerf_stroke* given = or_null(strokes.data());
  const kerf_cut_settings* set = or_null(&settings);
  const kerf_result result =
      change(in, [&] { return kerf_world_cut(in, given, strokes.size(), set, how, &done); });
  require((result == KERF_OK) != (done.seconds == 7), "a result of a cut that failed, or none");
}

// A stroke that is finished or cancelled: nothing else may change its world in between.
void Session::cut_in_steps() {
  keys_.clear();
  kerf_world* in = world();
  const std::string before = hash_of(in);
  const kerf_stroke begin = stroke();
  kerf_cut_settings set = settings();
  // A move of the thermal model is one unit, of any number of faces.
  const int geometric = KERF_MODEL_GEOMETRIC;
  std::memcpy(&set.model, &geometric, sizeof geometric);
  if (checked(kerf_stroke_begin(in, or_null(&begin), or_null(&set))) != KERF_OK) return;
  kerf_stroke_progress progress = KERF_STROKE_PROGRESS_INIT;
  const kerf_stroke more = stroke();
  for (size_t k = 0; more.keys != nullptr && k < more.key_count; ++k) {
    checked(kerf_stroke_add_pose(in, or_null(&more.keys[k])));
    for (size_t i = bytes_.below(4); i > 0; --i) {
      const double seconds = chance(4) ? number() : 1e-4;
      if (checked(kerf_stroke_step(in, bytes_.below(1000), seconds, or_null(&progress))) == KERF_FAILED)
        return require(hash_of(in) == before, "a stroke that failed and changed the world");
    }
    require(checked(kerf_world_cut(in, nullptr, 0, nullptr, nullptr, nullptr)) == KERF_BUSY,
            "a stroke in steps");
  }
  if (chance(2)) {
    require(kerf_stroke_cancel(in) == KERF_OK, "a stroke that cannot be cancelled");
    return require(hash_of(in) == before, "a cancelled stroke that changed the world");
  }
  require(kerf_stroke_end(in) == KERF_OK, "a stroke that cannot be ended");
  kerf_result result = KERF_OK;
  progress.is_finished = 0;
  for (int i = 0; i < kMaxPatience && result == KERF_OK && progress.is_finished == 0; ++i)
    result = checked(kerf_stroke_step(in, 500, 1, &progress));
  if (result == KERF_OK && progress.is_finished == 0)
    require(kerf_stroke_cancel(in) == KERF_OK, "a stroke that cannot be cancelled");
  require(checked(kerf_stroke_cancel(in)) == KERF_INVALID_ARGUMENT, "a stroke that is not finished");
}

void Session::edit() {
  const char* kMaterials[] = {nullptr, "copper", "pmma", "cheese"};
  kerf_world* in = world();
  const kerf_body of = body(in);
  const auto piece = static_cast<uint32_t>(bytes_.below(4));
  const int flag = static_cast<int>(bytes_.below(2));
  kerf_body now = KERF_NO_BODY;
  kerf_body* to = or_null(&now);
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  const double position[] = {bytes_.between(-5, 5), chance(16) ? nowhere : 0, 0};
  const double turned[] = {0, 1, 0, 0}, orientation[] = {chance(16) ? number() : 1, 0, 0, 0};
  const double thickness = chance(4) ? number() : 0.001, density = chance(4) ? number() : 0;
  const size_t kind = bytes_.below(8);
  const kerf_result result = change(in, [&] {
    switch (kind) {
      case 0:
        return kerf_piece_move(in, of, piece, position, flag ? turned : orientation, to);
      case 1:
        return kerf_piece_set_sheet(in, of, piece, kMaterials[bytes_.below(4)], thickness, density, to);
      case 2:
        return kerf_piece_set_solid(in, of, piece, flag, to);
      case 3:
        return kerf_piece_set_hidden(in, of, piece, flag, to);
      case 4:
        return kerf_piece_set_fixed(in, of, piece, flag, to);
      case 5:
        return join(in, of);
      case 6:
        return kerf_piece_rename(in, of, piece, flag ? "name" : "\xff");
      default:
        return chance(2) ? kerf_piece_remove(in, of, piece) : KERF_OK;
    }
  });
  if (result != KERF_OK || kind > 4 || to == nullptr) return;
  kerf_body_info info = KERF_BODY_INFO_INIT;
  require(kerf_body_get_info(in, now, &info) == KERF_OK, "an edit that names no body");
  char* text = nullptr;
  require(kerf_body_get_name(in, now, &text) == KERF_OK && std::string(text) == info.name, "another name");
  kerf_text_free(text);
  kerf_mesh* edited = nullptr;
  require(kerf_piece_get_mesh(in, now, piece, &edited) == KERF_OK, "an edit that changes the label");
  keep(edited);
}

kerf_result Session::join(kerf_world* in, kerf_body of) {
  kerf_joint joint = KERF_JOINT_INIT;
  const int kind = static_cast<int>(bytes_.below(4));
  std::memcpy(&joint.kind, &kind, sizeof kind);
  joint.has_limits = chance(4);
  for (double* member : {&joint.part_a[0], &joint.part_b[1], &joint.anchor[2], &joint.axis[0]})
    *member = chance(16) ? number() : bytes_.between(-2, 2);
  joint.limits[0] = bytes_.between(-190, 5);
  if (chance(4)) joint.radius = number();
  if (chance(16)) joint.size = bytes_.below(99);
  return kerf_body_join(in, of, or_null(&joint));
}

// Undo, redo and time.
void Session::travel() {
  kerf_world* in = world();
  const std::string before = hash_of(in);
  int done = 0;
  if (chance(3)) {
    const double gravity[] = {bytes_.between(-9, 9), bytes_.between(-20, 5), 0},
                 ground = bytes_.between(-5, 1);
    checked(kerf_world_set_environment(in, or_null(gravity), chance(2) ? &ground : nullptr));
    const double seconds = chance(4) ? -std::abs(number()) : bytes_.byte() / 2560.0;
    change(in, [&] { return kerf_world_simulate(in, seconds, nullptr); });
  } else if (chance(3)) {
    checked(kerf_world_set_undo_memory(in, chance(4) ? 0 : size_t{1} << 26));
    change(in, [&] { return kerf_world_redo(in, or_null(&done)); });
  } else if (change(in, [&] { return kerf_world_undo(in, &done); }) == KERF_OK && done && chance(2)) {
    require(checked(kerf_world_redo(in, &done)) == KERF_OK && done, "a step that cannot be redone");
    require(hash_of(in) == before, "a step that was redone to another state");
  }
}

void Session::take_changes() {
  kerf_world* of = world();
  kerf_changes changes = KERF_CHANGES_INIT;
  if (chance(16)) changes.size = bytes_.below(99);
  if (checked(kerf_world_take_changes(of, or_null(&changes))) != KERF_OK || changes.size != sizeof changes)
    return;
  for (size_t i = 0; i < changes.body_count; ++i) {
    const kerf_body_changes& b = changes.bodies[i];
    if (b.flags & KERF_BODY_DESTROYED) continue;
    std::vector<double> corners(9 * b.added_count);
    std::vector<uint32_t> pieces(b.added_count);
    require(kerf_body_get_faces(of, b.body, b.added, b.added_count, corners.data(), pieces.data(), nullptr,
                                nullptr) == KERF_OK,
            "an added face that does not exist");
    require(std::equal(pieces.begin(), pieces.end(), b.added_pieces), "an added face of another piece");
  }
}

void Session::take_pieces() {
  kerf_world* of = world();
  kerf_mesh** pieces = nullptr;
  size_t count = 0;
  checked(kerf_world_pieces(of, nullptr, nullptr, &count));
  const kerf_call_options* how = control(of);
  const kerf_result result = change(of, [&] { return kerf_world_pieces(of, how, &pieces, &count); });
  if (result != KERF_OK) return require(pieces == nullptr && count == 0, "pieces of a call that failed");
  for (size_t i = 0; i < count; ++i) {
    visit(pieces[i]);
    if (chance(8)) keep(std::exchange(pieces[i], nullptr));
  }
  kerf_pieces_free(pieces, count);
  kerf_pieces_free(nullptr, count);
}

void Session::cast_rays() {
  kerf_world* of = world();
  const size_t n = bytes_.below(6);
  std::vector<double> from, along;
  for (size_t i = 0; i < n; ++i) {
    from.insert(from.end(), {bytes_.between(-0.5, 1.5), 1, bytes_.between(-0.5, 1.5)});
    along.insert(along.end(), {0, -1, 0});
  }
  if (chance(8)) from = numbers(3 * n);
  if (chance(8)) along = numbers(3 * n);
  const std::vector<double> range{length(), length()};
  const double* within = chance(4) ? range.data() : nullptr;
  const double* origins = or_null(from.data());
  const double* directions = or_null(along.data());
  const kerf_call_options* how = control(of);
  kerf_hits nearest = KERF_HITS_INIT, hits = KERF_HITS_INIT, closest = KERF_HITS_INIT;
  const kerf_result near =
      change(of, [&] { return kerf_world_nearest_hits(of, origins, directions, n, within, how, &nearest); });
  require((near == KERF_OK) == (nearest.owner != nullptr), "hits without a result");
  const double farthest = chance(4) ? number() : 1;
  checked(kerf_world_closest_points(of, origins, n, farthest, how, &closest));
  kerf_hits_free(&closest);
  const std::vector<double> low = numbers(3), high{low[0] + length(), low[1] + length(), low[2] + length()};
  checked(kerf_world_faces_in_box(of, or_null(low.data()), high.data(), how, &closest));
  kerf_hits_free(&closest);
  checked(kerf_world_all_hits(of, origins, directions, n, within, nullptr, nullptr));
  how = control(of);
  const kerf_result all =
      change(of, [&] { return kerf_world_all_hits(of, origins, directions, n, within, how, &hits); });
  require((all == KERF_OK) == (hits.owner != nullptr), "hits without a result");
  if (all == KERF_OK && near == KERF_OK) {
    require(hits.offsets[n] == hits.count, "hits that are not counted");
    for (size_t i = 0; i < n; ++i) {
      const bool is_hit = hits.offsets[i] < hits.offsets[i + 1];
      require(is_hit == std::isfinite(nearest.distances[i]), "a nearest hit that is none of all hits");
      if (is_hit)
        require(hits.distances[hits.offsets[i]] == nearest.distances[i], "a nearer hit than the nearest");
    }
  }
  kerf_hits_free(&nearest);
  kerf_hits_free(&hits);
  kerf_hits_free(&hits);
  kerf_hits_free(nullptr);
}

// -- Files and texts

void Session::save_scene() {
  kerf_world* of = world();
  const std::string folder = path();
  const char* name = or_null(folder.c_str());
  if (checked(kerf_world_save_scene(of, name)) != KERF_OK) return;
  kerf_world* again = nullptr;
  const auto file = std::filesystem::path(folder) / "scene.json";
  const kerf_result opened = checked(kerf_world_open(file.c_str(), nullptr, &again));
  require(opened == KERF_OK, std::string("a scene that cannot be opened: ") + kerf_last_error());
  keep(again);
}

void Session::save_journal() {
  kerf_world* of = world();
  const std::string file = path();
  const char* name = or_null(file.c_str());
  const kerf_result saved = change(of, [&] { return kerf_world_save_journal(of, name); });
  if (saved != KERF_OK || !std::filesystem::is_regular_file(file) || !file.ends_with(".kerf")) return;
  kerf_world* again = nullptr;
  const kerf_result opened = checked(kerf_world_open(file.c_str(), nullptr, &again));
  require(opened == KERF_OK, std::string("a journal that cannot be opened: ") + kerf_last_error());
  require(hash_of(again) == hash_of(of), "a journal that leads to another state");
  keep(again);
}

void Session::report() {
  kerf_world* of = world();
  char* text = nullptr;
  checked(kerf_world_report(of, nullptr, nullptr));
  checked(kerf_world_graph(of, nullptr));
  checked(kerf_world_hash(of, nullptr));
  const kerf_call_options* how = control(of);
  if (checked(kerf_world_report(of, how, &text)) == KERF_OK) require(std::strlen(text) > 2, "no report");
  kerf_text_free(std::exchange(text, nullptr));
  if (checked(kerf_world_graph(of, &text)) == KERF_OK) require(std::strlen(text) > 2, "no graph");
  kerf_text_free(text);
  kerf_text_free(nullptr);
}

void Session::free_one() {
  if (chance(2) && !meshes_.empty()) {
    kerf_mesh_destroy(meshes_.back());
    meshes_.pop_back();
  } else if (!worlds_.empty()) {
    kerf_world_destroy(worlds_.back());
    worlds_.pop_back();
  }
  kerf_mesh_destroy(nullptr);
  kerf_world_destroy(nullptr);
}

}  // namespace kerf::fuzz
