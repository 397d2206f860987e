# SPDX-License-Identifier: GPL-3.0-or-later
"""A wrench: handle with a pattern of slots and a head with a hexagonal socket; it gains a stiffener along the handle.

`make()` gives the wrench with its stiffener, `make_without()` the same document before.
"""
import part_design as draw
from analysis import add_analysis

HANDLE_HEIGHT = 10


def draw_wrench():
    document, body = draw.new_document("tool")
    handle = draw.add_sketch(body, "HandleSketch")
    draw.draw_rectangle(handle, "Handle", 0, 0, 160, 24)
    draw.pad(body, "Handle", handle, HANDLE_HEIGHT)
    head = draw.add_sketch(body, "HeadSketch")
    draw.draw_circle(head, "Head", 178, 12, 26)
    draw.pad(body, "Head", head, 18)
    socket = draw.add_sketch(body, "SocketSketch")
    draw.draw_hexagon(socket, "Socket", 178, 12, 14)
    draw.pocket_through(body, "Socket", socket)
    slot = draw.add_sketch(body, "SlotSketch")
    draw.draw_rectangle(slot, "Slot", 15, 4, 12, 4)
    first_slot = draw.pocket_through(body, "Slot", slot)
    slots = draw.add_feature(body, "LinearPattern", "Slots")
    slots.Originals = [first_slot]
    slots.Direction = (slot, ["H_Axis"])
    slots.Length, slots.Occurrences = 90, 4
    body.Tip = slots
    document.recompute()
    return document


def load(document):
    """Held at two sides of the socket, pressed at the handle's end."""
    add_analysis(document, document.getObject("Body"), fixed_at=[(178, 12 + 14 * 0.75 ** 0.5, 9), (178, 12 - 14 * 0.75 ** 0.5, 9)],
                 force_at=(40, 24, 5), force_newton=300)
    document.recompute()
    return document


def make_without():
    return load(draw_wrench())


def make():
    document = draw_wrench()
    add_stiffener(document)
    return load(document)


def add_stiffener(document):
    """The edit of this example: a rib on the handle, beside the slots."""
    body = document.getObject("Body")
    stiffener = draw.add_sketch(body, "StiffenerSketch", HANDLE_HEIGHT)
    draw.draw_rectangle(stiffener, "Stiffener", 20, 13, 110, 5)
    body.Tip = draw.pad(body, "Stiffener", stiffener, 6)
    document.recompute()
