# SPDX-License-Identifier: LGPL-2.1-or-later

# The picture shows the points of each test and curves that are dashed beyond them; a file
# of another kind is refused.

from rubber_test import TRELOAR, check, output_of, require, rubber, scratch

require("numpy", "scipy", "matplotlib")

from biface_rubber.data import read
from biface_rubber.laws import LINEAR, TESTS, Law
from biface_rubber.picture import draw_law
from biface_report.drawing import plt

path = scratch() / "curves.png"
output_of(TRELOAR, "--plot", path)
check(path.read_bytes()[:4] == b"\x89PNG", "this is no PNG file")
code, _, errors = rubber(TRELOAR, "--plot", scratch() / "curves.doc")
check(code == 1 and "must be a png, svg or pdf file" in errors, errors)

data = read(TRELOAR)
panel = plt.subplots()[1]
draw_law(panel, Law("neo-Hooke", LINEAR["neo-Hooke"].values(), [0.4]), data, data)
for test in TESTS:
    end = data.stretches[data.of(test)].max()
    solid, = [line for line in panel.lines if line.get_label() == test]
    check(solid.get_linestyle() == "-" and solid.get_xdata()[-1] == end,
          f"the curve of {test} does not end with its points")
    check(any(line.get_linestyle() == "--" and line.get_xdata()[0] == end
              for line in panel.lines), f"the curve of {test} is not dashed beyond")
check(sum(len(line.get_xdata()) for line in panel.lines
          if line.get_linestyle() == "None") == len(data), "points are missing")
