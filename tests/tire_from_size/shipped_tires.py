# SPDX-License-Identifier: LGPL-2.1-or-later

# The rules are those of the shipped tires: 49x17 26PR gives the entries of
# prm/aircraft_tire.prm, 205/60 R15 on 6J those of prm/radial_tire.prm.

import math

from tire_from_size_test import SOURCE, check, check_close

import biface
from biface_tire.design import Design, Options
from biface_tire.parameter_file import ParameterFile

shipped = biface.read_parameters(SOURCE / "prm/aircraft_tire.prm").entries
design = Design("49x17 26PR")
tire = design.tire
section = "Surface/Cord equilibrium/"
for entry, value in (("Crown radius", tire.crown), ("Half width", tire.half_width),
                     ("End radius", tire.end), ("End half width", tire.end_half_width)):
    check_close(value, float(shipped[section + entry].value), 1e-6, entry)
check(tire.layers() == shipped["Laminate/Layers"].value, f"{tire.layers()} layers")
plies = "".join(shipped["Laminate/Plies"].value.replace("cord: 1.1 @ ", "cord: 1.1@").split())
check("".join(ParameterFile(design, "layer").plies().replace("cord: 1.1 @ ", "cord: 1.1@")
              .split()) == plies, "the plies differ")
check_close(design.load, 176100, 1e-9, "the rated load")

shipped = biface.read_parameters(SOURCE / "prm/radial_tire.prm").entries
design = Design("205/60 R15 91V", Options(rim="6J"))
# the shipped one is 209 mm wide on a rim of 152 mm
check_close(design.width, 209, 3e-3, "the section width")
file = ParameterFile(design, "layer")
check(shipped["Laminate/Layers"].value == "9, 2" and "Layers            = 9, 2"
      in file.text("", SOURCE, []), "the layers differ")
check(math.isclose(design.tire.crown, 300.8, rel_tol=1e-9), f"{design.tire.crown}")
