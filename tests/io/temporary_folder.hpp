// What the tests of io share: a folder of their own, files with given text, the faults of a call.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "io/frame.hpp"

namespace frit::io {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    // In memory where there is such a place: thousands of small files are slow on a busy disk.
    const bool in_memory = std::filesystem::is_directory("/dev/shm");
    const auto parent =
        in_memory ? std::filesystem::path("/dev/shm") : std::filesystem::temp_directory_path();
    std::string name = (parent / "frit-io-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(folder_); }

  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
  std::filesystem::path write(const std::string& name, std::string_view text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      found.push_back(entry.path().filename().string());
    }
    std::ranges::sort(found);
    return found;
  }

 private:
  std::filesystem::path folder_;
};

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// The faults that a call reports, without the folder before the file's name.
template <class Call>
std::vector<std::string> faults_of(const std::filesystem::path& path, Call&& call) {
  try {
    call();
  } catch (const InputError& error) {
    auto faults = error.faults();
    const auto folder = path.parent_path().string() + "/";
    for (auto& fault : faults) {
      for (auto at = fault.find(folder); at != fault.npos; at = fault.find(folder))
        fault.erase(at, folder.size());
    }
    return faults;
  }
  return {};
}

template <class Error, class Call>
std::string message_of(Call&& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

template <class Value>
bool same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

inline bool same_bits(const Vec3& a, const Vec3& b) { return std::memcmp(a.data(), b.data(), sizeof a) == 0; }

inline void expect_same_array(const NamedArray& a, const NamedArray& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.components, b.components) << a.name;
  ASSERT_EQ(a.values.index(), b.values.index()) << a.name;
  const bool same = std::visit(
      [&](const auto& values) {
        return same_bits(values, std::get<std::decay_t<decltype(values)>>(b.values));
      },
      a.values);
  EXPECT_TRUE(same) << a.name;
}

// A frame with awkward numbers: denormal, negative zero, huge, without a short decimal form.
inline Frame awkward_frame(std::size_t count) {
  Frame frame;
  frame.time = 1.0 / 3.0;
  std::vector<double> neck, velocity;
  std::vector<std::int64_t> coordination;
  for (std::size_t row = 0; row < count; ++row) {
    const double s = static_cast<double>(row);
    frame.ids.push_back(static_cast<std::int64_t>(7 * row + 2));
    frame.positions.emplace_back(s * 1e-6 / 3.0, row == 0 ? -0.0 : -s * 1e300, 4.9406564584124654e-324 * s);
    frame.radii.push_back(5e-6 / (s + 1.1));
    neck.push_back(row % 5 == 3 ? std::numeric_limits<double>::quiet_NaN() : s);
    for (const double factor : {1.0, -0.1, 3e-7}) velocity.push_back(factor * (s + 0.7));
    coordination.push_back(static_cast<std::int64_t>(row * 100'000'000'000'000'003ULL) - 4);
  }
  frame.arrays = {{"neck", 1, neck}, {"velocity", 3, velocity}, {"coordination", 1, coordination}};
  return frame;
}

}  // namespace frit::io
