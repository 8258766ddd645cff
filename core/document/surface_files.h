#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/world/world.h"

namespace kerf {

// The material library (.mtl) and the images of pieces saved as OBJ files, in the same folder. Existing files
// are never overwritten: one with the same bytes is reused; otherwise the new file gets another name.
class SurfaceFiles {
 public:
  SurfaceFiles() = default;
  // Collects the materials of all bodies. Different materials of one name get different names.
  explicit SurfaceFiles(const World& world);
  // Adds a body that was not added before.
  void add(const Body& body);

  // Writes the library, with this name if it is free, and the images to which it refers. No-op if the mesh
  // file of no body describes materials.
  Status write(const std::filesystem::path& folder, const std::string& name = "pieces.mtl");
  // Removes the files that write() created.
  void remove() const;

  // The name of the material library, an MTL file; empty if there is none.
  const std::string& mtl_name() const { return library_; }
  // The names of the materials of a body, by number.
  const std::vector<std::string>& names(const Body& body) const { return names_.at(&body); }

 private:
  struct Material {
    std::string name;
    std::vector<MtlLine> lines;  // with images of this list
  };

  uint32_t image(const SurfaceImage& image);
  std::string text(const std::vector<std::string>& image_names) const;
  Result<std::string> place(const std::filesystem::path& folder, const std::string& name,
                            const std::string& bytes);

  std::vector<Material> materials_;
  std::vector<const SurfaceImage*> images_;
  std::map<const Body*, std::vector<std::string>> names_;
  bool any_ = false;  // true if a mesh file describes a material
  std::string library_;
  std::vector<std::filesystem::path> created_;
};

}  // namespace kerf
