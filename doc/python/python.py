#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write python.md and its pictures: the cells of tutorial.py with their output."""

import ast
import contextlib
import io
import os
import re
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import EXAMPLES, parse_arguments

HEAD = "<!-- Written by doc/python/python.py: cmake --build build --target python_page -->"


def cells_of(text):
    """Whether it is Markdown, and the text of each cell."""
    for kind, body in re.findall(r"^# %%([^\n]*)\n(.*?)(?=^# %%|\Z)", text,
                                 re.MULTILINE | re.DOTALL):
        is_markdown = "[markdown]" in kind
        yield is_markdown, (re.sub(r"^# ?", "", body, flags=re.MULTILINE)
                            if is_markdown else body).strip()


def execute(code, variables):
    """Runs a cell; what it prints, and the value of a last expression without a
    semicolon, as notebooks show it."""
    statements = ast.parse(code)
    last = statements.body[-1]
    shown = None
    if isinstance(last, ast.Expr) and not code.endswith(";"):
        shown = ast.Expression(statements.body.pop().value)
    with contextlib.redirect_stdout(io.StringIO()) as output:
        exec(compile(statements, "tutorial.py", "exec"), variables)
        value = shown and eval(compile(shown, "tutorial.py", "eval"), variables)
        if value is not None:
            print(value)
    return "\n".join(map(str.rstrip, output.getvalue().rstrip().split("\n")))


def main():
    arguments = parse_arguments("python", __doc__)
    page, figures = arguments.output.resolve() / "python.md", 0
    text = Path(__file__).with_name("tutorial.py").read_text(encoding="utf-8")
    os.environ["BIFACE"] = str(Path(arguments.program).resolve())
    # the files are named from the root of the checkout
    os.chdir(arguments.scratch)
    Path("prm").unlink(missing_ok=True)
    Path("prm").symlink_to(EXAMPLES)
    parts, variables = [HEAD], {}
    for is_markdown, cell in cells_of(text):
        if is_markdown:
            parts.append(cell)
            continue
        parts.append(f"```python\n{cell.rstrip(';')}\n```")
        if output := execute(cell, variables):
            parts.append(f"```\n{output}\n```")
        if plt.get_fignums():
            figures += 1
            name = f"figures/python_{figures}.png"
            plt.savefig(page.parent / name, dpi=100, metadata={"Software": None})
            plt.close("all")
            # its comment says what the picture shows
            parts.append(f"![{re.search('^# (.*)', cell, re.MULTILINE)[1]}]({name})")
    page.write_text("\n\n".join(parts) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
