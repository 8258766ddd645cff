#include "ui/editor/inspect/face_facts.h"

#include <cmath>

#include "core/base/angle.h"
#include "core/base/assert.h"
#include "ui/editor/shared/files/file_frames.h"
#include "ui/window/number_text.h"

namespace kerf {

namespace {

double degrees_between(const Vec3& a, const Vec3& b) {
  const double sine = glm::length(glm::cross(a, b)), cosine = glm::dot(a, b);
  return sine == 0 && cosine == 0 ? 0 : std::atan2(sine, cosine) * 180 / kPi;
}

template <typename Text>
std::string joined(const std::array<double, 3>& values, const char* between, const Text& text) {
  return text(values[0]) + between + text(values[1]) + between + text(values[2]);
}

// "12", "border", "12 + 40 + 41 (ring of 4)".
std::string across(const std::vector<FaceId>& faces) {
  if (faces.empty()) return "border";
  std::string text;
  for (const FaceId f : faces) text += (text.empty() ? "" : " + ") + std::to_string(f.index);
  if (faces.size() > 1) text += " (ring of " + std::to_string(faces.size() + 1) + ")";
  return text;
}

std::string temperature_text(const FaceFacts& facts) {
  const std::string now = text_of("Temperature   %.0f K", facts.temperature);
  return facts.hottest > facts.temperature + 1 ? now + text_of(", once %.0f K", facts.hottest) : now;
}

}  // namespace

FaceFacts face_facts(const Body& body, FaceId face) {
  KERF_ASSERT(body.mesh.is_live(face));
  const FaceData& data = body.mesh.data(face);
  const Triangle t = body.mesh.triangle(face);
  const std::array<VertexId, 3> corners = body.mesh.corners(face);
  FaceFacts facts{face,
                  body.loaded_face(body.loaded_base(face)),
                  data.halvings,
                  body.label(face),
                  triangle_area(t),
                  {},
                  {},
                  {},
                  {}};
  facts.temperature = body.heat.temperature(body.mesh, face, body.sheet.substance, body.sheet.thickness);
  facts.hottest = body.heat.hottest_of(body.mesh, face);
  facts.slot = tree_slot(body.tree, body.mesh, face).value_or(TreeSlot());
  for (size_t i = 0; i < 3; ++i) {
    const size_t next = (i + 1) % 3, last = (i + 2) % 3;
    facts.edges[i] = glm::length(t[next] - t[i]);
    facts.angles[i] = degrees_between(t[next] - t[i], t[last] - t[i]);
    std::vector<Mesh::Side> sides;
    body.mesh.append_edge_sides(face, corners[i], corners[next], sides);
    for (const Mesh::Side& side : sides) facts.neighbours[i].push_back(side.face);
  }
  return facts;
}

std::vector<std::string> lines_of(const FaceFacts& facts, const Body& body, FileUnit unit) {
  const auto length = [&](double metres) { return length_label(metres, unit); };
  const auto angle = [](double degrees) { return text_of("%.1f", degrees); };
  const std::string level = facts.halvings == 0
                                ? "as loaded"
                                : "halved " + std::to_string(facts.halvings) + " times, of loaded face " +
                                      std::to_string(facts.loaded.index);
  return {"Face " + std::to_string(facts.face.index) + ", " + level,
          "Piece   " + body.name_of(facts.piece),
          "Area   " + area_label(facts.area, unit),
          "Edges   " + joined(facts.edges, ", ", length),
          "Angles   " + joined(facts.angles, ", ", angle) + " degrees",
          "Across   " + across(facts.neighbours[0]) + ", " + across(facts.neighbours[1]) + ", " +
              across(facts.neighbours[2]),
          temperature_text(facts),
          "Tree   block " + std::to_string(facts.slot.block) + ", place " +
              std::to_string(facts.slot.place + 1) + " of up to 4" +
              (facts.slot.hit ? "; the beam was in its box" : "")};
}

}  // namespace kerf
