# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths as they are typed."""
import argparse
import math


def millimetres(text):
    """A number, with or without its unit."""
    try:
        length = float(text.strip().removesuffix("mm"))
    except ValueError:
        length = math.inf
    if math.isinf(length):
        raise argparse.ArgumentTypeError("'%s' is no length in mm, such as 2.5" % text)
    return length


def ignored_length(text):
    """The property IgnoreBelow: mm, 0 for auto, -1 for off."""
    if text in ("auto", "off"):
        return 0.0 if text == "auto" else -1.0
    try:
        length = millimetres(text)
    except argparse.ArgumentTypeError:
        length = 0.0
    if not 0 < length < math.inf:
        raise argparse.ArgumentTypeError("'%s' is no length above zero, nor auto or off" % text)
    return length


def share(text):
    """A percentage, with or without its sign, as a share."""
    try:
        percent = float(text.strip().removesuffix("%"))
    except ValueError:
        percent = 0.0
    if not 0 < percent < 100:
        raise argparse.ArgumentTypeError("'%s' is no percentage between 0 and 100, such as 5" % text)
    return percent / 100
