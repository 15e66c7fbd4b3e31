"""Photos of faces to 468 landmarks and editable, coloured 3D meshes; δ-coordinates for any mesh.

Everything is computed on this machine, by the same core as the command line's and the page's, and to the same bits. Calls
use one thread unless ``jobs`` says more, and let other threads of Python run meanwhile. Networks are loaded once for each
process, when they are needed first.

Images are paths; JPEG, PNG or WebP files as ``bytes``, ``bytearray`` or ``memoryview``, or open for reading; arrays, ``uint8``,
sRGB, of the shape ``(height, width, 3)``, ``(height, width, 4)`` with alpha, or ``(height, width)`` for grey; or images of
Pillow's. Transparency is laid over white. A file's or a Pillow image's EXIF orientation and colour profile are applied; an
array is taken as it is.

Numbers may be NumPy's. Left and right are the subject's. Lengths are in metres where names end in ``_m`` and in millimetres
where they end in ``_mm``.
"""

from ._edits import Edit, Expression, Region, Slider, Symmetrise, Vertex
from ._images import Image
from ._landmarks import Face, Landmarks, Search, faces, landmarks
from ._laplacian import Laplacian
from ._mesh import Mesh, mesh
from ._rosto import RostoError

__all__ = [
    "Edit",
    "Expression",
    "Face",
    "Image",
    "Landmarks",
    "Laplacian",
    "Mesh",
    "Region",
    "RostoError",
    "Search",
    "Slider",
    "Symmetrise",
    "Vertex",
    "faces",
    "landmarks",
    "mesh",
]
