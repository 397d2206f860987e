# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps loads, supports, materials, groups and refinements where they were when an edit gives faces, edges and solids other numbers.

FreeCAD 0.20 knows them by number only: a constraint on Face11 stays on Face11 when that number comes to mean another face. Since 1.0
FreeCAD follows them itself, and marks with a question mark ("?Face11") what it lost; its verdict is held against ours. What each object
referred to at the last mesh is on record. What it became is known by the features that made the faces; what is gone is taken out of the
references, for a load must never act on a face that nobody chose, and an object that has nothing left is marked until it is mended.
"""

from contextlib import contextmanager

import FreeCAD

from . import analyses, assembled, versions
from .messages import said
from .proxies import HIDDEN
from .reading import has_shape
from .resolving import CLICKED, LOST, describe, is_between_solids, is_element_of, pairs_of, path_of

translate = FreeCAD.Qt.translate

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
# Is a task panel of the object open? It keeps its own list of references, so nobody else may change them. Set by the window's side.
is_in_edit = None
# Gives the paths (resolving.CLICKED) of those references of an object that were clicked through a link. Set by the window's side.
clicked_through = None
# A property of objects that have nothing left to refer to: the names of what they have lost.
MARK = "LostReferences"
# Properties that say along or about what a load acts: the direction of a force, the axis of a centrifugal load. FreeCAD takes the normal of a face where
# a direction is gone.
ALONG = ("Direction", "RotationAxis")
_OF_A_SHAPE = "Face", "Edge", "Vertex"   # FreeCAD 1.0 loses solids that are there
_OPPOSITE = 0.999   # the cosine of directions that are one another's opposite, without its sign
# A property of objects whose direction is gone: the names of what it was.
LOST_ALONG = "LostDirection"

_moved = set()   # (name of the document, name) of what was given other references since the last recompute

ELSEWHERE = QT_TRANSLATE_NOOP("FeatureMesh", "{object:text} refers to {where:entities}, which is not on the meshed part {part:text} and has no nodes in its mesh; choose "
                              "faces, edges or vertices of {part:text} instead")
_TAKEN_OUT = QT_TRANSLATE_NOOP("FeatureMesh", "{object:text} refers to {lost:entities}, which is gone; it was taken out of the references")
_CHOOSE_ANOTHER = {
    "Face": QT_TRANSLATE_NOOP("FeatureMesh", "{object:text} refers to {lost:entities}, which is gone; choose another face, the analysis cannot be solved without"),
    "Edge": QT_TRANSLATE_NOOP("FeatureMesh", "{object:text} refers to {lost:entities}, which is gone; choose another edge, the analysis cannot be solved without"),
    "Vertex": QT_TRANSLATE_NOOP("FeatureMesh", "{object:text} refers to {lost:entities}, which is gone; choose another vertex, the analysis cannot be solved without"),
    "Solid": QT_TRANSLATE_NOOP("FeatureMesh", "{object:text} refers to {lost:entities}, which is gone; choose another solid, the analysis cannot be solved without"),
}
# Of a load on what has no elements in the mesh.
ACTS_ON_NOTHING = QT_TRANSLATE_NOOP("FeatureMesh", "{object:text} acts on {places:entities}, where the mesh has no elements: that is too small for them, or lies on "
                               "another face; choose another face, or set Ignore below to off")
_CHOOSE_DIRECTION = QT_TRANSLATE_NOOP("FeatureMesh", "{object:text} acts along {lost:entities}, which is gone; open it and choose its direction again, the analysis cannot be "
                                      "solved without")


def record_of(objects, resolver):
    """{object name: {"pairs": what it refers to, "names": the sub-elements of the part that this means}}, to be followed later; with "along", if it
    acts along or about something of the part: {property: the same of that}."""
    record = {}
    for obj in objects:
        names, foreign = resolver.of_object(obj)
        if names and not foreign and not resolver.without_trace(obj):
            record[obj.Name] = {"pairs": plain_pairs(obj), "names": names}
            along = {name: {"pairs": plain_pairs(obj, name), "names": meant} for name, meant in _meant_along(obj, resolver).items()}
            record[obj.Name].update({"along": along} if _may_act_along(obj) else {})
    return record


def plain_pairs(obj, name="References"):
    """What an object refers to as [[object name, sub-element], ...]."""
    return [[target.Name, sub] for target, sub in pairs_of(obj, name)]


def settle(objects, resolver):
    """Lets `objects` refer to the meshed part itself: what was clicked names the tip of a body, which may be deleted, or a step before it."""
    with not_touched(objects):
        for obj in objects:
            _settle(obj, resolver)


def _settle(obj, resolver):
    for name, meant in _meant_along(obj, resolver).items() if may_change(obj, resolver) else ():
        _refer(obj, resolver.bearer, meant, name)
    pairs = pairs_of(obj)
    if all(target is resolver.bearer and LOST not in sub for target, sub in pairs) or not may_change(obj, resolver) or "" in (sub for _, sub in pairs):
        return
    meant = [resolver.names(target, sub) for target, sub in pairs]
    if all(meant):
        normal = FreeCAD.Vector(getattr(obj, "DirectionVector", FreeCAD.Vector()))
        obj.References = [(resolver.bearer, tuple(dict.fromkeys(name for names in meant for name in names)))]
        if is_between_solids(resolver.part.Shape, meant[0][0]):   # it has the normal of either of them
            _keep_sign(obj, normal)
        if getattr(obj, CLICKED, None):
            setattr(obj, CLICKED, [])


def note_clicks(obj):
    """To be called when an object was given other references: keeps beside what was chosen in its panel through which links that was clicked."""
    if clicked_through is None or not is_being_edited(obj):
        return
    paths = clicked_through(obj)
    if paths and CLICKED not in obj.PropertiesList:
        obj.addProperty("App::PropertyStringList", CLICKED, "FeatureMesh", "What of its references was clicked through a link, with the path to it")
        obj.setEditorMode(CLICKED, HIDDEN)
    if CLICKED in obj.PropertiesList and getattr(obj, CLICKED) != paths:
        setattr(obj, CLICKED, paths)


def is_being_edited(obj):
    """Is a task panel of the object open?"""
    return is_in_edit is not None and is_in_edit(obj)


def may_change(obj, resolver):
    """May the references of the object be written?"""
    return not is_being_edited(obj) and resolver.bearer is not None


def differs(obj, known, deleted):
    """Does the object refer to something else than the record knows, beside what was deleted since?"""
    return any(plain_pairs(obj, name) not in (of["pairs"], [pair for pair in of["pairs"] if pair[0] not in deleted])
               for name, of in (("References", known), *known.get("along", {}).items()))


def are_set_again(obj, known, deleted):
    """Were they set to what they were? Since 1.0 FreeCAD does so whenever a script gives the part another shape, whose faces of these names are others."""
    return versions.follows_faces() and not is_being_edited(obj) and not differs(obj, known, deleted)


def is_left_behind(obj):
    """Does nobody but a mesh let the references of the object follow an edit? Since 1.0 FreeCAD does, unless it has lost something."""
    return not versions.follows_faces() or any(LOST in sub for _, sub in pairs_of(obj))


def lost_by_deletion(known, deleted):
    """Was something that the record knows deleted since?"""
    return any(pair[0] in deleted for of in (known, *known.get("along", {}).values()) for pair in of["pairs"])


def was_changed_by_hand(obj, known, deleted):
    """As `differs`, but never where FreeCAD follows references itself, which changes them, too."""
    return not versions.follows_faces() and differs(obj, known, deleted)


def follow(obj, known, resolver, numbering):
    """Moves the references of one object to what theirs became. Returns a line for each thing to know, and {property: names of what is gone}.

    `known` is what record_of said of it, `numbering` the Numbering from then to now.
    """
    now, lost, lines, moved = [], [], [], {}
    chosen = _chosen_by_freecad(obj, resolver) if versions.follows_faces() else []
    for name in known["names"]:
        found = moved[name] = numbering.now(name) or _not_a_stranger(name, chosen, numbering)
        lines += _what_happened(obj, name, found, numbering, known["names"])
        now += [new for new in found if new not in now]
        if not found:
            lost.append(name)
    if hasattr(getattr(obj, "Proxy", None), "places_moved"):   # a study, which names them in words
        obj.Proxy.places_moved(obj, moved)
        return lines + [said(_TAKEN_OUT, object=obj.Label, lost=[name]) for name in lost], {}
    is_elsewhere = bool(resolver.of_object(obj)[1])   # the mesh was given another part
    if may_change(obj, resolver) and (lost or now != known["names"] or plain_pairs(obj) != known["pairs"] or is_elsewhere):
        _refer(obj, resolver.bearer, now)
        if lost and not now:
            _mark(obj, MARK, lost)
    more, lost_along = _follow_along(obj, known, resolver, numbering)
    return lines + _what_was_lost(obj, lost, now) + more, {"References": lost, **lost_along}


@contextmanager
def not_touched(objects):
    """While references are written otherwise: that is no edit. For refinements and groups of the mesh that is being made FreeCAD would make it once more."""
    untouched = [obj for obj in objects if "Touched" not in obj.State]
    yield
    for obj in untouched:
        obj.purgeTouched()


def look_again(document):
    """To be called after a recompute: what FreeCAD looked at before its face had its new number is in error no more, and what it left out for that is made."""
    moved = [document.getObject(name) for owner, name in _moved if owner == document.Name]
    _moved.difference_update([place for place in _moved if place[0] == document.Name])
    mended = [obj for obj in moved if obj is not None and "Invalid" in obj.State and pairs_of(obj)]
    left_out = {above for obj in mended for above in obj.InListRecursive if "Touched" in above.State}
    for obj in mended + sorted(left_out, key=lambda above: (len(above.OutListRecursive), above.Name)):
        if obj.recompute():
            obj.purgeTouched()


def take_back(obj, resolver, name, found):
    """Lets an object refer, or act along, to what is there again as well. Returns whether it did not do so already."""
    names, foreign = resolver.of_object(obj)
    if not may_change(obj, resolver) or name == "References" and (foreign or set(found) <= set(names)) or name != "References" and plain_pairs(obj, name):
        return False
    if name == "References":
        _refer(obj, resolver.bearer, names + [one for one in found if one not in names])
        mend(obj)
    else:
        _refer(obj, resolver.bearer, found[:1], name)
        mend_direction(obj)
    return True


def elsewhere(objects, resolver):
    """{object name: a line} for each of the objects that refers to something that the meshed part does not have, or has nothing of, a material excepted: that may refer to
    the solids that the part is made of."""
    foreign = {obj: resolver.of_object(obj)[1] or resolver.without_trace(obj) for obj in objects if not obj.isDerivedFrom("App::MaterialObject")}
    part = assembled.seen_as(resolver.part).Label
    return {obj.Name: said(ELSEWHERE, object=obj.Label, where=[describe(*pair) for pair in pairs], part=part)
            for obj, pairs in foreign.items() if pairs}


def unmended(analysis):
    """(object, sentence) for every member of the analysis that is solved and has lost all it referred to, or refers to what is not there: the analysis must not be
    solved until each has been given new references."""
    members = analyses.members_of(analysis)
    gone = {member: _gone(member) for member in members}
    return [(member, translate("FeatureMesh", "%s refers to %s, which is gone; choose another face, edge or solid for it") % (member.Label, ", ".join(lost)))
            for member, lost in gone.items() if lost] + [
                (member, translate("FeatureMesh", "%s acts along %s, which is gone; open it and choose its direction again") % (
                    member.Label, ", ".join(getattr(member, LOST_ALONG))))
                for member in members if getattr(member, LOST_ALONG, None)]


def _gone(obj):
    """What an object has lost where nothing is left; else what it refers to and is not there, as of a load that came from an analysis without a mesh."""
    pairs = pairs_of(obj) if hasattr(obj, "References") else []
    if not pairs:
        return getattr(obj, MARK, [])
    ends = [(path[-1], element) for path, element in (path_of(*pair) for pair in pairs)]
    return [element.lstrip(LOST) for end, element in ends if element.lstrip(LOST).rstrip("0123456789") in _OF_A_SHAPE and hasattr(end, "Shape") and has_shape(end)
            and not is_element_of(end.Shape, element)]


def is_marked(obj, name):
    """Has the object nothing left of what that property referred to?"""
    return bool(getattr(obj, MARK if name == "References" else LOST_ALONG, None))


def mend(obj):
    """Takes the mark away from an object that refers to something again."""
    if getattr(obj, MARK, None) and getattr(obj, "References", None):
        setattr(obj, MARK, [])


def mend_direction(obj):
    """To be called when somebody gave an object another direction, or said that it is to have none."""
    if getattr(obj, LOST_ALONG, None):
        setattr(obj, LOST_ALONG, [])


def has_unknown_direction(obj, known):
    """Was the record made before directions were on record?"""
    return bool(known) and "along" not in known and bool(_may_act_along(obj))


def _may_act_along(obj):
    return [name for name in ALONG if name in obj.PropertiesList]


def _meant_along(obj, resolver):
    """{property of ALONG: names of the sub-elements of the part that it means}, of those properties that are about the part."""
    found = {}
    for name in _may_act_along(obj):
        meant = [sub and resolver.names(target, sub) for target, sub in pairs_of(obj, name)]
        if meant and all(meant):
            found[name] = [names[0] for names in meant]   # all pieces of an edge or a plane have its direction
    return found


def _follow_along(obj, known, resolver, numbering):
    """Moves what an object acts along or about, as follow does with its references. Returns the same."""
    lines, gone = [], {}
    for name, then in known.get("along", {}).items():
        chosen = _chosen_by_freecad(obj, resolver, name) if versions.follows_faces() else []
        now = [(numbering.now(one) or _not_a_stranger(one, chosen, numbering))[:1] for one in then["names"]]
        lost = [one for one, found in zip(then["names"], now) if not found]
        if lost and may_change(obj, resolver):
            _refer(obj, resolver.bearer, [], name)
            _mark(obj, LOST_ALONG, lost)
        elif may_change(obj, resolver):
            _act_along(obj, resolver.bearer, [found for found, in now], name)
        lines += [said(_CHOOSE_DIRECTION, object=obj.Label, lost=[one]) for one in lost]
        gone[name] = lost
    return lines, gone


def _act_along(obj, bearer, names, name):
    """Sets what an object acts along also where that is no other edge: it may have turned, at which FreeCAD looks again since 1.1 only."""
    was_touched, before = "Touched" in obj.State, FreeCAD.Vector(getattr(obj, "DirectionVector", FreeCAD.Vector()))
    is_another = not _refers(obj, bearer, names, name)
    _write(obj, bearer, names, name)
    if is_another:   # the new edge may run the other way
        _keep_sign(obj, before)
    if not (was_touched or is_another):
        obj.purgeTouched()   # the mesh is solved with it now


def _keep_sign(obj, before):
    """Of the direction of an object whose references were written anew."""
    if before.dot(getattr(obj, "DirectionVector", before)) < -_OPPOSITE:
        obj.Reversed = not obj.Reversed


def _refers(obj, bearer, names, name):
    return plain_pairs(obj, name) == [[bearer.Name, one] for one in names]


def _refer(obj, bearer, names, name="References"):
    if not _refers(obj, bearer, names, name):
        _write(obj, bearer, names, name)


def _write(obj, bearer, names, name):
    _moved.add((obj.Document.Name, obj.Name))
    if obj.getTypeIdOfProperty(name).startswith("App::PropertyLinkSubList"):
        setattr(obj, name, [(bearer, tuple(names))] if names else [])
    else:
        setattr(obj, name, (bearer, list(names)) if names else None)


def _mark(obj, mark, lost):
    if mark not in obj.PropertiesList:
        obj.addProperty("App::PropertyStringList", mark, "FeatureMesh", "What it referred to and is gone; it needs new references")
    setattr(obj, mark, lost)


def _chosen_by_freecad(obj, resolver, name="References"):
    """What FreeCAD, which follows references itself, says that the object refers to now."""
    return [found for target, sub in pairs_of(obj, name) if LOST not in sub for found in resolver.names(target, sub) or []]


def _not_a_stranger(name, chosen, numbering):
    """Of what cannot be told by its features: FreeCAD's own choice, where it is nothing that was something else or somewhere else before."""
    return [found for found in chosen if not name.startswith("Solid") and found.rstrip("0123456789") == name.rstrip("0123456789")
            and not numbering.was(found) and numbering.may_be(name, found)][:1]


def _what_happened(obj, name, found, numbering, chosen):
    lines, within = [], numbering.within(name)
    if len(found) > 1:
        lines.append(said("{object:text}: {before:entities} was split into {now:entities}, it is on all of them now",
                          object=obj.Label, before=[name], now=found))
    elif found and found != [name]:
        lines.append(said("{object:text}: {before:entities} is now {now:entities}, its reference was changed",
                          object=obj.Label, before=[name], now=found))
    others = [other for other in (numbering.was(found[0]) if len(found) == 1 else []) if other not in chosen]
    if others:
        lines.append(said("{object:text}: {one:entities} has become one with {others:entities}, it is on all of that now",
                          object=obj.Label, one=[name], others=others))
    if within:
        lines.append(said("{object:text}: of {before:entities} it is not on {within:entities}, which lies between two solids now",
                          object=obj.Label, before=[name], within=within))
    return lines


def _what_was_lost(obj, lost, now):
    if now:
        return [said(_TAKEN_OUT, object=obj.Label, lost=[name]) for name in lost]
    return [said(_CHOOSE_ANOTHER[name.rstrip("0123456789")], object=obj.Label, lost=[name]) for name in lost]
