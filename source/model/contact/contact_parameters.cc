// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/contact/contact_parameters.h>

namespace Biface
{
  void
  ContactParameters::add_parameters(EntryDeclarations &prm)
  {
    body.add_parameters(prm);
    condition.add_parameters(prm);
    friction.add_parameters(prm);
    tread.add_parameters(prm);
  }


  void
  ContactParameters::check() const
  {
    condition.check();
    friction.check();
    tread.check();
    body.check();
  }
} // namespace Biface
