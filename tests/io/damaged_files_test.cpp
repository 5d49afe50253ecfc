// Files cut off or changed at any byte are read or refused with InputError: nothing else may happen (run with
// the sanitizers, this is a small fuzz test of each reader).
#include <functional>
#include <random>

#include "io/contacts_csv.hpp"
#include "io/frame_files.hpp"
#include "io/pvd.hpp"
#include "io/series.hpp"
#include "temporary_folder.hpp"

namespace frit::io {
namespace {

struct Sample {
  std::string name, bytes;
  std::function<void(const std::filesystem::path&)> read;
};

std::vector<Sample> samples(const TemporaryFolder& folder) {
  std::vector<Sample> all;
  auto frame = awkward_frame(6);
  frame.cell = {.periodic = true, .size = {1, 2, 3}};
  for (const std::string name : {"a.csv", "a.xyz", "a.dump", "a.vtp"}) {
    write_frame(folder / name, frame);
    all.push_back({name, bytes_of(folder / name), [](const auto& path) { read_frame(path); }});
  }
  all.push_back({"c.csv", "i,j,neck_radius [um]\n0,1,1\n1,2,3\n",
                 [](const auto& path) { read_contacts_csv(path, 3); }});
  all.push_back({"s.csv", "time [s],density\n0,0.5\n1,\n", [](const auto& path) { read_series(path); }});
  write_pvd(folder / "s.pvd", std::vector<PvdEntry>{{1.0, "a.vtp", 0, "a"}});
  all.push_back({"s.pvd", bytes_of(folder / "s.pvd"), [](const auto& path) { read_pvd(path); }});
  return all;
}

// Whether the reader took the bytes; any other exception than InputError fails the test.
bool is_accepted(const TemporaryFolder& folder, const Sample& sample, const std::string& bytes) {
  try {
    sample.read(folder.write(sample.name, bytes));
    return true;
  } catch (const InputError&) {
    return false;
  }
}

TEST(DamagedFiles, CutOffAnywhereTheyAreReadOrRefused) {
  const TemporaryFolder folder;
  for (const auto& sample : samples(folder)) {
    EXPECT_TRUE(is_accepted(folder, sample, sample.bytes)) << sample.name;
    for (std::size_t length = 0; length < sample.bytes.size(); ++length) {
      is_accepted(folder, sample, sample.bytes.substr(0, length));
    }
  }
}

TEST(DamagedFiles, VtpCutOffAnywhereIsNeverAccepted) {
  const TemporaryFolder folder;
  const auto vtp = samples(folder)[3];
  const auto last_line_end = vtp.bytes.size() - 1;
  for (std::size_t length = 0; length < last_line_end; ++length) {
    EXPECT_FALSE(is_accepted(folder, vtp, vtp.bytes.substr(0, length))) << length;
  }
}

TEST(DamagedFiles, WithChangedBytesTheyAreReadOrRefused) {
  const TemporaryFolder folder;
  std::mt19937 generator(11);
  for (const auto& sample : samples(folder)) {
    for (int trial = 0; trial < 1500; ++trial) {
      std::string bytes = sample.bytes;
      for (unsigned change = 0; change < 1 + trial % 3u; ++change) {
        const auto at = generator() % bytes.size();
        switch (generator() % 3) {
          case 0:
            bytes[at] = static_cast<char>(generator());
            break;
          case 1:
            bytes.insert(at, bytes.substr(generator() % bytes.size(), 5));
            break;
          default:
            bytes.erase(at, 1 + generator() % 3);
        }
      }
      is_accepted(folder, sample, bytes);
    }
  }
}

}  // namespace
}  // namespace frit::io
