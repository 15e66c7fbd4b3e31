"""The command line, as ``python -m rosto`` or ``rosto``."""

import os
import sys

from ._images import NETWORKS
from ._rosto import command_line


def main() -> None:
    os.environ.setdefault("ROSTO_NETWORKS", str(NETWORKS))
    sys.exit(command_line(sys.argv))


if __name__ == "__main__":
    main()
