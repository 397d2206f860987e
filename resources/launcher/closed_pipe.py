# SPDX-License-Identifier: GPL-3.0-or-later
"""What a program does when nobody reads its output any more."""
import os
import sys


def run_until_unread(main):
    """The exit code that main() gives; 1, without a word, when whoever read along has seen enough, as `head` has."""
    try:
        try:
            return main()
        finally:
            sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # for what Python itself writes at its end
        return 1
