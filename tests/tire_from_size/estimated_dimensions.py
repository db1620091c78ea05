# SPDX-License-Identifier: LGPL-2.1-or-later

# Sizes by a width code have rules that are estimates: within 2.5 % of the diameters and
# 6 % of the widths that tables list.

from tire_from_size_test import check_close

from biface_tire.size import parse_size

TABLE = {"4.00-8": (112, 415), "5.00-8": (137, 470), "6.00-9": (160, 540),
         "6.50-10": (177, 588), "7.50-16": (215, 805), "10.00-20": (278, 1055),
         "11R22.5": (279, 1054), "12R22.5": (300, 1084), "9R22.5": (229, 974),
         "14.9R28": (378, 1370), "18.4R38": (467, 1750), "185R14C": (188, 650)}

for text, (width, diameter) in TABLE.items():
    size = parse_size(text)
    check_close(size.width_on(size.measuring_rim), width, 0.06, f"the width of {text}")
    check_close(size.diameter, diameter, 0.025, f"the diameter of {text}")
