from collections.abc import Callable, Iterable
from os import PathLike
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

__version__: str

_Path = str | bytes | PathLike[str] | PathLike[bytes]

class Error(RuntimeError):
    """A call that failed; it has changed nothing."""

class Cancelled(Error):
    """A call that its progress callback cancelled."""

class Busy(Error):
    """A call that cannot run while another one uses the world."""

class FileNotFound(FileNotFoundError, ValueError):
    """A path without a file."""

def read(path: _Path) -> Mesh:
    """Reads an OBJ, PLY, STL, OFF or glTF file and returns a Mesh."""

class Mesh:
    """A triangle mesh, or a piece of one; immutable."""

    def __init__(self, vertices: npt.ArrayLike, faces: npt.ArrayLike) -> None: ...
    @property
    def vertices(self) -> npt.NDArray[np.float64]:
        """Positions of shape (n, 3), metres."""
    @property
    def faces(self) -> npt.NDArray[np.uint32]:
        """Vertex indices, shape (m, 3)."""
    @property
    def temperatures(self) -> npt.NDArray[np.float64]:
        """Face temperatures of a piece, shape (m,), kelvin; empty for any other mesh."""
    @property
    def area(self) -> float: ...
    @property
    def name(self) -> str: ...
    @property
    def mass(self) -> float: ...
    @property
    def centroid(self) -> npt.NDArray[np.float64]: ...
    @property
    def inertia(self) -> npt.NDArray[np.float64]: ...
    @property
    def boundary_edges(self) -> int: ...
    @property
    def placement(self) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]: ...
    def write(self, path: _Path) -> None: ...

class Stroke:
    """A stroke of the laser: keys are (time in s, origin in m, direction)."""

    def __init__(
        self,
        keys: Iterable[tuple[float, npt.ArrayLike, npt.ArrayLike]],
        radius: float | None = ...,
        range: tuple[float, float] | None = ...,
        power: float | None = ...,
    ) -> None: ...

class Hits:
    first: npt.NDArray[np.uint64]
    distance: npt.NDArray[np.float64]
    body: npt.NDArray[np.uint32]
    face: npt.NDArray[np.uint32]

class World:
    """The bodies that a laser cuts."""

    def __init__(self) -> None: ...
    @staticmethod
    def open(path: _Path) -> World: ...
    def add(self, mesh: Mesh, name: str = ...) -> None: ...
    def cut(
        self,
        strokes: Stroke | Iterable[Stroke],
        *,
        target_edge: float | None = ...,
        tolerance: float | None = ...,
        levels: int | None = ...,
        rim: Literal["faces", "smooth"] = ...,
        scheme: Literal["longest-edge", "one-to-four"] = ...,
        model: Literal["geometric", "thermal"] = ...,
        material: str | None = ...,
        progress: Callable[[float], object] | None = ...,
        threads: int = ...,
    ) -> dict[str, Any]: ...
    @property
    def pieces(self) -> list[Mesh]: ...
    def nearest_hits(
        self, origins: npt.ArrayLike, directions: npt.ArrayLike, *, range: tuple[float, float] | None = ...
    ) -> Hits: ...
    def all_hits(
        self, origins: npt.ArrayLike, directions: npt.ArrayLike, *, range: tuple[float, float] | None = ...
    ) -> Hits: ...
    def save_scene(self, folder: _Path) -> None: ...
    def save_journal(self, path: _Path) -> None: ...
    def report(self) -> dict[str, Any]: ...
    def graph(self) -> dict[str, Any]: ...
    @property
    def hash(self) -> str: ...
