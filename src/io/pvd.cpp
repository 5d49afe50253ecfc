#include "io/pvd.hpp"

#include <fmt/core.h>

#include "io/fault_list.hpp"
#include "io/text.hpp"
#include "io/write_file.hpp"
#include "io/xml_scan.hpp"

namespace frit::io {

void write_pvd(const std::filesystem::path& path, std::span<const PvdEntry> entries) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (const auto& entry : entries) {
    text += "    <DataSet timestep=\"";
    append_number(text, entry.time);
    text += fmt::format("\" group=\"\" part=\"{}\" name=\"{}\" file=\"{}\"/>\n", entry.part,
                        escape_xml(entry.name), escape_xml(entry.file));
  }
  write_file_whole(path, text + "  </Collection>\n</VTKFile>\n");
}

std::vector<PvdEntry> read_pvd(const std::filesystem::path& path) {
  const auto text = read_file_whole(path);
  FaultList faults;
  std::vector<PvdEntry> entries;
  std::size_t position = 0;
  bool is_collection = false;
  while (const auto tag = next_tag(text, position)) {
    is_collection = is_collection || tag->name == "Collection";
    if (tag->name != "DataSet") continue;
    const auto time = parse_real(tag->get("timestep"));
    const auto part = parse_whole(tag->get("part"));
    const auto file = tag->get("file");
    if (!time || file.empty()) {
      faults.add(fmt::format("{}: entry {}: timestep and file are needed", path.string(), entries.size()));
    }
    entries.push_back({time.value_or(0.0), file, static_cast<int>(part.value_or(0)), tag->get("name")});
  }
  if (!is_collection) faults.add(path.string() + ": not a ParaView collection");
  faults.throw_if_any();
  return entries;
}

}  // namespace frit::io
