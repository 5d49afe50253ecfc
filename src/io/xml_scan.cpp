#include "io/xml_scan.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace frit::io {

namespace {

constexpr std::string_view blanks = " \t\r\n";
constexpr std::array<std::pair<char, std::string_view>, 4> entities{
    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}}};

std::string unescape(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    char next = text[0];
    std::size_t length = 1;
    for (const auto& [character, entity] : entities) {
      if (!text.starts_with(entity)) continue;
      next = character;
      length = entity.size();
    }
    plain += next;
    text.remove_prefix(length);
  }
  return plain;
}

// Adds name="value" pairs to the tag until its text ends or makes no sense.
void parse_attributes(std::string_view text, XmlTag& tag) {
  while (true) {
    const auto begin = text.find_first_not_of(blanks);
    const auto equals = text.find("=\"");
    if (begin == text.npos || equals == text.npos || equals < begin) return;
    const auto end = text.find('"', equals + 2);
    if (end == text.npos) return;
    tag.attributes[std::string(text.substr(begin, equals - begin))] =
        unescape(text.substr(equals + 2, end - equals - 2));
    text.remove_prefix(end + 1);
  }
}

}  // namespace

std::string XmlTag::get(std::string_view attribute) const {
  const auto found = attributes.find(attribute);
  return found == attributes.end() ? "" : found->second;
}

std::optional<XmlTag> next_tag(std::string_view text, std::size_t& position) {
  while (true) {
    const auto begin = text.find('<', position);
    if (begin == text.npos) return std::nullopt;
    const bool comment = text.substr(begin).starts_with("<!--");
    const auto end = comment ? text.find("-->", begin) : text.find('>', begin);
    if (end == text.npos) return std::nullopt;
    position = end + (comment ? 3 : 1);
    if (comment) continue;
    const auto content = text.substr(begin + 1, end - begin - 1);
    const auto name_end = std::min(content.find_first_of(" \t\r\n"), content.size());
    XmlTag tag{std::string(content.substr(0, name_end)), {}};
    parse_attributes(content.substr(name_end), tag);
    return tag;
  }
}

std::string escape_xml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    std::string replacement(1, c);
    for (const auto& [character, entity] : entities) {
      if (c == character) replacement = entity;
    }
    escaped += replacement;
  }
  return escaped;
}

}  // namespace frit::io
