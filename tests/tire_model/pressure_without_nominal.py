# SPDX-License-Identifier: LGPL-2.1-or-later

# A pressure is refused where the file has no nominal one.

from tire_model_test import check_refused, output_of, require, write

require("numpy", "scipy")

file = write("tire.tir", "[MODEL]\nFITTYP = 6\n[DIMENSION]\nUNLOADED_RADIUS = 0.3\n"
                         "[VERTICAL]\nFNOMIN = 4000\n")
output_of("evaluate", file, "--fz", "4000")
check_refused(["evaluate", file, "--fz", "4000", "--pressure", "2e5"],
              "the pressure is given, but the file has no nominal one, NOMPRES")
