// What libFuzzer calls: its bytes go to the reader that FRIT_READER names.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "core/error.hpp"
#include "fuzz/readers.hpp"

namespace {

const frit::fuzz::Reader& chosen() {
  const char* name = std::getenv("FRIT_READER");
  const auto& readers = frit::fuzz::readers();
  const auto found = readers.find(name != nullptr ? name : "");
  if (found != readers.end()) return found->second;
  std::fputs("FRIT_READER names none of the readers:", stderr);
  for (const auto& [known, reader] : readers) std::fprintf(stderr, " %s", known.c_str());
  std::fputs("\n", stderr);
  std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const frit::fuzz::Reader& reader = chosen();
  try {
    reader({reinterpret_cast<const char*>(data), size});
  } catch (const frit::InputError&) {
  }
  return 0;
}
