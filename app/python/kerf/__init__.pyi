from collections.abc import Callable, Iterable
from os import PathLike
from typing import Any, Literal, Protocol, overload

import numpy as np
import numpy.typing as npt

__version__: str

_Path = str | bytes | PathLike[str] | PathLike[bytes]
_Vector = tuple[float, float, float]
_Progress = Callable[[float], object]

class _Faces(Protocol):
    """A mesh of another library, such as Trimesh."""

    @property
    def vertices(self) -> npt.ArrayLike: ...
    @property
    def faces(self) -> npt.ArrayLike: ...

class _Triangles(Protocol):
    """A mesh of another library, such as Open3D."""

    @property
    def vertices(self) -> npt.ArrayLike: ...
    @property
    def triangles(self) -> npt.ArrayLike: ...

class Error(RuntimeError):
    """A failed call; it has changed nothing."""

class Cancelled(Error):
    """A call that its progress callback cancelled."""

class Busy(Error):
    """A call on a world that another call uses."""

class FileNotFound(FileNotFoundError, ValueError):
    """A path without a file."""

def read(path: _Path, *, progress: _Progress | None = None) -> Mesh:
    """Reads an OBJ, PLY, STL, OFF, glTF or 3MF file and returns a Mesh."""

class Mesh:
    """A triangle mesh, or a piece of one; immutable."""

    @overload
    def __init__(self, vertices: npt.ArrayLike, faces: npt.ArrayLike) -> None: ...
    @overload
    def __init__(self, mesh: Mesh | _Faces | _Triangles) -> None: ...
    @property
    def vertices(self) -> npt.NDArray[np.float64]:
        """Positions of shape (n, 3), metres."""
    @property
    def faces(self) -> npt.NDArray[np.uint32]:
        """Vertex indices, shape (m, 3)."""
    @property
    def face_temperatures(self) -> npt.NDArray[np.float64]:
        """Face temperatures of a piece, shape (m,), kelvin; empty for any other mesh."""
    @property
    def attributes(self) -> dict[str, npt.NDArray[np.float32]]:
        """Values at the corners of the faces, shape (m, 3, k), by their names in glTF; NaN if a face has none."""
    @property
    def face_materials(self) -> npt.NDArray[np.uint16]:
        """Indices of the materials of faces, shape (m,); empty without materials."""
    @property
    def material_names(self) -> list[str]:
        """Names of materials by index, some empty."""
    @property
    def area(self) -> float:
        """Area, m^2."""
    @property
    def name(self) -> str:
        """Name of the piece; empty for a mesh that was read or created."""
    @property
    def mass(self) -> float:
        """Mass in kg; 0 unless the mesh is a piece of a world."""
    @property
    def centroid(self) -> npt.NDArray[np.float64]:
        """Centroid of the area, or of the volume of a solid, shape (3,), metres."""
    @property
    def inertia(self) -> npt.NDArray[np.float64]:
        """Inertia about the centroid in world axes, shape (6,), kg m^2: xx, yy, zz, xy, xz, yz."""
    @property
    def boundary_edges(self) -> int:
        """Number of edges with one face; 0 unless the mesh is a piece of a world."""
    @property
    def placement(self) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        """Position in metres and quaternion w, x, y, z of the body."""
    def write(self, path: _Path) -> None: ...

class Stroke:
    """A stroke of the laser: keys are (time in s, origin in m, direction)."""

    def __init__(
        self,
        keys: Iterable[tuple[float, npt.ArrayLike, npt.ArrayLike]],
        radius: float | None = None,
        range: tuple[float, float] | None = None,
        power: float = 2000.0,
    ) -> None: ...
    @property
    def keys(self) -> list[tuple[float, _Vector, _Vector]]:
        """Poses of the beam, a copy: (time in s, origin in m, direction)."""
    @keys.setter
    def keys(self, keys: Iterable[tuple[float, npt.ArrayLike, npt.ArrayLike]]) -> None: ...
    radius: float | None
    """Metres; None: 1/400 of the diagonal of the world."""
    range: tuple[float, float] | None
    """(min, max) along the beam in metres; None: from 0 to ten diagonals."""
    power: float
    """Watts, >= 0, for the thermal model."""

class Hits:
    """Crossings of k rays with surfaces, n in total."""

    @property
    def offsets(self) -> npt.NDArray[np.uint64]:
        """all_hits: shape (k + 1,); hits of ray i are offsets[i] to offsets[i + 1] - 1. nearest_hits: empty."""
    @property
    def distance(self) -> npt.NDArray[np.float64]:
        """Shape (n,), metres; inf on a miss."""
    @property
    def body(self) -> npt.NDArray[np.uint64]:
        """Shape (n,), ids of bodies; 2^64 - 1 on a miss."""
    @property
    def face(self) -> npt.NDArray[np.uint32]:
        """Shape (n,), face indices in their bodies; 2^32 - 1 on a miss."""
    @property
    def piece(self) -> npt.NDArray[np.uint32]:
        """Shape (n,), labels of pieces in their bodies."""

class World:
    """The bodies that a laser cuts."""

    def __init__(self) -> None: ...
    @staticmethod
    def open(path: _Path, *, progress: _Progress | None = None) -> World: ...
    def add(self, mesh: Mesh | _Faces | _Triangles, name: str = "mesh") -> None: ...
    def cut(
        self,
        strokes: Stroke | Iterable[Stroke],
        *,
        target_edge: float | None = None,
        tolerance: float | None = None,
        max_level: int | None = None,
        rim: Literal["faces", "smooth"] = "faces",
        scheme: Literal["longest-edge", "one-to-four"] = "longest-edge",
        model: Literal["geometric", "thermal"] = "geometric",
        material: str | None = None,
        progress: _Progress | None = None,
        threads: int = 0,
    ) -> dict[str, Any]: ...
    @property
    def pieces(self) -> list[Mesh]: ...
    def nearest_hits(
        self, origins: npt.ArrayLike, directions: npt.ArrayLike, *, range: tuple[float, float] | None = None
    ) -> Hits: ...
    def all_hits(
        self, origins: npt.ArrayLike, directions: npt.ArrayLike, *, range: tuple[float, float] | None = None
    ) -> Hits: ...
    def save_scene(self, folder: _Path) -> None: ...
    def save_journal(self, path: _Path) -> None: ...
    def report(self) -> dict[str, Any]: ...
    def graph(self) -> dict[str, Any]: ...
    @property
    def hash(self) -> str: ...
