# SPDX-License-Identifier: LGPL-2.1-or-later

# Wrong options of evaluate are refused in one sentence, unknown ones with the usage.

from tire_model_test import MADE, check, check_refused, require, tire_model

require("numpy", "scipy")

for options, sentence in [
        (["--fz", "x"], "--fz is 'x', but must be numbers separated by commas, or "
                        "FIRST:LAST:STEP"),
        (["--fz", "1:2"], "--fz is '1:2', but must be numbers"),
        (["--fz", "1:2:0"], "--fz is '1:2:0', but must be numbers"),
        (["--fz", "2:1:1"], "--fz is '2:1:1', but must be numbers"),
        (["--fz", "0:1e9:1e-3"], "but must be numbers"),
        (["--fz", "nan"], "--fz is 'nan', but must be numbers"),
        (["--fz", "-100"], "--fz must be positive, in SAE axes negative"),
        (["--fz", "100", "--axes", "sae"], "--fz must be positive, in SAE axes negative"),
        (["--fz", "100", "--alpha", "90"], "--alpha must lie between -90 degrees and 90"),
        (["--fz", "100", "--gamma", "-91"], "--gamma must lie between -90 degrees and 90"),
        (["--fz", "100", "--kappa", "-3"], "--kappa must lie between -2 and 2"),
        (["--fz", "100", "--pressure", "0"], "--pressure must be positive"),
        (["--fz", "100", "--velocity", "-1"], "--velocity must be positive"),
        (["--fz", "1:9000:1", "--alpha", "-40:40:.1", "--kappa", "-.9:.9:.1"],
         "the table would have more than ten million rows"),
        (["--fz", "4000", "--output", "/no/such/directory/x.csv"],
         "/no/such/directory/x.csv cannot be read or written")]:
    check_refused(["evaluate", MADE, *options], sentence)
for words in ([], ["evaluate", MADE], ["evaluate"], ["fit", "x.csv"], ["assess"],
              ["evaluate", MADE, "--fz", "1", "--axes", "din"],
              ["fit", "x.csv", "--format", "7", "--radius", "1", "--output", "x"]):
    code, output, errors = tire_model(*words)
    check(code == 1 and output == "" and errors.startswith("usage: biface-tire-model"),
          f"{words}: the exit code is {code}: {errors}")
