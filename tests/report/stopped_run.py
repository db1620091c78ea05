# SPDX-License-Identifier: LGPL-2.1-or-later

# The report of a run that was stopped while writing ends with its last complete step and says so.

from report_test import check, check_equal, copy_of, page_of, read_csv, require

require("matplotlib")
directory = copy_of("bias_tire")
path = directory / "history.csv"
history = read_csv(path)
# files of the step that was not finished are there, some only in part
(directory / "contact-0005.csv").write_text("alpha_1,al")
path.write_text(path.read_text()[:-20])

page = page_of(directory)
check_equal(page.numbers("Force on the ground")[0],
            float(history[-2]["force"]), "the force")
check("last line of history.csv is cut off" in page.text, "the cut is not told")
check("ended before its last stage was done: travel 15 of 20" in page.text,
      "the rest is not told")
