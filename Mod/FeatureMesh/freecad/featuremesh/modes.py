# SPDX-License-Identifier: GPL-3.0-or-later
"""Frequencies and buckling factors, of the tables that CalculiX prints."""

import itertools

# Kind of analysis -> title of the table, number of its columns, the column wanted.
TABLES = {"frequency": ("E I G E N V A L U E   O U T P U T", 5, 3), "buckling": ("B U C K L I N G", 2, 1)}


def read(text, kind):
    """The frequencies (Hz) or buckling factors of a .dat file's text, in CalculiX's order, whose table has no row for a mode below what was asked for: of a part that
    can move that may be the first of those near 0 Hz."""
    title, columns, column = TABLES[kind]
    _, _, rest = text.partition(title)
    of_table = itertools.dropwhile(lambda row: not _is_mode(row, columns), map(str.split, rest.splitlines()))
    return [float(row[column]) for row in itertools.takewhile(lambda row: _is_mode(row, columns), of_table)]


def _is_mode(row, columns):
    return len(row) == columns and row[0].isdigit()
