// JSON files (summary.json and the like).
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace frit::io {

// Writes `value` indented, whole or not at all; what is not finite becomes null. MachineError as
// write_file_whole.
void write_json(const std::filesystem::path& path, const nlohmann::json& value);

}  // namespace frit::io
