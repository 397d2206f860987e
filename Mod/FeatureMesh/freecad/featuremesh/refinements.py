# SPDX-License-Identifier: GPL-3.0-or-later
"""What the refinements of a mesh object ask for: FEM's own local sizes, and zones."""

from dataclasses import dataclass, field

from . import error_sizes, resolving, size_zone
from .errors import UserError
from .messages import said
from .proxies import type_of
from .reading import describe
from .resolving import Resolver

# FEM's refinements; those of later versions, too.
_FEMS_OWN = ("Fem::MeshRegion", "Fem::MeshRefinement", "Fem::MeshDistance", "Fem::MeshShape")


@dataclass
class Refinements:
    """What a mesh is to be refined by."""
    local: list = field(default_factory=list)   # ("Face12", size in mm, the object)
    zones: list = field(default_factory=list)   # (what the engine takes, see size_zone.wish_of, the object)
    balls: list = field(default_factory=list)   # what the engine takes, see error_sizes.balls_of
    notes: list = field(default_factory=list)   # a message for each that is left out

    def at_entities(self):
        """("Face12", size in mm, name of the refinement) for all that refines around faces, edges and vertices."""
        near = [(name, wish["inner"], obj) for wish, obj in self.zones for name in wish.get("entities", ())]
        return [(name, size, describe(obj)) for name, size, obj in self.local + near]

    def options(self):
        """As the engine takes them."""
        asked = {"zones": [wish for wish, _ in self.zones], "balls": self.balls}
        return {"local": [(name, size) for name, size, _ in self.local], **{name: values for name, values in asked.items() if values}}


def list_for(obj):
    """The property of a mesh object in which a refinement or a mesh group is listed; None for anything else."""
    kind = type_of(obj)
    if kind == "Fem::MeshGroup":
        return "MeshGroupList"
    return "MeshRegionList" if kind in _FEMS_OWN or size_zone.is_zone(obj) or error_sizes.is_error_sizes(obj) else None


def read(mesh, part, raw=None):
    """The Refinements of a mesh object; `raw` is the part as it was read, if it was. Throws UserError for a reference that is not on the part."""
    found, resolver = Refinements(), Resolver(part, raw)
    for obj in mesh.MeshRegionList:
        if size_zone.is_suppressed(obj):
            found.notes.append(said("The refinement {zone:text} is suppressed and left out.", zone=obj.Label))
            continue
        if error_sizes.is_error_sizes(obj):
            found.balls += error_sizes.balls_of(obj, part)
            continue
        names, foreign = resolver.of_object(obj)
        if foreign:
            raise UserError(said("the refinement {refinement:text} refers to {place:text}, which is not on {part:text}; refer to faces of that one",
                                 refinement=describe(obj), place=resolving.describe(*foreign[0]), part=describe(part)))
        _take(obj, names, found)
    return found


def _take(obj, names, found):
    wish = size_zone.wish_of(obj, names)
    if wish is None and not hasattr(obj, "CharacteristicLength"):
        found.notes.append(said("The refinement {zone:text} is of a kind that is not understood and left out. Use a refinement zone instead.",
            zone=obj.Label))
    elif not names and (wish is None or "entities" in wish):
        found.notes.append(said("The refinement {zone:text} refers to nothing and is left out. Choose faces, edges or vertices for it, or "
                              "suppress it.", zone=obj.Label))
    elif wish is not None:
        found.zones.append((wish, obj))
    elif obj.CharacteristicLength.Value <= 0:
        found.notes.append(said("The refinement {zone:text} has no size and is left out. Give it one, or suppress it.",
                                zone=obj.Label))
    else:
        found.local += [(name, obj.CharacteristicLength.Value, obj) for name in names]
