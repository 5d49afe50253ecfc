// A map of names to numbers, texts and arrays as CBOR (a binary form of JSON), one level deep.
//
// Arrays are byte strings, little endian, whose type the reader knows. One of more than one entry that holds
// nothing but zeros is written as the number of its entries, unless asked to be in full.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace frit::io {

static_assert(std::endian::native == std::endian::little, "arrays are written as they stand in memory");

class CborMap {
 public:
  using Bytes = std::vector<std::uint8_t>;

  void put(const std::string& name, double value) { values_[name] = value; }
  void put(const std::string& name, std::int64_t value) { values_[name] = value; }
  void put(const std::string& name, std::string value) { values_[name] = std::move(value); }
  // T holds nothing but numbers: its bytes are what is written.
  enum class Zeros { counted, in_full };
  template <class T>
  void put_array(const std::string& name, const std::vector<T>& values, Zeros zeros = Zeros::counted) {
    Bytes bytes(values.size() * sizeof(T));
    // NOLINTNEXTLINE(bugprone-undefined-memory-manipulation): Eigen's small vectors are their numbers
    if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    put_bytes(name, std::move(bytes), zeros == Zeros::counted ? sizeof(T) : 0);
  }

  // Each throws InputError when the name is missing or stands for something else.
  double real(const std::string& name) const;
  std::int64_t whole(const std::string& name) const;
  const std::string& text(const std::string& name) const;
  // Entries of an array that is written in full: a number that a file's length vouches for.
  std::size_t count(const std::string& name, std::size_t entry_bytes) const;
  // The array must have `count` entries.
  template <class T>
  std::vector<T> array(const std::string& name, std::size_t count) const {
    const Bytes* bytes = bytes_of(name, count, sizeof(T));
    std::vector<T> values(count);
    if (count == 0) return values;
    if (bytes == nullptr) {
      std::memset(static_cast<void*>(values.data()), 0, count * sizeof(T));
    } else {
      std::memcpy(static_cast<void*>(values.data()), bytes->data(), bytes->size());
    }
    return values;
  }

  // Appends the map to `bytes`; its arrays are gone afterwards, to spare memory.
  void move_to(std::string& bytes);
  // Throws InputError when the bytes are not such a map.
  static CborMap parse(std::string_view bytes);

 private:
  using Value = std::variant<double, std::int64_t, std::string, Bytes>;
  class Reader;

  // Zeros are counted as entries of so many bytes; 0: not counted.
  void put_bytes(const std::string& name, Bytes bytes, std::size_t entry_bytes);
  // Nothing where only the number of zeros was written.
  const Bytes* bytes_of(const std::string& name, std::size_t count, std::size_t entry_bytes) const;
  const Value& value(const std::string& name) const;

  std::map<std::string, Value> values_;
};

}  // namespace frit::io
