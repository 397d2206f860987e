"""The engine as Python sees it. Built from bindings/*.cpp; arrays are numpy, lengths mm, angles degrees.

`raw` is what was read from a document, a dict:
    final_object: str                       name of the record whose shape is meshed
    records: list of dicts in dependency order, each
        name, label, type, proxy: str       `proxy` is the class name of a Python feature's proxy, else ""
        links: list of (property, object name, sub-element)
        placement, global_placement: 16 floats, 4x4 matrix row by row; global_placement maps the object's own frame to the final shape's frame
        numbers: dict str -> float          numeric and boolean parameters (mm, degrees)
        texts: dict str -> str              enumerations
        measures: dict str -> str           if given: which numbers are a "length", which an "angle"
        shape, own_volume: int              index into the shapes (both already in the final shape's frame), -1 for none
        suppressed: bool
        error: str                          FreeCAD's message when the feature is in error, else ""
        elements: list of (id, 9 or 12 floats)  of a sketch, if given: three points of each line and curve, the second in its middle, and the
                                            centre of a circle or arc, in the sketch's own frame; the id stays as long as the document is open
    shapes: bytes                           `Part.Compound([...]).exportBinary` of all shapes, an empty compound for a null shape

`options` is a dict with at least size (mm); further min_size, elements_per_circle, elements_across_gap, growth, order (1, 2), threads,
dimension ("from_shape", which takes solids, else faces, else edges; "solids", "faces", "edges"),
target_dihedral_deg, keep_margin (in edge lengths; 0 is as the sizes need), ignore_below (mm; smaller details get no
elements of their own; 0: those below a two-hundredth of the size, unless the part is refused without them; negative: none),
most_tets (more are refused), local: list of ("Face12", size), zones: list of dicts with name, inner, outer (mm; 0: size), transition (mm) and shape:
"near" with entities (list of "Face12") and reach (mm), or, with rotation (9 floats, row by row) and translation (mm) in the part, "box" with sides (3),
"sphere" with radius, "cylinder" with radius and height (mm); balls: list of (x, y, z, radius, size in mm), in each of which no more than its size is wanted.

`progress(step: str, share: float) -> bool`: return False to cancel (raises Cancelled).
"""
from typing import Any, Callable, Optional, overload
import numpy as np

__version__: str
protocol: int   # of this interface; an addon says which numbers it can speak

def about() -> dict[str, Any]:
    """version, protocol, and the versions of the engine's libraries: occt, cgal, tbb."""

Message = dict[str, Any]
"""{"code": "size_not_positive", "template": English words with {name:kind} where a parameter goes, "parameters": {name: value}}. By kind the value is: count an int;
number, length (mm) and volume (mm^3) a float; extent (of a box) and point three floats (mm); entities a list of names ("Face12"); text a str; messages a list of
messages."""

def message_templates() -> dict[str, str]: """By code: the template of every message."""

class Error(RuntimeError):
    message: Optional[Message]    # the text is the same in English
class InputError(Error): ...      # the user's fault
class KernelError(Error): ...     # the geometry kernel could not
class MeshError(Error): ...       # no valid mesh
class StateError(Error): ...      # a saved state is damaged or foreign
class Cancelled(Error): ...

Progress = Optional[Callable[[str, float], bool]]

class PartMesh:
    """A part with its mesh; never changes."""
    order: int
    corner_count: int
    def arrays(self) -> dict[str, np.ndarray]:
        """All arrays of the mesh, to be saved, none left out where there is nothing of a kind: points (n,3), entities (n,2) int32 (dimension, index), parameters (n,2), node_numbers (n,) int64,
        segments (s,2), segment_mids (s,) or (0,), segment_edges, segment_numbers, triangles (t,3), triangle_mids, triangle_faces, triangle_numbers,
        tets (m,4), tet_mids (m,6) or (0,6), tet_solids, tet_numbers, counters (4,) int64 (order, corner_count, next node number, next element number); adopted_sizes
        (k,4) mm (place, edge length) where the mesh comes from another maker's; made_for_nodes (k,) and made_for_sizes (k,) mm where kept
        nodes were made for other edge lengths than those wanted there now; refined_narrow_faces (1,) bool: did faces far narrower than the size
        ask for shorter edges, as they do in updates of that mesh; ignored_below (1,) mm: smaller details have no elements of their own;
        shared_nodes (k,3) int32 (dimension, index, node): the nodes that entities without elements of their own share with others.
        Indices count from 0; tets have positive volume in VTK/Abaqus order. Views, read-only."""
    def node_origin(self) -> np.ndarray: """(n,) int32: index of the node in the mesh before the update, -1 for a new one."""
    def tet_origin(self) -> np.ndarray: """(m,) int32, likewise; by triangle or segment where those fill the part."""
    def active_points(self) -> np.ndarray: """(k,3): inner nodes that survived as start positions only."""
    def wanted_sizes(self, points: np.ndarray) -> np.ndarray: """(n,) mm: the edge length that the mesh was to have at each of the points, (n,3) mm."""
    def owners_of_faces(self) -> list[list[str]]: """By face of the final shape: names of the features that own it."""
    def labels_of_owners(self, names: list[str]) -> list[list[str]]:
        """Of faces and edges ("Face12"), in their order: labels of the features that own it, an edge's being those of its faces; none where that is not known."""
    def owners_of_tets(self) -> list[tuple[str, np.ndarray]]: """(feature name, numbers of the tets that have their middle in one of its volumes)."""

# Of reports "warnings" and the "refusal" of each of the "rounds" are messages, and so is "fallback" (None where all went as intended).
def mesh_part(raw: dict, options: dict, progress: Progress = None, next_numbers: tuple[int, int] = (1, 1)) -> tuple[PartMesh, dict[str, Any]]:
    """Nodes and elements are numbered from `next_numbers` on: those before were given to others in the document's history."""
def update_part(old: PartMesh, raw: dict, options: dict, progress: Progress = None) -> tuple[PartMesh, dict[str, Any]]: ...
def adopt_part(raw: dict, options: dict, arrays: dict[str, np.ndarray], progress: Progress = None) -> tuple[PartMesh, dict[str, Any]]:
    """Makes another maker's mesh of the part ours. `arrays` as PartMesh.arrays gives them; of CAD entities they need to know nothing."""
def restore_part(raw: dict, options: dict, arrays: dict[str, np.ndarray], progress: Progress = None) -> PartMesh: ...
def labels_of_owners(raw: dict, options: dict, names: list[str]) -> list[list[str]]: """As of a PartMesh, of a part that has no mesh."""
def transfer_field(old_arrays: dict[str, np.ndarray], new_arrays: dict[str, np.ndarray], values: np.ndarray, same_place: float = 0.0,
                   threads: int = 1) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Nodal values (n,) or (n,k) of the old mesh's nodes on the new one's: values, error estimates of the same shape, and by node where the value is from:
    0 the same node, 1 within an old element, 2 the nearest point of the old boundary."""
def read_tree(raw: dict) -> dict[str, Any]:
    """{"object", "features": [{"name", "label", "type", "role", "suppressed", "error", "depends_on", "volume_source",
    "volumes": [{"effect", "volume", "instance"}], "owns_cells", "owns_faces"}], "cells", "material_volume", "final_volume", "notes",
    "fallbacks" (those notes that say how the cells were had when the plain way failed), "untrusted" (names)}. Notes are messages, fallbacks English."""
def seconds_to_interpret(raw: dict, before: dict | None = None) -> float: """From a document's records to its feature tree, from nothing or after the state `before`."""
def compare(old: dict, new: dict, resolution: float = 0.0, fuse: bool = True) -> dict[str, Any]:
    """The feature difference: {"features": [{"name", "label", "verdict", "motion", "old_volume", "new_volume", "old_faces", "new_faces", "detail"}],
    "faces": [{"verdict", "old_face", "new_face", "old_area", "new_area", "inner", "new_faces" (all that overlap the old one)}],
    "edges": [{"verdict", "old_edge", "new_edge", "old_length", "new_length", "inner"}], "notes", "changed_boundary": (k,3,3) array}; areas, mm^2, of faces that changed. A detail is a
    message or None, notes are messages."""
@overload
def followed_faces(old: PartMesh, old_raw: dict, new: PartMesh, new_raw: dict) -> list[dict[str, Any]]: ...
@overload
def followed_faces(old_raw: dict, new_raw: dict) -> list[dict[str, Any]]:
    """For every face of the old final shape {"old_face", "new_faces" (several where it was split, none where it is gone or cannot be told),
    "by": "origin" (what made it), "place", "neighbours" or "", "within" (pieces of it that came to lie between two solids, and are none of new_faces)}."""
def trace_sub_elements(raw: dict, object: str) -> dict[str, list[str]]:
    """By name of every face, edge and vertex of an object that the part is made of: the names of what lies there on the final shape."""
def estimate_tets(raw: dict, options: dict) -> float: """About how many elements: tets, or triangles or segments where those are meshed."""
def statics_missing() -> str: """Why linear statics cannot be solved here (PETSc is not there); empty when it can."""
def statics_weight(arrays: dict, materials: np.ndarray, tet_materials: np.ndarray, gravity: list[float]) -> np.ndarray:
    """(n,3) N. `materials` are rows of Young's modulus (MPa), Poisson's ratio, density (t/mm^3), `gravity` in mm/s^2."""
def statics_pressure(arrays: dict, triangles: np.ndarray, pressure: float) -> np.ndarray: """(n,3) N: a pressure (MPa) against those triangles."""
def statics_area_shares(arrays: dict, triangles: np.ndarray) -> np.ndarray: """(n,) mm^2: each node's part where a force is spread over the triangles."""
def statics_length_shares(arrays: dict, segments: np.ndarray) -> np.ndarray: """(n,) mm, likewise over segments."""
def statics_bodies(arrays: dict) -> np.ndarray: """(m,) by tet the body that it belongs to; tets of a body hang together by their sides."""
def solve_statics(arrays: dict, model: dict, keep: str = "", threads: int = 1, progress: Progress = None,
                  start: tuple[np.ndarray, np.ndarray] | None = None) -> dict[str, Any]:
    """Linear statics. `model`: materials (k,3), tet_materials (m,), loads (n,3) N, held (n,3) bool, given (n,3) mm. The answer: displacements (n,3) mm,
    stresses (n,6) MPa (xx, yy, zz, xy, yz, zx), von_mises (n,), reactions (n,3) N, strain_energy (N mm), iterations, residual, energy_error,
    discretisation_error (an estimate, of the energy norm), preconditioner (its name), kept_preconditioner, kept_start_share, seconds by step.
    What is kept under the name `keep` makes the next solution of that name faster; where nothing is, `start` may be (node_numbers (n,), displacements (n,3) mm) of an earlier one."""
def statics_error(arrays: dict, materials: np.ndarray, tet_materials: np.ndarray, displacements: np.ndarray, threads: int = 1) -> np.ndarray:
    """(m,) by tet its part of the discretisation error that solve_statics tells of displacements (n,3) mm; the sum of their squares is its square (ZienkiewiczZhu1987)."""
def forget_statics(keep: str) -> None: ...
def write_activity_of_crash_to(descriptor: int) -> None:
    """From now on a crash of the process first writes what its thread was working on ("surface, Face12") to the file descriptor."""
