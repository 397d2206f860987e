# SPDX-License-Identifier: GPL-3.0-or-later
"""A part that was copied together with its mesh, or merged into another document: the mesh's saved state knows its objects by their names there."""

from collections import defaultdict, deque

from .reading import has_shape, read_document


def with_names_of(today, saved):
    """The part of a saved state with the names that its objects have `today` (both as reading.read_document gives them); None where it is another part."""
    now, then = ({record["name"]: record for record in raw["records"]} for raw in (today, saved))
    names = _names_by_links(now, then, {saved["final_object"]: today["final_object"]})
    if then[saved["final_object"]]["type"] != now[today["final_object"]]["type"]:
        return None
    _add_the_rest(names, now, then)
    return renamed(saved, names)


def renamed(raw, names):
    """A part as reading.read_document gave it, with other `names` of its objects, {then: now}."""
    return {**raw, "final_object": names.get(raw["final_object"], raw["final_object"]), "records": [{
        **record, "name": names.get(record["name"], record["name"]),
        "links": [(prop, names.get(target, target), sub) for prop, target, sub in record["links"]]} for record in raw["records"]]}


def take_todays_names(saved, part):
    """Of a state that came with a copy of its part."""
    if part is not None and saved.part_name != part.Name and has_shape(part):
        saved.raw = with_names_of(read_document(part), saved.raw) or saved.raw


def _names_by_links(now, then, names):
    """Goes along the links of both, property by property."""
    waiting = deque(names)
    while waiting:
        name = waiting.popleft()
        links = [_targets_by_property(records[own]) for records, own in ((then, name), (now, names[name]))]
        for prop in links[0]:
            for old, new in zip(links[0][prop], links[1][prop]):
                if old not in names and old in then and new in now and then[old]["type"] == now[new]["type"] and new not in names.values():
                    names[old] = new
                    waiting.append(old)
    return names


def _targets_by_property(record):
    targets = defaultdict(list)
    for prop, target, _ in record["links"]:
        targets[prop].append(target)
    return targets


def _add_the_rest(names, now, then):
    """What no link leads to, such as a sheet that drives a length by an expression: the others of its type in their order."""
    free = defaultdict(deque)
    for name, record in now.items():
        if name not in names.values():
            free[record["type"]].append(name)
    for name, record in then.items():
        if name not in names and free[record["type"]]:
            names[name] = free[record["type"]].popleft()
