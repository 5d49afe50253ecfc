// Writes a resolved case as TOML that reads back to the same case, bit for bit.
#pragma once

#include <string>
#include <string_view>

#include "config/case.hpp"

namespace frit::config {

// Every key that means something in this case, in SI, its unit in a comment; `version` is the program's,
// for the first line. The text is self-contained: it may be read from any folder.
std::string write_case(const Case& whole, std::string_view version);

}  // namespace frit::config
