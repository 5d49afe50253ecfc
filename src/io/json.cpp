#include "io/json.hpp"

#include <string>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "io/text.hpp"
#include "io/write_file.hpp"

namespace frit::io {

void write_json(const std::filesystem::path& path, const nlohmann::json& value) {
  // Broken UTF-8 can come in through file names; it must not cost the summary of a run.
  const auto broken_text = nlohmann::json::error_handler_t::replace;
  write_file_whole(path, value.dump(2, ' ', false, broken_text) + "\n");
}

nlohmann::json read_json_object(const std::filesystem::path& path) {
  const std::string text = read_file_whole(path);
  try {
    nlohmann::json value = nlohmann::json::parse(text);
    if (value.is_object()) return value;
  } catch (const nlohmann::json::parse_error& error) {
    throw InputError(path.string() + ": not JSON, wrong at byte " + std::to_string(error.byte));
  }
  throw InputError(path.string() + ": holds no JSON object");
}

}  // namespace frit::io
