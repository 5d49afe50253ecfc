// The reference of all keys, from the schema: for the terminal and as docs/config.md.
#pragma once

#include <string>
#include <string_view>

namespace frit::config {

// Plain text about one key ("contact.pull"), about all keys of a section ("contact"), or, for an empty
// path, the list of all keys. Throws InputError naming the nearest keys where there is no such key.
std::string describe(std::string_view path);

// docs/config.md.
std::string reference_markdown();

}  // namespace frit::config
