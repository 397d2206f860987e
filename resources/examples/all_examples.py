# SPDX-License-Identifier: GPL-3.0-or-later
"""All example parts by name, each with the function that draws it."""
import block_and_cylinder
import bracket
import csg_flange
import tool_with_stiffener

MAKERS = {
    "bracket": bracket.make,
    "block_and_cylinder": block_and_cylinder.make,
    "tool": tool_with_stiffener.make_without,
    "tool_with_stiffener": tool_with_stiffener.make,
    "csg_flange": csg_flange.make,
}
