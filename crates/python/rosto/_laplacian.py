"""δ-coordinates of any triangle mesh."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
import numpy.typing as npt

from ._mesh import Mesh
from ._rosto import System

if TYPE_CHECKING:
    import scipy.sparse

Vector = Sequence[float]


class Laplacian:
    """A mesh with one of the Laplacians, factorised once; it knows nothing of faces.

    ``mesh`` is a :class:`Mesh` or a pair of positions ``(V, 3)``, in any unit, and triangles ``(T, 3)``. ``operator`` is one of
    the command line's ``--operator``. It pickles as what it was made of, and is factorised anew where it arrives.
    """

    def __init__(
        self, mesh: Union[Mesh, tuple[npt.ArrayLike, npt.ArrayLike]], operator: str = "cotangent"
    ) -> None:
        positions, triangles = (mesh.positions_m, mesh.triangles) if isinstance(mesh, Mesh) else mesh
        self.positions = np.ascontiguousarray(positions, np.float64)
        self.triangles = np.ascontiguousarray(triangles, np.uint32)
        self.operator = operator
        self._system = System(self.positions, self.triangles, operator)

    def edit(
        self, handles: Mapping[int, Vector], anchors: Sequence[int], weight: Optional[float] = None
    ) -> npt.NDArray[np.float64]:
        """The positions ``(V, 3)`` of the mesh with ``handles`` (an offset for each vertex) moved and ``anchors`` held.

        The rest follows by keeping its δ-coordinates. Handles and anchors are held exactly, or with the ``weight`` of a soft
        constraint; the paper's is 1.
        """
        offsets = np.array(list(handles.values()), np.float64).reshape(-1, 3)
        return self._system.edit(list(handles), offsets, list(anchors), weight)

    def deltas(self, positions: Optional[npt.ArrayLike] = None) -> npt.NDArray[np.float64]:
        """The δ-coordinates ``(V, 3)`` of the mesh, or of other positions of its vertices."""
        asked = self.positions if positions is None else np.ascontiguousarray(positions, np.float64)
        return self._system.deltas(asked)

    def matrix(self) -> "scipy.sparse.csr_array":
        """The operator ``(V, V)``; its rows sum to zero. Needs the package ``scipy``."""
        from scipy.sparse import csr_array

        count = len(self.positions)
        return csr_array(self._system.matrix(), shape=(count, count))

    def __reduce__(self) -> Any:
        return Laplacian, ((self.positions, self.triangles), self.operator)
