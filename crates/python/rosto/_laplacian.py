"""Laplacian editing of triangle meshes."""

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
    """Laplacian editor of any triangle mesh; factorises its operator once.

    ``mesh`` is a :class:`Mesh`, or a pair of positions ``(V, 3)`` in any unit and triangles ``(T, 3)``; both are
    copied. ``operator`` is an id of the command line's ``--operator``. Pickling stores the mesh; unpickling factorises
    again.

    Raises :class:`RostoError` for coordinates that are not finite, invalid indices, and unsolvable systems;
    ``TypeError`` for values that are not numbers.
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
        """Returns the positions ``(V, 3)`` after moving ``handles`` (vertex to offset) and fixing ``anchors``.

        The other vertices keep their δ-coordinates as far as possible. Constraints are hard, or soft with ``weight``;
        the paper uses 1.
        """
        last = len(self.positions) - 1
        moved = [whole("handles", vertex, most=last) for vertex in handles]
        offsets = [vector(f"handles[{vertex}]", offset) for vertex, offset in handles.items()]
        fixed = list(wholes("anchors", anchors, most=last))
        soft = None if weight is None else number("weight", weight)
        return self._system.edit(moved, np.array(offsets, np.float64).reshape(-1, 3), fixed, soft)

    def deltas(self, positions: Optional[npt.ArrayLike] = None) -> npt.NDArray[np.float64]:
        """Returns the δ-coordinates ``(V, 3)`` of the mesh, or of other ``positions`` of its vertices."""
        return self._system.deltas(self.positions if positions is None else coordinates("positions", positions))

    def matrix(self) -> "scipy.sparse.csr_array":
        """Returns the operator ``(V, V)``, whose rows sum to zero. Requires ``scipy``."""
        from scipy.sparse import csr_array

        count = len(self.positions)
        return csr_array(self._system.matrix(), shape=(count, count))

    def __repr__(self) -> str:
        return f"Laplacian({len(self.positions)} vertices, {len(self.triangles)} triangles, {self.operator!r})"

    def __reduce__(self) -> Any:
        return Laplacian, ((self.positions, self.triangles), self.operator)
