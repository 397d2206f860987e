# SPDX-License-Identifier: GPL-3.0-or-later
"""Python expressions over parameters and responses, whose names may have dots: `HoleSketch.Hole6X > 2 * Fillet.Radius`."""

import ast
import itertools
import math
from types import SimpleNamespace

from ..errors import UserError
from ..messages import english, said

_FUNCTIONS = {name: getattr(math, name) for name in dir(math) if not name.startswith("_")}
_FUNCTIONS.update({function.__name__: function for function in (abs, min, max, sum, round)})


class Expression:
    """An expression of a study's file or of a command line, which is its owner's own program."""

    def __init__(self, text, what):
        """`what` is a message that says what it is. Throws UserError for what is no expression."""
        self.text, self._what = text, what
        try:
            self._code = compile(text, "<%s>" % english(what), "eval")
        except (SyntaxError, TypeError, ValueError) as error:
            raise UserError(said("{what:messages} {text:text} cannot be read: {why:text}",
                                 what=what, text=text, why=str(getattr(error, "msg", error)))) from error
        inner = [node.attr for node in ast.walk(ast.parse(text.strip(), mode="eval")) if isinstance(node, ast.Attribute) and node.attr.startswith("__")]
        if inner:   # by which it would come to all of Python, from a study in somebody's document, too
            raise UserError(said("{what:messages} {text:text} cannot be read: {why:text}", what=what, text=text, why=inner[0]))

    def refuse_unknown(self, names):
        """Throws UserError where it uses what is none of these names and no function of ours."""
        tree = ast.parse(self.text.strip(), mode="eval")
        known = {*names, *_FUNCTIONS, *(node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store))}
        for name in _dotted_names(tree):
            if not any(first in known for first in itertools.accumulate(name.split("."), "{}.{}".format)):
                raise UserError(said("{what:messages} {text:text} cannot be evaluated: {why:messages}; it may use {names:text}",
                                     what=self._what, text=self.text, why=said("there is no {name:text}", name=name), names=", ".join(names)))

    def value(self, values):
        """Its value where each name in `values` has that value. Throws UserError."""
        try:
            return eval(self._code, {"__builtins__": {}, **_FUNCTIONS, **_by_dots(values)})
        except Exception as error:
            raise UserError(said("{what:messages} {text:text} cannot be evaluated: {why:messages}; it may use {names:text}",
                                 what=self._what, text=self.text, why=str(error), names=", ".join(values))) from error


class Limit:
    """A comparison such as `max_mises <= 120`, with a measure of how far it is from being kept."""

    def __init__(self, text):
        """Throws UserError for what is no comparison of two things."""
        self.text, self._whole = text, Expression(text, said("the limit"))
        node = ast.parse(text.strip(), mode="eval").body
        if not isinstance(node, ast.Compare) or len(node.ops) != 1 or not isinstance(node.ops[0], (ast.LtE, ast.Lt, ast.GtE, ast.Gt)):
            raise UserError(said("the limit {limit:text} has to compare two things by <=, <, >= or >", limit=text))
        self._sign = 1 if isinstance(node.ops[0], (ast.LtE, ast.Lt)) else -1
        self._left, self._right = (Expression(ast.unparse(side), said("the limit")) for side in (node.left, node.comparators[0]))

    def refuse_unknown(self, names):
        """As Expression's."""
        self._whole.refuse_unknown(names)

    def is_kept(self, values):
        return bool(self._whole.value(values))

    def excess(self, values):
        """By which share of its right side the limit is broken; negative where it is kept."""
        right = self._right.value(values)
        return self._sign * (self._left.value(values) - right) / (abs(right) or 1.0)


def _dotted_names(node):
    """All names that are read, each as long as its dots go."""
    name = _dotted_name(node)
    return [name] if name else [name for child in ast.iter_child_nodes(node) for name in _dotted_names(child)]


def _dotted_name(node):
    """None for what is no name."""
    if isinstance(node, ast.Name):
        return node.id
    holder = _dotted_name(node.value) if isinstance(node, ast.Attribute) else None
    return "%s.%s" % (holder, node.attr) if holder else None


def _by_dots(values):
    """The values as names and, where names have dots, as attributes of objects."""
    top = {}
    for name, value in values.items():
        first, *rest = name.split(".")
        if not rest:
            top[first] = value
            continue
        holder = top.setdefault(first, SimpleNamespace())
        for step in rest[:-1]:
            if not hasattr(holder, step):
                setattr(holder, step, SimpleNamespace())
            holder = getattr(holder, step)
        setattr(holder, rest[-1], value)
    return top
