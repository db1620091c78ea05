# SPDX-License-Identifier: LGPL-2.1-or-later

# Fits of curves that a law has drawn give its constants, with either kind of errors.

from rubber_test import (OGDEN, check, curves, entries_of, output_of, require, scratch,
                         write)

require("numpy", "scipy")

from biface_rubber.laws import LINEAR, Law, ogden_terms

CASES = [(name, Law(name, LINEAR[name].values(), constants))
         for name, constants in (("neo-Hooke", [0.4]), ("Mooney-Rivlin", [0.15, 0.02]),
                                 ("Yeoh", [0.17, -0.002, 5e-5]))]
CASES += [("Ogden", Law("Ogden", ogden_terms(alphas), factors))
          for alphas, factors in ((OGDEN["alpha_i"], OGDEN["mu_i"]),
                                  ((1.77, 6.3, -2.6), (0.41, 2e-4, -0.03)),
                                  ((2.6, -1.2), (0.1, -0.2)), ((2.4,), (0.3,)))]
for name, law in CASES:
    expected = ([law.constants] if name == "Ogden"
                else [[constant] for constant in law.constants])
    if name == "Ogden":
        expected.append([term.alpha for term in law.terms])
    points = curves(law)
    largest = max(stress for _, _, stress in points)
    path = write(scratch() / "curves.csv", points)
    for errors in ("absolute", "relative"):
        words = ["--terms", str(len(law.terms))] if name == "Ogden" else []
        output = output_of(path, "--law", name, "--errors", errors, *words)
        found = entries_of(output)
        check(found.pop("Type") == name, f"another law: {output}")
        found.pop("K")
        if name == "Ogden":
            # terms in any order
            pairs = [sorted(zip(*lists)) for lists in (found.values(), expected)]
            pairs = [[number for pair in list_ for number in pair] for list_ in pairs]
        else:
            pairs = [sum(found.values(), []), sum(expected, [])]
        check(len(pairs[0]) == len(pairs[1]), f"other constants: {output}")
        for computed, exact in zip(*pairs):
            check(abs(computed - exact) <= 1e-5 * abs(exact),
                  f"{computed}, not {exact}: {output}")
        rms = [float(line.split()[6]) for line in output.splitlines()
               if line.startswith(("# uniaxial", "# equibiaxial", "# planar"))]
        check(len(rms) == 3 and max(rms) < 1e-6 * largest, f"the errors are {rms}")
