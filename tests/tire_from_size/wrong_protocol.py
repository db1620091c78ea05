# SPDX-License-Identifier: LGPL-2.1-or-later

# A wrong protocol, and a parameter file that is no tire's, give one sentence and the exit
# code 1.

from tire_from_size_test import SOURCE, check_refused, output_of, scratch

directory = scratch()
output_of("new", "4.00-8", "4PR", "--output", directory)
HEAD = "kind,load [N],pressure [bar],inclination_angle [deg],slip_angle [deg],slip_ratio [-]\n"
for text, sentence in [
        ("", "protocol.csv is empty"),
        (HEAD, "protocol.csv has no rows"),
        ("load [N]\n1000\n", "has no column 'kind'"),
        ("kind,grip\nsteady,1\n", "the column 'grip' is not known: a protocol has kind,"),
        ("kind,load,load [N]\nsteady,1,1\n", "has the column load twice"),
        ("kind,load [stone]\nsteady,1\n", "the unit of the column load is 'stone', but must "
                                          "be n,"),
        ("kind,slip_angle [%]\nsteady,1\n", "the unit of the column slip_angle is '%'"),
        (HEAD + "steady,1000\n", "line 2: the row has 2 fields where 6 columns are named"),
        (HEAD + "rolling,1000,2,,,\n", "line 2: the kind is 'rolling', but must be radial,"),
        (HEAD + "steady,-1000,2,,,\n", "line 2: load is '-1000', but must be positive"),
        (HEAD + "steady,1000,0,,,\n", "line 2: pressure is '0', but must be positive"),
        (HEAD + "steady,many,2,,,\n", "line 2: load is 'many', but must be numbers separated "
                                      "by blanks, or begin:end:number"),
        (HEAD + "steady,nan,2,,,\n", "load is 'nan', but must be numbers"),
        (HEAD + "steady,1000,2,0:5:1,,\n", "the number in begin:end:number must be a whole "
                                           "one from 2 to 1000"),
        (HEAD + "steady,1000,2,0 5 5,,\n", "inclination_angle is '0 5 5', which has 5 twice"),
        (HEAD + "steady,1000,2,95,,\n", "inclination_angle is '95', but must lie between -90 "
                                        "and 90 degrees"),
        (HEAD + "steady,1000,2,,,-20\n", "slip_ratio is '-20', but must lie between -1 and 1"),
        (HEAD + "radial,1000,2,,4,\n", "slip_angle is '4', but a row of the kind 'radial' has "
                                       "none"),
        (HEAD + "steady,1000,2,,4,\nsteady,1000.0,2,0,4,\n",
         "line 3 says the same as line 2"),
        ("kind,load [%]\nsteady,40000\n", "load is '40000', but must be at most 1000 % of that "
                                          "of the tire"),
        ("kind\nbar run over\n", "nothing of the protocol can be computed: ")]:
    protocol = directory / "protocol.csv"
    protocol.write_text(text, encoding="utf-8")
    check_refused(("model", directory, "--protocol", protocol), sentence)

check_refused(("model", directory, "--protocol", "mf53"),
              "the protocol is 'mf53', but must be cdtire, ftire, mf52, mf61 or quick, or a "
              "file")
check_refused(("model", directory / "none.prm", "--protocol", "quick"), "cannot be read")
check_refused(("model", directory, "--protocol", "quick", "--load", "-3"),
              "--load is '-3', but must be positive")
check_refused(("model", SOURCE / "prm/tire_modes.prm", "--protocol", "quick"),
              "names no load: neither 'Tire test/Loads' nor a 'Force' of a stage with "
              "'Control = foundation force'")
plain = directory / "plain.prm"
for text, sentence in [
        ("set Number of stages = 1\n", "the entry 'Units' is missing, in which length"),
        ("set Units = mm, N\n", "the units are 'mm, N', but must be those of length"),
        ("set Units = mm, N, s\n", "no stage before the ground comes has a 'Pressure'")]:
    plain.write_text(text, encoding="utf-8")
    check_refused(("model", plain, "--protocol", "quick"), sentence)
