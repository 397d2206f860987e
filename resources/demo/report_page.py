# SPDX-License-Identifier: GPL-3.0-or-later
"""A report as one self-contained HTML page: key figures, tables and pictures, nothing loaded from elsewhere."""
import base64
from html import escape

STYLE = """
:root { --ink: #20262d; --soft: #66717d; --line: #e1e6eb; --accent: #d9772b; --panel: #f6f8fa; }
* { box-sizing: border-box; }
body { margin: 0; color: var(--ink); background: #fff; font: 16px/1.55 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
main { max-width: 1120px; margin: 0 auto; padding: 40px 28px 72px; }
h1 { font-size: 30px; line-height: 1.2; margin: 0 0 6px; letter-spacing: -0.01em; }
h2 { font-size: 20px; margin: 44px 0 8px; padding-top: 14px; border-top: 1px solid var(--line); }
p { margin: 8px 0; max-width: 82ch; }
.lead { color: var(--soft); font-size: 17px; }
.tiles { display: grid; grid-template-columns: repeat(auto-fit, minmax(185px, 1fr)); gap: 14px; margin: 26px 0 8px; }
.tile { background: var(--panel); border-radius: 10px; padding: 14px 16px; }
.tile b { display: block; font-size: 27px; line-height: 1.25; font-variant-numeric: tabular-nums; }
.tile span { color: var(--soft); font-size: 14px; line-height: 1.35; display: block; }
.tile.strong b { color: var(--accent); }
figure { margin: 18px 0 6px; }
figure img { width: 100%; height: auto; display: block; }
figcaption { color: var(--soft); font-size: 14px; margin-top: 4px; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; margin: 14px 0; font-variant-numeric: tabular-nums; }
th, td { text-align: right; padding: 6px 16px 6px 0; border-bottom: 1px solid var(--line); white-space: nowrap; }
th { color: var(--soft); font-weight: 600; font-size: 14px; }
th:first-child, td:first-child { text-align: left; }
td.words, th.words { text-align: left; white-space: normal; }
footer { margin-top: 48px; color: var(--soft); font-size: 13px; border-top: 1px solid var(--line); padding-top: 12px; }
"""


class Page:
    """Collects the parts of a page from top to bottom."""

    def __init__(self, title, lead):
        self._title = title
        self._parts = [f"<h1>{escape(title)}</h1>", f'<p class="lead">{escape(lead)}</p>']

    def add_tiles(self, tiles):
        """Key figures: (number, what it is, is it the point of the page)."""
        cells = "".join(f'<div class="tile{" strong" if strong else ""}"><b>{escape(number)}</b><span>{escape(what)}</span></div>'
                        for number, what, strong in tiles)
        self._parts.append(f'<div class="tiles">{cells}</div>')

    def add_heading(self, text):
        self._parts.append(f"<h2>{escape(text)}</h2>")

    def add_text(self, text):
        self._parts.append(f"<p>{escape(text)}</p>")

    def add_table(self, header, rows, words=()):
        """A table; columns whose numbers are in `words` hold words and are set to the left."""
        def row(tag, values):
            return "<tr>" + "".join(f'<{tag}{" class=words" if column in words else ""}>{escape(str(value))}</{tag}>'
                                    for column, value in enumerate(values)) + "</tr>"
        body = "".join(row("td", values) for values in rows)
        self._parts.append(f'<div class="scroll"><table><thead>{row("th", header)}</thead><tbody>{body}</tbody></table></div>')

    def add_figure(self, path, caption):
        """A PNG picture, taken into the page."""
        with open(path, "rb") as picture:
            data = base64.b64encode(picture.read()).decode("ascii")
        self._parts.append(f'<figure><img alt="{escape(caption)}" src="data:image/png;base64,{data}">'
                           f"<figcaption>{escape(caption)}</figcaption></figure>")

    def write(self, path, closing):
        """Writes the page with a closing line."""
        html = (f'<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">'
                f"<title>{escape(self._title)}</title><style>{STYLE}</style></head><body><main>{''.join(self._parts)}"
                f"<footer>{escape(closing)}</footer></main></body></html>")
        with open(path, "w", encoding="utf-8") as page:
            page.write(html)
