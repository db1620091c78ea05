# SPDX-License-Identifier: LGPL-2.1-or-later

# Diameters and widths of metric sizes on their measuring rims are those of the standards:
# D = d + 2 S_N a/100, S = S_N + 0.4 (A - K S_N) with K = 0.7, and 0.85 below 50 %
# (UN R30), as catalogs print them.

from tire_from_size_test import check

from biface_tire.size import parse_size

# measuring rim in inches, section width and overall diameter in mm, rounded as printed
TABLE = {
    "155/80 R13": (4.5, 157, 578), "175/65 R14": (5, 177, 584), "185/60 R14": (5.5, 189, 578),
    "185/70 R14": (5.5, 189, 615), "195/65 R15": (6, 201, 635), "205/55 R16": (6.5, 214, 632),
    "205/60 R15": (6, 209, 627), "225/45 R17": (7.5, 225, 634), "225/50 R17": (7, 233, 657),
    "235/40 R18": (8.5, 241, 645), "255/35 R19": (9, 260, 661), "315/80 R22.5": (9, 312, 1076),
    "295/80 R22.5": (9, 298, 1044), "385/65 R22.5": (11.75, 389, 1072),
    "LT235/85R16": (6.5, 235, 806), "LT265/75R16": (7.5, 267, 804),
    "380/85 R28": (12, 380, 1357)}

for text, (rim, width, diameter) in TABLE.items():
    size = parse_size(text)
    check(abs(size.measuring_rim / 25.4 - rim) < 1e-9,
          f"the rim of {text} is {size.measuring_rim / 25.4} inches")
    check(abs(size.width_on(size.measuring_rim) - width) <= 0.6,
          f"the width of {text} is {size.width_on(size.measuring_rim)}")
    check(abs(size.diameter - diameter) <= 1, f"the diameter of {text} is {size.diameter}")

# the notation itself: 15 inches and twice 0.65 of 195 mm
size = parse_size("195/65 R15 91")
check(abs(size.diameter - 634.5) < 1e-9 and size.width == 195, f"{size}")
