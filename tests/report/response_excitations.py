# SPDX-License-Identifier: LGPL-2.1-or-later

# Of more than six excitations, loads among them, the first six are drawn, and a sentence
# counts the others.

from report_test import check, copy_of, page_of, require

require("matplotlib")
directory = copy_of("response")
path = directory / "response.csv"
text = path.read_text(encoding="utf-8")
lines = [line for line in text.splitlines() if ",ground x," in line]
for other in ("pressure", "load factor", "ground y", "ground z", "supports y",
              "supports z"):
    text += "".join(line.replace("ground x", other) + "\n" for line in lines)
path.write_text(text, encoding="utf-8")
page = page_of(directory)
drawn = [image["alt"].rpartition("excitation ")[2] for image in page.images
         if "phase of forces" in image["alt"]]
check(drawn == ["ground x.", "supports x.", "pressure.", "load factor.", "ground y.",
                "ground z."], f"{drawn}")
check("Not drawn, but in response.csv: 2 other excitations." in page.text,
      "the others are not counted")
