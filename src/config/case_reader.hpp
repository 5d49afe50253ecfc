// Reads a case: strict TOML against the schema, defaults filled in, all faults told at once.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "config/case.hpp"

namespace frit::config {

// Every key at its default; keys without a default are unset.
Case default_case();

// The case in `text`. `name` stands in the faults, and relative paths in the case are relative to its folder.
// Overrides are "key.path=value", as after --set: the value in TOML, or a string without quotation marks
// where it is not TOML; they replace what the text says.
// Throws InputError with every fault found: "NAME:LINE: key.path: what is wrong; allowed ...".
Case parse_case(std::string_view text, const std::string& name,
                const std::vector<std::string>& overrides = {});

// The same from a file. A file that cannot be read is the user's fault too (InputError).
Case load_case(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

}  // namespace frit::config
