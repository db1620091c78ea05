#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write rubber_constants.md and its pictures."""

import os
import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from example_page import EXAMPLES, biface, parse_arguments, table

ROOT = EXAMPLES.parent
PACKAGE = ROOT / "source/python"

PAGE = """<!-- Written by doc/rubber_constants/rubber_constants.py: cmake --build build --target rubber_constants -->

# Constants of rubber

`biface-rubber` finds the constants of the laws of rubber, `neo-Hooke`, `Mooney-Rivlin`,
`Yeoh` and `Ogden`, from a hardness or from measured curves. What it prints is a section
of a parameter file; the lines with # are comments. It needs SciPy, which
`doc/install.sh report` installs.

## From a hardness

{shore}

The relation of [Gent 1958](references.bib#Gent1958), with the hardness S in Shore A,

```math
E = 0.0981\\,\\frac{{56 + 7.62336\\,S}}{{0.137505\\,(254 - 2.54\\,S)}}\\ \\text{{MPa}},
```

comes from the elastic theory of a small indentation; its author found the theory to hold
above a hardness of 40. [Qi, Joyce and Boyce 2003](references.bib#QiJoyceBoyce2003) simulated the test and
give $`\\log_{{10}} E = 0.0235\\,S - 0.6403`$. They differ:

{hardness}

So a hardness is a rough estimate, the rougher the harder the rubber, for a first run. It
says nothing about large strains, so that only `neo-Hooke` makes sense, up to strains of
some 30 %. Values outside 40 to 80, where both relations hold, are refused.

## From curves

The file has the columns `test`, `stretch` and `stress`; lines that start with # are
comments:

| Column | Meaning |
| --- | --- |
| `test` | `uniaxial`: a strip; `equibiaxial`: a sheet pulled equally in two directions, or a bubble; `planar`: a wide strip that cannot contract along its width, "pure shear" |
| `stretch` | deformed over initial length; 1 plus the strain; less than 1 is compression; from 0.01 to 100 |
| `stress` | nominal stress, force over undeformed area. Its unit is that of the constants |

Rubber softens in its first cycles. Measure the cycle that the shell is in, at a slow rate, and
subtract the permanent set from the length.

[rubber_treloar.csv](../prm/rubber_treloar.csv) contains the classic measurements of
[Treloar 1944](references.bib#Treloar1944), up to a stretch of 7.6. Without `--law` the
command compares all laws:

{all}

![Treloar's points in three tests and the curves of six laws](figures/rubber_laws.png)

*Points: Treloar; lines: the laws, dashed beyond the points that were fitted. MPa.*

    {all_plot}

Choose one by `--law`:

{ogden}

| Option | Meaning |
| --- | --- |
| `--law L`, `--terms N` | the law, and for `Ogden` the number of terms, 1 to 3 |
| `--errors relative` | makes the errors relative to the measured stresses small, so that small strains weigh more; the default, `absolute`, weighs all points alike, so that high stresses rule |
| `--only TESTS` | fits some tests and shows how well the law predicts the others |
| `--stable` | only constants whose signs make the law stable at all stretches |
| `--up-to S` | the stretch up to which stability is checked, by default at twice the largest measured strain |
| `--nu`, `--K` | Poisson's ratio or the bulk modulus, see below |
| `--plot FILE` | a picture |
| `--name N` | the name of the material |

Fits of `Ogden` start from all combinations of a fixed list of exponents and keep the
best result; they are the same every time.

As a check, points drawn by the constants that
[Ogden 1972](references.bib#Ogden1972) published for this rubber ($`\\mu_i`$ = 0.63, 0.0012,
−0.01 MPa, $`\\alpha_i`$ = 1.3, 5, −2) give these constants again
(`tests/rubber/constants_recovered.py`). Against Treloar's points, in MPa:

{published}

His constants miss the end of the uniaxial curve: at the last point the table has
{end:.2f} MPa and they give {end_published:.2f} MPa.

## Which law

- **neo-Hooke**: one constant; strains up to some 30 %. It cannot follow the softening
  after that, nor the rise at the end, and never becomes unstable.
- **Mooney-Rivlin**: strains up to some 100 %. Fitted to the rise at the end, it gets a negative
  c01 and becomes unstable. c01 from a uniaxial test alone is not reliable.
- **Yeoh**: the choice if there is only a uniaxial curve. It depends on the first invariant
  alone, so that what it learns in one test helps in the others. It underestimates
  equibiaxial stresses.
- **Ogden**: the closest, if all tests are there. From one test alone it may be wrong without
  bound in the others.

The same laws, from the uniaxial points only:

{uniaxial}

![The laws fitted to the uniaxial points only, with the points of all tests](figures/rubber_uniaxial.png)

*The laws fitted to the uniaxial points, beside all points. MPa.*

    {uniaxial_plot}

Two and three terms of Ogden's law follow the uniaxial curve best, Drucker's condition
holds, and in equibiaxial tension they are wrong by orders of magnitude. The walls of
inflated shells are stretched in two directions: a sphere equibiaxially, a long tube nearly
in the planar way. For these measure equibiaxial and planar curves, or take Yeoh's
law. No law is reliable much beyond its points: keep the strains of the run
inside them.

## Stability

Drucker's condition says that a small further strain takes further stress: the moduli
$`\\partial\\tau_i/\\partial\\ln\\lambda_j`$ of the first two principal directions, without stress in the
third and at constant volume, are positive definite. Where they are not, the law is no
rubber, and steps of a run may fail. The command checks the three tests from
stretch 1 on; compression needs no check of its own, since it is tension in
another test under a pressure. Between the tests nothing is checked. Sufficient are c10, c01, c20, c30 not
negative, and $`\\mu_i\\alpha_i > 0`$ in each term; `--stable` only allows these. For
Treloar's points it costs Yeoh's law its negative c20, and Ogden's law nothing.

Stable rubber still has limit points: the pressure of a balloon has a maximum. See
`Control` in [parameters.md](parameters.md).

## The bulk modulus

Rubber changes its shape a thousand times more easily than its volume: K is of the order of
1000 MPa ([Tabor 1994](references.bib#Tabor1994)). Walls of shells are free to become
thinner, so that K hardly matters unless rubber is confined, as a thin layer between stiff
ones. By default K follows from nu = 0.499, K = 500 mu. The tube of
[1_cylinder.prm](../prm/tutorial/1_cylinder.prm) with the constants of Ogden's law above, inflated to {pressure} MPa in {steps} steps with nonlinear theory:

{bulk}

The displacement changes by {change:.1f} % from nu = 0.45 on, by {late:.1f} % from 0.49 on and by
{last:.1f} % from 0.499 on. Larger bulk moduli do not cost convergence, since a cell has a single
stress across its thickness. So keep nu = 0.499; give `--K` if rubber is confined.
In tube.prm the printed section replaces that of the example:

    {bulk_command}
"""

PRESSURE, STEPS = 0.005, 8


def rubber(*words):
    """The output of biface-rubber."""
    return subprocess.run(
        [sys.executable, "-B", "-m", "biface_rubber", *words], cwd=ROOT,
        env=dict(os.environ, PYTHONPATH=str(PACKAGE)), capture_output=True, text=True,
        check=True).stdout


def shown(*words):
    """A command and its output, as a block of the page."""
    return (f"    $ biface-rubber {' '.join(words)}\n"
            + "".join(f"    {line}".rstrip() + "\n"
                      for line in rubber(*words).splitlines())).rstrip()


def plotted(target, *words):
    """The command that draws a picture, which it draws."""
    rubber(*words, "--plot", str(target))
    words = [f"'{word}'" if " " in word else word for word in words]
    return f"biface-rubber {' '.join(words)} --plot doc/figures/{target.name}"


def hardness_table():
    from biface_rubber.hardness import young_modulus, young_modulus_of_simulations
    return table(["Shore A", "mu, Gent, MPa", "mu, Qi et al., MPa"], [
        [str(shore), f"{young_modulus(shore) / 3:.2f}",
         f"{young_modulus_of_simulations(shore) / 3:.2f}"]
        for shore in range(40, 81, 10)])


def published_table(words):
    """Errors of Ogden's constants and of a fit, and the last uniaxial stresses."""
    from biface_rubber.data import read
    from biface_rubber.fit import fit
    from biface_rubber.laws import Law, ogden_terms
    from biface_rubber.text import residuals
    data = read(ROOT / words)
    published = Law("Ogden", ogden_terms((1.3, 5, -2)), (0.63, 0.0012, -0.01))
    rows = [residuals(law, data) for law in (published, fit(data, "Ogden", 3))]
    text = table(["test", "RMS, published", "maximum, published", "RMS, fitted",
                  "maximum, fitted"], [
        [test] + [f"{row[test][i]:.3f}" for row in rows for i in (1, 2)]
        for test in data.measured()])
    last = data.stretches[data.of("uniaxial")].argmax()
    return {"published": text, "end": data.stresses[last],
            "end_published": published.stress("uniaxial", data.stretches[[last]])[0]}


def bulk_table(arguments):
    """The tube with several bulk moduli."""
    example = (EXAMPLES / "tutorial/1_cylinder.prm").read_text(encoding="utf-8")
    rows, moved = [], []
    settings = {"Stage 1/Strain theory": "nonlinear", "Stage 1/Steps": STEPS,
                "Stage 1/Pressure": PRESSURE, "Loads/Pressure type": "follower"}
    for nu in (0.45, 0.49, 0.495, 0.499, 0.4998, 0.49998):
        section = rubber("prm/rubber_treloar.csv", "--law", "Ogden", "--nu", str(nu))
        file = arguments.scratch / f"tube-{nu}.prm"
        file.write_text(re.sub(r"subsection Material rubber.*?\nend\n", lambda _: section,
                               example, flags=re.DOTALL), encoding="utf-8")
        results = biface.run(file, settings, arguments.scratch / f"tube-{nu}",
                             program=arguments.program)
        moved.append(results.probes().where(name="middle")["u_3"][-1])
        iterations = results.history["iterations"].sum()
        rows.append([f"{nu:g}", f"{2 * (1 + nu) / (3 * (1 - 2 * nu)):.0f}",
                     f"{moved[-1]:.3f}", f"{iterations:.0f}"])
    options = " ".join(f'--set "{entry}={value}"' for entry, value in settings.items())
    return {"bulk": table(["nu", "K/mu", "radial displacement, mm", "iterations"], rows),
            "change": 100 * abs(moved[-1] / moved[0] - 1),
            "late": 100 * abs(moved[-1] / moved[1] - 1),
            "last": 100 * abs(moved[-1] / moved[3] - 1),
            "bulk_command": f"biface {options} tube.prm"}


def main():
    sys.path.insert(0, str(PACKAGE))
    arguments = parse_arguments("rubber_constants", __doc__)
    figures = arguments.output.resolve() / "figures"
    data = "prm/rubber_treloar.csv"
    only = ("--only", "uniaxial")
    (arguments.output / "rubber_constants.md").write_text(PAGE.format(
        shore=shown("--shore", "60"), hardness=hardness_table(),
        all=shown(data), all_plot=plotted(figures / "rubber_laws.png", data),
        ogden=shown(data, "--law", "Ogden"),
        uniaxial=shown(data, *only),
        uniaxial_plot=plotted(figures / "rubber_uniaxial.png", data, *only),
        pressure=PRESSURE, steps=STEPS, **published_table(data), **bulk_table(arguments)),
        encoding="utf-8")


if __name__ == "__main__":
    main()
