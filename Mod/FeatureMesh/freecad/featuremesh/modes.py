# SPDX-License-Identifier: GPL-3.0-or-later
"""Frequencies and buckling factors, of the tables that CalculiX prints."""

# Kind of analysis -> title of the table, number of its columns, the column wanted.
TABLES = {"frequency": ("E I G E N V A L U E   O U T P U T", 5, 3), "buckling": ("B U C K L I N G", 2, 1)}


def read(text, kind):
    """The frequencies (Hz) or buckling factors of a .dat file's text, in CalculiX's order."""
    title, columns, column = TABLES[kind]
    _, _, rest = text.partition(title)
    found = []
    for row in map(str.split, rest.splitlines()):
        if len(row) == columns and row[0] == str(len(found) + 1):
            found.append(float(row[column]))
    return found
