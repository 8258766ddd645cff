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
    """A failed call. It changes nothing, unless stated otherwise."""

class Cancelled(Error):
    """A call that its progress callback cancelled."""

class Busy(Error):
    """A call on a world that another call or a stroke in steps uses."""

class FileNotFound(FileNotFoundError, ValueError):
    """A path without a file."""

def show(world: World | Mesh | _Faces | _Triangles, *options: object) -> None:
    """Opens the editor on a copy of a world or of a mesh, and returns when its window is closed."""

def read(path: _Path, *, progress: _Progress | None = None) -> Mesh:
    """Reads an OBJ, PLY, STL, OFF, glTF, 3MF or Kerf (.kmesh) file and returns a Mesh."""

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
    def parts(self) -> list[tuple[str, int, int]]:
        """Parts that the file names: (name, first face, number of faces); ranges may overlap."""
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
    @property
    def volume(self) -> float:
        """Volume of a closed piece, m^3; 0 for an open one and any other mesh."""
    @property
    def is_closed(self) -> bool:
        """True if the mesh is a piece of a world and uses each edge equally often in both directions."""
    @property
    def euler_number(self) -> int:
        """Vertices - edges + faces."""
    @property
    def warnings(self) -> list[str]:
        """Warnings of reading the mesh, such as dropped faces."""
    @staticmethod
    def decode(bytes: bytes, format: str | None = None, *, progress: _Progress | None = None) -> Mesh:
        """Reads a mesh from the bytes of a file."""
    def encode(self, format: str) -> bytes:
        """Returns the bytes that write() writes; format: an extension without the dot."""
    def write(self, path: _Path) -> None: ...

class Stroke:
    """A stroke of the laser: keys are (time in s, origin in m, direction)."""

    def __init__(
        self,
        keys: Iterable[tuple[float, npt.ArrayLike, npt.ArrayLike]],
        radius: float | None = None,
        range: tuple[float, float] | None = None,
        power: float = 2000.0,
        *,
        wavelength: float | None = None,
        focus: float | None = None,
        pulse_rate: float | None = None,
        duty: float = 1.0,
        assist: Literal["none", "oxygen"] = "none",
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
    """Watts, >= 0, for the thermal model, as are the following attributes."""
    wavelength: float | None
    """Metres; None: that of the usual laser for the material."""
    focus: float | None
    """Metres along the beam to its waist; None: the radius is constant."""
    pulse_rate: float | None
    """Hertz; None: a continuous beam."""
    duty: float
    """Share of each pulse period with the beam on, 0 < duty <= 1."""
    assist: Literal["none", "oxygen"]
    """The gas."""

class Hits:
    """Points of surfaces, n in total, of k rays, points or one box."""

    @property
    def offsets(self) -> npt.NDArray[np.uint64]:
        """all_hits: shape (k + 1,); hits of ray i are offsets[i] to offsets[i + 1] - 1. Other queries: empty."""
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
    @property
    def barycentrics(self) -> npt.NDArray[np.float64]:
        """Shape (n, 3), of the point in its face."""
    @property
    def position(self) -> npt.NDArray[np.float64]:
        """Shape (n, 3), metres in the world."""
    @property
    def normal(self) -> npt.NDArray[np.float64]:
        """Shape (n, 3), unit and outward; 0 on a miss."""
    @property
    def material(self) -> npt.NDArray[np.uint16]:
        """Shape (n,), indices of materials of the mesh."""
    @property
    def is_cut(self) -> npt.NDArray[np.bool_]:
        """Shape (n,), true for walls that a cut made in a solid."""

class BodyInfo:
    """Properties of a body when World.info was called."""

    @property
    def name(self) -> str: ...
    @property
    def material(self) -> str | None:
        """A name from `kerf materials`; None for any other."""
    @property
    def position(self) -> npt.NDArray[np.float64]:
        """Shape (3,), metres."""
    @property
    def orientation(self) -> npt.NDArray[np.float64]:
        """Unit quaternion w, x, y, z."""
    @property
    def velocity(self) -> npt.NDArray[np.float64]:
        """Of the point at `position`, shape (3,), m/s."""
    @property
    def spin(self) -> npt.NDArray[np.float64]:
        """Shape (3,), rad/s in world axes."""
    @property
    def thickness(self) -> float:
        """Of the sheet, metres."""
    @property
    def density(self) -> float:
        """kg/m^3."""
    @property
    def face_count(self) -> int: ...
    @property
    def piece_count(self) -> int: ...
    @property
    def is_solid(self) -> bool: ...
    @property
    def is_hidden(self) -> bool: ...
    @property
    def is_fixed(self) -> bool: ...
    @property
    def is_asleep(self) -> bool: ...

class BodyChanges:
    """Changes of a body. Faces ascend; each is in at most one list."""

    @property
    def body(self) -> int: ...
    @property
    def created(self) -> bool: ...
    @property
    def destroyed(self) -> bool: ...
    @property
    def placement_changed(self) -> bool: ...
    @property
    def properties_changed(self) -> bool: ...
    @property
    def visibility_changed(self) -> bool: ...
    @property
    def added(self) -> npt.NDArray[np.uint32]:
        """Faces that are new or have other corners."""
    @property
    def added_pieces(self) -> npt.NDArray[np.uint32]: ...
    @property
    def removed(self) -> npt.NDArray[np.uint32]:
        """Faces that no longer exist."""
    @property
    def moved(self) -> npt.NDArray[np.uint32]:
        """Other faces whose piece changed."""
    @property
    def moved_pieces(self) -> npt.NDArray[np.uint32]: ...
    @property
    def new_pieces(self) -> list[tuple[int, int | None]]:
        """(label, label of the piece from which it was cut off)."""
    @property
    def destroyed_pieces(self) -> npt.NDArray[np.uint32]: ...

class Changes:
    """Changes of a world since the last call of World.take_changes."""

    @property
    def everything(self) -> bool:
        """True if any part may have changed and the lists are empty."""
    @property
    def bodies(self) -> list[BodyChanges]: ...
    @property
    def detached(self) -> list[tuple[int, int, int, bool]]:
        """Pieces that moved to another body: (from, to, piece, keeps_faces)."""

class World:
    """The bodies that a laser cuts."""

    def __init__(self) -> None: ...
    @staticmethod
    def open(path: _Path, *, progress: _Progress | None = None) -> World: ...
    def add(
        self,
        mesh: Mesh | _Faces | _Triangles,
        name: str = "mesh",
        *,
        position: npt.ArrayLike | None = None,
        orientation: npt.ArrayLike | None = None,
        material: str | None = None,
        thickness: float = 0.001,
        density: float | None = None,
        is_solid: bool = False,
        is_hidden: bool = False,
        is_fixed: bool = False,
    ) -> int: ...
    @property
    def bodies(self) -> list[int]: ...
    def info(self, body: int) -> BodyInfo: ...
    def faces(self, body: int) -> npt.NDArray[np.uint32]: ...
    def corners(self, body: int, faces: Iterable[int]) -> npt.NDArray[np.float64]: ...
    def piece_labels(self, body: int, faces: Iterable[int]) -> npt.NDArray[np.uint32]: ...
    def piece(self, body: int, piece: int) -> Mesh: ...
    def move(
        self, body: int, piece: int, position: npt.ArrayLike, orientation: npt.ArrayLike | None = None
    ) -> int: ...
    def set_sheet(
        self,
        body: int,
        piece: int,
        material: str | None = None,
        thickness: float = 0.001,
        density: float | None = None,
    ) -> int: ...
    def set_solid(self, body: int, piece: int, is_solid: bool) -> int: ...
    def set_hidden(self, body: int, piece: int, is_hidden: bool) -> int: ...
    def set_fixed(self, body: int, piece: int, is_fixed: bool) -> int: ...
    def rename(self, body: int, piece: int, name: str) -> None: ...
    def remove(self, body: int, piece: int) -> None: ...
    def join(
        self,
        body: int,
        kind: Literal["weld", "hinge", "hub"],
        part_a: npt.ArrayLike,
        part_b: npt.ArrayLike,
        *,
        anchor: npt.ArrayLike,
        axis: npt.ArrayLike | None = None,
        limits: tuple[float, float] | None = None,
        radius: float | None = None,
    ) -> None: ...
    def set_environment(
        self, gravity: npt.ArrayLike | None = None, ground: float | None = None
    ) -> None: ...
    def simulate(self, seconds: float) -> None: ...
    def undo(self) -> bool: ...
    def redo(self) -> bool: ...
    def set_undo_memory(self, bytes: int) -> None: ...
    def take_changes(self) -> Changes: ...
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
        bodies: Iterable[int] | None = None,
        progress: _Progress | None = None,
        threads: int = 0,
    ) -> dict[str, Any]: ...
    def cut_plane(
        self, normal: npt.ArrayLike, offset: float, *, progress: _Progress | None = None, threads: int = 0
    ) -> None: ...
    def begin_stroke(
        self,
        stroke: Stroke,
        *,
        target_edge: float | None = None,
        tolerance: float | None = None,
        max_level: int | None = None,
        rim: Literal["faces", "smooth"] = "faces",
        scheme: Literal["longest-edge", "one-to-four"] = "longest-edge",
        model: Literal["geometric", "thermal"] = "geometric",
        bodies: Iterable[int] | None = None,
    ) -> None: ...
    def add_pose(self, time: float, origin: npt.ArrayLike, direction: npt.ArrayLike) -> None: ...
    def step_stroke(
        self, max_faces: int | None = None, max_seconds: float | None = None
    ) -> dict[str, Any]: ...
    def end_stroke(self) -> None: ...
    def cancel_stroke(self) -> None: ...
    @property
    def pieces(self) -> list[Mesh]: ...
    def nearest_hits(
        self, origins: npt.ArrayLike, directions: npt.ArrayLike, *, range: tuple[float, float] | None = None
    ) -> Hits: ...
    def all_hits(
        self, origins: npt.ArrayLike, directions: npt.ArrayLike, *, range: tuple[float, float] | None = None
    ) -> Hits: ...
    def closest_points(self, points: npt.ArrayLike, *, max_distance: float | None = None) -> Hits: ...
    def faces_in_box(self, min: npt.ArrayLike, max: npt.ArrayLike) -> Hits: ...
    def save_scene(self, folder: _Path) -> None: ...
    def save_journal(self, path: _Path) -> None: ...
    def report(self) -> dict[str, Any]: ...
    def graph(self) -> dict[str, Any]: ...
    @property
    def hash(self) -> str: ...
