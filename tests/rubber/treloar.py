# SPDX-License-Identifier: LGPL-2.1-or-later

# Ogden's published constants miss Treloar's equibiaxial and planar curves by less than
# 0.05 MPa, and the fit of three terms all curves by less than 0.1 MPa.

from rubber_test import OGDEN, TRELOAR, check, require, scratch

require("numpy", "scipy")

from biface_rubber.data import read
from biface_rubber.fit import fit
from biface_rubber.laws import Law, ogden_terms
from biface_rubber.text import residuals

data = read(TRELOAR)
published = Law("Ogden", ogden_terms(OGDEN["alpha_i"]), OGDEN["mu_i"])
errors = {test: rms for test, (_, rms, _, _) in residuals(published, data).items()}
check(list(errors) == ["uniaxial", "equibiaxial", "planar"], f"the tests are {errors}")
check(errors["equibiaxial"] < 0.05 and errors["planar"] < 0.05, f"{errors}")
fitted = residuals(fit(data, "Ogden", 3), data)
check(fitted["uniaxial"][1] < 0.1 < errors["uniaxial"], f"the errors are {fitted}")
check(max(fitted["equibiaxial"][1], fitted["planar"][1]) < 0.05, f"{fitted}")

# with semicolons and decimal commas the points are the same
path = scratch() / "comma.csv"
path.write_text(TRELOAR.read_text(encoding="utf-8").replace(",", ";").replace(".", ","),
                encoding="utf-8")
again = read(path)
check((again.stretches == data.stretches).all() and (again.stresses == data.stresses).all(),
      "other points with decimal commas")
