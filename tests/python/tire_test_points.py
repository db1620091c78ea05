# SPDX-License-Identifier: LGPL-2.1-or-later

# A tire test has a row for each combination of loads, inclination angles and slips, in
# which the wheel rolls as in stages written by hand, in the axes that are asked for and
# on any number of ranks.

from tire_test import COARSE, TIRE_TEST, biface, check, run, scratch

POINTS = {"Tire test/Loads": "1000, 1500", "Tire test/Inclination angles": "0, 3",
          "Tire test/Slip angles": "-2, 1, 2", "Tire test/Slip ratios": -0.03}
FORCES = ("F_x", "F_y", "F_z", "M_x", "M_y", "M_z")

table = run(POINTS).tire_test()
check(len(table) == 2 * 2 * 5, f"there are {len(table)} points")
check(list(table["point"]) == list(range(1, 21)), "the numbers of the points")
check(set(table["status"]) == {"ok"} and set(table["axes"]) == {"ISO"}, "the text")
slips = [(row["slip_angle"], row["slip_ratio"]) for row in table.rows()[:5]]
check(slips == [(0, 0), (0, -0.03), (1, 0), (2, 0), (-2, 0)], f"the slips are {slips}")
check(abs(table["F_z"] - table["load"]).max() < 1e-5 * 1500, "the vertical force")
check(abs(table.where(slip_ratio=0)["axle_moment"]).max() < 1e-5 * 250 * 1500,
      "the moment of the axle")

# written by hand, on another path: first the inclination
stages = {"Tire test/Loads": "", "Number of stages": 5}
for number, settings in enumerate([
        {"Control": "foundation force", "Friction": 0},
        {"Control": "foundation force and axle moment", "Ground velocity": 10000},
        {"Control": "foundation force and axle moment", "Slip angle": 2},
        {"Control": "foundation force", "Slip ratio": -0.03, "Start from": 3}], 2):
    for entry, value in {"Contact": True, "Force": 1500, "Inclination angle": 3,
                         **settings}.items():
        stages[f"Stage {number}/{entry}"] = value
by_hand = biface.run(TIRE_TEST, {**COARSE, **stages}, scratch()).rolling()
SCALES = {**{name: 1500 if name[0] == "F" else 1500 * 250 for name in FORCES},
          "axle_moment": 1500 * 250, "angular_velocity": 40, "rolling_radius": 250}
for row, wanted in ((0, {"slip_angle": 0, "slip_ratio": 0}), (1, {"slip_angle": 2}),
                    (2, {"slip_ratio": -0.03})):
    point = table.where(load=1500, inclination_angle=3, **wanted).row(0)
    for name, scale in SCALES.items():
        check(abs(point[name] - by_hand[name][row]) < 2e-6 * scale,
              f"{name} of {wanted} is {point[name]}, by hand {by_hand[name][row]}")

# other axes, and two ranks
inclined = {"Tire test/Loads": 1500, "Tire test/Inclination angles": 3}
heavy = table.where(load=1500, inclination_angle=3)
for axes, signs, ranks in (("SAE", (1, -1, -1, 1, -1, -1, -1, 1), 2),
                           ("adapted ISO", (1, 1, 1, 1, 1, 1, -1, -1), 1)):
    other = run({**POINTS, **inclined, "Tire test/Axes": axes}, ranks=ranks).tire_test()
    check(set(other["axes"]) == {axes}, f"the axes are {set(other['axes'])}")
    for name, sign in zip((*FORCES, "slip_angle", "inclination_angle"), signs):
        scale = max(abs(heavy[name]).max(), 1)
        check(abs(other[name] - sign * heavy[name]).max() < 1e-7 * scale,
              f"{name} in the axes {axes}")
right = table.where(load=1500, inclination_angle=0, slip_angle=2).row(0)
left = table.where(load=1500, inclination_angle=0, slip_angle=-2).row(0)
check(right["F_y"] < left["F_y"] - 100, "a wheel that moves to the left is pushed to "
      "the right")
check(table.where(slip_ratio=-0.03)["F_x"].max() < -100, "a braked wheel is pushed back")
