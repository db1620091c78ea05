# SPDX-License-Identifier: LGPL-2.1-or-later

# The view of the shell turns by the mouse and by keys, its slider changes the step,
# and the page loads nothing and reports no errors.

from report_test import RUNS, check, report, require, scratch

require("matplotlib")

import numpy as np
from browser import Browser

target = scratch() / "page.html"
report(RUNS / "shell", target=target)
browser = Browser(target)


def canvas():
    """What the view shows, without the frame of the focus."""
    left, top, width, height = map(int, browser.run("""
        const { canvas } = view;
        const { left, top, width, height } = canvas.getBoundingClientRect();
        return [left, top, width, height];"""))
    return browser.picture()[top + 5:top + height - 5, left + 5:left + width - 5]


def changed(before, what):
    """Checks that the view shows something else than before; returns it."""
    after = canvas()
    share = (np.abs(after - before).max(-1) > 20).mean()
    check(share > 0.002, f"{what} changes only {share} of the picture")
    return after


first = canvas()
check((np.ptp(first, axis=-1) > 60).mean() > 0.002, "there is no zone in color")
browser.drag(120, 30)
turned = changed(first, "dragging")
browser.press("ArrowLeft", "ArrowUp")
turned = changed(turned, "an arrow key")
browser.press("Home")
check(np.abs(canvas() - first).max() < 20, "Home does not reset the view")
label = browser.run(
    "return view.canvas.ariaLabel;")
check("step 2" in label and "contact_pressure" in label, f"label: {label}")
browser.set("Step", 0)
changed(first, "the slider")
label = browser.run("return view.label.value;")
check("step 1" in label, f"the slider leads to {label}")
browser.check_no_errors()
