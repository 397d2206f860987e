# SPDX-License-Identifier: GPL-3.0-or-later
"""Designs for quadratic response surfaces, in coded units: -1 is a parameter's low end, 1 its high end. (Box and Wilson 1951; Box and Behnken 1960.)"""

import itertools

import numpy as np


def box_behnken(count):
    """(n, count), three parameters at least: for each two parameters their four corners with the others in the middle, and the middle once. Cases are computed, so the
    middle is not repeated."""
    found = []
    for pair in itertools.combinations(range(count), 2):
        for corner in itertools.product((-1.0, 1.0), repeat=2):
            row = np.zeros(count)
            row[list(pair)] = corner
            found.append(row)
    return np.array([*found, np.zeros(count)])


def central_composite(count):
    """(2^count + 2 count + 1, count): the corners, the middles of the sides (face-centred, so nothing leaves the bounds), the middle."""
    corners = np.array(list(itertools.product((-1.0, 1.0), repeat=count)))
    return np.vstack([corners, -np.eye(count), np.eye(count), np.zeros((1, count))])
