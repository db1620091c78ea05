#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later

# Installs the Debian 12 packages that biface needs and that are not there:
#   doc/install.sh         to build and run the program
#   doc/install.sh tests   to run the tests and build the documentation, too
#   doc/install.sh report  to turn results into a page with biface-report, too

set -eu

packages="cmake g++ ninja-build libdeal.ii-dev libmumps-dev
  libopenblas0-pthread openmpi-bin"
case ${1-} in
  "") ;;
  tests) packages="$packages numdiff clang clang-format-14 doxygen
    texlive-binaries python3" ;;
  report)
    packages="$packages python3-matplotlib xvfb xauth"
    # ParaView has a VTK of its own and would have to go for Debian's
    status=$(dpkg-query -W -f '${db:Status-Status}' python3-paraview \
      2>/dev/null) || :
    [ "$status" = installed ] || packages="$packages python3-vtk9"
    ;;
  *)
    echo "Usage: doc/install.sh [tests | report]" >&2
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

# the lists of packages may be absent, or older than the archive
# shellcheck disable=SC2086
{
  apt-get install --simulate $missing >/dev/null 2>&1 || apt update
  apt install -y --no-install-recommends $missing ||
    { apt update && apt install -y --no-install-recommends $missing; }
}
