# SPDX-License-Identifier: LGPL-2.1-or-later

# Rows of a table are chosen by conditions and values, without a change of the table.

import numpy as np

from python_test import biface, check

table = biface.Table({"body": np.array(["rim", "ground", "rim"], dtype=object),
                      "F_x": np.array([1., 2., 3.])})
check(len(table) == 3 and len(table.where(body="rim")) == 2, "the number of rows")
check(list(table.where(table["F_x"] > 1, body="rim")["F_x"]) == [3.], "both at once")
check(table.row(-1) == {"body": "rim", "F_x": 3.}, "the last row")
check([row["F_x"] for row in table.rows()] == [1., 2., 3.], "all rows")
