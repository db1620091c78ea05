// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_active_set_h
#define biface_contact_active_set_h

#include <vector>

namespace Biface
{
  /** The points in contact, as a flag for each position. One byte each, since
   * the elements of vector<bool> cannot be written independently. */
  using ActiveSet = std::vector<char>;
} // namespace Biface

#endif
