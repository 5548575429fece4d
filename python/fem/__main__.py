"""The command `fem`."""

from __future__ import annotations

import sys

from fem import _fem


def main() -> int:
    """Runs the command of the command line, and returns its exit status."""
    return _fem.command(["fem", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
