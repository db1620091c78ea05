# SPDX-License-Identifier: LGPL-2.1-or-later

# All notations of a size give the same tire, with its kind, construction, ratings and
# service description.

from tire_from_size_test import check

from biface_tire.size import parse_size

SAME = [("195/65R15 91V", "195/65 R15 91V", "195/65 R 15 91 V", "195/65 ZR15 (91V)",
         "195/65r15 91v TL", "195/65R15 91V M+S"),
        ("700x25C", "25-622", "700 x 25", "700×25c"),
        ("7.50-16 6PR", "7,50-16 6PR", "7.50 - 16 6 PR", "7.50-16 6-ply", "7.50-16 LRC",
         "7.50-16 LOAD RANGE C")]
for texts in SAME:
    sizes = [parse_size(text) for text in texts]
    for size in sizes[1:]:
        check((size.kind, size.is_radial, size.width, size.diameter, size.rim_diameter,
               size.ply_rating, size.load_index, size.speed_symbol)
              == (sizes[0].kind, sizes[0].is_radial, sizes[0].width, sizes[0].diameter,
                  sizes[0].rim_diameter, sizes[0].ply_rating, sizes[0].load_index,
                  sizes[0].speed_symbol), f"{size} is not {sizes[0]}")

# kind, whether radial, width and rim diameter in mm, ply rating, load index
KINDS = {
    "205/60 R15 91V": ("passenger", True, 205, 381, None, 91),
    "P205/75R15": ("passenger", True, 205, 381, None, None),
    "225/45ZR17 (94Y) XL": ("passenger", True, 225, 431.8, None, 94),
    "LT235/85R16 LRE": ("light truck", True, 235, 406.4, 10, None),
    "185R14C 102/100Q": ("light truck", True, 185, 355.6, None, 102),
    "31x10.50R15LT": ("light truck", True, 266.7, 381, None, None),
    "11R22.5": ("truck", True, 279.4, 571.5, None, None),
    "315/80 R22.5 156/150L": ("truck", True, 315, 571.5, None, 156),
    "380/85 R28 133A8": ("agricultural", True, 380, 711.2, None, 133),
    "14.9-28 8PR": ("agricultural", False, 378.46, 711.2, 8, None),
    "4.80/4.00-8 LRB": ("utility", False, 121.92, 203.2, 4, None),
    "18x8.50-8 4PR": ("utility", False, 215.9, 203.2, 4, None),
    "110/90-18 61H": ("motorcycle", False, 110, 457.2, None, 61),
    "26x4.00": ("bicycle", False, 101.6, 559, None, None),
    "650x35B": ("bicycle", False, 35, 584, None, None),
    "49x17 26PR": ("aircraft", False, 427.4, 508, 26, None),
    "H44.5x16.5-21 28PR": ("aircraft", False, 419.1, 533.4, 28, None)}
for text, expected in KINDS.items():
    size = parse_size(text)
    found = (size.kind, size.is_radial, round(size.width, 2), round(size.rim_diameter, 2),
             size.ply_rating, size.load_index)
    check(found == expected, f"{text} is {found}, not {expected}")

check(parse_size("195/65R15", "light truck").kind == "light truck", "the kind is not taken")
