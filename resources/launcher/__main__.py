# SPDX-License-Identifier: GPL-3.0-or-later
"""`featuremesh COMMAND ...`: sets up what is missing, then runs. Exit code 0 for success, 2 for the user's error, 1 for ours, 3 where
something cannot be had on this machine."""
import signal
import sys

from arguments import parse
from closed_pipe import run_until_unread
from layout import Failure, Unavailable, UserError


def interrupt(_signal, _frame):
    raise KeyboardInterrupt


def main():
    signal.signal(signal.SIGTERM, interrupt)  # whoever ends the launcher ends what it started
    given = parse(sys.argv[1:])
    try:
        return given.run(given)
    except UserError as error:
        print(f"featuremesh {given.command}: {error}", file=sys.stderr)
        return 2
    except Failure as error:
        print(f"featuremesh {given.command}: {error}", file=sys.stderr)
        return 1
    except Unavailable as error:
        print(f"featuremesh {given.command}: {error}", file=sys.stderr)
        return 3
    except KeyboardInterrupt:
        print(f"\nfeaturemesh {given.command}: cancelled", file=sys.stderr)
        return 1


sys.exit(run_until_unread(main))
