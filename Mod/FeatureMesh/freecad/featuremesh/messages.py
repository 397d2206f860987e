# SPDX-License-Identifier: GPL-3.0-or-later
"""The engine's messages, and those that are kept in documents, in the user's language.

They are made and stored in English, with the names and figures in them. What is shown is recognised by the sentences below, where each
%s stands for such a name or figure, or for another message; a message that is not among them stays English.
"""

import re

import FreeCAD

from .unit_words import in_users_units

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

# Where two would fit, the first counts: more words before fewer.
SENTENCES = (
    # The user's settings
    QT_TRANSLATE_NOOP("FeatureMesh", "The mesh size is %s mm; it must be larger than zero. The part is %s."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The mesh size of %s mm is larger than the part, which is %s. Ask for a smaller size."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The smallest mesh size is %s mm; it must lie between zero and the mesh size of %s mm."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The growth rate is %s; it must be at least 1 (1.3 is usual)."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The number of elements per circle is %s; it must not be negative (0 turns it off)."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The number of elements across gaps is %s; it must not be negative (0 turns it off)."),
    QT_TRANSLATE_NOOP("FeatureMesh", "Details below %s mm cannot be ignored; at most those below half of the mesh size of %s mm can be."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The local mesh size at %s is %s mm; it must be larger than zero."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The refinement %s has an inner size of %s mm; it must be larger than zero."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The refinement %s has a radius of %s mm; it must be larger than zero."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The refinement %s has a length of %s mm; it must be larger than zero."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The refinement %s has a width of %s mm; it must be larger than zero."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The refinement %s has a height of %s mm; it must be larger than zero."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The refinement %s is coarser inside (%s mm) than outside (%s mm); exchange the two sizes."),
    QT_TRANSLATE_NOOP("FeatureMesh", "A size of %s mm would make about %s million elements; at most %s million are made. Choose a larger size."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The refinement %s with a size of %s mm would make about %s million elements; at most %s million are made. Choose a "
                                     "larger size there."),
    QT_TRANSLATE_NOOP("FeatureMesh", "There is not enough memory for this mesh. Choose a larger size."),
    # The part
    QT_TRANSLATE_NOOP("FeatureMesh", "The shape is empty. Recompute the document and mesh an object that has a solid."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The shape has no solid. Mesh a body or a Part object whose result is a solid."),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s has no solid. Recompute the document, and mesh a body or a Part object whose result is a solid."),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s has no face. Recompute the document, and mesh an object with faces, or its edges."),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s has no edge. Recompute the document, and mesh an object with edges."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The shell of %s is open at %s. Close the gap (Part: Check geometry, then sew or rebuild the feature there)."),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s has no positive volume. Its faces point inwards or cross each other; check the feature that made it "
                                     "(Part: Check geometry)."),
    # The surface
    QT_TRANSLATE_NOOP("FeatureMesh", "%s cannot be meshed: its boundary crosses or touches itself%s. Check the feature that made it (Part: Check "
                                     "geometry), or try a smaller size."),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s cannot be meshed: %s. Try a smaller size on this face, or check the feature that made it (Part: Check "
                                     "geometry)."),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s cannot be meshed: %s. Check the feature that made it (Part: Check geometry), or refine the shape."),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s cannot be filled: %s. Mesh the part from scratch."),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s and %s are in the same place but run differently. Check the feature that made them (Part: Check geometry)."),
    QT_TRANSLATE_NOOP("FeatureMesh", "These faces cross each other: %s. The shape intersects itself (Part: Check geometry), or is thinner there than "
                                     "any mesh of this size can follow; repair the feature, or ask for a smaller size on these faces."),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s 10-node tetrahedra would be folded near %s: the face bends too much within one element. Ask for a smaller size "
                                     "there, or for 4-node tetrahedra."),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s 6-node triangles would be folded near %s: the face bends too much within one element. Ask for a smaller size "
                                     "there, or for 3-node triangles."),
    # The volume
    QT_TRANSLATE_NOOP("FeatureMesh", "The geometry kernel failed while meshing: %s. Try another size, or check the shape (Part: Check geometry)."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The part could not be filled: %s. Try another size, or check the shape (Part: Check geometry)."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The mesh is not valid: %s."),
    QT_TRANSLATE_NOOP("FeatureMesh", "the surface mesh does not close at %s; check the shape there, or try another size"),
    QT_TRANSLATE_NOOP("FeatureMesh", "the shape touches itself: nodes of %s lie in the same place, such as %s; repair it there (Part: Check geometry)"),
    QT_TRANSLATE_NOOP("FeatureMesh", "Not meshed, because no solid has them: %s."),
    QT_TRANSLATE_NOOP("FeatureMesh", "Not meshed, because no face has them: %s."),
    QT_TRANSLATE_NOOP("FeatureMesh", "These shells and beams lie inside a solid and share no nodes with it there: %s. No load passes between them. "
                                     "Divide the solid along them (Part: Boolean Fragments)."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The part has faces or edges beside its solids, and only meshes of solids can be adopted. Mesh the part anew, or "
                                     "adopt the mesh for the solids alone (Dimension: Solids)."),
    QT_TRANSLATE_NOOP("FeatureMesh", "triangles of %s cut one another; the shape may touch or cut itself there: repair it, or mesh finer there"),
    QT_TRANSLATE_NOOP("FeatureMesh", "the volume mesh cannot be made to meet the triangles of %s; mesh finer there, or check the shape for faces "
                                     "that cut or touch one another"),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s elements without a volume to speak of remain at %s; mesh finer there, or take out what is much smaller than "
                                     "the rest of the part"),
    # The saved state
    QT_TRANSLATE_NOOP("FeatureMesh", "the saved mesh state belongs to %s, not to %s"),
    QT_TRANSLATE_NOOP("FeatureMesh", "the saved mesh state is damaged (%s)"),
    QT_TRANSLATE_NOOP("FeatureMesh", "the saved mesh state is from a newer FeatureMesh (%s, schema %s; this one reads up to %s)"),
    QT_TRANSLATE_NOOP("FeatureMesh", "the document holds no mesh state"),
    QT_TRANSLATE_NOOP("FeatureMesh", "the new mesh's state cannot be stored (%s), the old mesh stays; is the disk full?"),
    QT_TRANSLATE_NOOP("FeatureMesh", "The saved mesh does not fit the part: %s."),
    QT_TRANSLATE_NOOP("FeatureMesh", "No element of the mesh fits the part: %s. Choose the object it was made of, or mesh the part anew."),
    # The report's warnings and fallbacks
    QT_TRANSLATE_NOOP("FeatureMesh", "The smallest angle of an element is %s degrees, at %s: results there are poor. Take details out that are much "
                                     "smaller than the edge length, or mesh finer there."),
    QT_TRANSLATE_NOOP("FeatureMesh", "Details of the part far smaller than the elements force an angle below 2 degrees on %s elements: %s. Results "
                                     "there are poor. Take them out of the features that make them (points of a sketch that nearly coincide, a "
                                     "step as shallow), or mesh finer there."),
    QT_TRANSLATE_NOOP("FeatureMesh", "Meshed finer than asked, because a face beside it would cross itself: %s."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The mesh is finer than asked where these faces are near each other: %s."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The mesh is finer than asked at %s, because elements of that size cannot follow the part there."),
    QT_TRANSLATE_NOOP("FeatureMesh", "Faces far narrower than the size are meshed at the plain size, since shorter edges failed: %s"),
    QT_TRANSLATE_NOOP("FeatureMesh", "The mesh is finer than asked at %s, because 10-node tetrahedra of that size would be folded, or nearly so, by the curved face."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The mesh is finer than asked at %s, because 6-node triangles of that size would be folded, or nearly so, by the curved face."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The part is %s mm thick at %s: elements are smaller there than asked, so that %s go round it."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The local size at %s is left out: the part has no such face, edge or vertex any more. Refer the refinement to another one."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The refinement %s is suppressed and left out."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The refinement %s refers to nothing and is left out. Choose faces, edges or vertices for it, or suppress it."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The refinement %s has no size and is left out. Give it one, or suppress it."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The refinement %s is of a kind that is not understood and left out. Use a refinement zone instead."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The refinement %s is left out: the part has nothing of what it refers to. Refer it to a face, an edge or a vertex."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The refinement %s lies outside the part. Move it into the part, or suppress it."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The refinement %s changes nothing: its inner size of %s mm is not below the mesh size of %s mm."),
    QT_TRANSLATE_NOOP("FeatureMesh", "The refinement %s grows to %s mm over %s mm, not over %s mm: neighbouring elements may differ by a factor of %s at most "
                                     "(Growth)."),
    QT_TRANSLATE_NOOP("FeatureMesh", "These solids touch or overlap without sharing faces: %s (%s). Each has a mesh of its own: no load passes "
                                     "between them but by ties and contacts, and where they overlap the material counts twice. If that is not "
                                     "meant, fuse them or join them (Part: Boolean Fragments)."),
    QT_TRANSLATE_NOOP("FeatureMesh", "These faces touch or cross without sharing edges: %s. Each sheet has a mesh of its own, and no load passes between "
                                     "them. If that is not meant, join them (Part: Boolean Fragments)."),
    QT_TRANSLATE_NOOP("FeatureMesh", "the solids of the final shape overlap by %s mm^3; fuse them or mesh them one by one"),
    QT_TRANSLATE_NOOP("FeatureMesh", "In the place of another vertex within a millionth of the part, with which they share a node: %s."),
    QT_TRANSLATE_NOOP("FeatureMesh", "Nearer to another vertex than %s mm, so that they share its node: %s."),
    QT_TRANSLATE_NOOP("FeatureMesh", "Too short for an element of their own: %s."),
    QT_TRANSLATE_NOOP("FeatureMesh", "Too narrow for elements of their own: %s."),
    QT_TRANSLATE_NOOP("FeatureMesh", "meshed from scratch: %s"),
    QT_TRANSLATE_NOOP("FeatureMesh", "full mesh: no element of the old mesh is clear of what changed"),
    QT_TRANSLATE_NOOP("FeatureMesh", "full mesh: nothing could be kept"),
    QT_TRANSLATE_NOOP("FeatureMesh", "full mesh: keeping still less would take longer than meshing the part anew"),
    QT_TRANSLATE_NOOP("FeatureMesh", "full mesh: %s"),
    QT_TRANSLATE_NOOP("FeatureMesh", "keeping everything further than %s edge lengths from the change failed: %s"),
    QT_TRANSLATE_NOOP("FeatureMesh", "keeping all that fits failed: %s"),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s of %s elements do not fit the part and were made anew: %s"),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s mid-side nodes were off the surface and are new, on it"),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s: %s is now %s, its reference was changed"),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s: %s was split into %s, it is on all of them now"),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s: %s has become one with %s, it is on all of that now"),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s could not be followed from the last mesh, whose state is gone; check what it refers to"),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s refers to %s, which is gone; it was taken out of the references"),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s refers to %s, which is gone; choose another face, the analysis cannot be solved without"),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s refers to %s, which is gone; choose another edge, the analysis cannot be solved without"),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s refers to %s, which is gone; choose another vertex, the analysis cannot be solved without"),
    QT_TRANSLATE_NOOP("FeatureMesh", "%s refers to %s, which is gone; choose another solid, the analysis cannot be solved without"),
    # The feature difference
    QT_TRANSLATE_NOOP("FeatureMesh", "the two parts look unrelated: they have no feature name in common"),
    QT_TRANSLATE_NOOP("FeatureMesh", "its own volume is the same, but other features now meet %s of its faces differently"),
    QT_TRANSLATE_NOOP("FeatureMesh", "moved by %s mm"),
    QT_TRANSLATE_NOOP("FeatureMesh", "volume %s mm^3"),
    QT_TRANSLATE_NOOP("FeatureMesh", "no longer suppressed"),
    QT_TRANSLATE_NOOP("FeatureMesh", "treated as changed: %s"),
)
_PATTERNS = [(sentence, re.compile("(.+?)".join(map(re.escape, sentence.split("%s"))), re.DOTALL)) for sentence in SENTENCES]


def in_words(message):
    """A message in the user's language and units, with the messages inside it; in English when it is not known."""
    return in_users_units(_translated(message))


def _translated(message):
    for sentence, pattern in _PATTERNS:
        found = pattern.fullmatch(message)
        if found:
            return translate("FeatureMesh", sentence) % tuple(_translated(words) for words in found.groups())
    return message
