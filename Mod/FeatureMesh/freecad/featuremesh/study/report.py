# SPDX-License-Identifier: GPL-3.0-or-later
"""What a study found, as one page of HTML that needs nothing beside it."""

import html
import os

import numpy as np

from ..errors import UserError
from . import answers, plots

_MOST_ROWS = 200
_STYLE = ("body{font:15px/1.45 sans-serif;max-width:1100px;margin:2em auto;padding:0 1em;color:#1a202c}"
          "table{border-collapse:collapse;font-size:13px}td,th{padding:3px 9px;border-bottom:1px solid #e2e8f0;text-align:right}"
          "th{background:#f7fafc}td:last-child{text-align:left}img{max-width:100%}.note{color:#4a5568}")


def write(folder, path, pair=None, goal=None, limits=()):
    """Writes the page. `pair` are the two responses of the Pareto front, `goal` and `limits` expressions for the best case. Throws UserError."""
    data = answers.data_of(folder)
    responses = data.study.responses
    parts = [_head(folder, data), _best_cases(data, goal, limits)]
    all_effects = [found for found in (answers.effects(data, response.name) for response in responses) if found]
    if all_effects:
        parts += ["<h2>What matters</h2>", _image(plots.png(plots.tornado, data, responses, all_effects), "tornado"), _effects_table(data, all_effects)]
    else:
        parts.append("<p class=note>There are too few cases for response surfaces of %d parameters; add some.</p>" % len(data.names))
    if data.names:
        parts += ["<h2>Responses over parameters</h2>", _image(plots.png(plots.scatter, data, responses), "scatter"),
                  "<h2>All cases at once</h2>", _image(plots.png(plots.parallel, data, responses), "parallel coordinates")]
    parts += _pareto(data, pair)
    parts += ["<h2>Cases</h2>", _cases_table(folder, data)]
    page = "<!DOCTYPE html><html lang=en><meta charset=utf-8><title>%s</title><style>%s</style><body>%s</body></html>\n" % (
        html.escape(_title(folder)), _STYLE, "\n".join(parts))
    try:
        with open(path + ".tmp", "w", encoding="utf-8") as stream:
            stream.write(page)
        os.replace(path + ".tmp", path)
    except OSError as error:
        raise UserError("cannot write %s: %s" % (path, error.strerror)) from error


def _title(folder):
    return "Study of " + os.path.basename(folder.study().document)


def _head(folder, data):
    counts, facts = folder.database.counts(), folder.facts()
    study = data.study
    remarks = "".join("<p class=note>%s.</p>" % html.escape(remark) for remark in facts["remarks"])
    return "<h1>%s</h1><p>%s: %s. Every case starts from one base mesh (%d nodes, %d elements); %s.</p>" % (
        html.escape(_title(folder)), html.escape(study.sampling), ", ".join("%d %s" % (count, state) for state, count in counts.items() if count),
        facts["nodes"], facts["elements"], {"ccx": "solved by CalculiX", "live": "solved live", None: "not solved"}[facts["solver"]]) + remarks


def _best_cases(data, goal, limits):
    rows = []
    if goal:
        case = answers.best(data, goal, limits)
        what = html.escape(" and ".join(["least " + goal, *limits]))
        rows.append("<li>%s: %s</li>" % (what, _case_in_words(data, case) if case else "no case keeps that"))
    for response in data.study.responses:
        least, largest = (pick(data.cases, key=lambda case: case.responses[response.name]) for pick in (min, max))
        rows.append("<li>%s: least %.5g in case %d, largest %.5g in case %d</li>" % (
            html.escape(response.name), least.responses[response.name], least.id, largest.responses[response.name], largest.id))
    return "<ul>%s</ul>" % "".join(rows)


def _case_in_words(data, case):
    values = {**case.parameters, **case.responses}
    return "case %d (%s)" % (case.id, html.escape(", ".join("%s %s" % (name, _shown(value)) for name, value in values.items())))


def _effects_table(data, all_effects):
    head = "<tr><th>response<th>parameter<th>main effect<th>first-order index<th>total index<th>surface, left-out error</tr>"
    rows = []
    for found in all_effects:
        for place, name in enumerate(data.names):
            rows.append("<tr><td>%s<td>%s<td>%.4g<td>%.3f<td>%.3f<td>%s</tr>" % (
                html.escape(found.response), html.escape(name), found.main[place], _index(found.first[place]), _index(found.total[place]),
                "%s, %.3g (%.1f %% of the spread)" % (found.surface.kind, found.surface.error, 100 * found.surface.relative_error) if not place else ""))
    return ("<table>%s%s</table><p class=note>The main effect is the response's mean change from a parameter's lowest to its highest value; the "
            "indices are Sobol's shares of the variance. All are of the response surface: they mean no more than its error allows, which is that "
            "of cases left out of the fit.</p>" % (head, "".join(rows)))


def _pareto(data, pair):
    responses = {response.name: response for response in data.study.responses}
    names = pair or list(responses)[:2]
    for name in names:
        if name not in responses:
            raise UserError("the study has no response %s; it has %s" % (name, ", ".join(responses)))
    if len(names) != 2:
        return []
    front = answers.pareto(data, *names)
    return ["<h2>Compromises between %s and %s</h2>" % tuple(map(html.escape, names)),
            _image(plots.png(plots.pareto, data, front, *(responses[name] for name in names)), "Pareto front"),
            "<p>Less of both: %s.</p>" % ", ".join("case %d" % case.id for case in front)]


def _cases_table(folder, data):
    study, cases = data.study, folder.database.cases()
    names = [parameter.name for parameter in study.parameters] + [response.name for response in study.responses]
    titles = [parameter.name for parameter in study.parameters] + [response.title for response in study.responses]
    head = "<tr>%s</tr>" % "".join("<th>%s" % html.escape(title) for title in ("case", "state", *titles, "time, s", "nodes kept", "message"))
    rows = []
    for case in cases[:_MOST_ROWS]:
        values = {**case.parameters, **case.responses}
        cells = [str(case.id), case.state, *(_shown(values.get(name, "")) for name in names), _shown(case.seconds.get("total", "")),
                 "%.0f %%" % (100 * case.mesh["kept_share"]) if case.mesh else "", html.escape(case.message)]
        rows.append("<tr>%s</tr>" % "".join("<td>" + cell for cell in cells))
    more = "<p class=note>%d more are in the table that `study export` writes.</p>" % (len(cases) - _MOST_ROWS) if len(cases) > _MOST_ROWS else ""
    return "<table>%s%s</table>%s" % (head, "".join(rows), more)


def _index(value):
    """Without the sign of a zero: indices are sums over random points."""
    return round(value, 3) + 0.0


def _shown(value):
    return "%.5g" % value if isinstance(value, (float, np.floating)) else html.escape(str(value))


def _image(source, what):
    return '<img alt="%s" src="%s">' % (what, source)
