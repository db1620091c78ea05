# SPDX-License-Identifier: LGPL-2.1-or-later

# The runs of a protocol have the tire, its tread and its inflation as in its file, and the
# states that the rows ask for; the shipped protocols have all that their tire models need.

from tire_from_size_test import SOURCE, check, check_close, output_of, scratch

from biface.parameters import parse_parameters, stages
from biface_tire.protocol import find, read_protocol, shipped
from biface_tire.runs import Tire, plan

directory = scratch()
output_of("new", "195/65", "R15", "91", "--output", directory)
tire = Tire(directory)
check(tire.base == 2, f"the ground comes after the stage {tire.base}")
check_close(tire.pressure, 2.5e5, 1e-9, "the pressure")
check_close(tire.load, 6031, 1e-3, "the load")
check_close(tire.velocity, 1e-3 * float(tire.get("Stage 8/Ground velocity")), 1e-9,
            "the velocity")

check(shipped() == ["cdtire", "ftire", "mf52", "mf61", "quick"], f"{shipped()}")
NAMES = {"cdtire": {"standing", "leaning", "vibrating", "transversal-bar-20", "steady-1"},
         "ftire": {"standing", "leaning", "vibrating", "transversal-bar-20",
                   "longitudinal-bar-20", "steady-1", "steady-2"},
         "mf52": {"standing", "vibrating", "steady-1", "steady-2", "steady-3"},
         "mf61": {"standing", "vibrating", "steady-1", "steady-2", "steady-3"},
         "quick": {"standing", "vibrating", "steady-1"}}
before = parse_parameters((directory / "tire.prm").read_text(encoding="utf-8"))
for name in shipped():
    rows = read_protocol(find(name))
    runs, left_out = plan(tire, rows)
    check({run.name for run in runs} == NAMES[name], f"{name}: {[run.name for run in runs]}")
    check(len(left_out) == sum(row.kind == "bar run over" for row in rows), f"{left_out}")
    for run in runs:
        found = parse_parameters(run.text)
        for entry in before.entries.values():
            if entry.name.startswith(("Contact/", "Material", "Laminate", "Mesh/")):
                check(found[entry.name] == entry.value, f"{run.name}: {entry.name}")
        check(found["Surface/Spline/File"] == str(directory.resolve() / "tire_profile.csv"),
              found["Surface/Spline/File"])
        check(len(stages(found)) == int(found["Number of stages"]), f"{run.name}")
        check([found[f"Stage {number}/Name"] for number in (1, 2)]
              == ["inflation", "vibration"], f"{run.name} is not inflated as in the file")

# what the Magic Formula needs: three loads, both signs of inclination and slip angle, both
# slips at once, for 6.1 three pressures
for name, pressures in (("mf52", 1), ("mf61", 3)):
    steady = [row for row in read_protocol(find(name)) if row.kind == "steady"]
    check(all(len(row.load) == 3 for row in steady), "loads")
    check(max(len(row.pressure) for row in steady) == pressures, "pressures")
    check(any(len(row.inclination_angle) == 3 for row in steady), "inclinations")
    check(any(any(row.slip_angle) and any(row.slip_ratio) for row in steady), "combined slip")

# parts of the own load and pressure become numbers of the units of the file
protocol = directory / "own.csv"
protocol.write_text("kind,pressure [bar],load [%],slip_angle [rad],velocity [m/s]\n"
                    "steady,2 3,50,-0.1 0 0.1,10\nlateral,2,100,,\n", encoding="utf-8")
standing, rolling = (parse_parameters(run.text)
                     for run in plan(tire, read_protocol(protocol))[0])
check(rolling["Tire test/Pressures"] == "0.2, 0.3", rolling["Tire test/Pressures"])
check_close(float(rolling["Tire test/Loads"]), tire.load / 2, 1e-9, "the load")
check_close(float(rolling["Tire test/Slip angles"].split(", ")[1]), 5.729577951, 1e-9, "angle")
check(float(rolling["Tire test/Ground velocity"]) == 10000, "the velocity")
check(standing["Stage 3/Pressure"] == "0.2" and standing["Stage 5/Glued"] == "true",
      "the stages of the standing tire")

# what is not computed is left out with a sentence
protocol.write_text("kind,load [N],inclination_angle [deg]\nlateral,3000,0 5\n",
                    encoding="utf-8")
runs, left_out = plan(tire, read_protocol(protocol))
check([run.name for run in runs] == ["standing"], f"{[run.name for run in runs]}")
check(len(left_out) == 1 and "line 2: the lateral stiffness of a leaning wheel, which is not "
      "computed." in left_out[0], f"{left_out}")

# a file with its own tire test: the stages before it are the inflation
check(Tire(SOURCE / "prm/tire_test.prm").base == 1, "the stages of prm/tire_test.prm")
