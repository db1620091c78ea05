# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of a page of HTML: numbers, tables, pictures, sections."""

import math
from collections import namedtuple
from html import escape
from pathlib import Path

# A section of the page: its identifier, heading, content as HTML, and whether it
# takes the full width of a wide page or half of it
Section = namedtuple("Section", "name title html is_wide", defaults=[False])

# A section that is left out, and why: one sentence
LeftOut = namedtuple("LeftOut", "title reason")

# Relative to its neighbors, anything smaller is round-off
ROUND_OFF = 1e-9
# Relative to the forces and displacements of a step, anything smaller is below what
# the iteration resolves
TOLERANCE = 1e-7


def number(value, digits=5, scale=0):
    """A rounded number for people, and the exact one for programs. Round-off,
    relative to a scale, is shown as such."""
    shown = ("≈ 0" if 0 < abs(value) < ROUND_OFF * scale
             else plain_number(value, digits))
    return f'<data value="{float(value)!r}">{shown}</data>'


def plain_number(value, digits=5):
    """A number with some digits; with a power of ten only if that is shorter."""
    value = float(value)
    if not math.isfinite(value):
        return "–"
    if value == 0:
        return "0"
    exponent = math.floor(math.log10(abs(float(f"{value:.{digits - 1}e}"))))
    if -4 <= exponent < 7:
        text = f"{value:.{max(digits - 1 - exponent, 0)}f}"
        text = text.rstrip("0").rstrip(".") if "." in text else text
    else:
        mantissa = f"{value / 10**exponent:.{digits - 1}f}".rstrip("0").rstrip(".")
        text = f"{mantissa}\u00a0×\u00a010<sup>{exponent}</sup>".replace(
            "sup>-", "sup>−")
    return text.replace("-", "−", 1) if text.startswith("-") else text


def count(value, noun, plural=None):
    """A number with its noun."""
    return f"{value} {noun if value == 1 else plural or noun + 's'}"


def paragraph(html, kind=None):
    """A paragraph of HTML, with a class if there is one."""
    return f'<p class="{kind}">{html}</p>' if kind else f"<p>{html}</p>"


def missing(parts):
    """The section on what is left out."""
    items = "\n".join(f"<li>{escape(part.title)}: {escape(part.reason)}</li>"
                      for part in parts)
    return Section("missing", "Not in this report", f"<ul>\n{items}\n</ul>", True)


def table(caption, heads, rows, row_heads=True):
    """A table that scrolls if it is too wide.

    Cells are HTML. The first cell of each row is its head."""
    head = "".join(f'<th scope="col">{cell}</th>' for cell in heads)
    body = []
    for first, *others in rows:
        begin = f'<th scope="row">{first}</th>' if row_heads \
            else f"<td>{first}</td>"
        body.append("<tr>" + begin
                    + "".join(f"<td>{cell}</td>" for cell in others) + "</tr>")
    top = f"<thead><tr>{head}</tr></thead>\n" if heads else ""
    label = escape(caption, quote=True)
    return (f'<div class="scroll" role="region" tabindex="0" '
            f'aria-label="{label}">\n<table>\n<caption>{escape(caption)}'
            f"</caption>\n{top}<tbody>\n" + "\n".join(body)
            + "\n</tbody>\n</table>\n</div>")


def figure(picture, alternative, caption=None):
    """A picture (see drawing.py), its description, and a caption in HTML."""
    text = f"<figcaption>{caption}</figcaption>" if caption else ""
    return (f'<figure><img src="{picture.address}" width="{picture.width}" '
            f'alt="{escape(alternative, quote=True)}">{text}</figure>')


def details(summary, html, is_open=False):
    """HTML that can be folded, and is at first unless it is_open."""
    start = "<details open>" if is_open else "<details>"
    return f"{start}\n<summary>{escape(summary)}</summary>\n{html}\n</details>"


def section_html(section):
    """A section with its heading."""
    kind = ' class="wide"' if section.is_wide else ""
    return (f'<section id="{section.name}"{kind} '
            f'aria-labelledby="{section.name}-h">\n'
            f'<h2 id="{section.name}-h">{escape(section.title)}</h2>\n'
            f"{section.html}\n</section>")


def page(title, introduction, sections, scripts=""):
    """The whole page."""
    style = (Path(__file__).parent / "style.css").read_text(encoding="utf-8")
    links = "\n".join(f'<li><a href="#{section.name}">{escape(section.title)}'
                      "</a></li>" for section in sections)
    body = "\n\n".join(map(section_html, sections))
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="biface-report">
<title>{escape(title)}</title>
<style>
{style}</style>
</head>
<body>
<header>
<h1>{escape(title)}</h1>
{introduction}
</header>
<nav aria-label="Sections">
<ul>
{links}
</ul>
</nav>
<main>
{body}
</main>
{scripts}</body>
</html>
"""
