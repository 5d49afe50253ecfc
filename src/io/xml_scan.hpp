// Just enough XML for the files this program writes itself: tags and their attributes, one after the other.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace frit::io {

struct XmlTag {
  std::string name;  // "Points"; "/Points" for the end of an element
  std::map<std::string, std::string, std::less<>> attributes;

  // The attribute's value, or "" if there is none.
  std::string get(std::string_view attribute) const;
};

// The next tag at or after `position`, which moves behind it; nothing at the end of the text or in a torn
// tag. Comments and text between tags are passed over.
std::optional<XmlTag> next_tag(std::string_view text, std::size_t& position);

// The text with & < > " written as entities, for attribute values.
std::string escape_xml(std::string_view text);

}  // namespace frit::io
