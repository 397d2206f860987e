# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields of a panel whose property an expression drives: what is typed there would be another value again after the next edit."""

import FreeCAD

translate = FreeCAD.Qt.translate


def expressions_of(obj):
    """{path of a property: the expression that drives it}."""
    return {path.lstrip("."): expression for path, expression in obj.ExpressionEngine}


def close(obj, widgets):
    """Closes those that cannot be typed into; `widgets` are lists of them by the path of their property, such as "Size" or "Placement.Base.x"."""
    for name, expression in expressions_of(obj).items():
        for widget in widgets.get(name, ()):
            widget.setEnabled(False)
            widget.setToolTip(translate("FeatureMesh", "The expression %s drives this; change it in the property editor") % expression)
