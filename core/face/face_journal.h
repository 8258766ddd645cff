#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/document/files/scene.h"
#include "core/document/history/document.h"
#include "core/face/face_mesh.h"

namespace kerf {

// What the journal of a world begins with: the bodies of the scene that was opened, and behind them those
// that were added, as they were then. A world that is changed in a way that its journal cannot tell, after it
// was cut, has none any more.
class Beginning {
 public:
  void open(SceneDescription scene) { scene_ = std::move(scene); }
  void add(const kerf_mesh& mesh, const std::string& name) { added_.push_back({mesh, name}); }
  // The bodies have another material from now on.
  void set_substance(const Substance& substance);
  // The world is not what the journal leads to any more.
  void lose() { lost_ = true; }

  // Writes the journal of the document, and beside it the meshes that were added. Bad input where there is no
  // journal; fails if a file cannot be written.
  Status save(const Document& document, const std::filesystem::path& file) const;

 private:
  struct Added {
    kerf_mesh mesh;
    std::string name;
  };

  SceneDescription scene_;
  std::vector<Added> added_;
  Sheet sheet_;  // of those that were added
  bool lost_ = false;
};

}  // namespace kerf
