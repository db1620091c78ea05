# SPDX-License-Identifier: LGPL-2.1-or-later

# Wrong input gives one sentence that names it, and the exit code 1.

from rubber_test import TRELOAR, check_refused_by, require, rubber_here, scratch

require("numpy", "scipy")

HEAD = "test,stretch,stress\n"
FILES = [
    ("", "is empty"),
    ("# comment\n\n", "is empty"),
    (HEAD, "has no points"),
    ("test,stretch\nuniaxial,2\n", "has no column 'stress'"),
    ("test|stretch|stress\nuniaxial|2|1\n",
     "has no column 'test' among columns separated by commas, semicolons, tabs or blanks"),
    ("test;stretch;stress\nuniaxial;2,5;1.5\n",
     "has numbers with decimal commas and others with decimal points"),
    (HEAD + "uniaxial,2,1\nbiaxial,2,1\n",
     "line 3: the test is 'biaxial', but must be uniaxial, equibiaxial or planar"),
    (HEAD + "uniaxial,0,1\n", "line 2: the stretch is 0, but must lie between 0.01"),
    (HEAD + "uniaxial,-2,1\n", "line 2: the stretch is -2, but must lie between 0.01"),
    (HEAD + "uniaxial,150,1\n", "line 2: the stretch is 150, but must lie between"),
    ("# comment\n" + HEAD + "uniaxial,2,nan\n",
     "line 3: the stress is 'nan', but must be a number"),
    (HEAD + "uniaxial,two,1\n", "line 2: the stretch is 'two', but must be a number"),
    (HEAD + "uniaxial,2\n", "line 2: the stress is '', but must be a number"),
    (HEAD + "uniaxial,2,1\nplanar,2,1\n",
     "Yeoh has 3 constants, but there are only 2 points"),
    (HEAD + 4 * "uniaxial,2,1\n", "the points do not determine all constants of Yeoh"),
    (HEAD + "uniaxial,0.5,1\nuniaxial,0.7,1.2\nuniaxial,0.9,1.4\n",
     "the points give Yeoh the shear modulus"),
]
OPTIONS = [
    ([], "give either DATA.csv or --shore"),
    ([TRELOAR, "--shore", "60"], "give either DATA.csv or --shore"),
    (["no_such.csv"], "no_such.csv cannot be read"),
    (["--shore", "39"], "--shore is 39, but must lie between 40 and 80"),
    (["--shore", "nan"], "--shore is nan, but must lie between 40 and 80"),
    (["--shore", "60", "--law", "Yeoh"], "--law belongs to curves"),
    (["--shore", "60", "--nu", "0.5"], "--nu is 0.5, but must lie between 0 and 0.5"),
    (["--shore", "60", "--K", "0.5"], "--K is 0.5, but must be greater than two thirds"),
    (["--shore", "60", "--K", "900", "--nu", "0.4"], "--K and --nu exclude each other"),
    ([TRELOAR, "--terms", "2"], "--terms belongs to --law Ogden"),
    ([TRELOAR, "--up-to", "1"], "--up-to is 1, but must be greater than 1"),
]


def check_refused(words, sentence):
    check_refused_by("biface-rubber", rubber_here(*words), sentence, words)


for content, sentence in FILES:
    path = scratch() / "curves.csv"
    path.write_text(content, encoding="utf-8")
    check_refused([path, "--law", "Yeoh"], sentence)
path.write_bytes(bytes(range(128, 256)))
check_refused([path], "is not a text file")
for words, sentence in OPTIONS:
    check_refused(words, sentence)
