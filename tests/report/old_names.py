# SPDX-License-Identifier: LGPL-2.1-or-later

# Results with the older names of entries give the same page.

from report_test import RUNS, check, copy_of, page_of, require

require("matplotlib")
OLD_NAMES = {"set Direction": "set Plane normal", "set Named points": "set Points",
             "set Start from prestress": "set Begin from prestress"}


def without_input(page):
    """The page down to the section that quotes parameters.prm."""
    return page.source[:page.source.index('<section id="input"')]


for run in ("drum", "composite_panel"):
    directory = copy_of(run)
    path = directory / "parameters.prm"
    text = path.read_text()
    for new, old in OLD_NAMES.items():
        check(new in text, f"parameters.prm has no '{new}'")
        text = text.replace(new, old)
    path.write_text(text)
    check(without_input(page_of(directory)) == without_input(page_of(RUNS / run)),
          f"{run}: the pages differ")
