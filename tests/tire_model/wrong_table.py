# SPDX-License-Identifier: LGPL-2.1-or-later

# A wrong table is refused in one sentence with file, line, column and value.

from tire_model_test import check_refused, require, scratch, write

require("numpy", "scipy")

HEAD = "slip_angle,F_z,F_y\n"
MANY = "".join(f"{angle},4000,{-900 * angle}\n" for angle in range(-4, 5))
CASES = [
    ("", "is empty"),
    ("# comment\n", "is empty"),
    (HEAD, "has no rows"),
    ("slip_angle,F_y\n1,2\n", "the table has no column F_z, the load"),
    ("F_z,F_y\n1,2\n", "the table has neither a column slip_ratio nor a column "
                       "slip_angle"),
    ("slip_angle,F_z\n1,2\n", "the table has no forces and moments: it needs at least one "
                              "of the columns F_x, F_y, M_x, M_y or M_z"),
    ("slip_angle,F_z,F_y,F_y\n1,2,3,4\n", "has the column F_y twice"),
    ("slip_angle,F_z [stone],F_y\n1,2,3\n",
     "the unit of the column F_z is 'stone', but must be n, newton"),
    (HEAD + "1,2\n", "line 2: the row has 2 fields where 3 columns are named"),
    (HEAD + "1,4000,x\n", "line 2: F_y is 'x', but must be a number"),
    ("# c\n" + HEAD + "1,4000,5\n1,,5\n", "line 4: F_z is '', but must be a number"),
    (HEAD + "nan,4000,5\n", "line 2: slip_angle is 'nan', but must be a number"),
    (HEAD + "1,inf,5\n", "line 2: F_z is 'inf', but must be a number"),
    (HEAD + "1,4000,1\n2,-4000,1\n", "line 3: the load F_z must be positive"),
    (HEAD + "95,4000,1\n", "line 2: slip_angle must lie between -90 and 90 degrees"),
    ("slip_ratio,F_z,F_x\n-10,4000,1\n",
     "line 2: slip_ratio must lie between -2 and 2; it is a ratio, not percent"),
    ("pressure," + HEAD + "0,1,4000,1\n", "line 2: pressure must be positive"),
    ("velocity," + HEAD + "-3,1,4000,1\n", "line 2: velocity must be positive"),
    ("x,y,force\n1,2,3\n", "has none of the columns slip_ratio, slip_angle,"),
    ("x,y,force\n1,2,3\n", "M_y or M_z, separated by commas, semicolons, tabs or "
                                  "blanks"),
    ("SA;FZ;FY\n1,5;4000;3\n1.5;4000;3\n",
     "has numbers with decimal commas and others with decimal points"),
    ("SA,FZ,FY,P\n1,4000,3,97\n",
     "the column P needs its unit behind it, as in 'P [kPa]'"),
    ("SA,FZ,FY,V\n1,4000,3,97\n", "as in 'V [km/h]'"),
    ("SA,FZ,FY,speed\n1,4000,3,97\n", "the column speed needs its unit behind it"),
    ("SA,FZ,FY\ngon,N,N\n1,4000,3\n",
     "the unit of the column slip_angle is 'gon', but must be rad,"),
    ("SA,FZ,FY\ndeg,N,N\n", "has no rows"),
    ("SA\tFZ\tFY\n1\t4,000\t-1,200\n2\t4,000\t-2,100\n",
     "has numbers such as '4,000', whose comma may separate decimals or thousands"),
    ("kappa,alpha,camber,FZ,FY\n0,1,2,4000,-900\n",
     "the column camber is positive if the top leans outward, which depends on the side of "
     "the vehicle: name it inclination_angle"),
    ("SA,SR,FZ,FY\n1,0,4000,-900\n",
     "the column SR may refer to the loaded or to the effective radius: name it slip_ratio"),
    (HEAD + "-.2,4000,900\n.2,4000,-900\n",
     "the slip angles reach only 0.2 degrees: name their unit, as in 'slip_angle [rad]'"),
    (HEAD + "-2,4,.9\n2,4,-.9\n",
     "the loads reach only 4 N: name their unit, as in 'F_z [kN]', or use --units"),
    ("slip_angle,F_z [mN],F_y\n2,4,-900\n",
     "line 2: the load F_z is less than 0.1 N, as with a wrong unit"),
    ("pressure," + HEAD + "2.2,1,4000,-900\n",
     "line 2: pressure is not between 1000 and 1e+07 Pa, as with a wrong unit"),
    ("loaded_radius," + HEAD + "300,1,4000,-900\n",
     "line 2: loaded_radius is more than 5 m, as with a wrong unit"),
    (HEAD + "1,4000,1\n2,4000,1\n", "no curve can be fitted: each needs states at 5 slips"),
]
out = scratch() / "out.tir"
fit = ["--format", "6.1", "--radius", "0.3", "--without-combined", "neutral", "--output", out]
for text, sentence in CASES:
    check_refused(["fit", write("table.csv", text), *fit], sentence)
path = scratch() / "binary.csv"
path.write_bytes(bytes(range(128, 256)))
check_refused(["fit", path, *fit], "is not a text file")
check_refused(["fit", "no_such.csv", *fit], "no_such.csv cannot be read")

good = write("good.csv", HEAD + MANY)
for options, sentence in [
        (["--radius", "0"], "--radius is 0, but must be positive"),
        (["--radius", "nan"], "--radius is nan, but must be positive"),
        (["--nominal-load", "-1"], "--nominal-load is -1, but must be positive"),
        (["--units", "mm, N"], "the units are 'mm, N', but must be those of length, force "
                               "and time, such as 'mm, N, s'"),
        (["--units", "mm, N, fortnight"], "the unit of time is 'fortnight', but must be s,"),
        (["--axes", "sae"], "the load F_z must be positive"),
        (["--output", "/no/such/directory/x.tir"], "cannot be read or written"),
        (["--picture", out.with_suffix(".doc")], "--picture is ")]:
    code_words = ["fit", good, *fit, *options]
    if options[0] == "--picture":
        require("matplotlib")
        from tire_model_test import check, tire_model
        code, _, errors = tire_model(*code_words)
        check(code == 1 and "must be a pdf, svg or png file" in errors, errors)
    else:
        check_refused(code_words, sentence)
