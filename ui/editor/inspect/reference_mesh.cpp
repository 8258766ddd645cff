#include "ui/editor/inspect/reference_mesh.h"

#include <cmath>
#include <new>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/document/extract.h"
#include "core/mesh/build_mesh.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/measures.h"
#include "core/mesh/mesh_file.h"

namespace kerf {

namespace {

// Returns the visible faces of all bodies in the frame of the world.
Soup visible_faces(const World& world) {
  Soup soup;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (body.hidden) continue;
    std::vector<FaceId> faces;
    for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot) {
      if (body.mesh.is_live(FaceId(slot))) faces.emplace_back(slot);
    }
    const Extract extract = extract_faces(body, faces);
    const auto first = static_cast<uint32_t>(soup.positions.size());
    soup.positions.insert(soup.positions.end(), extract.positions.begin(), extract.positions.end());
    for (const auto& [a, b, c] : extract.triangles)
      soup.triangles.push_back({first + a, first + b, first + c});
  }
  return soup;
}

Bounds bounds_of(const std::vector<Vec3>& positions) {
  Bounds bounds = Bounds::none();
  for (const Vec3& p : positions) {
    if (std::isfinite(p.x + p.y + p.z)) bounds.add(p);
  }
  return bounds;
}

// Returns the length in metres of one unit of the positions that were read.
double metres_of(const Soup& soup, const Bounds& bounds, const ReferenceRequest& request) {
  const auto format = mesh_format(soup.format);
  if (!format || states_unit(*format)) return 1;
  const double read = metres_per_unit(request.unit);
  const FileUnit unit = request.usual_unit ? *request.usual_unit
                                           : guess_frame(*format, bounds.min / read, bounds.max / read).unit;
  return metres_per_unit(unit) / read;
}

// Scales the reference to the unit of the document if the sizes show that it has another one.
void bring_to_unit_of_document(Soup& soup, const Soup& visible, const ReferenceRequest& request) {
  const Bounds bounds = bounds_of(soup.positions);
  const double size = bounds.diagonal() / bounds_of(visible.positions).diagonal();
  if (!std::isfinite(size) || !(size > 0)) return;
  const double scale = metres_of(soup, bounds, request) / metres_per_unit(request.document_unit);
  if (std::abs(std::log(size * scale)) >= std::abs(std::log(size))) return;
  for (Vec3& p : soup.positions) p *= scale;
}

// Like load_mesh(), in the unit of the document.
Result<BuiltMesh> load_in_unit_of_document(const ReferenceRequest& request, const Soup& visible,
                                           const Progress& progress) {
  ProgressShares shares(&progress);
  const Progress reading = shares.next(0.2), building = shares.next(0.8);
  auto soup = read_mesh(request.file, &reading, request.unit);
  if (!soup) return soup.error();
  const std::string name = one_line(request.file.string());
  try {
    bring_to_unit_of_document(*soup, visible, request);
    auto built = build_mesh(*soup, &building);
    if (!built && built.error().code == ErrorCode::kBadInput)
      return bad_input(name + ": " + built.error().message);
    return built;
  } catch (const std::bad_alloc&) {
    return failed(name + ": not enough memory to build its mesh.");
  }
}

}  // namespace

ReferenceMesh::ReferenceMesh(std::filesystem::path path, Mesh built, bool is_closed)
    : file(std::move(path)), mesh(std::move(built)), tree(mesh), closed(is_closed) {}

Result<std::shared_ptr<const ReferenceMesh>> load_reference(const World& world,
                                                            const ReferenceRequest& request,
                                                            const Progress* progress) {
  ProgressShares shares(progress);
  const Progress loading = shares.next(0.4), building = shares.next(0.1), aligning = shares.next(0.25),
                 measuring = shares.next(0.25);
  const Soup soup = visible_faces(world);
  if (soup.triangles.empty()) return bad_input("No piece is visible, so there is nothing to compare.");
  auto built = load_in_unit_of_document(request, soup, loading);
  if (!built) return built.error();
  const Vec3 middle = 0.5 * (built->report.min + built->report.max);
  const bool closed = enclosed_volume(built->mesh, middle).closed;
  auto reference = std::make_shared<ReferenceMesh>(request.file, std::move(built->mesh), closed);

  const auto visible = build_mesh(soup, &building);
  if (!visible) return visible.error();
  const AabbTree tree(visible->mesh);
  const Surface surface{visible->mesh, tree};
  const auto motion = align_surfaces(surface, reference->surface(), request.alignment, &aligning);
  if (!motion) return motion.error();
  const auto found = compare_surfaces(surface, reference->surface(), closed, *motion, &measuring);
  if (!found) return found.error();
  reference->motion = *motion;
  reference->found = *found;
  return std::shared_ptr<const ReferenceMesh>(std::move(reference));
}

void ReferenceLoader::begin(const World& world, ReferenceRequest request) {
  cancel();
  job_ = std::make_unique<Job>();
  job_->world = std::make_shared<const World>(world);
  job_->request = std::move(request);
  job_->result = std::async(std::launch::async, [job = job_.get()] {
    const Progress progress{[job](double fraction) {
      job->fraction = fraction;
      return !job->stopped;
    }};
    return load_reference(*job->world, job->request, &progress);
  });
}

void ReferenceLoader::cancel() {
  if (job_) job_->stopped = true;
  job_.reset();
}

std::optional<Result<std::shared_ptr<const ReferenceMesh>>> ReferenceLoader::take() {
  if (!job_ || job_->result.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return std::nullopt;
  const std::unique_ptr<Job> job = std::move(job_);
  return job->result.get();
}

}  // namespace kerf
