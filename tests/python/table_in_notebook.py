# SPDX-License-Identifier: LGPL-2.1-or-later

# Notebooks show the first and last rows of a table, and its text as text.

import numpy as np

from python_test import biface, check_equal

table = biface.Table({"force": np.arange(20.), "status": np.array(["<ok>"] * 20, object)})
text = table._repr_html_()
check_equal(text.count("<tr>"), 12, "the number of lines")
check_equal(text.count("<td>…</td>"), 2, "the number of cells left out")
check_equal(text.count("&lt;ok&gt;"), 10, "the number of texts")
check_equal(text.count("<td>19</td>"), 1, "the last row")
check_equal(table.where(table["force"] < 3)._repr_html_().count("<tr>"), 4,
            "the number of lines of a short table")
