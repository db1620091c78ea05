// SPDX-License-Identifier: LGPL-2.1-or-later

// Modules loaded by MPI stay in memory until the end, so that reports of their
// leaks contain a file name that leaks.supp can suppress.

extern "C" int
dlclose(void *)
{
  return 0;
}
