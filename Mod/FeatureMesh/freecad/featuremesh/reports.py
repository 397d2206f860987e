# SPDX-License-Identifier: GPL-3.0-or-later
"""The report of a mesh or an update, as JSON and the user take it."""

from .messages import english, is_message, said, several

_OF_DETAILS = {"vertices_nearer_than": "vertices", "edges_too_short": "edges", "faces_too_narrow": "faces"}   # the engine's warnings and what they name


def add_fallback(report, message):
    """Adds a message to what the report says could not be kept or done."""
    report["fallback"] = several([message, report.get("fallback")])


def remarks_of(report):
    """What a report says that the user should know: the fallback, then the warnings."""
    return ([report["fallback"]] if report.get("fallback") else []) + report.get("warnings", [])


def news_of(report, known):
    """What a report says that the user should know and these remarks, which have been read, did not tell. Solids that touch go on to do so with other faces, or
    with the same in another order."""
    told = list(map(_what_is_told, known))
    return [line for line in remarks_of(report) if _what_is_told(line) not in told]


def _what_is_told(line):
    return line["parameters"]["solids"] if is_message(line) and line.get("code") == "solids_touch" else line


def with_details_in_one(warnings):
    """The engine's warnings with those about the vertices, edges and faces of ignored details in one line, in place of the first of them."""
    about = {line["code"]: line for line in warnings if line["code"] in _OF_DETAILS}
    if len(about) < 2 or "vertices_nearer_than" not in about:
        return warnings
    places = [place for code in reversed(_OF_DETAILS) if code in about for place in about[code]["parameters"][_OF_DETAILS[code]]]
    line = said("Details smaller than {below:length} have no elements of their own: {places:entities}.",
                below=about["vertices_nearer_than"]["parameters"]["distance"], places=places)
    first = warnings.index(next(iter(about.values())))
    return [*warnings[:first], line, *(other for other in warnings[first:] if other["code"] not in about)]


def without_errors_told(warnings, remarks):
    """The engine's warnings but for the features in error of which one of the remarks tells what FreeCAD says of them."""
    told = list(map(english, remarks))
    return [line for line in warnings if line.get("code") != "feature_in_error" or not any(line["parameters"]["error"] in remark for remark in told)]


def plain(value):
    """The same with lists in place of arrays, and triangles (of no use in a report) counted only."""
    if is_message(value):
        return value
    if isinstance(value, dict):
        short = {key: plain(entry) for key, entry in value.items() if key != "changed_boundary"}
        if "changed_boundary" in value:
            short["changed_triangles"] = len(value["changed_boundary"])
        return short
    if isinstance(value, (list, tuple)):
        return [plain(entry) for entry in value]
    return value.tolist() if hasattr(value, "tolist") else value
