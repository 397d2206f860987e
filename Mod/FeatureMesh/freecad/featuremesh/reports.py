# SPDX-License-Identifier: GPL-3.0-or-later
"""The report of a mesh or an update, as JSON and the user take it."""


from .messages import is_message, several


def add_fallback(report, message):
    """Adds a message to what the report says could not be kept or done."""
    report["fallback"] = several([message, report.get("fallback")])


def remarks_of(report):
    """What a report says that the user should know: the fallback, then the warnings."""
    return ([report["fallback"]] if report.get("fallback") else []) + report.get("warnings", [])


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
