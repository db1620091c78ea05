#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later

# Runs all checks: format, warnings, documentation, and all tests in Debug and
# Release. Installs missing packages. The exit code is 0 if all pass.
#   tests/run.sh [arguments of ctest]

set -eu
cd "$(dirname "$0")/.."

step()
{
  printf '\n== %s\n' "$*"
}

step "Packages"
doc/install.sh tests

step "Format"
find source include tests \( -name '*.h' -o -name '*.cc' \) \
  -exec clang-format-14 --dry-run -Werror {} +

# ranks and threads would compete for the same cores
export OPENBLAS_NUM_THREADS=1
# without /sys, hwloc would print an error into the output of the tests
export HWLOC_HIDE_ERRORS=2
# a machine that is not in its own /etc/hosts: MPI would wait 5 s for DNS per run
export RES_OPTIONS="${RES_OPTIONS-timeout:1 attempts:1}"
if [ "$(id -u)" -eq 0 ]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi

step "Configuration"
cmake -S . -B build-tests -G Ninja \
  -DCMAKE_BUILD_TYPE=DebugRelease -DBIFACE_WERROR=ON -DBIFACE_DEBUG_SYMBOLS=OFF \
  -DBIFACE_BATCH=24

step "Debug and Release, documentation"
cmake --build build-tests --target documentation all build_tests

step "Tests"
ctest --test-dir build-tests -j "$(nproc)" --output-on-failure "$@"
