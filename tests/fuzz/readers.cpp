#include "fuzz/readers.hpp"

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "config/case_reader.hpp"
#include "config/units.hpp"
#include "io/contacts_csv.hpp"
#include "io/frame_files.hpp"
#include "io/packing_csv.hpp"
#include "io/pvd.hpp"
#include "io/sealed.hpp"
#include "io/series.hpp"
#include "io/state_arrays.hpp"
#include "solve/dump.hpp"

namespace frit::fuzz {
namespace {

// The bytes as a file for as long as it lives, in memory where there is such a place.
class Copy {
 public:
  Copy(std::string_view bytes, const std::string& ending) {
    static const std::string folder = std::filesystem::is_directory("/dev/shm") ? "/dev/shm" : "/tmp";
    path_ = folder + "/frit-fuzz-" + std::to_string(::getpid()) + ending;
    std::ofstream(path_, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
  Copy(const Copy&) = delete;
  Copy& operator=(const Copy&) = delete;
  ~Copy() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

void read_state(std::string_view bytes) {
  io::unseal(bytes, {"frit checkpoint", 1});
  io::take_state(io::CborMap::parse(bytes), "now.");
}

}  // namespace

const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> all{
      {"case", [](auto bytes) { config::parse_case(bytes, "case.toml"); }},
      {"units", [](auto bytes) { config::parse_quantity(bytes, config::Quantity::length); }},
      {"checkpoint", read_state},
      {"dump",
       [](auto bytes) {
         solve::load_dump({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
       }},
      {"packing", [](auto bytes) { io::read_packing_csv(Copy(bytes, ".csv").path()); }},
      {"contacts", [](auto bytes) { io::read_contacts_csv(Copy(bytes, ".csv").path(), 100); }},
      {"series", [](auto bytes) { io::read_series(Copy(bytes, ".csv").path()); }},
      {"pvd", [](auto bytes) { io::read_pvd(Copy(bytes, ".pvd").path()); }},
      {"vtp", [](auto bytes) { io::read_frame(Copy(bytes, ".vtp").path()); }},
      {"xyz", [](auto bytes) { io::read_frame(Copy(bytes, ".xyz").path()); }},
      {"lammps", [](auto bytes) { io::read_frame(Copy(bytes, ".dump").path()); }}};
  return all;
}

}  // namespace frit::fuzz
