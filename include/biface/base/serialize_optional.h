// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_base_serialize_optional_h
#define biface_base_serialize_optional_h

#include <memory>
#include <optional>

namespace Biface
{
  /** Add a value that may not be set to an archive, or read it from one. */
  template <class Archive, class Value>
  void
  serialize_optional(Archive &archive, std::optional<Value> &value)
  {
    bool            given   = value.has_value();
    Value           content = value.value_or(Value());
    archive &given &content;
    value = (given ? std::optional<Value>(content) : std::nullopt);
  }


  /** Add a shared value to an archive, or read it from one: null stands for one
   * that is not set, as in std::optional. */
  template <class Archive, class Value>
  void
  serialize_optional(Archive &archive, std::shared_ptr<const Value> &value)
  {
    std::optional<Value> content;
    if (value)
      content = *value;
    serialize_optional(archive, content);
    value = (content ? std::make_shared<const Value>(*content) : nullptr);
  }
} // namespace Biface

#endif
