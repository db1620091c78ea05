#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later

# Installs the Debian 12 packages that biface needs and that are missing:
#   doc/install.sh         to build and run the program
#   doc/install.sh report  and for biface-report, biface-rubber, biface-tire, biface-tire-model
#   doc/install.sh tests   and to run all tests and build the documentation

set -eu

packages="cmake g++ ninja-build libdeal.ii-dev libmumps-dev
  libopenblas0-pthread openmpi-bin"
report="python3-matplotlib python3-scipy libjs-three"
case ${1-} in
  "") ;;
  report) packages="$packages $report" ;;
  tests) packages="$packages $report chromium chromium-driver numdiff clang
    clang-format-14 doxygen lld python3-pandas python3-pip python3-setuptools
    python3-wheel texlive-binaries valgrind" ;;
  *)
    echo "Usage: doc/install.sh [report | tests]" >&2
    exit 1
    ;;
esac

missing=
for package in $packages; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) || :
  [ "$status" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

apt()
{
  if [ "$(id -u)" -eq 0 ]; then
    DEBIAN_FRONTEND=noninteractive apt-get "$@" </dev/null
  else
    sudo env DEBIAN_FRONTEND=noninteractive apt-get "$@"
  fi
}

# the package lists may be missing or older than the archive
# shellcheck disable=SC2086
{
  apt-get install --simulate $missing >/dev/null 2>&1 || apt update
  apt install -y --no-install-recommends $missing ||
    { apt update && apt install -y --no-install-recommends $missing; }
}
