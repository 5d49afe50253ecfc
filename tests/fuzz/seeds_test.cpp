// The inputs that fuzzing has kept (seeds/<reader>/): each is read or refused with InputError, in every
// build. Run with the sanitizers, they are the regression test of the readers.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.hpp"
#include "fuzz/readers.hpp"
#include "io/text.hpp"

namespace frit::fuzz {
namespace {

class Seeds : public testing::TestWithParam<std::string> {};

TEST_P(Seeds, AreReadOrRefused) {
  const Reader& reader = readers().at(GetParam());
  int read = 0, refused = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FRIT_SEEDS "/" + GetParam())) {
    SCOPED_TRACE(entry.path().filename().string());
    const std::string bytes = io::read_file_whole(entry.path());
    try {
      reader(bytes);
      ++read;
    } catch (const InputError&) {
      ++refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << "neither read nor refused: " << error.what();
    }
  }
  EXPECT_GE(read, 1) << "no seed is a file as it should be";
  EXPECT_GE(refused, 10) << "too few seeds are broken";
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& [name, reader] : readers()) all.push_back(name);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Readers, Seeds, testing::ValuesIn(names()),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace frit::fuzz
