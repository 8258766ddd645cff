#include "core/mesh/openmesh/smooth.h"

#include "core/mesh/openmesh/sheets.h"

#include <OpenMesh/Tools/Smoother/JacobiLaplaceSmootherT.hh>

namespace kerf {

Result<Remeshed> smooth(const Mesh& mesh, size_t times, std::span<const FaceId> kept,
                        const Progress* progress) {
  ProgressShares shares(progress);
  const Progress copying = shares.next(0.5), moving = shares.next(0.4), back = shares.next(0.1);
  auto sheets = to_sheets(mesh, kept, &copying);
  if (!sheets) return sheets.error();
  {
    // It leaves locked vertices and those on boundaries where they are.
    using Smoother = OpenMesh::Smoother::JacobiLaplaceSmootherT<OpenMeshKernel>;
    Smoother smoother(sheets->mesh);
    smoother.initialize(Smoother::Tangential_and_Normal, Smoother::C0);
    for (size_t i = 0; i < times; ++i) {
      if (!moving.report(static_cast<double>(i) / static_cast<double>(times))) return cancelled();
      smoother.smooth(1);
    }
  }
  if (!back.report(0)) return cancelled();
  return from_sheets(*sheets, sheets->faces, mesh);
}

}  // namespace kerf
