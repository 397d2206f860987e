# SPDX-License-Identifier: GPL-3.0-or-later
"""`featuremesh COMMAND ...`: sets up what is missing, then runs. Exit code 0 for success, 2 for the user's error, 1 for ours, 3 where
something cannot be had on this machine, 130 when it was cancelled."""
import errno
import os
import signal
import sys

CANCELLED = 128 + signal.SIGINT   # as shells have it


def cancel_at_once(_signal, _frame):
    os.write(2, b"\nfeaturemesh: cancelled\n")
    os._exit(CANCELLED)


signal.signal(signal.SIGINT, cancel_at_once)   # until there is something to end
signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})   # blocked while Python started

from arguments import parse  # noqa: E402
from closed_pipe import run_until_unread  # noqa: E402
from layout import Failure, Unavailable, UserError  # noqa: E402


def interrupt(_signal, _frame):
    raise KeyboardInterrupt


def main():
    signal.signal(signal.SIGTERM, interrupt)  # whoever ends the launcher ends what it started
    given = parse(sys.argv[1:])
    try:
        os.getcwd()
    except FileNotFoundError:
        print("featuremesh: the folder that it was started in is gone; change to another one", file=sys.stderr)
        return 2
    try:
        signal.signal(signal.SIGINT, signal.default_int_handler)
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
    except OSError as error:
        if error.errno not in (errno.ENOSPC, errno.EDQUOT) and "temporary directory" not in str(error):
            raise
        print(f"featuremesh {given.command}: the disk is full ({error})", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print(f"\nfeaturemesh {given.command}: cancelled", file=sys.stderr)
        return CANCELLED


sys.exit(run_until_unread(main))
