// JSON files (summary.json and the like).
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace frit::io {

// Writes `value` indented, whole or not at all; what is not finite becomes null. MachineError as
// write_file_whole.
void write_json(const std::filesystem::path& path, const nlohmann::json& value);

// Reads a file that holds one JSON object. InputError naming the file and the place if it does not.
nlohmann::json read_json_object(const std::filesystem::path& path);

}  // namespace frit::io
