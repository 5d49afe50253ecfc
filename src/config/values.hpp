// One value of a case: from the document into the member its key names, and back into TOML.
#pragma once

#include <optional>
#include <string>

#include "config/document.hpp"
#include "config/schema.hpp"

namespace frit::config {

// Throws InputError with one fault (what is wrong, what is allowed; neither place nor key) and then leaves
// the target as it was. Not for lists of tables.
void read_value(const Key& key, const Node& node, Target& target);

// The value in TOML, in SI, with the shortest digits that read back to the same bits; nothing where the
// member is unset. Not for lists of tables.
std::optional<std::string> write_value(const Key& key, Target& target);

// A TOML string: quoted, with escapes.
std::string quote(const std::string& text);

}  // namespace frit::config
