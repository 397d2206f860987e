# SPDX-License-Identifier: GPL-3.0-or-later
"""The properties of a mesh object: what they are called and mean, and what its status says."""

import json

import FreeCAD

from . import messages, user_words, versions
from .messages import said
from .proxies import add_missing
from .reading import describe

# Kept in documents as they are; shown in the user's language by status_in_words.
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
NOT_MESHED = QT_TRANSLATE_NOOP("FeatureMesh", "not meshed yet")
UP_TO_DATE = QT_TRANSLATE_NOOP("FeatureMesh", "up to date")
OUT_OF_DATE = QT_TRANSLATE_NOOP("FeatureMesh", "out of date: the part or a setting changed, update by hand or switch Automatic on")
EDITED_ELSEWHERE = QT_TRANSLATE_NOOP("FeatureMesh", "out of date: the part was edited in another document")
SETTINGS_CHANGED = QT_TRANSLATE_NOOP("FeatureMesh", "settings changed, not meshed yet")
CANCELLED = QT_TRANSLATE_NOOP("FeatureMesh", "out of date: the last update was cancelled")
FAILED = "failed: "   # and why, in English

DIMENSIONS = ("From shape", "Solids", "Faces", "Edges")
FROM_SHAPE = DIMENSIONS[0]
_FILLED = "solids", "faces", "edges"   # by elements, as a report says it
SAVED_FOR_FREECAD = UNLESS_LARGE, ALWAYS, NEVER = "Unless larger than a million elements", "Always", "Never"
LARGE = 1000000   # elements, of which FreeCAD saves and reads as many in 8 s

# (type, name, group, default, read-only, tooltip)
PROPERTIES = [
    ("App::PropertyLength", "Size", "Mesh size", 0.0, False, "Wanted edge length of the elements"),
    ("App::PropertyLength", "MinSize", "Mesh size", 0.0, False,
     "Smallest edge length that curvature, thin walls and growth may ask for; 0: a tenth of Size"),
    ("App::PropertyFloat", "ElementsPerCircle", "Mesh size", 12.0, False,
     "Edges along a full circle of any curved face or edge; 0: sizes do not follow curvature"),
    ("App::PropertyFloat", "ElementsAcrossGap", "Mesh size", 0.0, False,
     "Elements across thin walls; 0: sizes do not follow thickness"),
    ("App::PropertyFloat", "Growth", "Mesh size", 1.3, False,
     "By how much neighbouring elements may differ in size at most"),
    ("App::PropertyFloat", "QualityTarget", "Mesh", 30.0, False,
     "Smallest angle in degrees that new elements are improved towards; below 30 is faster, above 35 is rarely reached"),
    ("App::PropertyDistance", "IgnoreBelow", "Mesh", 0.0, False,
     "Edges, steps and strips of faces smaller than this get no elements of their own; 0: those below a two-hundredth of Size, or fewer "
     "where the part cannot be meshed without them; negative: none"),
    ("App::PropertyEnumeration", "Order", "Mesh", ["1st", "2nd"], False,
     "1st: 4-node tetrahedra; 2nd: 10-node tetrahedra with their mid-side nodes on the surface"),
    ("App::PropertyEnumeration", "Dimension", "Mesh", list(DIMENSIONS), False,
     "What is meshed: solids with tetrahedra, faces with triangles (shells), edges with segments (beams); From shape: solids and what is beside them, else faces, else edges"),
    ("App::PropertyInteger", "Threads", "Mesh", 0, False,
     "Processor threads to use; 0: all. The mesh is the same for any number"),
    ("App::PropertyBool", "Automatic", "Mesh", True, False, "Update the mesh whenever the document is recomputed"),
    ("App::PropertyLinkList", "MeshRegionList", "Mesh", [], False, "Local sizes: FEM mesh refinements"),
    ("App::PropertyLinkList", "MeshGroupList", "Mesh", [], False, "FEM mesh groups"),
    ("App::PropertyBool", "AllGroups", "Mesh", False, False,
     "Give the mesh in this document the groups of every face, edge and feature, too. Exported files have them always"),
    ("App::PropertyEnumeration", "SavedForFreeCAD", "Mesh", list(SAVED_FOR_FREECAD), False,
     "Save the mesh in FreeCAD's own form, too. Without that a large document is saved in a tenth of the time and has a third of the size, but only "
     "FeatureMesh finds the mesh in it"),
    ("App::PropertyString", "Status", "Result", NOT_MESHED, True, "Whether the mesh fits the part, and if not, why"),
    ("App::PropertyInteger", "NodeCount", "Result", 0, True, "Nodes of the mesh"),
    ("App::PropertyInteger", "TetCount", "Result", 0, True, "Elements of the mesh: tetrahedra, or triangles or segments where faces or edges are meshed"),
    ("App::PropertyPercent", "KeptNodes", "Result", 0, True, "Share of the nodes kept bit for bit by the last update"),
    ("App::PropertyPercent", "KeptTets", "Result", 0, True, "Share of the elements kept by the last update"),
    ("App::PropertyAngle", "MinDihedral", "Result", 0.0, True, "Smallest angle between two faces of an element, or at a corner of a triangle"),
    ("App::PropertyFloat", "MeanRadiusRatio", "Result", 0.0, True,
     "Mean of three times (of triangles, twice) the inscribed over the circumscribed radius; 1 for regular elements"),
    ("App::PropertyFloat", "Seconds", "Result", 0.0, True, "Time the last mesh or update took"),
    ("App::PropertyString", "Report", "Result", "", True, "Everything about the last mesh or update, as JSON"),
    ("App::PropertyString", "Failure", "Result", "", True, "Why the last update failed, as JSON"),
    ("App::PropertyFileIncluded", "SavedState", "Result", None, True, "What the next update needs"),
    ("App::PropertyString", "StateName", "Result", "", True, "Which state SavedState is, by which it is found after undo"),
    ("App::PropertyString", "NotedParts", "Result", "", True, "The part as it was when loads were given other references after the last mesh"),
    ("App::PropertyString", "ReferredTo", "Result", "", True, "What loads, supports, materials and refinements referred to, as JSON"),
]
_HIDDEN = ("Report", "Failure", "SavedState", "StateName", "NotedParts", "ReferredTo")
# What alters no mesh: FreeCAD does not tell a mesh that follows by hand what is new, so that it would call itself out of date.
_WITHOUT_TOUCH = ("Threads", "Automatic", "SavedForFreeCAD", "StateName", "NotedParts", "ReferredTo")
OPTION_OF = {"Size": "size", "MinSize": "min_size", "ElementsPerCircle": "elements_per_circle",
              "ElementsAcrossGap": "elements_across_gap", "Growth": "growth", "QualityTarget": "target_dihedral_deg",
              "IgnoreBelow": "ignore_below", "Threads": "threads"}
# What a mesh depends on beside the part and its refinements.
SETTINGS = (*(name for name in OPTION_OF if name != "Threads"), "Order", "Dimension")
_WHAT_OLD_MESHES_HAD = {"Dimension": FROM_SHAPE, "IgnoreBelow": 0.0}   # settings that came later
AUTOMATIC_SHARE = 0.1   # of Size is the smallest size where none is given


def add(mesh):
    """Adds what the object lacks: all of it when new, what came later when from an older document."""
    if "Shape" not in mesh.PropertiesList and "Part" not in mesh.PropertiesList:
        mesh.addProperty("App::PropertyLinkGlobal", "Part", "Mesh", "The part to mesh")
    add_missing(mesh, PROPERTIES, _WITHOUT_TOUCH, _HIDDEN)
    for name in ("Threads", "Automatic"):   # of an older document
        mesh.setPropertyStatus(name, ["NoRecompute", "Output"])


def is_saved_for_freecad(mesh):
    """Is the mesh saved in FreeCAD's own form, too?"""
    return mesh.SavedForFreeCAD == ALWAYS or mesh.SavedForFreeCAD != NEVER and mesh.TetCount <= LARGE


def remarks_on_form(mesh, report):
    """What to know of a new mesh with that report: that it is of less than the last one, and of saving a large one."""
    return _remarks_on_filling(mesh, report) + _remarks_on_saving(mesh, element_count(report))


def _remarks_on_filling(mesh, report):
    before, now = (_FILLED.index(one.get("dimension", "solids")) for one in (json.loads(mesh.Report or "{}"), report))
    if now <= before or not mesh.Report or mesh.Dimension != FROM_SHAPE:
        return []
    part = describe(versions.part_of(mesh))
    return [said("{part:text} has no solid any more: its faces are meshed, and loads and results are those of a shell. Mend the part if it is to be a solid.", part=part)
            if _FILLED[now] == "faces" else
            said("{part:text} has no solid and no face any more: its edges are meshed, and loads and results are those of beams. Mend the part if it is to be more.", part=part)]


def _remarks_on_saving(mesh, elements):
    if mesh.SavedForFreeCAD != UNLESS_LARGE or elements <= LARGE:
        return []
    return [said("The mesh has more than {limit:count} {limit:element|elements}: it is saved in FeatureMesh's form only, in a tenth of the time. A FreeCAD without "
                 "FeatureMesh finds no mesh in the document then; to save FreeCAD's form, too, set SavedForFreeCAD to Always.", limit=LARGE)]


def choose_form(obj, is_saved):
    """Lets FreeCAD save the FemMesh of an object, or leave it out."""
    obj.setPropertyStatus("FemMesh", "-Transient" if is_saved else "Transient")


def is_of_its_part(mesh):
    """Is the mesh that of its part as it is now?"""
    return mesh.Status in (UP_TO_DATE, SETTINGS_CHANGED)


def settings_of(mesh):
    """{name: value} of the properties that a mesh depends on."""
    return {name: getattr(getattr(mesh, name), "Value", getattr(mesh, name)) for name in SETTINGS if hasattr(mesh, name)}


def differ_from_mesh(mesh, settings):
    """Are these other settings than the mesh was made with? Meshes from before that was written down count as made with them."""
    return as_in_documents(settings) != as_in_documents({**_WHAT_OLD_MESHES_HAD, **json.loads(mesh.Report or "{}").get("settings", settings)})


def as_in_documents(value):
    """The same with numbers to twelve digits: FreeCAD saves those of lengths to sixteen behind the point, and a mesh is not another one when its document is
    opened again."""
    if isinstance(value, float):
        return float("%.12g" % value)
    if isinstance(value, dict):
        return {key: as_in_documents(entry) for key, entry in value.items()}
    return type(value)(map(as_in_documents, value)) if isinstance(value, (list, tuple)) else value


def status_after(mesh, name):
    """The Status of a mesh whose property of that name somebody has set."""
    if name in SETTINGS and is_of_its_part(mesh):
        return SETTINGS_CHANGED if differ_from_mesh(mesh, settings_of(mesh)) else UP_TO_DATE
    if name == versions.part_property(mesh) and versions.part_of(mesh) is not None and mesh.Status != NOT_MESHED:
        return OUT_OF_DATE
    return mesh.Status


def status_in_words(obj, status=None):
    """The Status of a mesh object or a live result, or what stands in its place, in the user's language."""
    status = status or obj.Status
    if status.startswith(FAILED):
        return FreeCAD.Qt.translate("FeatureMesh", "failed: %s") % user_words.in_words(failure_of(obj))
    if status == OUT_OF_DATE and obj.Automatic:
        status = QT_TRANSLATE_NOOP("FeatureMesh", "out of date: the part or a setting was changed and not recomputed")
    return FreeCAD.Qt.translate("FeatureMesh", status)


def what_it_is_of(mesh):
    """That the mesh is not that of its part as it is, as a sentence in the user's language; "" when it is."""
    status = OUT_OF_DATE if mesh.Proxy.is_behind(mesh) else mesh.Status
    return "" if status == UP_TO_DATE else FreeCAD.Qt.translate("FeatureMesh", "These are the elements of the last mesh: %s") % status_in_words(mesh, status)


def failed(obj, error):
    """The Status of an object whose work ended with an error, in English; its message is kept for status_in_words."""
    obj.Failure = json.dumps(messages.of_error(error))
    return FAILED + messages.english(messages.of_error(error))


def failure_of(obj):
    """The message of the error for which Status says "failed"; in documents from before it was kept, the words in Status."""
    words = obj.Status[len(FAILED):]
    failure = json.loads(obj.Failure or "null")
    return failure if messages.english(failure) == words else words


def element_count(report):
    """How many elements fill the part: tetrahedra, or triangles or segments where those are meshed."""
    return int(report[{"faces": "triangles", "edges": "segments"}.get(report.get("dimension"), "tets")])


def has_all_elements(mesh):
    """Has FreeCAD the mesh that the properties tell of?"""
    fem_mesh = mesh.FemMesh
    return (mesh.NodeCount, mesh.TetCount) == (fem_mesh.NodeCount, fem_mesh.VolumeCount or fem_mesh.FaceCount or fem_mesh.EdgeCount)


def show_report(mesh, report):
    """Sets the properties that tell of a mesh."""
    report.setdefault("fallback", None)
    quality, kept = report.get("quality", {}), report.get("kept") or {}
    mesh.NodeCount, mesh.TetCount = int(report["nodes"]), element_count(report)
    mesh.KeptNodes = int(100 * kept.get("nodes_share", 0.0))
    mesh.KeptTets = int(100 * kept.get("tets_share", 0.0))
    mesh.MinDihedral = float(quality.get("min_dihedral", 0.0))
    mesh.MeanRadiusRatio = float(quality.get("mean_radius_ratio", 0.0))
    mesh.Seconds = report["seconds"]["total"]
    mesh.Report = json.dumps(report, sort_keys=True)
