#include <cmath>
#include <utility>

#include "core/api/api_internal.h"
#include "core/base/json.h"
#include "core/base/platform.h"
#include "core/document/document.h"
#include "core/document/extract.h"
#include "core/document/material_table.h"
#include "core/document/text/fields.h"
#include "core/document/text/json.h"
#include "core/world/body_mass.h"

namespace kerf {

namespace {

// The table of materials, read once.
const Result<std::vector<Material>>& materials() {
  static const Result<std::vector<Material>> table = load_materials(assets_folder() / "materials.json");
  return table;
}

bool is_utf8(const std::string& text) { return dump_json(nlohmann::ordered_json(text), -1).ok(); }

Result<Placement> placement_of(const double position[3], const double orientation[4]) {
  const Placement placement{{position[0], position[1], position[2]},
                            {orientation[0], orientation[1], orientation[2], orientation[3]}};
  const glm::dquat& q = placement.orientation;
  if (!is_finite(placement.position)) return bad_input("position: must be three finite numbers");
  if (!is_unit_length2(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z))
    return bad_input("orientation: must be a quaternion of length 1");
  return placement;
}

Result<Sheet> sheet_of(const char* material, double thickness, double density) {
  Sheet sheet;
  if (material != nullptr) {
    const auto substance = substance_named(material);
    if (!substance) return substance.error();
    sheet.substance = *substance;
  }
  sheet.thickness = thickness;
  sheet.density = density == 0 ? sheet.substance.density : density;
  if (!kThickness.range.contains(sheet.thickness))
    return bad_input("thickness: " + out_of_limits(sheet.thickness, kThickness.range));
  if (!kDensity.range.contains(sheet.density))
    return bad_input("density: " + out_of_limits(sheet.density, kDensity.range));
  return sheet;
}

Result<AddedBody> added_body(const kerf_mesh& mesh, const kerf_body_desc* given) {
  const auto desc = read_struct(given, KERF_BODY_DESC_INIT, "desc");
  if (!desc) return desc.error();
  const auto placement = placement_of(desc->position, desc->orientation);
  if (!placement) return placement.error();
  const auto sheet = sheet_of(desc->material, desc->thickness, desc->density);
  if (!sheet) return sheet.error();
  AddedBody body{std::make_shared<const kerf_mesh>(mesh), desc->name == nullptr ? "mesh" : desc->name,
                 *placement, *sheet};
  if (!is_utf8(body.name)) return bad_input("name: must be UTF-8");
  body.solid = desc->is_solid != 0;
  body.hidden = desc->is_hidden != 0;
  body.pinned = desc->is_fixed != 0;
  return body;
}

Result<kerf_body> add_body(kerf_world& world, const kerf_mesh& mesh, const kerf_body_desc* desc,
                           const Progress& progress) {
  auto added = added_body(mesh, desc);
  if (!added) return added.error();
  AddMesh command;
  command.name = added->name;
  command.create = [body = *added](const Progress* building) { return body.create(building); };
  const auto delta = apply_edit(world, command, progress);
  if (!delta) return delta.error();
  const BodyId id = delta->created.front();
  added->slot = id.slot;
  world.added[world.document.journal().size() - 1] = std::move(*added);
  const Body& body = world.document.world().body(id);
  world.record_loaded(body, body.placement);
  world.keep();
  return to_api(id);
}

Result<JointDescription> joint_of(const kerf_joint* given) {
  const auto joint = read_struct(given, KERF_JOINT_INIT, "joint");
  if (!joint) return joint.error();
  const auto vector = [](const double v[3]) { return Vec3(v[0], v[1], v[2]); };
  JointDescription made;
  switch (joint->kind) {
    case KERF_JOINT_WELD:
      made.kind = Joint::Kind::kWeld;
      break;
    case KERF_JOINT_HINGE:
      made.kind = Joint::Kind::kHinge;
      break;
    case KERF_JOINT_HUB:
      made.kind = Joint::Kind::kHub;
      break;
    default:
      return bad_input("kind: must be one of KERF_JOINT_WELD, KERF_JOINT_HINGE and KERF_JOINT_HUB");
  }
  made.anchor = vector(joint->anchor);
  made.near = {vector(joint->part_a), vector(joint->part_b)};
  if (!is_finite(made.anchor) || !is_finite((*made.near)[0]) || !is_finite((*made.near)[1]))
    return bad_input("anchor, part_a and part_b: must be finite");
  if (made.kind != Joint::Kind::kWeld) made.axis = vector(joint->axis);
  if (!is_finite(made.axis) || made.axis == Vec3(0)) return bad_input("axis: must be finite and not zero");
  if (joint->has_limits != 0) {
    made.limits = Interval{joint->limits[0], joint->limits[1]};
    if (made.kind != Joint::Kind::kHinge) return bad_input("limits: only a hinge has limits");
    if (!(-180 <= made.limits->low && made.limits->low <= 0 && 0 <= made.limits->high &&
          made.limits->high <= 180))
      return bad_input("limits: must be an angle from -180 to 0 and one from 0 to 180 degrees");
  }
  if (!(joint->radius > 0)) return bad_input("radius: must be greater than 0");
  if (std::isfinite(joint->radius)) made.radius = joint->radius;
  return made;
}

// Returns the name of a body as it stores it: the custom name of its only piece, else its own. O(pieces).
const std::string& stored_name(const Body& body) {
  const std::string displayed = body.own_name();
  for (const auto& [label, name] : body.piece_names) {
    if (name == displayed) return name;
  }
  return body.name;
}

void fill(const Body& body, kerf_body_info& info) {
  info.name = stored_name(body).c_str();
  if (const auto& table = materials(); table.ok()) {
    for (const Material& material : *table) {
      if (is_of(body.sheet.substance, material.substance)) info.material = material.name.c_str();
    }
  }
  const glm::dquat& q = body.placement.orientation;
  const double orientation[] = {q.w, q.x, q.y, q.z};
  std::copy_n(orientation, 4, info.orientation);
  for (int k = 0; k < 3; ++k) {
    info.position[k] = body.placement.position[k];
    info.velocity[k] = body.motion.velocity[k];
    info.spin[k] = body.motion.spin[k];
  }
  info.thickness = body.sheet.thickness;
  info.density = body.sheet.density;
  info.face_count = body.mesh.live_faces();
  for (uint32_t label = 0; label < body.pieces.size(); ++label)
    info.piece_count += body.pieces[label].faces > 0;
  info.is_solid = body.solid;
  info.is_hidden = body.hidden;
  info.is_fixed = body.pinned;
  info.is_asleep = body.motion.asleep;
}

PieceId piece_id(kerf_body body, uint32_t piece) { return {from_api(body), piece}; }

// Applies an edit of a piece. `command`: returns the command, or an error for an invalid argument.
kerf_result edit(kerf_world* world, kerf_body body, uint32_t piece, kerf_body* now,
                 const std::function<Result<Command>(PieceId)>& command) {
  return change_world(world, nullptr, [&](const Progress& progress) -> Status {
    const PieceId id = piece_id(body, piece);
    const auto valid = command(id);
    if (!valid) return valid.error();
    const auto delta = apply_edit(*world, *valid, progress);
    if (!delta) return delta.error();
    if (now != nullptr) *now = to_api(id_after(*delta, id).body);
    return Done{};
  });
}

}  // namespace

Result<Substance> substance_named(const std::string& name) {
  const auto& table = materials();
  if (!table) return table.error();
  if (const Material* material = find_material(*table, name)) return material->substance;
  std::string names;
  for (const Material& material : *table) names += (names.empty() ? "" : ", ") + material.name;
  return bad_input("material: \"" + name + "\" is unknown; use one of: " + names);
}

Result<Body> AddedBody::create(const Progress* progress) const {
  ProgressShares shares(progress);
  const Progress building = shares.next(0.5), growing = shares.next(0.5);
  auto built = build_mesh(soup_of(*mesh), &building);
  if (!built) {
    const bool bad = built.error().code == ErrorCode::kBadInput;
    return bad ? bad_input("mesh: " + built.error().message) : built.error();
  }
  auto body = make_body(name, std::move(*built), &growing);
  if (!body) return body;
  body->placement = placement;
  body->sheet = sheet;
  body->hidden = hidden;
  body->pinned = pinned;
  if (solid) make_solid(*body, true);
  return body;
}

Result<Delta> apply_edit(kerf_world& world, const Command& command, const Progress& progress) {
  Outcome outcome = world.document.apply(command, &progress);
  world.changes.record(world.document.world(), outcome.delta);
  if (!outcome.ok()) return outcome.error();
  world.keep();
  return std::move(outcome.delta);
}

}  // namespace kerf

kerf_result kerf_world_add(kerf_world* world, const kerf_mesh* mesh, const kerf_body_desc* desc,
                           const kerf_call_options* options, kerf_body* body) {
  if (mesh == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "mesh: must not be null");
  return kerf::change_world(world, options, [&](const kerf::Progress& progress) -> kerf::Status {
    const auto added = kerf::add_body(*world, *mesh, desc, progress);
    if (!added) return added.error();
    if (body != nullptr) *body = *added;
    return kerf::Done{};
  });
}

kerf_result kerf_body_get_info(const kerf_world* world, kerf_body body, kerf_body_info* info) {
  if (info == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "info: must not be null");
  return kerf::read_world(world, nullptr,
                          [&](const kerf::Document& document, const kerf::Progress&) -> kerf::Status {
                            if (const kerf::Status valid = kerf::check_size(*info, "info"); !valid)
                              return valid;
                            const auto own = kerf::body_of(document.world(), body);
                            if (!own) return own.error();
                            kerf_body_info filled{};
                            kerf::fill(**own, filled);
                            kerf::write_struct(filled, *info);
                            return kerf::Done{};
                          });
}

kerf_result kerf_body_get_name(const kerf_world* world, kerf_body body, char** out) {
  if (out == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "out: must not be null");
  return kerf::read_world(world, nullptr,
                          [&](const kerf::Document& document, const kerf::Progress&) -> kerf::Status {
                            const auto own = kerf::body_of(document.world(), body);
                            if (!own) return own.error();
                            *out = kerf::copy_of(kerf::stored_name(**own));
                            return kerf::Done{};
                          });
}

kerf_result kerf_piece_get_mesh(const kerf_world* world, kerf_body body, uint32_t piece, kerf_mesh** out) {
  if (out == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "out: must not be null");
  return kerf::read_world(world, nullptr,
                          [&](const kerf::Document& document, const kerf::Progress&) -> kerf::Status {
                            const kerf::PieceId id = kerf::piece_id(body, piece);
                            if (!kerf::has_faces(document.world(), id)) return kerf::no_such_piece(id);
                            const kerf::Body& own = document.world().body(id.body);
                            const std::vector<kerf::FaceId> faces = own.faces_of(piece);
                            // While a stroke is cut in steps, faces get the label of a new piece one by one.
                            if (faces.empty()) return kerf::no_such_piece(id);
                            *out = kerf::mesh_of_piece(own, faces).release();
                            return kerf::Done{};
                          });
}

kerf_result kerf_piece_move(kerf_world* world, kerf_body body, uint32_t piece, const double position[3],
                            const double orientation[4], kerf_body* now) {
  if (position == nullptr || orientation == nullptr)
    return kerf::set_error(KERF_INVALID_ARGUMENT, "position and orientation: must not be null");
  return kerf::edit(world, body, piece, now, [&](kerf::PieceId id) -> kerf::Result<kerf::Command> {
    const auto placement = kerf::placement_of(position, orientation);
    if (!placement) return placement.error();
    return kerf::Command(kerf::MovePiece{id, *placement});
  });
}

kerf_result kerf_piece_set_sheet(kerf_world* world, kerf_body body, uint32_t piece, const char* material,
                                 double thickness, double density, kerf_body* now) {
  return kerf::edit(world, body, piece, now, [&](kerf::PieceId id) -> kerf::Result<kerf::Command> {
    const auto sheet = kerf::sheet_of(material, thickness, density);
    if (!sheet) return sheet.error();
    return kerf::Command(kerf::SetSheetProperties{id, *sheet});
  });
}

kerf_result kerf_piece_set_solid(kerf_world* world, kerf_body body, uint32_t piece, int is_solid,
                                 kerf_body* now) {
  return kerf::edit(world, body, piece, now, [&](kerf::PieceId id) -> kerf::Result<kerf::Command> {
    return kerf::Command(kerf::SetSolid{id, is_solid != 0});
  });
}

kerf_result kerf_piece_set_hidden(kerf_world* world, kerf_body body, uint32_t piece, int is_hidden,
                                  kerf_body* now) {
  return kerf::edit(world, body, piece, now, [&](kerf::PieceId id) -> kerf::Result<kerf::Command> {
    return kerf::Command(kerf::HidePiece{id, is_hidden != 0});
  });
}

kerf_result kerf_piece_set_fixed(kerf_world* world, kerf_body body, uint32_t piece, int is_fixed,
                                 kerf_body* now) {
  return kerf::edit(world, body, piece, now, [&](kerf::PieceId id) -> kerf::Result<kerf::Command> {
    return kerf::Command(kerf::PinPiece{id, is_fixed != 0});
  });
}

kerf_result kerf_piece_rename(kerf_world* world, kerf_body body, uint32_t piece, const char* name) {
  if (name == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "name: must not be null");
  return kerf::edit(world, body, piece, nullptr, [&](kerf::PieceId id) -> kerf::Result<kerf::Command> {
    if (!kerf::is_utf8(name)) return kerf::bad_input("name: must be UTF-8");
    return kerf::Command(kerf::RenamePiece{id, name});
  });
}

kerf_result kerf_body_join(kerf_world* world, kerf_body body, const kerf_joint* joint) {
  if (joint == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "joint: must not be null");
  return kerf::edit(world, body, 0, nullptr, [&](kerf::PieceId id) -> kerf::Result<kerf::Command> {
    auto made = kerf::joint_of(joint);
    if (!made) return made.error();
    return kerf::Command(kerf::JoinParts{id, std::move(*made)});
  });
}

kerf_result kerf_piece_remove(kerf_world* world, kerf_body body, uint32_t piece) {
  return kerf::edit(world, body, piece, nullptr, [&](kerf::PieceId id) -> kerf::Result<kerf::Command> {
    return kerf::Command(kerf::DeletePiece{id});
  });
}
