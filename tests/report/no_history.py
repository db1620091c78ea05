# SPDX-License-Identifier: LGPL-2.1-or-later

# A directory without history.csv, or a missing one, is reported by one sentence.

from report_test import check, complaint, copy_of, require

require("matplotlib")
directory = copy_of("bias_tire")
(directory / "history.csv").unlink()
check("there is no history.csv in it" in complaint(directory), "the sentence")
check("is not a directory" in complaint(directory / "nowhere"), "the sentence")
