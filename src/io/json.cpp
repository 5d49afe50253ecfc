#include "io/json.hpp"

#include <nlohmann/json.hpp>

#include "io/write_file.hpp"

namespace frit::io {

void write_json(const std::filesystem::path& path, const nlohmann::json& value) {
  // Broken UTF-8 can come in through file names; it must not cost the summary of a run.
  const auto broken_text = nlohmann::json::error_handler_t::replace;
  write_file_whole(path, value.dump(2, ' ', false, broken_text) + "\n");
}

}  // namespace frit::io
