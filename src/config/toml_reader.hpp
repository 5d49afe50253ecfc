// TOML text into a Document tree. The only place that knows the TOML library.
#pragma once

#include <string_view>

#include "config/document.hpp"

namespace frit::config {

// Throws TextFault for text that is not TOML, or that the screen refuses.
Table read_toml(std::string_view text);

// The value of one override, as TOML where it is TOML, else as a string (a bare word, "2 h").
// Throws TextFault where it starts like a string, list or table and is not a whole one.
Node read_toml_value(std::string_view text, Place place);

}  // namespace frit::config
