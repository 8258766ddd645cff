#include "ui/editor/shared/files/mesh_formats.h"

#include <imgui.h>

#include <array>
#include <string>

#include "ui/window/landmarks.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

struct Choice {
  MeshFormat format;
  const char *name, *tip;
};
constexpr std::array kChoices{
    Choice{MeshFormat::kObj, "OBJ", "Text, exact to the bit, with the names and colours of materials (MTL)."},
    Choice{MeshFormat::kPly, "PLY", "Binary, exact to the bit, without materials."},
    Choice{MeshFormat::kStl, "STL", "Binary in single precision, without materials; for printers."},
    Choice{MeshFormat::kOff, "OFF", "Text, exact to the bit, without materials."},
    Choice{MeshFormat::kGlb, "GLB", "Binary glTF 2.0 in single precision, with the names of materials."}};

}  // namespace

std::optional<MeshFormat> draw_mesh_formats(MeshFormat current) {
  std::optional<MeshFormat> chosen;
  for (const Choice& choice : kChoices) {
    if (&choice != kChoices.data()) ImGui::SameLine();
    if (ImGui::RadioButton(choice.name, choice.format == current)) chosen = choice.format;
    mark_last_item((std::string("format ") + choice.name).c_str());
    tooltip(choice.tip);
  }
  return chosen;
}

void draw_file_names(std::span<const std::filesystem::path> files) {
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(" ...").x;
  std::string text = "Writes";
  for (const std::filesystem::path& file : files) {
    const std::string more = (text == "Writes" ? " " : ", ") + file.filename().string();
    if (ImGui::CalcTextSize((text + more).c_str()).x > room) {
      text += " ...";
      break;
    }
    text += more;
  }
  ImGui::TextDisabled("%s", text.c_str());
}

}  // namespace kerf
