# SPDX-License-Identifier: LGPL-2.1-or-later

# Wrong input gives one sentence that names it and says what is possible, and the exit
# code 1.

from tire_from_size_test import check_refused, scratch

SIZES = [
    ("", "the size is empty"),
    ("tire", "the size 'tire' is not understood: it must be one such as 195/65 R15 91V"),
    ("195/65", "the size '195/65' is not understood"),
    ("195/650R15", "has the aspect ratio 650, but must have one between 20 and 105"),
    ("195/15R15", "has the aspect ratio 15, but must have one between 20 and 105"),
    ("19/65R15", "has the width 19 mm, but must have one between 50 and 1100 mm"),
    ("50.00-8", "has the width 50 inches, but must have one between 1 and 45 inches"),
    ("195/65R15 91V blue", "'BLUE' in the size '195/65R15 91V blue' is not understood"),
    ("195/65R15 91X", "the speed symbol X in '195/65R15 91X' is not known"),
    ("195/65R15 280V", "the load index is 280, but must lie between 0 and 279"),
    ("4.00-8 90PR", "the ply rating in '4.00-8 90PR' is 90, but must lie between 2 and 60"),
    ("650x25", "needs one of the letters A, B, C that name its rim, as in 650x25C"),
    ("25-800", "has the rim diameter 800 mm, but that of a bicycle tire must lie between"),
    ("700x10C", "is 10 mm wide, but a bicycle tire must be 16 to 150 mm wide"),
    ("23x4.00", "does not say its rim: add it, as in 23x4.00-15"),
    ("31x10.50R35", "has a rim of 35 inches in a tire of 31 inches"),
    ("50x20 30PR", "does not say the diameter of its rim"),
    ("49x17", "has no pressure: give --pressure, or the ply rating 26PR or 30PR"),
    ("120/70R17 M/C", "is a radial tire of a motorcycle"),
]
OPTIONS = [
    (["4.00-8", "--rim", "8"], "4.00-8 does not fit a rim 8 inches (203.2 mm) wide, which "
     "is 1.27 of the section width, not 0.45 to 0.97: it must be"),
    (["4.00-8", "--rim", "1"], "it must be 1.75 to 4.88 inches (44 to 124 mm) wide"),
    (["195/65R15", "--rim", "9J"], "must be 3.8 to 8.74 inches (97 to 222 mm) wide"),
    (["700x25C", "--rim", "30C"], "it must be 11 to 29 mm wide"),
    (["195/65R15", "--rim", "6Jx16"], "has the diameter 406.4 mm, but 195/65R15 needs one "
     "of 381 mm (15 inches)"),
    (["195/65R15", "--rim", "six"], "the rim 'six' is not understood: a rim is a width in "
     "inches"),
    (["195/65R15", "--rim", "6Q"], "has the contour Q, but must have one of A, B, C"),
    (["700x25C", "--rim", "6.5J"], "that of a bicycle is its inner width in mm"),
    (["195/65R15", "--pressure", "2.5"], "the pressure is 2.5 MPa (25 bar), but must be at "
     "most 1 MPa (10 bar) in a tire by the rules for passenger: give the unit"),
    (["195/65R15", "--pressure", "much"], "--pressure is 'much', but must be a number"),
    (["195/65R15", "--pressure=-1bar"], "--pressure is '-1bar', but must be positive"),
    (["195/65R15", "--pressure", "100bar"], "the pressure is 10 MPa, but must lie between"),
    (["195/65R15", "--load", "60kN"], "the load is 6e+04 N, but must lie between 0 and"),
    (["195/65R15", "--load", "5stone"], "with one of the units n, kn, kg, lb, lbf or in N"),
    (["4.00-8", "--plies", "0"], "--plies is 0, but must lie between 1 and 60"),
    (["4.00-8", "--plies", "60"], "or the plies be fewer"),
    (["195/65R15", "--diameter", "400"], "but must have more than 426 mm"),
    (["195/65R15", "--diameter", "5"], "--diameter is 5, but must lie between 100 and 4500"),
    (["195/65R15", "--cells", "9"], "--cells is 9, but must lie between 0.25 and 4"),
    (["195/65R15", "--speed", "nan"], "--speed is nan, but must lie between 0.1 and 500"),
    (["195/65R15", "--tread", "layer", "--tire-test"], "--tire-test needs --tread bristles"),
    (["195/65R15", "--contour", "c.csv", "--width", "200"], "leave out --diameter and"),
    (["195/65R15", "--contour", "no_such.csv"], "no_such.csv cannot be read"),
]
CONTOURS = [("", "has 0 points, but must have at least 9"),
            ("radius, axial coordinate\n1, x\n", "line 2: this is '1, x', but must be"),
            ("-5, 3\n", "must have a radius above 0"), ("5, 3\n5, 3\n", "is the same as the"),
            ("".join(f"{200 + i}, {i + 1}\n" for i in range(9)), "must go from one side"),
            ("".join(f"{200 + i}, {i - 4}\n" for i in range(9)), "must go over the crown")]

for size, sentence in SIZES:
    check_refused(["new", size, "--check"], sentence)
for words, sentence in OPTIONS:
    check_refused(["new", *words, "--check"], sentence)
check_refused(["new", "195/65R15"], "--output is missing")
directory = scratch()
for content, sentence in CONTOURS:
    path = directory / "contour.csv"
    path.write_text(content, encoding="utf-8")
    check_refused(["new", "195/65R15", "--contour", path, "--check"], sentence)
check_refused(["judge", directory], "judge needs the directory that biface-tire new has")
(directory / "tire.prm").write_text("set Units = mm, N, s\n", encoding="utf-8")
check_refused(["judge", directory], "has no line 'Made by: biface-tire new ...'")
