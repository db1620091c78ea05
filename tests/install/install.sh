#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later

# The installation is usable: another project finds the package, links the
# library and computes with it; the installed program runs.
#   install.sh BUILD_DIRECTORY PROGRAM
# The environment names the generator and the compilers: CMAKE_GENERATOR, CC, CXX.

set -eu
build=$1
program=$2
here=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
prefix=$scratch/prefix

cmake --install "$build" --prefix "$prefix" >/dev/null

cmake -S "$here/consumer" -B "$scratch/consumer" \
  -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_FLAGS="-Wall -Wextra"
cmake --build "$scratch/consumer"
"$scratch/consumer/strip" "$here/consumer/strip.prm"

# the examples refer to files beside them, the pages to each other
cd "$scratch"
"$prefix/bin/$program" --version
"$prefix/bin/$program" --check "$prefix/share/doc/biface/examples/belted_tire.prm"
test -f "$prefix/share/doc/biface/prm/bias_tire.prm"
test -f "$prefix/share/doc/biface/doc/figures/deformed_tire.png"
test -f "$prefix/share/man/man1/biface.1"
