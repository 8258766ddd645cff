#include "ui/render/bodies/body_picture.h"

#include "core/base/platform.h"
#include "ui/gl/buffers.h"
#include "ui/render/view/colours.h"

namespace kerf {

Shaders::Shaders() : folder_(assets_folder() / "shaders") {}

gl::Program Shaders::load(const gl::ProgramFiles& files) {
  if (!status_) return {};
  Result<gl::Program> program = gl::Program::load(folder_, files);
  if (!program) {
    status_ = program.error();
    return {};
  }
  program->bind_block("Frame", kFrameBlock);
  program->bind_block("Paints", kPaintBlock);
  program->bind_block("Surfaces", kSurfaceBlock);
  return std::move(*program);
}

namespace {
constexpr size_t kPaints = 256;
constexpr size_t kPieceColours = 32;  // as in body.vert
}  // namespace

bool is_frame_bound() {
  GLint buffer = 0;
  glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, kFrameBlock, &buffer);
  return buffer != 0;
}

std::vector<glm::vec4> paint_table(const std::vector<std::string>& materials,
                                   const std::map<std::string, Paint>& paints,
                                   std::span<const std::optional<SurfaceLook>> looks) {
  const Paint plain;
  std::vector<glm::vec4> table(kPaints, glm::vec4(glm::vec3(plain.colour), plain.gloss));
  for (size_t m = 0; m < std::min(kPaints, materials.size()); ++m) {
    const auto found = paints.find(materials[m]);
    if (found != paints.end()) {
      table[m] = glm::vec4(glm::vec3(found->second.colour), found->second.gloss);
    } else if (m < looks.size() && looks[m]) {
      table[m] = glm::vec4(glm::vec3(looks[m]->base), kDescribed + 1 - looks[m]->roughness);
    }
  }
  return table;
}

std::vector<glm::dvec3> piece_colours(const std::vector<std::string>& materials,
                                      const std::map<std::string, Paint>& paints) {
  std::vector<glm::dvec3> there;
  for (const glm::vec4& paint : paint_table(materials, paints)) there.emplace_back(glm::vec3(paint));
  there.resize(std::clamp<size_t>(materials.size(), 1, there.size()));
  return piece_palette(there, kPieceColours);
}

BodyPicture::BodyPicture(const Body& body, const std::map<std::string, Paint>& paints, PreparedBody prepared,
                         std::shared_ptr<const SurfaceTextures> textures, double glow_width)
    : faces_(body.mesh, prepared.frame, std::move(prepared.bases), glow_width),
      textures_(std::move(textures)) {
  std::span<const std::optional<SurfaceLook>> looks;
  if (textures_) looks = textures_->looks();
  std::vector<glm::vec4> table = paint_table(body.material_names, paints, looks);
  for (const glm::dvec3& colour : piece_colours(body.material_names, paints))
    table.emplace_back(glm::vec3(colour), 0);
  gl::fill_buffer(GL_UNIFORM_BUFFER, paints_, table.size() * sizeof(glm::vec4), table.data(), GL_STATIC_DRAW);
}

void BodyPicture::bind(const gl::Program& program, const FrameSpace& space,
                       const Placement& placement) const {
  program.set("frame_from_body", space.from_body(placement, faces_.frame()));
  program.set("turn", glm::mat3(space.turn_from(placement.orientation)));
  program.set("terminator", faces_.deviation());
  program.set("heated", faces_.heat().any() ? 1 : 0);
  glBindBufferBase(GL_UNIFORM_BUFFER, kPaintBlock, paints_.name());
  looks_.bind(program);
  if (is_textured()) textures_->bind(program);
}

void BodyPicture::draw(const gl::Program& program, const FrameSpace& space,
                       const Placement& placement) const {
  bind(program, space, placement);
  faces_.draw();
}

}  // namespace kerf
