#include "core/mesh/remesh/simplify.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/mesh/remesh/collapser_internal.h"
#include "core/mesh/weld.h"

namespace kerf {

namespace {

// The squared cosines of 15, 30, 60 and 90 degrees, by which one collapse may turn a face.
constexpr std::array kMinCosine2 = {0.93301270189221932, 0.75, 0.25, 0.0};
// Down to this multiple of the target number of faces only the quadrics are used.
constexpr size_t kFacesForSamples = 5;
// The first bound of the distance of samples, relative to the edge of an equilateral face of the target size;
// later ones double.
constexpr double kFirstBound = 1 / 2048.0;
constexpr double kLastBound = 1;
constexpr size_t kFirstTurns = 2;  // maximum turns of the first bounded rounds

// Returns the edge of an equilateral triangle of this area.
double edge_of(double area) { return std::sqrt(4 / std::sqrt(3.0) * area); }

// Returns false if stopped.
bool collapse_to_error(Collapser& collapser, double error) {
  collapser.bound_distance(kShareForSamples * error);
  return collapser.run_round({.faces = 0, .min_cosine2 = kMinCosine2.front()});
}

// Returns false if stopped.
bool collapse_to_faces(Collapser& collapser, size_t faces) {
  const auto round = [&](size_t until, double cosine2) {
    return collapser.left() <= until || collapser.run_round({.faces = until, .min_cosine2 = cosine2});
  };
  if (!round(kFacesForSamples * faces, kMinCosine2.front())) return false;
  const double edge = edge_of(collapser.area() / static_cast<double>(faces));
  for (const auto turns :
       {std::span(kMinCosine2).first(kFirstTurns), std::span(kMinCosine2).subspan(kFirstTurns)}) {
    for (double bound = kFirstBound; bound <= kLastBound && collapser.left() > faces; bound *= 2) {
      collapser.bound_distance(bound * edge);
      for (const double cosine2 : turns) {
        if (!round(faces, cosine2)) return false;
      }
    }
  }
  collapser.bound_distance(std::nullopt);
  return std::all_of(kMinCosine2.begin(), kMinCosine2.end(),
                     [&](double cosine2) { return round(faces, cosine2); });
}

// Returns the remaining faces, with welded positions in the order of their first use.
Remeshed to_remeshed(const Mesh& mesh, const FlatSheets& sheets, const FlatSurface& surface) {
  std::vector<uint32_t> number(surface.vertices(), kNoIndex);
  std::vector<Vec3> positions;
  for (uint32_t f = 0; f < surface.faces(); ++f) {
    if (!surface.has(f)) continue;
    for (const uint32_t v : surface.corners(f)) {
      if (number[v] != kNoIndex) continue;
      number[v] = static_cast<uint32_t>(positions.size());
      positions.push_back(mesh.position(sheets.vertices[v]));
    }
  }
  WeldedTriangles welded(positions);
  Remeshed out;
  for (uint32_t f = 0; f < surface.faces(); ++f) {
    if (!surface.has(f)) continue;
    const auto& [a, b, c] = surface.corners(f);
    if (welded.add({number[a], number[b], number[c]})) out.origins.push_back(sheets.faces[f]);
  }
  out.positions = std::move(welded.positions);
  out.triangles = std::move(welded.triangles);
  return out;
}

}  // namespace

Result<Remeshed> simplify(const Mesh& mesh, const SimplifyTarget& target, const RemeshLimits& limits,
                          const Progress* progress, std::span<const FaceId> followed) {
  ProgressShares shares(progress);
  const Progress copying = shares.next(0.3), collapsing = shares.next(0.6), back = shares.next(0.1);
  const auto sheets = to_flat_sheets(mesh, limits, &copying);
  if (!sheets) return sheets.error();
  Collapser collapser(mesh, *sheets, target.faces, followed, &collapsing);
  const bool done = std::isfinite(target.error)
                        ? collapse_to_error(collapser, target.error * sheets->frame.scale)
                        : collapse_to_faces(collapser, target.faces);
  if (!done || !back.report(0)) return cancelled();
  Remeshed out = to_remeshed(mesh, *sheets, collapser.surface());
  out.followed = collapser.followed();
  return out;
}

}  // namespace kerf
