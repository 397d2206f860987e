# SPDX-License-Identifier: GPL-3.0-or-later
"""What a study found, as one page of HTML that needs nothing beside it."""

import html
import os

import numpy as np

from .. import whole_file
from ..errors import UserError
from ..messages import english, figure, said
from . import answers, plots

_MOST_ROWS = 200
_STATES = {"waiting": said("waiting"), "running": said("running"), "done": said("done"), "infeasible": said("infeasible"), "failed": said("failed")}
_SURFACES = {"linear": said("linear"), "quadratic": said("quadratic"), "thin-plate spline": said("thin-plate spline")}
_SOLVED = {"ccx": said("solved by CalculiX"), "live": said("solved live"), None: said("not solved")}
_STYLE = ("body{font:15px/1.45 sans-serif;max-width:1100px;margin:2em auto;padding:0 1em;color:#1a202c}"
          "table{border-collapse:collapse;font-size:13px}td,th{padding:3px 9px;border-bottom:1px solid #e2e8f0;text-align:right}"
          "th{background:#f7fafc}td:last-child{text-align:left}img{max-width:100%}.note{color:#4a5568}")


def write(folder, path, pair=None, goal=None, limits=(), say=english, as_shown=str):
    """Writes the page. `pair` are the two responses of the Pareto front, `goal` and `limits` expressions for the best case, `say` puts messages into words,
    `as_shown` gives a text of numbers the user's decimal sign. Throws UserError."""
    page = _Page(folder, say, as_shown).made(pair, goal, limits)
    try:
        with whole_file.written(path) as stream:
            stream.write(page)
    except OSError as error:
        raise UserError(said("cannot write {path:text}: {why:messages}", path=path, why=error.strerror)) from error


class _Page:
    """The page's parts, each as HTML."""

    def __init__(self, folder, say, as_shown):
        self._folder, self._say, self._as_shown, self._data = folder, say, as_shown, answers.data_of(folder)

    def made(self, pair, goal, limits):
        """All of it."""
        data = self._data
        parts = [self._head(), self._best_cases(goal, limits), *self._what_matters()]
        if data.names:
            parts += [*self._picture(said("Responses over parameters"), plots.scatter, data, data.study.responses, self._say),
                      *self._picture(said("All cases at once"), plots.parallel, data, data.study.responses, self._say)]
        parts += [*self._pareto(pair), self._title(said("Cases")), self._cases_table()]
        return "<!DOCTYPE html><html><meta charset=utf-8><title>%s</title><style>%s</style><body>%s</body></html>\n" % (
            self._heading(), _STYLE, "\n".join(parts))

    def _words(self, message):
        return html.escape(self._say(message))

    def _title(self, message):
        return "<h2>%s</h2>" % self._words(message)

    def _picture(self, message, draw, *shown, what=None):
        """With its title; `what` says what it is where the title does not."""
        return [self._title(message), '<img alt="%s" src="%s">' % (self._words(what or message), plots.png(draw, *shown, as_shown=self._as_shown))]

    def _note(self, message):
        return "<p class=note>%s</p>" % self._words(message)

    def _row_of_titles(self, messages):
        return "<tr>%s</tr>" % "".join("<th>" + self._words(message) for message in messages)

    def _heading(self):
        return self._words(said("Study of {document:text}", document=os.path.basename(self._data.study.document)))

    def _head(self):
        counts, facts = self._folder.database.counts(), self._folder.facts()
        states = ", ".join("%d %s" % (count, self._say(_STATES[state])) for state, count in counts.items() if count)
        what = said("{sampling:text}: {states:text}. Every case starts from one base mesh ({nodes:count} {nodes:node|nodes}, {elements:count} "
                    "{elements:element|elements}); {solved:messages}.", sampling=self._data.study.sampling, states=states, nodes=facts["nodes"],
                    elements=facts["elements"], solved=_SOLVED[facts["solver"]])
        return "<h1>%s</h1><p>%s</p>" % (self._heading(), self._words(what)) + "".join("<p class=note>%s.</p>" % self._words(remark) for remark in facts["remarks"])

    def _best_cases(self, goal, limits):
        data, rows = self._data, []
        if goal:
            case = answers.best(data, goal, limits)
            rows.append(said("least {goal:text}: {case:messages}", goal=" & ".join([goal, *limits]),
                             case=self._case_in_words(case) if case else said("no case keeps that")))
        for response in data.study.responses:
            least, largest = (pick(data.cases, key=lambda case: case.responses[response.name]) for pick in (min, max))
            rows.append(said("{response:messages}: least {least:text} in case {case:count}, largest {largest:text} in case {other:count}", response=response.words,
                             least=self._with_unit(least, response), case=least.id, largest=self._with_unit(largest, response), other=largest.id))
        return "<ul>%s</ul>" % "".join("<li>%s</li>" % self._words(row) for row in rows)

    def _what_matters(self):
        data = self._data
        found = [effects for effects in (answers.effects(data, response.name) for response in data.study.responses) if effects]
        if not found:
            return [self._note(said("There are too few cases for response surfaces of {parameters:count} {parameters:parameter|parameters}; add some.",
                                    parameters=len(data.names)))]
        return [*self._picture(said("What matters"), plots.tornado, data, data.study.responses, found, self._say), self._effects_table(found)]

    def _effects_table(self, all_effects):
        head = self._row_of_titles([said("response"), said("parameter"), said("main effect"), said("first-order index"), said("total index"),
                                    said("surface, left-out error")])
        words = {response.name: response.words for response in self._data.study.responses}
        rows = ["<tr><td>%s<td>%s<td>%s<td>%s<td>%s<td>%s</tr>" % (
            self._words(words[found.response]), html.escape(name), *map(self._as_shown, (
                "%.4g" % found.main[place], "%.3f" % _index(found.first[place]), "%.3f" % _index(found.total[place]))),
            self._words(self._surface(found)) if not place else "") for found in all_effects for place, name in enumerate(self._data.names)]
        return "<table>%s%s</table>%s" % (head, "".join(rows), self._note(said(
            "The main effect is the response's mean change from a parameter's lowest to its highest value; the indices are Sobol's shares of the variance. "
            "All are of the response surface: they mean no more than its error allows, which is that of cases left out of the fit.")))

    def _pareto(self, pair):
        data = self._data
        responses = {response.name: response for response in data.study.responses}
        names = pair or list(responses)[:2]
        for name in names:
            if name not in responses:
                raise UserError(said("the study has no response {response:text}; it has {responses:text}", response=name, responses=", ".join(responses)))
        if len(names) != 2:
            if pair:
                raise UserError(said("compromises are between two responses, not {responses:text}", responses=", ".join(pair)))
            return []
        front = answers.pareto(data, *names)
        title = said("Compromises between {one:messages} and {other:messages}", one=responses[names[0]].words, other=responses[names[1]].words)
        return [*self._picture(title, plots.pareto, data, front, *(responses[name] for name in names), self._say, what=said("Pareto front")),
                "<p>%s</p>" % self._words(said("Less of both: {cases:text}.", cases=", ".join(
                    self._say(said("case {case:count}", case=case.id)) for case in front)))]

    def _cases_table(self):
        study, cases = self._data.study, self._folder.database.cases()
        names = [parameter.name for parameter in study.parameters] + [response.name for response in study.responses]
        titles = [parameter.title for parameter in study.parameters] + [response.title for response in study.responses]
        head = self._row_of_titles([said("case"), said("state"), *titles, said("time, s"), said("nodes kept"), said("message")])
        more = self._note(said("{count:count} more are in the table that `study export` writes.", count=len(cases) - _MOST_ROWS)) \
            if len(cases) > _MOST_ROWS else ""
        return "<table>%s%s</table>%s" % (head, "".join(self._case_row(case, names) for case in cases[:_MOST_ROWS]), more)

    def _case_row(self, case, names):
        values = {**case.parameters, **case.responses}
        cells = [str(case.id), self._say(_STATES[case.state]), *(self._shown(values.get(name, "")) for name in names), self._shown(case.seconds.get("total", "")),
                 "%.0f %%" % (100 * case.mesh["kept_share"]) if case.mesh else "", self._say(case.message)]
        return "<tr>%s</tr>" % "".join("<td>" + html.escape(cell) for cell in cells)

    def _case_in_words(self, case):
        words = {parameter.name: parameter.title for parameter in self._data.study.parameters}
        words.update((response.name, self._say(response.words)) for response in self._data.study.responses)
        values = ", ".join("%s %s" % (words.get(name, name), self._shown(value)) for name, value in {**case.parameters, **case.responses}.items())
        return said("case {case:count} ({values:text})", case=case.id, values=values)

    def _surface(self, found):
        return said("{kind:messages}, {error:text} ({percent:text} % of the spread)", kind=_SURFACES[found.surface.kind],
                    error=self._as_shown("%.3g" % found.surface.error), percent=self._as_shown("%.1f" % (100 * found.surface.relative_error)))

    def _with_unit(self, case, response):
        return " ".join(filter(None, (self._shown(case.responses[response.name]), response.unit)))

    def _shown(self, value):
        return self._as_shown(figure(value, 5)) if isinstance(value, (float, np.floating)) else str(value)


def _index(value):
    """Without the sign of a zero: indices are sums over random points."""
    return round(value, 3) + 0.0
