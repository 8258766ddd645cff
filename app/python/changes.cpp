// World.take_changes and its results.
#include <memory>

#include "app/python/arguments.h"
#include "app/python/results.h"

namespace kerf::python {

namespace {

// Copies of the arrays of kerf_body_changes.
struct ChangesOfBody {
  BodyId body;
  uint32_t flags;
  py::array added, added_pieces, removed, moved, moved_pieces, destroyed_pieces;
  py::list new_pieces;

  explicit ChangesOfBody(const kerf_body_changes& c)
      : body(c.body),
        flags(c.flags),
        added(array_copy(std::span(c.added, c.added_count))),
        added_pieces(array_copy(std::span(c.added_pieces, c.added_count))),
        removed(array_copy(std::span(c.removed, c.removed_count))),
        moved(array_copy(std::span(c.moved, c.moved_count))),
        moved_pieces(array_copy(std::span(c.moved_pieces, c.moved_count))),
        destroyed_pieces(array_copy(std::span(c.destroyed_pieces, c.destroyed_piece_count))) {
    for (const kerf_new_piece& piece : std::span(c.new_pieces, c.new_piece_count)) {
      const py::object from =
          piece.from == KERF_NO_PIECE ? py::object(py::none()) : py::object(py::int_(piece.from));
      new_pieces.append(py::make_tuple(piece.piece, from));
    }
  }
};

// A copy of kerf_changes.
struct ChangesOfWorld {
  bool everything;
  py::list bodies, detached;

  explicit ChangesOfWorld(const Changes& c) : everything(c.everything != 0) {
    for (const kerf_body_changes& body : std::span(c.bodies, c.body_count))
      bodies.append(ChangesOfBody(body));
    for (const kerf_detached& d : std::span(c.detached, c.detached_count))
      detached.append(py::make_tuple(d.from, d.to, d.piece, d.keeps_faces != 0));
  }
};

void add_changes_of_body(py::module_& m) {
  const auto flag = [](uint32_t bit) {
    return [bit](const ChangesOfBody& changes) { return (changes.flags & bit) != 0; };
  };
  py::class_<ChangesOfBody>(m, "BodyChanges", "Changes of a body. Faces ascend; each is in at most one list.")
      .def_readonly("body", &ChangesOfBody::body, "Id of the body.")
      .def_property_readonly("created", flag(KERF_BODY_CREATED), "New; all faces are in `added`.")
      .def_property_readonly("destroyed", flag(KERF_BODY_DESTROYED), "No longer exists; no face is listed.")
      .def_property_readonly("placement_changed", flag(KERF_BODY_MOVED), "Position or orientation changed.")
      .def_property_readonly("properties_changed", flag(KERF_BODY_PROPERTIES),
                             "Name, mass, solidity, or whether it is fixed changed.")
      .def_property_readonly("visibility_changed", flag(KERF_BODY_VISIBILITY), "Was hidden or shown.")
      .def_readonly("added", &ChangesOfBody::added,
                    "uint32 of shape (n,), faces that are new or have other corners.")
      .def_readonly("added_pieces", &ChangesOfBody::added_pieces, "uint32 of shape (n,), their pieces.")
      .def_readonly("removed", &ChangesOfBody::removed,
                    "uint32 of shape (n,), faces that no longer exist; some may be unknown to the caller.")
      .def_readonly("moved", &ChangesOfBody::moved, "uint32 of shape (n,), other faces whose piece changed.")
      .def_readonly("moved_pieces", &ChangesOfBody::moved_pieces, "uint32 of shape (n,), their pieces.")
      .def_readonly(
          "new_pieces", &ChangesOfBody::new_pieces,
          "Labels that have faces now and had none: a list of (label, label of the piece from which "
          "it was cut off, or None).")
      .def_readonly("destroyed_pieces", &ChangesOfBody::destroyed_pieces,
                    "uint32 of shape (n,), labels that had faces and have none now.")
      .def("__repr__", [](const ChangesOfBody& changes) {
        return "<kerf.BodyChanges of body " + std::to_string(changes.body) + ", " +
               counted(static_cast<size_t>(changes.added.size()), "face", "faces") + " added, " +
               std::to_string(changes.removed.size()) + " removed>";
      });
}

}  // namespace

void add_changes(py::module_& m, WorldClass& world) {
  add_changes_of_body(m);
  py::class_<ChangesOfWorld>(m, "Changes", "Changes of a world since the last call of World.take_changes.")
      .def_readonly("everything", &ChangesOfWorld::everything,
                    "True if any part may have changed and the lists are empty: read the world again.")
      .def_readonly("bodies", &ChangesOfWorld::bodies, "A list of BodyChanges, destroyed bodies first.")
      .def_readonly(
          "detached", &ChangesOfWorld::detached,
          "Pieces that moved to another body, unless it was removed since and no listed piece left it: a "
          "list of (from, to, piece, keeps_faces). The smaller side, the piece or the rest, has a created "
          "body, in which face i is the i-th of its faces before. If keeps_faces, faces of `from` are now "
          "those of `to`, by the same indices; else they remain.")
      .def("__repr__", [](const ChangesOfWorld& changes) {
        return changes.everything
                   ? std::string("<kerf.Changes of everything>")
                   : "<kerf.Changes of " + counted(changes.bodies.size(), "body", "bodies") + ">";
      });
  world.def(
      "take_changes",
      [](World& of) { return ChangesOfWorld(of.take_changes()); },  // the next call invalidates the arrays
      "Returns the Changes since the last call for this world. The first call returns `everything`, as does "
      "one after a failed cut or stroke step, or after more changes than the log holds. To mirror the world: "
      "remove destroyed bodies; apply `detached` in order, moving the mirror of `from`, if any, to `to` if "
      "keeps_faces; then for the other bodies, replacing created ones, remove faces, then add faces. Raises "
      "Busy.");
}

}  // namespace kerf::python
