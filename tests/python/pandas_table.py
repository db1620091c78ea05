# SPDX-License-Identifier: LGPL-2.1-or-later

# The DataFrame of a table has its columns.

from python_test import check, require, run

require("pandas")
history = run().history
frame = history.to_pandas()
check(list(frame.columns) == list(history), "the columns differ")
check((frame["force"].to_numpy() == history["force"]).all(), "the forces differ")
check(frame.groupby("stage")["force"].max()["contact"] == history["force"][-1],
      "groupby() does not find the stage")
