# SPDX-License-Identifier: GPL-3.0-or-later
"""What the proxies of our document objects and views have in common."""

NO_TOUCH = 8 | 16   # attributes of a property whose change asks for no recompute: Prop_NoRecompute and Prop_Output
READ_ONLY, HIDDEN = 1, 2   # of the property editor


def type_of(obj):
    """What its proxy says that an object is; "" without one, also of None, which links have in place of what is being deleted."""
    return getattr(getattr(obj, "Proxy", None), "Type", "")


class Stateless:
    """A proxy of which nothing but its class path is stored in documents."""

    def dumps(self):
        return None

    def loads(self, saved):
        """What an older version stored is of no concern."""

    __getstate__ = dumps   # as FreeCAD before 1.0 calls them

    def __setstate__(self, saved):
        self.loads(saved)


class GetsReady(Stateless):
    """The proxy of an object that `_get_ready` gives what it needs, when it is made and when a document is opened."""

    def __init__(self, obj):
        obj.Proxy = self
        self._get_ready(obj)

    def onDocumentRestored(self, obj):
        """Called by FreeCAD."""
        self._get_ready(obj)

    def _get_ready(self, obj):
        raise NotImplementedError


class View(Stateless):
    """The proxy of a view of ours."""

    @classmethod
    def attach_to(cls, obj):
        """Gives the object this view if it has none of ours yet. Returns whether it had none."""
        view = obj.ViewObject
        is_new = view is not None and not isinstance(getattr(view, "Proxy", None), cls)
        if is_new:
            cls(view)
        return is_new

    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        """Called by FreeCAD."""
        self.Object = view.Object


def add_missing(obj, rows, without_touch=(), hidden=()):
    """Adds the properties that the object lacks, with their defaults; the names of those that were added.

    A row is (type, name, group, default or None, read-only, tooltip). A change of those `without_touch` asks for no recompute.
    """
    added = []
    for kind, name, group, default, read_only, tooltip in rows:
        if name not in obj.PropertiesList:
            obj.addProperty(kind, name, group, tooltip, NO_TOUCH if name in without_touch else 0)
            if default is not None:
                setattr(obj, name, default)
            added.append(name)
        if read_only:
            obj.setEditorMode(name, HIDDEN if name in hidden else READ_ONLY)
    return added
