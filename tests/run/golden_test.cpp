// The bits of five runs that together touch all that advances a state: the same for any number of threads,
// and the same as in golden_bits.txt, for the compiler and processor that its lines name.
#include <gnu/libc-version.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <map>

#include "core/parallel.hpp"
#include "io/state_arrays.hpp"
#include "run/result_folder.hpp"
#include "run/samples.hpp"

namespace frit::run {
namespace {

using samples::Recorder;

const std::filesystem::path golden_file = FRIT_SOURCE_FOLDER "/tests/run/golden_bits.txt";

// What the last bits of a result may depend on beside the source: compiler, instruction set, the elementary
// functions, and the library whose expressions are compiled into ours. Build types and checks must not
// matter.
std::string build() {
#if defined(__clang__)
  const std::string compiler = fmt::format("clang {}.{}", __clang_major__, __clang_minor__);
#else
  const std::string compiler = fmt::format("g++ {}.{}", __GNUC__, __GNUC_MINOR__);
#endif
#if defined(__AVX512F__)
  const char* processor = "x86-64-v4";
#elif defined(__AVX2__) && defined(__FMA__)
  const char* processor = "x86-64-v3";
#elif defined(__x86_64__)
  const char* processor = "x86-64";
#else
  const char* processor = "other";
#endif
  return fmt::format("{}, {}, glibc {}, Eigen {}.{}.{}", compiler, processor, gnu_get_libc_version(),
                     EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
}

std::string bytes_of(const State& state) {
  io::CborMap map;
  io::put_state(map, "", state);
  std::string bytes;
  map.move_to(bytes);
  return bytes;
}

// FNV-1a, 64 bits.
std::string hash_of(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  return fmt::format("{:016x}", hash);
}

// The golden values of all builds: (case, build) -> hash.
using Golden = std::map<std::pair<std::string, std::string>, std::string>;

Golden read_golden() {
  Golden golden;
  std::ifstream file(golden_file);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string name, hash, of_build;
    if (words >> name >> hash && std::getline(words >> std::ws, of_build)) golden[{name, of_build}] = hash;
  }
  return golden;
}

void write_golden(const Golden& golden) {
  std::ofstream file(golden_file);
  for (const auto& [key, hash] : golden) file << key.first << ' ' << hash << ' ' << key.second << '\n';
}

struct Sample {
  const char* name;
  int count;  // particles: more than a block (core/parallel.hpp)
  std::vector<std::string> overrides;
  bool (*is_touched)(const State&);  // whether the last state shows what the case is for
  int resumed_after = 0;             // steps; 0: straight through
};

config::Case case_of(const io::TemporaryFolder& folder, const Sample& sample) {
  std::vector<std::string> overrides{"packing.radius_spread=0.1", "output.snapshots=false"};
  overrides.insert(overrides.end(), sample.overrides.begin(), sample.overrides.end());
  return samples::periodic_case(folder, "random-dense", sample.count, overrides);
}

// Largest distance between the places of a particle in two states, over its radius.
double largest_difference(const State& a, const State& b) {
  double largest = 0.0;
  for (std::size_t n = 0; n < a.particles.size(); ++n) {
    const double moved = (a.particles.position[n] - b.particles.position[n]).norm();
    largest = std::max(largest, moved / a.particles.radius[n]);
  }
  return largest;
}

// The same of the radii of their necks; infinity where they have other necks.
double largest_neck_difference(const State& a, const State& b) {
  const Contacts &of_a = a.contacts, &of_b = b.contacts;
  if (of_a.i != of_b.i || of_a.j != of_b.j) return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t k = 0; k < of_a.size(); ++k) {
    const double ratio = of_a.neck_radius_squared[k] / of_b.neck_radius_squared[k];
    largest = std::max(largest, std::abs(std::sqrt(ratio) - 1.0));
  }
  return largest;
}

// FRIT_STATES=DIR keeps the last states there, or tells how far those of another build are.
void compare_with_other_build(const std::string& name, const State& state, const std::string& bytes) {
  const char* folder = std::getenv("FRIT_STATES");
  if (folder == nullptr) return;
  const auto path = std::filesystem::path(folder) / (name + ".cbor");
  if (!std::filesystem::exists(path)) {
    std::ofstream(path, std::ios::binary) << bytes;
    return;
  }
  const State other = io::take_state(io::CborMap::parse(io::bytes_of(path)), "");
  fmt::print("{}: {} the same bits; time {:.1e}, positions {:.1e} of a radius, necks {:.1e}\n", name,
             bytes_of(other) == bytes ? "" : "not", state.time / other.time - 1.0,
             largest_difference(state, other), largest_neck_difference(state, other));
}

State last_state(const Sample& sample) {
  const io::TemporaryFolder folder;
  const config::Case whole = case_of(folder, sample);
  Recorder recorder;
  if (sample.resumed_after == 0) {
    EXPECT_EQ(run_case(whole, {&recorder}).code, 0);
    return recorder.last;
  }
  ResultFolder files(folder / "out");
  samples::Interrupter interrupter(sample.resumed_after);
  EXPECT_EQ(run_case(whole, {&files, &interrupter}, interrupter.requests()).code, 128 + SIGTERM);
  Interrupted run = load_interrupted(folder / "out", {});
  EXPECT_EQ(resume_case(run, {&recorder}).code, 0);
  return recorder.last;
}

class Bits : public testing::TestWithParam<Sample> {};

TEST_P(Bits, AreThoseOfAnyNumberOfThreadsAndOfTheGoldenRun) {
  const Sample& sample = GetParam();
  set_threads(1);
  const State state = last_state(sample);
  EXPECT_TRUE(sample.is_touched(state)) << "the case has lost what it is for";
  const std::string bytes = bytes_of(state), hash = hash_of(bytes);
  for (const int thread_count : {2, 3, 4}) {
    set_threads(thread_count);
    EXPECT_EQ(hash_of(bytes_of(last_state(sample))), hash) << thread_count << " threads";
  }
  set_threads(1);
  compare_with_other_build(sample.name, state, bytes);
  Golden golden = read_golden();
  const auto key = std::pair(std::string(sample.name), build());
  if (std::getenv("FRIT_UPDATE")) {
    golden[key] = hash;
    write_golden(golden);
  }
  if (!golden.contains(key)) {
    GTEST_SKIP() << "the same bits for 1, 2, 3 and 4 threads, but no golden value: " << golden_file.filename()
                 << " has no line of " << build() << "; FRIT_UPDATE=1 adds it";
  }
  EXPECT_EQ(hash, golden.at(key))
      << "results have changed; where that is meant, FRIT_UPDATE=1 renews the value";
}

bool has_births(const State& state) {
  return std::ranges::any_of(state.contacts.birth_time, [](double time) { return time > 0.0; });
}

bool has_rattlers(const State& state) {
  std::vector<bool> touches(state.particles.size());
  for (const auto* ends : {&state.contacts.i, &state.contacts.j}) {
    for (const std::int32_t n : *ends) touches[static_cast<std::size_t>(n)] = true;
  }
  return std::ranges::find(touches, false) != touches.end();
}

bool is_at_equilibrium(const State& state) {
  return std::ranges::any_of(state.contacts.equilibrium_force, [](double force) { return force > 0.0; });
}

INSTANTIATE_TEST_SUITE_P(
    Golden, Bits,
    testing::Values(
        Sample{"periodic", 2100, {"stop.relative_density=0.645"}, has_births},
        Sample{"free-body",
               1100,
               {"cell.kind=free", "contact.sliding_resistance=0", "stop.time=0.02", "output.every_time=5"},
               has_rattlers},
        Sample{"explicit",
               1100,
               {"method.name=verlet", "method.density_factor=1e14", "cell.stress=-1 MPa", "stop.time=0.2"},
               has_births},
        Sample{"quasi-static-furnace",
               1100,
               {"method.name=quasi-static", "temperature.start=700 degC",
                "temperature.program=[{rate = 1, to = \"1050 degC\"}, {hold = 5}]", "stop.time=355",
                "output.every_time=120"},
               has_births},
        Sample{"equilibrium-resumed",
               1100,
               {"packing.radius_spread=0.3", "material.dihedral_angle=40 deg", "contact.neck_bending=true",
                "cell.strain_rate=[0.0, 0.0, 0.002]", "stop.time=20", "stop.relative_density=0.8"},
               is_at_equilibrium,
               3}),
    [](const auto& sample) {
      std::string name = sample.param.name;
      std::ranges::replace(name, '-', '_');
      return name;
    });

}  // namespace
}  // namespace frit::run
