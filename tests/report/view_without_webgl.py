# SPDX-License-Identifier: LGPL-2.1-or-later

# Without WebGL, a sentence stands in place of the view.

from report_test import RUNS, check, report, require, scratch

require("matplotlib")

from browser import Browser

target = scratch() / "page.html"
report(RUNS / "shell", target=target)
text = Browser(target, "--disable-3d-apis").run(
    "return figure.querySelector('p.warning').textContent;")
check(text == "The view needs WebGL, which this browser lacks.", text)
