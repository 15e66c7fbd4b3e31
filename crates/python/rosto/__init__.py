"""Face landmarks and editable, coloured 3D meshes from photos, and Laplacian editing of any mesh.

Everything runs locally, and results are bit-identical to those of the command line and the page. Calls use one thread
unless you set ``jobs``, and release the GIL. Each process loads the networks once, on first use.

Images are paths; JPEG, PNG or WebP files as ``bytes``, ``bytearray``, ``memoryview`` or file objects; ``uint8`` sRGB
arrays of shape ``(height, width, 3)``, ``(height, width, 4)`` with alpha, or ``(height, width)`` for grey; or Pillow
images. Transparent pixels are composited over white. EXIF orientation and colour profiles of files and Pillow images
are applied; arrays are used unchanged.

Numbers may be NumPy scalars. Left and right are the subject's. Names ending in ``_m`` are in metres, in ``_mm`` in
millimetres.
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
