// A TOML document as a plain tree: what the reader of cases works on, whatever library parsed the text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace frit::config {

// Where a value stands: a line of the case file, or one of the overrides.
struct Place {
  static constexpr int in_file = -1;
  int line = 0;
  int override_index = in_file;
};

struct Entry;
struct Node;
struct Table {
  std::vector<Entry> entries;  // keys are unique
  Entry* find(std::string_view key);
  const Entry* find(std::string_view key) const;
};
struct List {
  std::vector<Node> items;
};
struct DateOrTime {};  // TOML knows them; no key of a case wants one

struct Node {
  std::variant<std::string, std::int64_t, double, bool, DateOrTime, List, Table> value;
  Place place;

  template <class T>
  const T* as() const {
    return std::get_if<T>(&value);
  }
  template <class T>
  T* as() {
    return std::get_if<T>(&value);
  }
};

struct Entry {
  std::string key;
  Place place;
  Node node;
};

inline const Entry* Table::find(std::string_view key) const {
  for (const auto& entry : entries)
    if (entry.key == key) return &entry;
  return nullptr;
}
inline Entry* Table::find(std::string_view key) {
  return const_cast<Entry*>(static_cast<const Table*>(this)->find(key));
}

}  // namespace frit::config
