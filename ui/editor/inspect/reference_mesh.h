#pragma once

#include <atomic>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/files/mesh_format.h"
#include "core/mesh/mesh.h"
#include "core/tree/aabb_tree.h"
#include "core/tree/surface_comparison.h"
#include "core/world/world.h"

namespace kerf {

// A mesh file with which the visible pieces are compared.
struct ReferenceMesh {
  ReferenceMesh(std::filesystem::path path, Mesh built, bool is_closed);

  Surface surface() const { return {mesh, tree}; }
  // Returns the distance of a point of the world (m) from the reference; negative inside a closed one.
  double distance(const Vec3& p) const { return signed_distance(surface(), closed, motion.apply(p)); }

  std::filesystem::path file;
  Mesh mesh;
  AabbTree tree;
  bool closed;
  RigidMotion motion;       // from the world to the frame of the reference
  SurfaceComparison found;  // of the pieces that were visible when it was loaded
};

// How to load a reference. A document keeps the numbers of its files, so a reference may have another unit.
// It is scaled from the unit that it states, or that its format usually has, to that of the document, unless
// it then differs more in size from the visible faces: exports of a document have the numbers of the
// document.
struct ReferenceRequest {
  std::filesystem::path file;
  FileUnit unit = FileUnit::kMetre;  // see read_mesh
  Alignment alignment = Alignment::kNone;
  FileUnit document_unit = FileUnit::kMetre;  // of the numbers in the world
  std::optional<FileUnit> usual_unit = {};    // of files of this format; nullopt: guessed (see guess_frame)
};

// Loads a reference, aligns the visible faces of the world with it and measures their distances, as `kerf
// compare` does. Fails like load_mesh(), with bad input if no face is visible, and with cancelled() when
// stopped; `progress` may be null.
Result<std::shared_ptr<const ReferenceMesh>> load_reference(const World& world,
                                                            const ReferenceRequest& request,
                                                            const Progress* progress);

// Loads a reference on another thread, from a copy of the world.
class ReferenceLoader {
 public:
  ReferenceLoader() = default;
  ReferenceLoader(const ReferenceLoader&) = delete;
  ReferenceLoader& operator=(const ReferenceLoader&) = delete;
  ~ReferenceLoader() { cancel(); }

  // Stops an earlier request, waits until it ended, and begins this one.
  void begin(const World& world, ReferenceRequest request);
  // Stops the request and waits until it ended.
  void cancel();
  // Returns the reference or the error of a completed request, once.
  std::optional<Result<std::shared_ptr<const ReferenceMesh>>> take();

  bool busy() const { return job_ != nullptr; }
  // Returns the progress, 0 to 1. Precondition: busy().
  double fraction() const { return job_->fraction; }
  // Returns the file that is being loaded. Precondition: busy().
  const std::filesystem::path& file() const { return job_->request.file; }

 private:
  struct Job {
    std::shared_ptr<const World> world;
    ReferenceRequest request;
    std::atomic<double> fraction = 0;
    std::atomic<bool> stopped = false;
    std::future<Result<std::shared_ptr<const ReferenceMesh>>> result;
  };
  std::unique_ptr<Job> job_;
};

}  // namespace kerf
