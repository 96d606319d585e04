"""`meshmend-worker`: the `worker` of the command line, as a process of its own."""

import signal
import sys

from . import _native


def main() -> None:
    """Mends files as standard input asks for them."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    sys.exit(_native.command_line(["meshmend", "worker", *sys.argv[1:]]))


if __name__ == "__main__":
    main()
