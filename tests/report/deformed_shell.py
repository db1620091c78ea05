# SPDX-License-Identifier: LGPL-2.1-or-later

# With VTK, the page shows the deformed shell, colored by the contact pressure, and
# the foundation as it is.

import base64
import io
import os
import shutil
import sys

from report_test import RUNS, check, page_of, require

require("matplotlib", "vtk")
if not (shutil.which("xvfb-run") and shutil.which("xauth")
        or os.environ.get("DISPLAY")):
    print("skipped: there is no display, and no xvfb-run with xauth")
    sys.exit(77)

import matplotlib.image
import numpy as np

for run, name in (("shell", "plane"), ("drum", "drum")):
    page = page_of(RUNS / run)
    check(f"Seen through the {name}," in page.text, f"the {name} is not named")
images = [image for image in page.images
          if image["alt"] == "The deformed shell, colored by contact pressure."]
check(len(images) == 1, "there is no picture of the shell")
data = base64.b64decode(images[0]["src"].split(",", 1)[1])
pixels = matplotlib.image.imread(io.BytesIO(data))[..., :3]
# left of the bar: the shell is gray, the zone is purple to yellow
pixels = pixels[:, :820].reshape(-1, 3)
color = np.ptp(pixels, axis=1)
gray = ((color < 0.15) & (pixels.max(1) < 0.9)).mean()
check(gray > 0.1, f"only {gray} of the picture is shell")
check((color > 0.4).mean() > 0.002, "there is no footprint in color")
