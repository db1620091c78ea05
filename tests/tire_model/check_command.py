# SPDX-License-Identifier: LGPL-2.1-or-later

# The command check tells sections, and coefficients that are missing, not used, out of
# their usual bounds, or that give curves no tire has.

from tire_model_test import MADE, TRUCK, check, output_of, require, tire_model, write

require("numpy", "scipy")

text = output_of("check", MADE)
check("Magic Formula 6.1, FITTYP 61, nominal load 4200 N, radius 0.32 m, nominal pressure "
      "220000 Pa." in text, text)
check("[LATERAL_COEFFICIENTS]          42 entries" in text, text)
check("Missing" not in text and "Not used" not in text
      and text.endswith("No coefficient is out of its usual bounds.\n"), text)

code, text, _ = tire_model("check", TRUCK)
check(code == 1 and "Not used (relaxation): LSGKP, LSGAL, LGYR, PTX1" in text, text)
check("The slip stiffness is not positive from the load 5.308e+04 to 7.875e+04 N."
      in text, text)

source = MADE.read_text(encoding="utf-8")
for old, new, sentence in [
        ("PCY1 = 1.37\n", "", "Missing, taken as neutral: PCY1."),
        ("PCY1 = 1.37\n", "PCY1 = 1.37\nPXY9 = 1\n",
         "Not used (no known purpose): PXY9."),
        ("[VERTICAL]\n", "[VERTICAL]\nLMUV = 0.1\n",
         "Not used (the decay of friction with the slip velocity): LMUV."),
        ("PCY1 = 1.37", "PCY1 = 13.7",
         "PCY1 is 13.7, but usually lies between 0.8 and 2.5."),
        ("LMUY = 0.93", "LMUY = -1", "The friction of F_y is not positive from the load"),
        ("PKY1 = -19.4", "PKY1 = 19.4",
         "The cornering stiffness has the wrong sign from the load 400 to 9000 N"),
        ("FZMAX = 9000", "FZMAX = 100", "FZMIN is 400, but must be less than FZMAX, 100."),
        ("[UNITS]\nLENGTH = 'meter'\nFORCE = 'newton'\nANGLE = 'radians'\nMASS = 'kg'\n"
         "TIME = 'second'\n", "", "There is no section [UNITS]; the values are taken as SI"),
        ("[SCALING_COEFFICIENTS]", "[SHAPE]\n{radial width}\n1 0\n1 1\n"
         "[SCALING_COEFFICIENTS]", "0 entries, a table of 2 rows: RADIAL WIDTH")]:
    check(source.count(old) == 1, f"{old} occurs {source.count(old)} times")
    code, text, errors = tire_model("check", write("tire.tir", source.replace(old, new)))
    check(sentence in text and errors == "", f"'{sentence}' is not in {text}{errors}")
    wrong = any(word in sentence for word in ("usually", "positive", "wrong", "less"))
    check(code == int(wrong), f"the exit code is {code} for '{sentence}'")
