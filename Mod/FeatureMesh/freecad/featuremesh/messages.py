# SPDX-License-Identifier: GPL-3.0-or-later
"""What the engine and our documents have to say, and how it is put into words; user_words.py does so in the user's language. Needs no FreeCAD.

A message is {"template": English words with {name:kind} where a parameter goes, "parameters": {name: value}}; behind a count
{name:element|elements} takes the first words for one, the others for any other number. The engine's have their "code", too
(src/core/messages.def), and "owners" where it is known which features own the faces and edges that it names:
{"Face12": ["Fillet"]}, by their labels. So it is kept in documents. Older documents hold English sentences, which stay as they are.
"""

import difflib
import string

_MOST_WITHOUT_POWER = 1e7
_MOST_ENTITIES = 6   # are named
_MOST_OWNERS = 3      # of one: what belongs to more features is not told by them
AND_MORE, INSIDE = "%s and %d more", "the inside"


def said(template, /, **parameters):
    """A message of our own; a `template` that stands here in quotes is translated (update_translations.py)."""
    return {"template": template, "parameters": parameters}


def several(messages):
    """Several messages as one, None where there is none."""
    messages = [message for message in messages if message]
    return messages[0] if len(messages) == 1 else said("{all:messages}", all=messages) if messages else None


def alternatives(names):
    """"A or B or C", as a parameter of a message."""
    return names[0] if len(names) == 1 else said("{one:text} or {others:messages}", one=names[0], others=alternatives(names[1:]))


def close_names(name, known):
    """The known names nearest to `name`, as a message that goes on with a sentence; "" where none is near."""
    near = difflib.get_close_matches(name, known, 3, 0.5)
    return said("; did you mean {names:messages}?", names=alternatives(near)) if near else ""


def of_error(error):
    """What an error says: its message, or its text without line breaks. FreeCAD's own errors have theirs within a dict."""
    if isinstance(error, MemoryError):
        return said("There is not enough memory for this mesh. Choose a larger size.")
    first = error.args[0] if error.args else None
    words = first["sErrMsg"] if isinstance(first, dict) and "sErrMsg" in first else str(error)
    return getattr(error, "message", None) or " ".join(words.split()) or type(error).__name__


def english(message):
    """A message in English and mm, as the engine itself puts it."""
    return _ENGLISH.put(message)


def in_english(value):
    """The same report or answer with all messages in it in English."""
    if is_message(value):
        return english(value)
    if isinstance(value, dict):
        return {key: in_english(entry) for key, entry in value.items()}
    return [in_english(entry) for entry in value] if isinstance(value, (list, tuple)) else value


def is_message(value):
    """Is this a message with parameters?"""
    return isinstance(value, dict) and "template" in value and "parameters" in value


def entities_in(message):
    """The names of the faces, edges, vertices and solids that a message is about, each once."""
    if not is_message(message):
        return []
    names = []
    for _, name, kind, _ in string.Formatter().parse(message["template"]):
        if kind == "entities":
            names += message["parameters"][name]
        elif kind == "messages":
            names += [entity for inner in _listed(message["parameters"][name]) for entity in entities_in(inner)]
    return list(dict.fromkeys(names))


def with_owners(value, labels_of):
    """The same message, or messages within lists and dicts, with the features that own the faces and edges named there.

    `labels_of` gives the labels of the owners for each of the names it is asked for; it is asked once, and not where nothing is named.
    """
    names = [name for name in dict.fromkeys(_entities_within(value)) if name.startswith(("Face", "Edge"))]
    if not names:
        return value
    owners = {name: labels for name, labels in zip(names, labels_of(names)) if 0 < len(labels) <= _MOST_OWNERS}
    return _owned(value, owners)


def with_parts(value, part_of):
    """Likewise with the parts that the solids named there are of; `part_of` has their labels by the names of the solids."""
    return _owned(value, {name: [label] for name, label in part_of.items()})


def _entities_within(value):
    if is_message(value):
        return entities_in(value)
    inner = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    return [name for entry in inner for name in _entities_within(entry)]


def _owned(value, owners):
    if isinstance(value, list):
        return [_owned(entry, owners) for entry in value]
    if not isinstance(value, dict):
        return value
    inner = {key: _owned(entry, owners) for key, entry in value.items()}
    own = {name: owners[name] for name in entities_in(value) if name in owners}
    return {**inner, "owners": {**value.get("owners", {}), **own}} if own else inner


class Words(string.Formatter):
    """Puts messages into words; the kinds in a template are those of src/core/message.h."""

    def __init__(self, translated=lambda words: words, with_units=lambda text: text, as_shown=lambda numbers: numbers):
        """`as_shown` gives numbers the decimal sign that the user is used to."""
        self._translated, self._with_units, self._as_shown = translated, with_units, as_shown

    def put(self, message):
        if not is_message(message):
            return self._with_units(message or "")
        owners = message.get("owners", {})
        return self.vformat(self._translated(message["template"]), (), {name: _owned_names(value, owners) for name, value in message["parameters"].items()})

    def sentence(self, message):
        """The same as a sentence of its own. A label, a number or a face that it begins with stays as it is."""
        text = self.put(message)
        return text[:1].upper() + text[1:] if self._begins_with_words(message) else text

    def _begins_with_words(self, message):
        if not is_message(message):
            return False
        words, name, kind, _ = next(self.parse(self._translated(message["template"])))
        return bool(words) or kind == "messages" and self._begins_with_words(next(iter(_listed(message["parameters"][name])), ""))

    def format_field(self, value, kind):
        if "|" in kind:
            return kind.split("|")[value != 1]
        return getattr(self, "_" + kind)(value)

    def _text(self, value):
        return str(value)

    _count = _text

    def _number(self, value):
        return self._as_shown(_digits(value))

    def _length(self, value):
        return self._as_shown(self._with_units(_digits(value) + " mm"))

    def _volume(self, value):
        return self._as_shown(self._with_units(_digits(value, nothing=0.0) + " mm^3"))

    def _extent(self, value):
        return self._as_shown(self._with_units(" x ".join(map(_digits, value)) + " mm"))

    def _point(self, value):
        text = self._as_shown(self._with_units("(%s) mm" % ", ".join(map(_digits, value))))
        return text if self._as_shown("0.5") == "0.5" else text.replace(", ", "; ")   # beside decimal commas

    def _entities(self, names):
        shown, more = ", ".join(names[:_MOST_ENTITIES]), len(names) - _MOST_ENTITIES
        if more > 0:
            return self._translated(AND_MORE) % (shown, more)
        return shown or self._translated(INSIDE)

    def _messages(self, messages):
        *before, last = map(self.put, _listed(messages)) if messages else [""]
        return "; ".join([*(text.removesuffix(".") for text in before), last])


def figure(value, digits):
    """A number with so many digits that count, and without a power of ten where people write none: 16500 for 1.65e+04."""
    text = "%.*g" % (digits, value)
    return "%.0f" % float(text) if "e+" in text and abs(value) < _MOST_WITHOUT_POWER else text


def _digits(value, nothing=5e-10):
    return figure(0 if abs(value) < nothing else value, 6)


def _owned_names(value, owners):
    """Of a parameter: "Face12 (Fillet)" for "Face12"."""
    if not owners or not isinstance(value, list):
        return value
    return ["%s (%s)" % (name, ", ".join(owners[name])) if isinstance(name, str) and name in owners else name for name in value]


def _listed(messages):
    return messages if isinstance(messages, list) else [messages]


_ENGLISH = Words()
