# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user prefers, kept by FreeCAD: what a new mesh starts with in the window, where the engine runs, and colours.

Scripts and the launcher's commands do not ask for preferences, so they give the same mesh for everybody.
"""

import FreeCAD

GROUP = "User parameter:BaseApp/Preferences/Mod/FeatureMesh"
# Name -> default; the type of the default is the type of the preference. Colours are 0xRRGGBBAA as FreeCAD keeps them.
DEFAULTS = {
    "ElementsAlongDiagonal": 30,
    "SecondOrder": True,
    "Threads": 0,
    "Automatic": True,
    "InWorker": True,
    "WelcomeSeen": False,
}
COLOURS = {
    "KeptColour": 0x5B9BD5FF,
    "ActiveColour": 0xFFE14DFF,
    "NewColour": 0xF28C28FF,
}


def get(name):
    """The preference of that name."""
    default = DEFAULTS[name]
    group = FreeCAD.ParamGet(GROUP)
    return group.GetBool(name, default) if isinstance(default, bool) else group.GetInt(name, default)


def put(name, value):
    """Sets the preference of that name."""
    group = FreeCAD.ParamGet(GROUP)
    if isinstance(DEFAULTS[name], bool):
        group.SetBool(name, bool(value))
    else:
        group.SetInt(name, int(value))


def colour(name):
    """(red, green, blue) from 0 to 1."""
    packed = FreeCAD.ParamGet(GROUP).GetUnsigned(name, COLOURS[name])
    return tuple((packed >> shift & 255) / 255 for shift in (24, 16, 8))


def put_colour(name, rgb):
    """Sets a colour from its red, green and blue, 0 to 1."""
    red, green, blue = (round(255 * value) for value in rgb)
    FreeCAD.ParamGet(GROUP).SetUnsigned(name, red << 24 | green << 16 | blue << 8 | 255)


def for_new_mesh(in_place_of=None):
    """The settings of a new mesh as arguments of api.add_mesh; one `in_place_of` another maker's has the order of that."""
    order = {"order": 2 if get("SecondOrder") else 1} if in_place_of is None else {"in_place_of": in_place_of}
    return {"elements": get("ElementsAlongDiagonal"), **order, **for_adopted_mesh()}


def for_adopted_mesh():
    """Those of them that another maker's mesh does not bring along."""
    return {"threads": get("Threads"), "automatic": get("Automatic")}
