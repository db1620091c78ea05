# SPDX-License-Identifier: LGPL-2.1-or-later

# The view shows one ply alone, in the range of its values in all steps, or in this
# step.

from report_test import PACKAGE, RUNS, check, report, require, scratch

require("matplotlib")

import sys

import numpy as np
from browser import Browser

sys.path.insert(0, str(PACKAGE))

from biface import read_vtu

target = scratch() / "page.html"
report(RUNS / "plies", target=target)
browser = Browser(target)
data = [read_vtu(RUNS / f"plies/plies-000{step}.vtu") for step in (1, 2)]
browser.set("Show", "1 2")
browser.set("Color", "s_L -1")
for name, chosen in (("Same range in all steps", data), ("Step", data[:1])):
    values = np.concatenate([step["s_L"][step["ply"] == 3] for step in chosen])
    found = browser.run(
        "return [view.uniforms.low.value, view.uniforms.high.value];")
    check(np.allclose(found, [values.min(), values.max()], rtol=1e-4),
          f"{name}: the bar is from {found[0]} to {found[1]}")
    browser.set("Same range in all steps", False)
    browser.set("Step", 0)
count, total = browser.run("""
    return [view.surface.geometry.drawRange.count,
            view.surface.geometry.index.count];""")
check(8 * count == total, f"{count} of {total} points of triangles are drawn")
check("ply 3" in browser.run("return view.part.selectedOptions[0].text;"),
      "the menu does not name the ply")
browser.check_no_errors()
