#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write tire_model.md and its picture."""

import os
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import EXAMPLES, Runs, parse_arguments

ROOT = EXAMPLES.parent
PACKAGE = ROOT / "source/python"
DATA = ROOT / "tests/data"

PAGE = """<!-- Written by doc/tire_model/tire_model.py: cmake --build build --target tire_model -->

# Tire models

`biface-tire-model` brings forces and moments of a rolling tire into the form that vehicle
dynamics programs read: the coefficients of the Magic Formula in a .tir file, or TYDEX
files; with stiffnesses and frequencies of the standing tire. It also evaluates and checks .tir files of others. It needs SciPy, which
`doc/install.sh report` installs, and matplotlib for pictures.

| Command | Meaning |
| --- | --- |
| `evaluate FILE.tir` | a table of forces and moments at any slip, load, inclination, pressure |
| `fit TABLE.csv` | a .tir file from such a table, of MF 5.2 or MF 6.1 |
| `stiffness DIRECTORY` | tables of stiffnesses, footprints and frequencies from results of `biface` |
| `tydex TABLE.csv` | a TYDEX file for each sweep of the table |
| `check FILE.tir` | what is missing or unusual in a .tir file |

## Forces of a file

The tire of Project Chrono's HMMWV, [Chrono 2016](references.bib#Chrono2016), is one of the test data:

{evaluate}

`--alpha`, `--kappa`, `--gamma`, `--fz`, `--pressure` and `--velocity` are numbers separated by commas, or
first, last and step; the table has all their combinations. `-o` writes it to a file,
`--picture` draws its curves. Values outside the ranges of the file are computed all the
same, with a warning. `--mirror` gives the tire on the other side of the vehicle than that of
`TYRESIDE`; a `USE_MODE` below 0 in the file does the same, and both together give the tire as
measured. Without `UNLOADED_RADIUS` there are no moments, unless `--radius` gives it.

Units are `--units "m, N, s"` and `--angles deg` by default: length, force and time as in
the entry `Units` of a parameter file. Pressures are in force over length squared, moments
in force times length: Pa and N m here, MPa and N mm for `--units "mm, N, s"`.

## Axes, signs and slips

By default all is in the W axes of [ISO 8855](references.bib#ISO8855), with x forward, y to the left, z
up, as in [rolling.md](rolling.md#axes); forces and moments are those of the road on the tire. `--axes`
chooses others, for input and output:

| | `iso` | `sae` | `adapted-iso` | `adapted-sae` |
| --- | --- | --- | --- | --- |
| y, z | left, up | right, down | left, up | right, down |
| slip angle is positive if the wheel moves | to the left | to the right | to the right | to the left |
| inclination angle is positive if the top leans | to the right | to the right | to the left | to the right |
| $`F_z`$ of a load | positive | negative | positive | positive; negative is read, too |
| slope of $`F_y`$ over the slip angle | negative | negative | positive | positive |

`sae` are the axes of [SAE J670e](references.bib#SAEJ670e), the ISO axes turned about x by 180 degrees;
`adapted-iso` are those of [Besselink 2000](references.bib#Besselink2000), where all slip stiffnesses are
positive, and `adapted-sae` those of appendix 1 of [Pacejka 2012](references.bib#Pacejka2012). .tir files always have ISO
signs; TYDEX files are written with them, and read with those of `--axes`.

Data whose $`F_y`$ has the other slope than their axes, or $`F_x`$ over the longitudinal slip, are refused; so are
tables with a title or a comment that names axes, such as "SAE J670 coordinates", until `--axes` says which. `fit` warns
of the signs that few tires have: of $`F_y`$ of a tire that leans, of $`M_z`$ at small slip angles, of $`M_y`$.

The longitudinal slip is $`\\kappa = -V_{{sx}}/|V_x|`$, with the slip velocity $`V_{{sx}}`$ of
the wheel at its effective rolling radius: 0 for free rolling, −1 for a locked wheel, a ratio
and not percent. The slip angle is that of the velocity of the contact center to the plane of the
wheel. Moments refer to the contact center. A tire that rolls forward has $`M_y < 0`$.

## The equations

They are (4.E1) to (4.E78) of [Pacejka 2012](references.bib#Pacejka2012), section 4.3.2, without turn
slip: $`F_x`$, $`F_y`$ and $`M_z`$ at pure and combined slip, $`M_x`$, $`M_y`$, with inclination,
pressure and all scaling factors $`\\lambda`$. MF 5.2, Adams's PAC2002, is the older set of
[Pacejka 2006](references.bib#Pacejka2006). The file decides: `FITTYP` 5, 6, 21 and 52 are MF 5.2; 60, 61
and 62 are MF 6.1, since the forces and moments of MF 6.2 are the same; without it
`PROPERTY_FILE_FORMAT = 'PAC2002'` is MF 5.2.

Pure slip is a curve

```math
F = D \\sin\\left(C \\arctan\\left(B x - E\\,(B x - \\arctan B x)\\right)\\right) + S_V,
\\qquad x = \\kappa + S_H \\text{{ or }} \\alpha + S_H,
```

with the largest force D, the stiffness B C D at $`x = 0`$, and factors that depend on the load
by $`df_z = (F_z - \\lambda F_{{z0}})/(\\lambda F_{{z0}})`$ and on the pressure by
$`dp_i = (p - p_0)/p_0`$. Combined slip multiplies it by a factor
$`G = \\cos(C \\arctan(\\ldots))`$ of the other slip.

### Doubtful readings

Where book, files and programs differ, the program follows mfeval ([Furlan 2021](references.bib#Furlan2021)), whose
author compared it with TNO's solver:

| Subject | Here | Others |
| --- | --- | --- |
| $`\\alpha^*`$, $`\\gamma^*`$ | the angles themselves, as in TNO's and Adams's programs | tan α and sin γ of (4.E3), (4.E4): `--starred` |
| Curvature E | at most 1, in all curves | some do not limit it |
| Factor $`\\lambda'_\\mu`$ of $`S_{{Vx}}`$, $`S_{{Vy}}`$ | $`\\lambda_\\mu`$, that is, $`A_\\mu = 1`$ in (4.E8) | $`A_\\mu = 10`$ of the book |
| $`B_t`$, (4.E40) | 1 + QBZ4 γ + QBZ5 \\|γ\\| + QBZ6 γ² | the book has no QBZ4, files no QBZ6 |
| $`D_t`$, (4.E43) | 1 + QDZ3 γ + QDZ4 γ² | \\|γ\\| with QDZ3 in the book |
| $`D_t`$, $`s`$ and `LFZO` | divided by FNOMIN | by LFZO × FNOMIN in the book and in Chrono |
| $`\\alpha_{{eq}}`$, (4.E77), (4.E78) | the arctangent of MF 5.2 | the root without it in the book |
| Residual moment | one factor cos α | mfeval has two at pure slip |
| $`F'_y`$ in $`M_z`$, MF 6.1 | $`G_{{y\\kappa}}`$ with camber times $`F_{{y0}}`$ without | |
| $`M_x`$, (4.E69) | the square of QSX6 $`F_z/F_{{z0}}`$ is inside the arctangent, over FNOMIN | outside in one program; Chrono leaves QSX6 out |
| $`M_y`$, (4.E70) | negative for forward rolling; MF 6.1: FNOMIN $`(F_z/F_{{z0}})^{{QSY7}}`$, MF 5.2: $`F_z (F_z/F_{{z0}})^{{QSY7}}`$ | the book has $`F_z`$ for both, with which the usual QSY7 = 0.85 makes no sense |
| Camber in the friction | 1 − PDY3 γ² | + in one version of Chrono |
| Cornering stiffness | scaled by LKY | by LMUY in Chrono |

Coefficients that a file lacks have no effect: the scales are 1, PKY4 is 2, QSY7 is that
with which $`M_y`$ is proportional to the load.

## Fits

The table has a row for each steady state, in any order, and these columns, of which `F_z`,
one of the slips and one force or moment are needed. Others are left out.

{columns}

A name may have its unit behind it, as in `F_z [kN]`, or in a line of units below; otherwise
`--units` and `--angles` say it. `SA`, `SL`, `IA`, `P`, `V`, `RL`, `FX`, ..., `MZ` are the same columns
(`SL` is `slip_ratio`, `RL` is `loaded_radius`), and so are `alpha`, `kappa`, `gamma` and the words
of the list, such as "vertical force"; pressures and velocities with such names need their units. `camber` and `SR` are refused, since their sign or their radius is open. Columns are separated by
commas, semicolons, tabs or blanks, and numbers may have decimal commas where these do not separate; where all of these
may as well separate thousands, as in 4,000, they are refused.
Slips that are not there are 0; forces and moments may be empty. Lines that start with # or %
are comments, and lines of title may come first. Rows whose column `status` is not `ok` are left out, and a column `axes` replaces
`--axes`. Radii, pressures, loads and angles of a size that only another unit explains are refused, and `fit` names columns that
it does not use. The output of `evaluate` is such a table, whose first line tells its units and axes; a directory of TYDEX files may replace it, or
one of the results of a [tire test](tire_test.md), whose units are then those of the results. Here three loads, three inclination angles and combined slip:

{make}

{fit}

![F_y and M_z over the slip angle, F_x over the longitudinal slip at three loads, and F_y over F_x: the points are on the curves](figures/tire_model.png)

*Points: the table; curves: the fitted formula, without camber.*

Each curve is fitted by least squares in its turn: $`F_y`$, $`F_x`$ and $`M_z`$ at pure slip,
where the other slip is at most {pure_slip:g} and {pure_angle:g}°, what combined slip adds to them, $`M_x`$
and $`M_y`$. The residuals are in parts of the peak of a channel. Several starts, first at the states
nearest to the nominal one, avoid wrong minima; they are the same every time. Every coefficient has bounds.

A coefficient that the data do not determine keeps its neutral value, and the comment behind it in the file
says why: there is one load, one pressure, no inclination angle, no combined slip; or its
standard error is more than {error:g} % of the width of its bounds.

Without combined slip in the data, a file would give full $`F_x`$ and full $`F_y`$ at once, which no tire has.
Then the reductions are typical ones, with a warning and a comment in the file: `RBX1`, `RBX2`, `RCX1`, `REX1`, `RBY1`,
`RBY2`, `RCY1`, `REY1` of a 205/60 R15, [TNO 2013](references.bib#TNO2013). `--without-combined neutral` leaves them
out; a file of MF 5.2 then has `FE_METHOD = 'YES'`, with which Adams and Chrono reduce the forces by a
friction ellipse; `evaluate` does not. `--without-combined refuse` writes no file.

The ranges of the data are in the file (`KPUMIN`, ..., `FZMAX`). Outside them the formula
is a guess.

| Option | Meaning |
| --- | --- |
| `--format 5.2` or `6.1` | 5.2 also for Adams's PAC2002 and Chrono |
| `--radius R` | of the unloaded tire, the arm of all moments; by default that at which a line through the loaded radii has no load |
| `--nominal-load F`, `--nominal-pressure P` | FNOMIN and NOMPRES; by default the load nearest to the mean of all and the most frequent pressure |
| `--velocity V` | LONGVL |
| `--side RIGHT` | where the tire was mounted; LEFT by default |
| `--without-combined` | `typical`, `neutral` or `refuse`, see above |
| `--structure DIRECTORY` | results of `biface` with stiffnesses or modes, see Structure below; may be repeated |
| `--picture FILE` | a picture |

Forces of a finite element model have no noise, but errors of the mesh; nodes that enter contact
make them jump. Then the residuals say how far to trust the file. `VERTICAL_STIFFNESS` is that of a line through
the column `loaded_radius`, if there is one, of upright wheels that roll straight ahead. Vehicle programs need more
entries than the fit knows, such as masses and damping: add them by hand.

## Structure

[`biface-tire model`](tire_from_size.md#a-tire-model) computes all of this section for the tire of a parameter file.
`--structure` adds what the standing tire tells: its stiffnesses against motions of the ground, from
[stiffness.csv](output.md#stiffnesscsv), and its natural frequencies, from [modes.csv](output.md#modescsv).
Here for the tire of [tire_test.md](tire_test.md), upright and with pure slip:

{runs}

{structure}

The units are those that the results name, or else `--units`. A `Contact/Tread` is part of the stiffness: with another one than that of the
tire test, stiffnesses are left out.

| Entry of MF 6.1, `[STRUCTURAL]` | What it is |
| --- | --- |
| `LONGITUDINAL_STIFFNESS`, `LATERAL_STIFFNESS` | of the footprint against slides, N/m |
| `PCFX1`, `PCFX2`, `PCFX3`, `PCFY1`, `PCFY2`, `PCFY3` | their dependence on load and pressure |
| `YAW_STIFFNESS` | of the footprint against turns, N m/rad |
| `FREQ_LONG`, `FREQ_LAT`, `FREQ_YAW`, `FREQ_WINDUP` | frequencies of the inflated tire in the air on a fixed rim, Hz |

Each stage in which the ground slides or turns from a loaded state, without rolling, gives the secant
of its first step. Stages with `Glued = true` count if there are any, otherwise those with friction, whose footprint slips at its edge; the
comment in the file says which. Least squares of the relative deviations give

```math
C = C_0\\,(1 + p_1\\,df_z + p_2\\,df_z^2)(1 + p_3\\,dp_i),
```

(17) and (18) of [Besselink 2010](references.bib#Besselink2010), as in mfeval; comments of files call $`p_1`$ and $`p_2`$ a dependence on the
vertical deflection. $`p_1`$ needs two loads, $`p_2`$ three, $`p_3`$ two pressures. The nominal load
and pressure may lie outside those of the states by {near:g} % of them. `VERTICAL_STIFFNESS` comes from the approaching
ground, as the tangent at the nominal load, only if the table has no loaded radii.

A frequency is written if one mode, or one pair of modes with a wave around the axis, moves more than half of the tire as a
rigid ring: of the mass along y (`FREQ_LAT`), along x and z (`FREQ_LONG`), of the moment of inertia about the axle (`FREQ_WINDUP`), about x
and z (`FREQ_YAW`). No two modes can, since the parts of all modes together are at most the whole. Moments of inertia need the
files `modes-NNNN-MMM.vtu` of the shapes, in which the mass is taken as even; without them `FREQ_WINDUP` is left out, and `FREQ_YAW` is
that of the only pair with one wave, one half wave along the meridian and no translation. Waves do not suffice for `FREQ_WINDUP`: the first mode of this bias tire without waves
and translation, at {radial} Hz, is a radial one. A bias tire moves as no ring fore and aft; a tire with belts does, such as that of
[belted_tire.prm](../prm/belted_tire.prm) with densities, on an even mesh, at 0.2 MPa:

{ring}

The tread of bristles has no mass.

### Relaxation lengths

When a slip changes, the force of the rolling tire follows it over the distance

```math
\\sigma_\\alpha = \\frac{{1}}{{C_y}}\\left|\\frac{{dF_y}}{{d\\alpha}}\\right|, \\qquad
\\sigma_\\kappa = \\frac{{1}}{{C_x}}\\,\\frac{{dF_x}}{{d\\kappa}},
```

to first order, with the slopes of the fit at zero slip and the stiffnesses of the standing tire, section 7.2 of
[Pacejka 2012](references.bib#Pacejka2012). That the ground is glued to a standing tire is an assumption: in a tire that rolls, other particles
carry the load. For bristles on a rigid wheel $`\\sigma_\\kappa`$ is half the length of the footprint, which is {half} mm at 1500 N. `fit` prints
them for each load and pressure at which both are known, and for the nominal ones.

How well this holds, `python3 doc/tire_model/relaxation.py --program build/biface --scratch runs --output .` prints for the bias tire of [bias_tire.md](bias_tire.md) under true pressure and
1500 N, without a tread: it rolls slowly over ground to which it sticks, straight and with a slip angle of 0.5°, and
the difference of the side forces is the response. The ratio is 341 mm (42,956 N/rad over 126.0 N/mm). From the force after the first
7 mm the length is 352 mm, but 63 % of the steady force are reached after 305 mm: the force is no exponential
function of the way, and the ratio is 12 % longer than the way to 63 %.

Programs compute them in this way from the stiffnesses of MF 6.1. Files of MF 5.2 have them instead, here {old}:

```math
\\sigma_\\kappa = F_z\\,(p_{{Tx1}} + p_{{Tx2}}\\,df_z)\\,\\frac{{R_0}}{{F_{{z0}}}}, \\qquad
\\sigma_\\alpha = p_{{Ty1}} \\sin\\left(2\\arctan\\frac{{F_z}}{{p_{{Ty2}} F_{{z0}}}}\\right) R_0 .
```

The factor $`\\exp(\\mp p_{{Tx3}}\\,df_z)`$ has the lower sign in Chrono's PAC2002 and the upper one in mfeval: `PTX3` is 0. With one load `PTY2` is `PKY2`, as for
a stiffness that does not depend on the load. The public files of Adams's PAC2002 that were seen have no stiffnesses but the
vertical one: none are written, only printed. Adams uses the relaxation lengths with `USE_MODE = 14`; the file has 4, since Chrono knows no 14.

### Tables for other tire models

`stiffness` prints tables of the same results as CSV, or with `-o` writes a file for each:

| Table | Contents |
| --- | --- |
| `radial_stiffness` | load, deflection, loaded radius, secant from the first touch, tangent of each step |
| `footprint` | length, width and area over load |
| `lateral_stiffness`, `longitudinal_stiffness`, `torsional_stiffness` | secant of the first step, secant and tangent at the end, load, pressure, glued or with friction |
| `frequencies` | modes of the standing tire off the ground, their pressure, waves and parts of the mass, and the names of those above |

{stiffness}

The units are those of the results, or with `--si` meters, newtons and radians. Such numbers identify the
parameters of tire models that are no formula, such as FTire. Their own files are not written.
[`biface-tire model --protocol ftire`](tire_from_size.md#a-tire-model) computes them all.

## TYDEX files

`tydex` writes release 1.3 of the format, [Unrau and Zamow 1997](references.bib#UnrauZamow1997), a file for each sweep with
constant load, inclination, pressure and velocity: `cornering_01.tdx`, ... with a slip angle
only, `braking_01.tdx`, ... with a longitudinal slip only, `combined_01.tdx`, ... with a constant slip angle. A state
without slip stands in both of the former. Numbers have the room of ten characters, so that
five to eight digits remain. Read are also files with other channels, which are left out, and with
factors and offsets: a value is (number + first offset) × factor + second offset. `NOTAVAIL` is no value:
a force or moment is missing, and a state without its slip, load, pressure or velocity is left out.

## Checks

{check}

Angles among the entries, such as `ALPMIN`, and all other values become SI units by the
section `[UNITS]`; the coefficients of the formula belong to radians whatever it says. Values
that no formula uses may be empty or words. A section may come in parts, and an entry twice if its values are the same.
Comments begin with $ or !; a line of comments also with #, %, ; or //, and #, ; or // behind a blank end a value. Sizes that
contradict `[UNITS]` and a cornering stiffness that contradicts the ISO axes are named, by `evaluate` as well. The exit code is
1 if anything is unusual, here since PKX2 is negative: files often have such ends of ranges.

## In Python

```python
from biface_tire_model import (Structural, fit, make_tir, read_structure, read_table,
                               read_tir)

formula = read_tir("tire.tir").formula()
forces = formula.evaluate(4000, kappa=0, alpha=[0, 0.02, 0.05])  # newtons, radians
forces.F_y, forces.M_z                                          # NumPy arrays
formula.lateral(4000).slope                                     # cornering stiffness

result = fit(read_table("test.csv"), "6.1", radius=0.32)
structure = Structural(read_structure(["output"]), result, vertical=None)
make_tir(result, structural=structure).write("fitted.tir")
```

## Verification

| | Largest difference, parts of the peak |
| --- | ---: |
{verified}

The first row is OpenTire's PAC2002, [OpenTire 2015](references.bib#OpenTire2015), run as it is; the second are the
equations of MFeval.jl, a port of mfeval, translated line by line, which add an epsilon of
1e-6 to denominators. The others are fits to forces of known coefficients; those of MF 6.1
are made for tests, so that all of them matter, and no real tire's. `tests/tire_model`
contains these and the exact limits: slopes, peaks, mirror symmetry, pure slip as a case of
combined slip, derivatives by load and pressure.

## What is left out

- turn slip, parking, rolling backward, standstill: the formulas hold for a forward velocity
- rolling radii, masses, damping (`DAMP_LONG`, ...), the dependence of `YAW_STIFFNESS` on load and pressure (`PCMZ1`): entries for them are kept but not
  fitted; stiffnesses, frequencies and relaxation lengths are not used
- the decay of friction with the slip speed, $`\\lambda_{{\\mu V}}`$: `check` names `LMUV`
- MF-Swift, Adams's PAC89, PAC94, PAC-TIME and PAC-MC, Fiala's model: such files are refused
- PAC2002's friction ellipse (`FE_METHOD`) in place of the coefficients of combined slip
"""

STATES = (("--alpha", "-10:10:1", "--gamma", "-3,0,3"),
          ("--alpha", "-6,-2,0,2,6", "--kappa", "-.3:.3:.03"))


def tire_model(*words, directory=ROOT, succeed=True):
    """The output of biface-tire-model."""
    return subprocess.run(
        [sys.executable, "-B", "-m", "biface_tire_model", *words], cwd=directory,
        env=dict(os.environ, PYTHONPATH=str(PACKAGE)), capture_output=True, text=True,
        check=succeed).stdout


def block(words, output):
    """A command and its output, as a block of the page."""
    words = [f'"{word}"' if " " in word else word for word in words]
    return (f"    $ biface-tire-model {' '.join(words)}\n"
            + "".join(f"    {line}".rstrip() + "\n"
                      for line in output.splitlines())).rstrip()


def shown(*words, **options):
    """A command that is run, with its output."""
    return block(words, tire_model(*words, **options))


# Runs for the structure: a name, an example, and the entries that change
RUNS = (("rolling", "tire_test.prm", {"Tire test/Slip": "pure",
                                      "Tire test/Inclination angles": 0}),
        ("standing", "tire_stiffness.prm",
         {"Contact/Tread/Height": 8, "Contact/Tread/Modulus": 1.8,
          "Contact/Regularization": "automatic",
          "Contact/Tangential regularization": "automatic"}),
        ("modes", "tire_modes.prm", {"Number of stages": 2, "Stage 1/Modes": 0}))
BELTED = {"Material rubber/Density": 1.1e-9, "Material carcass/Density": 1.2e-9,
          "Material belt/Density": 1.6e-9, "Number of stages": 1, "Stage 1/Modes": 25,
          "Mesh/Intervals alpha_2": "-180:180:40", "Output/Write ply VTU": False}


def run_commands():
    """The runs as commands."""
    return "\n".join(
        f"    $ biface prm/{example} --output {name}"
        + "".join(f' \\\n        --set "{entry}={value}"'
                  for entry, value in changes.items())
        for name, example, changes in RUNS)


def structure(arguments, scratch):
    """The parts of the page on the structure."""
    import numpy as np
    from biface_tire_model.mode_names import MEANINGS, name_modes
    from biface_tire_model.stiffness_fit import NEAR
    from biface_tire_model.structure import read_structure
    runs = Runs(arguments)
    found = {name: runs.run(name, example, {**changes, "Output/Write VTU": name == "modes"})
             for name, example, changes in RUNS}
    words = ("fit", "rolling", "--format", "6.1", "--output", "tire.tir", "--structure",
             "standing", "--structure", "modes")
    lines = tire_model(*words, directory=scratch).splitlines()
    begin = next(i for i, line in enumerate(lines) if line.startswith("Vertical"))
    old = tire_model(*("5.2" if word == "6.1" else word for word in words),
                     directory=scratch)
    tables = tire_model("stiffness", "standing", directory=scratch).splitlines()
    modes = found["modes"].modes()
    radial = modes.where((modes["circumferential_waves"] == 0)
                         & (modes["effective_mass_y"] < 0.01 * modes["total_mass"]))
    runs.run("belted", "belted_tire.prm", {**BELTED, "Output/Write VTU": True})
    belted = read_structure([scratch / "belted"]).modes[0]
    named = name_modes(belted)[0]
    rows = [f"| `{name}` | {meaning} | {named[name].frequency:.1f} | "
            f"{100 * named[name].share:.0f} % |" for name, meaning in MEANINGS.items()]
    history = found["rolling"].tire_test()
    middle = history.where(load=1500, slip_angle=0, slip_ratio=0)
    return {
        "runs": run_commands(), "near": 100 * NEAR,
        "structure": block(words, "...\n" + "\n".join(lines[begin:])),
        "radial": f"{radial['frequency'][0]:.0f}",
        "ring": "\n".join(["| Entry | Motion | Hz | Part that moves as one |",
                           "| --- | --- | ---: | ---: |", *rows]),
        "half": f"{np.mean(middle['footprint_length']) / 2:.0f}",
        "old": ", ".join(
            "`{}` = {}".format(*pair.split()) for line in old.splitlines()
            if line.startswith("PTX1") for pair in line.split("  ")),
        "stiffness": block(("stiffness", "standing"), "\n".join(tables[:5] + ["..."]))}


def columns_table():
    from biface_tire_model.channels import CHANNELS
    names = {"slip": "-", "angle": "degrees", "force": "force",
             "pressure": "force/length²", "velocity": "length/time",
             "moment": "force · length", "length": "length"}
    lines = ["| Column | Meaning | Unit |", "| --- | --- | --- |"]
    lines += [f"| `{channel.name}` | {channel.meaning} | {names[channel.kind]} |"
              for channel in CHANNELS.values()]
    return "\n".join(lines)


def verified():
    """Differences to other programs, and of fits to known forces."""
    import numpy as np
    os.environ.update(BIFACE_BUILD=".", BIFACE_SOURCE=str(ROOT), BIFACE_RUNS=".")
    sys.path.insert(0, str(ROOT / "tests/tire_model"))
    from biface_tire_model import fit, read_table, read_tir
    from biface_tire_model.units import System
    from tire_model_test import largest_errors, sweeps
    rows = []

    def add(what, errors):
        rows.append(f"| {what} | {max(errors.values()):.1e} |")

    for name, what, more in (("opentire_pac2002", "MF 5.2 and OpenTire", {}),
                             ("made_mf61", "MF 6.1 and the equations of mfeval",
                              {"velocity": 20})):
        formula = read_tir(DATA / f"{name}.tir").formula()
        data = read_table(DATA / f"{name}.csv", System(angle="rad"))
        if more:
            data = data.with_column("velocity", np.full(len(data), more["velocity"]))
        add(what, largest_errors(formula, data))
    for name, version, loads, pressures in (
            ("hmmwv_pac2002", "5.2", (7000, 14000, 21000, 28000), (None,)),
            ("made_mf61", "6.1", (1500, 3000, 4500, 6500), (1.8e5, 2.2e5, 2.6e5))):
        formula = read_tir(DATA / f"{name}.tir").formula()
        data = sweeps(formula, loads, (-0.05, 0, 0.05), pressures, angles=10, slips=7)
        result = fit(data, version, formula.p.UNLOADED_RADIUS)
        pressure = ", three pressures" if len(pressures) > 1 else ""
        add(f"fit of MF {version} to {len(data)} states: four loads, three inclination "
            f"angles{pressure}", largest_errors(result.formula, data))
    return "\n".join(rows)


def main():
    sys.path.insert(0, str(PACKAGE))
    arguments = parse_arguments("tire_model", __doc__)
    from biface_tire_model.fitting import LARGEST_ERROR
    from biface_tire_model.table import PURE_ANGLE, PURE_SLIP
    scratch = arguments.scratch.resolve()
    figure = arguments.output.resolve() / "figures/tire_model.png"
    truck = "tests/data/hmmwv_pac2002.tir"
    loads = ("--fz", "10000,20000,30000")
    parts, commands = [], []
    for states, name in zip(STATES, ("cornering.csv", "braking.csv")):
        words = ("evaluate", truck, *loads, *states)
        parts.append(tire_model(*words).splitlines())
        commands.append(block((*words, "-o", name), ""))
    commands.append("    $ (cat cornering.csv; tail -n +3 braking.csv) > test.csv")
    (scratch / "test.csv").write_text("\n".join(parts[0] + parts[1][2:]) + "\n",
                                      encoding="utf-8")
    fitted = ("fit", "test.csv", "--format", "5.2", "--radius", "0.4699", "--output",
              "fitted.tir")
    output = tire_model(*fitted, "--picture", str(figure), directory=scratch)
    checked = ("check", truck)
    (arguments.output / "tire_model.md").write_text(PAGE.format(
        evaluate=shown("evaluate", truck, "--fz", "10000", "--alpha", "0,2,4", "--kappa",
                       "-.05,0"),
        columns=columns_table(), make="\n".join(commands),
        fit=block((*fitted, "--picture", "tire_model.png"), output),
        check=block(checked, tire_model(*checked, succeed=False)),
        pure_slip=PURE_SLIP, pure_angle=PURE_ANGLE * 180 / 3.141592653589793,
        error=100 * LARGEST_ERROR, verified=verified(),
        **structure(arguments, scratch)), encoding="utf-8")


if __name__ == "__main__":
    main()
