# SPDX-License-Identifier: LGPL-2.1-or-later

# A ply rating is not the number of plies: 4.00-8 4PR has two, the program says so, and that
# four given ones are more than needed.

from tire_from_size_test import check, output_of

output = " ".join(output_of("new", "4.00-8", "4PR", "--rim", "2.50C", "--check").split())
check("carcass 2 x nylon 840/2" in output, output)
check("4PR is a rating of strength, not the number of plies: 2 plies" in output, output)
output = " ".join(output_of("new", "4.00-8", "4PR", "--rim", "2.50C", "--plies", "4",
                            "--check").split())
check("carcass 4 x nylon 840/2 given" in output, output)
check("4 plies are more than the 2 that hold 4 times the pressure" in output
      and "4PR is a rating, not the number of plies" in output, output)
