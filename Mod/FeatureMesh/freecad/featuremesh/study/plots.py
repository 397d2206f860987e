# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of a study, drawn on figures of matplotlib, for a page or for the window."""

import base64
import io
import textwrap

import numpy as np
from matplotlib import colormaps
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import Formatter, FuncFormatter, MaxNLocator, ScalarFormatter

from ..messages import english, said
from .answers import are_the_same

_MOST_DIGITS = 12
_RESOLUTION = 0.02   # of the range between two numbers, to which both are written
_SHADES = 200
_ROOM = 6   # for how many axes' names there is room beside each other
_AROUND = 0.05   # of a number that all cases have, shown above and below it
_ACROSS = 3   # tornado plots beside each other
_LETTERS_HIGH, _LETTERS_BESIDE, _LETTERS_WIDE = 24, 18, 40   # in a line of a name: along the axis of a scatter, beside others, below a plot
_BLUE, _ORANGE, _GREY = "#2b6cb0", "#dd6b20", "#a0aec0"


def scatter(figure, data, responses, say=english):
    """Each response over each parameter. The points are pickable, in the order of the cases. `say` puts messages into words."""
    figure.set_size_inches(3.2 * len(data.names) + 1, 2.4 * len(responses))
    axes = figure.subplots(len(responses), len(data.names), squeeze=False)
    for row, response in enumerate(responses):
        for column, name in enumerate(data.names):
            plot, (low, high) = axes[row][column], data.limits[column]
            plot.scatter(low + (data.points[:, column] + 1) / 2 * (high - low), data.values(response.name), s=14, color=_BLUE, picker=5)
            plot.xaxis.set_major_locator(MaxNLocator(3))   # numbers may be as long as 0.00925
            plot.tick_params(axis="x", labelsize=8)
            plot.set_xlabel(_in_lines(name, _LETTERS_WIDE))
            if column == 0:
                plot.set_ylabel(_in_lines(say(response.title), _LETTERS_HIGH))
            values = data.values(response.name)
            if are_the_same(values) and values.any():
                plot.set_ylim(*sorted(((1 - _AROUND) * values[0], (1 + _AROUND) * values[0])))


def parallel(figure, data, responses, say=english):
    """A line for each case across all parameters and responses, coloured by the first response, as its axis shows. The lines are pickable, in the order of the cases."""
    names = data.names + [response.name for response in responses]
    shares = np.column_stack([(data.points + 1) / 2, *(_shares(data.values(response.name)) for response in responses)])
    limits = data.limits + [(data.values(response.name).min(), data.values(response.name).max()) for response in responses]
    figure.set_size_inches(1.7 * len(names) + 1, 3.6)
    plot = figure.subplots()
    coloured = len(data.names)
    for line in shares:
        plot.plot(line, color=colormaps["viridis"](line[coloured]), alpha=0.8, linewidth=1.1, picker=4)
    scale = np.linspace(0, 1, _SHADES)
    plot.scatter(np.full(_SHADES, coloured), scale, c=scale, cmap="viridis", marker="s", s=24, linewidths=0)   # what the colours mean
    titles = [_in_lines(title, _LETTERS_BESIDE) for title in (*data.names, *(say(response.title) for response in responses))]
    for place, (name, (low, high)) in enumerate(zip(titles, limits)):
        plot.axvline(place, color=_GREY, linewidth=0.8)
        ends = _told_apart(low, high)
        plot.text(place, -0.07, "%s\n%s%s" % (ends[0], "\n" if len(titles) > _ROOM and place % 2 else "", name), ha="center", va="top", fontsize=8)
        plot.text(place, 1.07, ends[1], ha="center", va="bottom", fontsize=8)
    plot.set_axis_off()


def _in_lines(text, letters):
    """The same text in lines of so many letters; a $ in it begins no formula."""
    return textwrap.fill(text, letters, break_long_words=False).replace("$", r"\$")


def _told_apart(low, high):
    """Both numbers as texts of four digits, or of as many as the range between them needs."""
    digits = 4
    while not are_the_same(np.array((low, high))) and digits < _MOST_DIGITS and any(abs(float("%.*g" % (digits, end)) - end) > _RESOLUTION * (high - low) for end in (low, high)):
        digits += 1
    return "%.*g" % (digits, low), "%.*g" % (digits, high)


def tornado(figure, data, responses, all_effects, say=english):
    """The main effects, the largest on top. `say` puts messages into words."""
    rows, columns = -(-len(all_effects) // _ACROSS), min(len(all_effects), _ACROSS)
    figure.set_size_inches(4.2 * columns, (0.5 * len(data.names) + 1.2) * rows)
    axes = figure.subplots(rows, columns, squeeze=False)
    units = {response.name: response for response in responses}
    for plot in axes.ravel()[len(all_effects):]:
        plot.set_axis_off()
    for plot, found in zip(axes.ravel(), all_effects):
        order = np.argsort(np.abs(found.main))
        plot.barh([_in_lines(data.names[place], _LETTERS_WIDE) for place in order], found.main[order], color=[_BLUE if found.main[place] < 0 else _ORANGE for place in order])
        plot.axvline(0, color="black", linewidth=0.8)
        plot.xaxis.set_major_locator(MaxNLocator(3))
        plot.xaxis.set_major_formatter(FuncFormatter(lambda value, _: "%.3g" % value))
        plot.tick_params(labelsize=8)
        plot.set_xlabel(say(said("change of")) + "\n" + _in_lines(say(units[found.response].title), _LETTERS_WIDE))


def pareto(figure, data, front, first, second, say=english):
    """All cases in the plane of two responses, and those that no other beats."""
    figure.set_size_inches(5.2, 3.8)
    plot = figure.subplots()
    plot.scatter(data.values(first.name), data.values(second.name), s=16, color=_GREY, label=say(said("cases")))
    plot.plot([case.responses[first.name] for case in front], [case.responses[second.name] for case in front], "o-", color=_ORANGE, label=say(said("not beaten")))
    plot.set_xlabel(say(first.title))
    plot.set_ylabel(_in_lines(say(second.title), _LETTERS_WIDE))
    plot.legend()


def show_numbers(figure, as_shown):
    """Puts all numbers of a figure as `as_shown` does, with the user's decimal sign."""
    for plot in figure.axes:
        for axis in (plot.xaxis, plot.yaxis):
            if isinstance(axis.get_major_formatter(), (ScalarFormatter, FuncFormatter)):   # not names
                axis.set_major_formatter(_AsShown(axis.get_major_formatter(), as_shown))
        for text in plot.texts:
            text.set_text(as_shown(text.get_text()))


class _AsShown(Formatter):

    def __init__(self, inner, as_shown):
        self._inner, self._as_shown = inner, as_shown

    def __call__(self, value, place=None):
        return self._as_shown(self._inner(value, place))

    def set_locs(self, locs):
        self._inner.set_locs(locs)

    def get_offset(self):
        return self._as_shown(self._inner.get_offset())


def _shares(values):
    return np.full(len(values), 0.5) if are_the_same(values) else (values - values.min()) / np.ptp(values)


def png(draw, *words, as_shown=str):
    """What `draw(figure, *words)` draws, its numbers as `as_shown` puts them, as it stands in a page."""
    figure = Figure()
    draw(figure, *words)
    show_numbers(figure, as_shown)
    figure.tight_layout()
    stream = io.BytesIO()
    FigureCanvasAgg(figure).print_figure(stream, format="png", dpi=110, metadata={"Software": None})
    return "data:image/png;base64," + base64.b64encode(stream.getvalue()).decode("ascii")
