# SPDX-License-Identifier: LGPL-2.1-or-later

# The page has no external references, is well-formed, and every picture has a description.

from report_test import RUNS, check, page_of, require

require("matplotlib")
for run in ("bias_tire", "composite_panel", "shell"):
    page = page_of(RUNS / run)
    for address in page.addresses:
        check(address.startswith(("data:image/", "#")), f"{address[:80]}")
    for word in ("@import", "url(", "<link", "<iframe"):
        check(word not in page.source, f"the page has {word}")
    check(len(page.images) >= 3, f"{run} has {len(page.images)} pictures")
    for image in page.images:
        check(len(image.get("alt", "")) > 10, "a picture has no words")
    targets = [address[1:] for address in page.addresses if address[0] == "#"]
    for target in targets:
        check(page.source.count(f'id="{target}"') == 1, f"#{target} is not there")
