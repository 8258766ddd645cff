// Rays, nearest points and boxes of World, and the class Hits.
#include <limits>

#include "app/python/arguments.h"
#include "app/python/results.h"

namespace kerf::python {

namespace {

// Hits as NumPy arrays.
struct HitArrays {
  py::array offsets, distance, body, face, piece, barycentrics, position, normal, material, is_cut;

  explicit HitArrays(const Hits& hits)
      : offsets(array_copy(hits.offsets)),
        distance(array_copy(hits.distances)),
        body(array_copy(hits.bodies)),
        face(array_copy(hits.faces)),
        piece(array_copy(hits.pieces)),
        barycentrics(vectors_copy(hits.barycentrics)),
        position(vectors_copy(hits.positions)),
        normal(vectors_copy(hits.normals)),
        material(array_copy(hits.materials)),
        is_cut(array_copy(hits.is_cut).attr("astype")("bool")) {}
  explicit HitArrays(const py::tuple& state)
      : offsets(state[0]),
        distance(state[1]),
        body(state[2]),
        face(state[3]),
        piece(state[4]),
        barycentrics(state[5]),
        position(state[6]),
        normal(state[7]),
        material(state[8]),
        is_cut(state[9]) {}

  py::tuple state() const {
    return py::make_tuple(offsets, distance, body, face, piece, barycentrics, position, normal, material,
                          is_cut);
  }
};

void add_hits(py::module_& m) {
  py::class_<HitArrays>(m, "Hits", "Points of surfaces, n in total, of k rays, points or one box.")
      .def_readonly("offsets", &HitArrays::offsets,
                    "all_hits: uint64 of shape (k + 1,); hits of ray i are offsets[i] to offsets[i + 1] - 1. "
                    "Other queries: empty.")
      .def_readonly("distance", &HitArrays::distance,
                    "float64 of shape (n,), metres from the origin of the ray, or from the point; inf on a "
                    "miss.")
      .def_readonly("body", &HitArrays::body, "uint64 of shape (n,), ids of bodies; 2^64 - 1 on a miss.")
      .def_readonly("face", &HitArrays::face,
                    "uint32 of shape (n,), face indices in their bodies; 2^32 - 1 on a miss.")
      .def_readonly("piece", &HitArrays::piece, "uint32 of shape (n,), labels of pieces in their bodies.")
      .def_readonly("barycentrics", &HitArrays::barycentrics,
                    "float64 of shape (n, 3), of the point in its face, one per corner.")
      .def_readonly("position", &HitArrays::position, "float64 of shape (n, 3), metres in the world.")
      .def_readonly("normal", &HitArrays::normal, "float64 of shape (n, 3), unit and outward; 0 on a miss.")
      .def_readonly("material", &HitArrays::material,
                    "uint16 of shape (n,), indices of materials of the mesh.")
      .def_readonly("is_cut", &HitArrays::is_cut,
                    "bool of shape (n,), true for walls that a cut made in a solid.")
      .def(py::pickle([](const HitArrays& hits) { return hits.state(); },
                      [](const py::tuple& state) { return HitArrays(state); }))
      .def("__repr__", [](const HitArrays& hits) {
        return "<kerf.Hits, " + counted(static_cast<size_t>(hits.distance.size()), "distance", "distances") +
               ">";
      });
}

template <typename Trace>
HitArrays trace_rays(const py::object& origins, const py::object& directions, const py::object& range,
                     Trace trace) {
  const std::vector<double> from = triples_argument(origins, "origins"),
                            along = triples_argument(directions, "directions");
  std::array<double, 2> within{0, std::numeric_limits<double>::max()};
  if (!range.is_none()) within = range_argument(range);
  const CallOptions options = options_argument(py::none(), 0);
  return HitArrays(unlocked([&] { return trace(from, along, within, options); }));
}

}  // namespace

void add_queries(py::module_& m, WorldClass& world) {
  add_hits(m);
  world
      .def(
          "nearest_hits",
          [](const World& in, const py::object& origins, const py::object& directions,
             const py::object& range) {
            return trace_rays(origins, directions, range,
                              [&](const auto&... all) { return in.nearest_hits(all...); });
          },
          py::arg("origins"), py::arg("directions"), py::kw_only(), py::arg("range") = py::none(),
          "Finds the first surface that each of n rays crosses and returns Hits of shape (n,).\n\n"
          "origins, directions: finite, of shape (n, 3), metres; directions of any non-zero length.\n"
          "range: (min, max) distance in metres; None: from 0 to infinity.\n\n"
          "Raises ValueError for arrays or a range that violate the above, and Busy.")
      .def(
          "all_hits",
          [](const World& in, const py::object& origins, const py::object& directions,
             const py::object& range) {
            return trace_rays(origins, directions, range,
                              [&](const auto&... all) { return in.all_hits(all...); });
          },
          py::arg("origins"), py::arg("directions"), py::kw_only(), py::arg("range") = py::none(),
          "Finds all surfaces that each of n rays crosses, nearest first, and returns Hits. Arguments and "
          "errors are those of nearest_hits.")
      .def(
          "closest_points",
          [](const World& in, const py::object& points, const py::object& max_distance) {
            const std::vector<double> to = triples_argument(points, "points");
            const double limit = optional_argument(max_distance, number_argument, "max_distance")
                                     .value_or(std::numeric_limits<double>::infinity());
            const CallOptions options = options_argument(py::none(), 0);
            return HitArrays(unlocked([&] { return in.closest_points(to, limit, options); }));
          },
          py::arg("points"), py::kw_only(), py::arg("max_distance") = py::none(),
          "Finds the point of all surfaces nearest to each of n points and returns Hits of shape (n,).\n\n"
          "points: finite, of shape (n, 3), metres.\n"
          "max_distance: metres, beyond which a point has no hit; None: no limit.\n\n"
          "Raises ValueError for numbers that violate the above, and Busy.")
      .def(
          "faces_in_box",
          [](const World& in, const py::object& min, const py::object& max) {
            const auto low = vector_argument(min, "min"), high = vector_argument(max, "max");
            return HitArrays(unlocked([&] { return in.faces_in_box(low, high); }));
          },
          py::arg("min"), py::arg("max"),
          "Finds the faces that a box meets or touches and returns Hits, one per face, with the points "
          "nearest to the centre of the box.\n\n"
          "min, max: corners of shape (3,), metres.\n\n"
          "Raises ValueError for min > max or numbers beyond 1e150, and Busy.");
}

}  // namespace kerf::python
