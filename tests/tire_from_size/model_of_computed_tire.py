# SPDX-License-Identifier: LGPL-2.1-or-later

# The runs of a protocol succeed on a tire from its size: the tables have the stiffnesses of
# stiffness.csv, those of a footprint with bristles, and the frequencies of modes.csv; ground
# and bar together carry the load, and the bar lifts the axle.

import os

from tire_from_size_test import check, check_close, output_of, require, scratch, tire

require("matplotlib")

from biface import Results

os.environ["BIFACE"] = os.environ["BIFACE_PROGRAM"]
path = scratch()
output_of("new", "4.00-8", "4PR", "--rim", "2.50C", "--cells", "0.3", "--output", path)
protocol = path / "few.csv"
protocol.write_text("kind,load [%],height [mm]\nlateral,60,\nmodes,,\n"
                    "transversal bar,40,12\n", encoding="utf-8")
code, output, errors = tire("model", path, "--protocol", protocol)
check(code == 0 and errors == "", f"{code}: {output}{errors}")
results = path / "model_few"
standing = Results(results / "runs/standing")
check_close(float(standing.setting("Contact/Tread/Height")), 3.80226, 1e-5, "the tread")


def column(table, name):
    """The numbers of a column of a table."""
    names, *rows = (results / f"tables/{table}.csv").read_text(
        encoding="utf-8").splitlines()[1:]
    place = names.split(",").index(name)
    return [float(row.split(",")[place]) for row in rows]


found = standing.stiffness().where(motion="slide")
check_close(column("lateral_stiffness", "first_secant [N/m]")[0], 1000 * found["secant"][0],
            1e-9, "the stiffness")
check_close(column("radial_stiffness", "load [N]")[-1], 0.6 * 2689.77, 1e-5, "the load")
modes = Results(results / "runs/vibrating").modes()
check(modes["frequency"][0] > 0 and len(column("frequencies", "frequency [Hz]")) == len(modes),
      "frequencies are missing")
check_close(column("frequencies", "frequency [Hz]")[0], modes["frequency"][0], 1e-9,
            "the frequency")
check_close(column("transversal_bar_12", "load [N]")[-1], 0.4 * 2689.77, 1e-5, "the load")
plane, bar = (Results(results / "runs/transversal-bar-12").stage(name).last("approach")
              for name in ("load 1075.908 at 0.38641 on the plane",
                           "on the bar: load 1075.908 at 0.38641"))
check(plane - 12 < bar < plane, f"the bar lifts the axle by {plane - bar} mm")
check_close(column("transversal_bar_12", "deflection [m]")[-1], bar / 1000, 1e-9, "the height")
