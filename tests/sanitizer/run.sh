#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later

# Runs tests with AddressSanitizer and UndefinedBehaviorSanitizer in the
# program, its library and the tests, in build-sanitize/. Every error is fatal.
# deal.II and the libraries below it are those of the system. The Release version
# is sufficient: the assertions of Debug are checked by the ordinary tests.
#   tests/sanitizer/run.sh [arguments of ctest]

set -eu
cd "$(dirname "$0")/../.."
here=$PWD/tests/sanitizer

export ASAN_OPTIONS="detect_container_overflow=0:${ASAN_OPTIONS-}"
export LSAN_OPTIONS="suppressions=$here/leaks.supp:print_suppressions=0:${LSAN_OPTIONS-}"
export UBSAN_OPTIONS="suppressions=$here/undefined.supp:print_stacktrace=1:halt_on_error=1:${UBSAN_OPTIONS-}"
export OPENBLAS_NUM_THREADS=1 HWLOC_HIDE_ERRORS=2
export OMPI_MCA_mpi_yield_when_idle=1
if [ "$(id -u)" -eq 0 ]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi

cmake -S . -B build-sanitize -G Ninja \
  -DCMAKE_BUILD_TYPE=Release -DBIFACE_SANITIZE=ON
cmake --build build-sanitize --target libbiface.release biface.release test_driver.release
ctest --test-dir build-sanitize --output-on-failure "$@"
