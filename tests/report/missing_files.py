# SPDX-License-Identifier: LGPL-2.1-or-later

# Sections whose files are missing are omitted, each with a sentence that says why.

from report_test import check, copy_of, page_of, require

require("matplotlib")
FILES = {"Footprint": "contact-0005.csv", "Deformed section": "profile-0005.csv",
         "Deformed shell": "shell-0005.vtu", "Input": "parameters.prm"}

directory = copy_of("bias_tire")
for file in FILES.values():
    (directory / file).unlink(missing_ok=True)
page = page_of(directory)
for heading, file in FILES.items():
    check(heading not in page.headings, f"the section '{heading}' is there")
    check(f"{heading}: {file} is missing." in page.text, f"{file} is not told of")
check("Load and deflection" in page.headings, "the curve is missing, too")
