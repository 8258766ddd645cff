#include <algorithm>

#include "core/api/api_internal.h"

namespace kerf {

namespace {

Status get_faces(const Body& body, std::span<const uint32_t> faces, double* corners, uint32_t* pieces,
                 uint16_t* materials, uint8_t* is_cut) {
  const Mesh& mesh = body.mesh;
  for (const uint32_t f : faces) {
    if (!mesh.is_live(FaceId(f))) return bad_input("faces: the body has no face " + std::to_string(f));
  }
  for (size_t i = 0; i < faces.size(); ++i) {
    const FaceId f(faces[i]);
    const FaceData& data = mesh.data(f);
    if (pieces != nullptr) pieces[i] = data.piece;
    if (materials != nullptr) materials[i] = data.material;
    if (is_cut != nullptr) is_cut[i] = body.walls.contain(mesh, f);
    if (corners == nullptr) continue;
    for (const Vec3& p : mesh.triangle(f)) {
      for (int k = 0; k < 3; ++k) *corners++ = p[k];
    }
  }
  return Done{};
}

}  // namespace

Result<const Body*> body_of(const World& world, kerf_body body) {
  const BodyId id = from_api(body);
  if (!world.contains(id)) return bad_input("body: the world has no body " + std::to_string(body));
  return &world.body(id);
}

}  // namespace kerf

kerf_result kerf_world_bodies(const kerf_world* world, kerf_body* out, size_t capacity, size_t* count) {
  if (count == nullptr || (out == nullptr && capacity > 0))
    return kerf::set_error(KERF_INVALID_ARGUMENT, "out and count: must not be null");
  return kerf::read_world(world, nullptr,
                          [&](const kerf::Document& document, const kerf::Progress&) -> kerf::Status {
                            const std::vector<kerf::BodyId> ids = document.world().ids();
                            for (size_t i = 0; i < std::min(capacity, ids.size()); ++i)
                              out[i] = kerf::to_api(ids[i]);
                            *count = ids.size();
                            return kerf::Done{};
                          });
}

kerf_result kerf_body_faces(const kerf_world* world, kerf_body body, uint32_t* out, size_t capacity,
                            size_t* count) {
  if (count == nullptr || (out == nullptr && capacity > 0))
    return kerf::set_error(KERF_INVALID_ARGUMENT, "out and count: must not be null");
  return kerf::read_world(world, nullptr,
                          [&](const kerf::Document& document, const kerf::Progress&) -> kerf::Status {
                            const auto own = kerf::body_of(document.world(), body);
                            if (!own) return own.error();
                            const kerf::Mesh& mesh = (*own)->mesh;
                            size_t found = 0;
                            for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
                              if (!mesh.is_live(kerf::FaceId(f))) continue;
                              if (found < capacity) out[found] = f;
                              ++found;
                            }
                            *count = found;
                            return kerf::Done{};
                          });
}

kerf_result kerf_body_get_faces(const kerf_world* world, kerf_body body, const uint32_t* faces, size_t n,
                                double* corners, uint32_t* pieces, uint16_t* materials, uint8_t* is_cut) {
  if (faces == nullptr && n > 0) return kerf::set_error(KERF_INVALID_ARGUMENT, "faces: must not be null");
  return kerf::read_world(world, nullptr,
                          [&](const kerf::Document& document, const kerf::Progress&) -> kerf::Status {
                            const auto own = kerf::body_of(document.world(), body);
                            if (!own) return own.error();
                            return kerf::get_faces(**own, {faces, n}, corners, pieces, materials, is_cut);
                          });
}

kerf_result kerf_world_take_changes(kerf_world* world, kerf_changes* out) {
  if (out == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "out: must not be null");
  return kerf::use_exclusively(world, nullptr, [&](const kerf::Progress&) -> kerf::Status {
    if (const kerf::Status valid = kerf::check_size(*out, "out"); !valid) return valid;
    kerf::write_struct(world->changes.take(world->document), *out);
    return kerf::Done{};
  });
}
