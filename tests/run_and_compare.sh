#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later

# Runs a test in the current directory and compares what it prints, with the scripts
# that deal.II has for its own tests.
#   run_and_compare.sh SCRIPTS NUMDIFF TEST EXPECTED COMMAND...

set -eu
scripts=$1 numdiff=$2 test=$3 expected=$4
shift 4
sh "$scripts/run_test.sh" run "$test" "$@"
perl -pi "$scripts/normalize.pl" output
sh "$scripts/run_test.sh" diff "$test" "$numdiff" "$expected"
