// Gives any bytes to the reader that FRIT_READER names: an answer or an InputError, nothing else.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "config/case_reader.hpp"
#include "config/units.hpp"
#include "core/error.hpp"
#include "io/contacts_csv.hpp"
#include "io/frame_files.hpp"
#include "io/packing_csv.hpp"
#include "io/pvd.hpp"
#include "io/sealed.hpp"
#include "io/series.hpp"
#include "io/state_arrays.hpp"
#include "solve/dump.hpp"

namespace {

using Reader = std::function<void(std::string_view)>;

// For readers of files: in memory where there is such a place.
std::filesystem::path file_of(std::string_view bytes, const std::string& ending) {
  static const std::string folder = std::filesystem::is_directory("/dev/shm") ? "/dev/shm" : "/tmp";
  const std::filesystem::path path = folder + "/frit-fuzz-" + std::to_string(::getpid()) + ending;
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return path;
}

void read_state(std::string_view bytes) {
  frit::io::unseal(bytes, {"frit checkpoint", 1});
  frit::io::take_state(frit::io::CborMap::parse(bytes), "now.");
}

const std::map<std::string, Reader>& readers() {
  using namespace frit;
  static const std::map<std::string, Reader> all{
      {"case", [](auto bytes) { config::parse_case(bytes, "case.toml"); }},
      {"units", [](auto bytes) { config::parse_quantity(bytes, config::Quantity::length); }},
      {"checkpoint", read_state},
      {"dump",
       [](auto bytes) {
         solve::load_dump({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
       }},
      {"packing", [](auto bytes) { io::read_packing_csv(file_of(bytes, ".csv")); }},
      {"contacts", [](auto bytes) { io::read_contacts_csv(file_of(bytes, ".csv"), 100); }},
      {"series", [](auto bytes) { io::read_series(file_of(bytes, ".csv")); }},
      {"pvd", [](auto bytes) { io::read_pvd(file_of(bytes, ".pvd")); }},
      {"vtp", [](auto bytes) { io::read_frame(file_of(bytes, ".vtp")); }},
      {"xyz", [](auto bytes) { io::read_frame(file_of(bytes, ".xyz")); }},
      {"lammps", [](auto bytes) { io::read_frame(file_of(bytes, ".dump")); }}};
  return all;
}

const Reader& chosen() {
  const char* name = std::getenv("FRIT_READER");
  const auto found = readers().find(name != nullptr ? name : "");
  if (found != readers().end()) return found->second;
  std::fputs("FRIT_READER names none of the readers:", stderr);
  for (const auto& [known, reader] : readers()) std::fprintf(stderr, " %s", known.c_str());
  std::fputs("\n", stderr);
  std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Reader reader = chosen();
  try {
    reader({reinterpret_cast<const char*>(data), size});
  } catch (const frit::InputError&) {
  }
  return 0;
}
