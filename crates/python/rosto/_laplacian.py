"""δ-coordinates of any triangle mesh."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
import numpy.typing as npt

from ._mesh import Mesh
from ._numbers import Number, Vector, coordinates, corners, number, vector, whole, wholes
from ._rosto import System

if TYPE_CHECKING:
    import scipy.sparse


class Laplacian:
    """A mesh with one of the Laplacians, factorised once; it knows nothing of faces.

    ``mesh`` is a :class:`Mesh` or a pair of positions ``(V, 3)``, in any unit, and triangles ``(T, 3)``. ``operator`` is one of
    the command line's ``--operator``. Positions and triangles are copied. It pickles as what it was made of, and is factorised
    again where it arrives.

    Raises :class:`RostoError` for coordinates that are not finite, indices that are not whole numbers or name no vertex, and
    anything else that has no answer; ``TypeError`` for what are not numbers.
    """

    def __init__(
        self, mesh: Union[Mesh, tuple[npt.ArrayLike, npt.ArrayLike]], operator: str = "cotangent"
    ) -> None:
        positions, triangles = (mesh.positions_m, mesh.triangles) if isinstance(mesh, Mesh) else mesh
        self.positions = coordinates("positions", positions)
        self.triangles = corners("triangles", triangles, len(self.positions))
        self.operator = operator
        self._system = System(self.positions, self.triangles, operator)

    def edit(
        self,
        handles: Mapping[int, Vector],
        anchors: Union[Sequence[int], npt.NDArray[Any], int],
        weight: Optional[Number] = None,
    ) -> npt.NDArray[np.float64]:
        """The positions ``(V, 3)`` of the mesh with ``handles`` (an offset for each vertex) moved and ``anchors`` held.

        The rest follows by keeping its δ-coordinates. Handles and anchors are held exactly, or with the ``weight`` of a soft
        constraint; the paper's is 1.
        """
        last = len(self.positions) - 1
        moved = [whole("handles", vertex, most=last) for vertex in handles]
        offsets = [vector(f"handles[{vertex}]", offset) for vertex, offset in handles.items()]
        held = list(wholes("anchors", anchors, most=last))
        soft = None if weight is None else number("weight", weight)
        return self._system.edit(moved, np.array(offsets, np.float64).reshape(-1, 3), held, soft)

    def deltas(self, positions: Optional[npt.ArrayLike] = None) -> npt.NDArray[np.float64]:
        """The δ-coordinates ``(V, 3)`` of the mesh, or of other positions of its vertices."""
        return self._system.deltas(self.positions if positions is None else coordinates("positions", positions))

    def matrix(self) -> "scipy.sparse.csr_array":
        """The operator ``(V, V)``; its rows sum to zero. Needs the package ``scipy``."""
        from scipy.sparse import csr_array

        count = len(self.positions)
        return csr_array(self._system.matrix(), shape=(count, count))

    def __repr__(self) -> str:
        return f"Laplacian({len(self.positions)} vertices, {len(self.triangles)} triangles, {self.operator!r})"

    def __reduce__(self) -> Any:
        return Laplacian, ((self.positions, self.triangles), self.operator)
