// Collects everything that is wrong with a case, so that it is told at once.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "config/document.hpp"

namespace frit::config {

class Faults {
 public:
  // `file` is named in every fault of the file; `overrides` are the texts of --set.
  Faults(std::string file, std::vector<std::string> overrides)
      : file_(std::move(file)), overrides_(std::move(overrides)) {}

  // A fault of `key` where it stands; `key` may be empty (a fault of the text).
  void add(Place place, const std::string& key, const std::string& what);
  // A fault of something that is not there.
  void add_missing(const std::string& key, const std::string& what) { add({}, key, what); }

  bool has(const std::string& key) const { return keys_.contains(key); }

  // Throws InputError with all faults, in the order of the file, overrides last; returns where there are
  // none.
  void throw_if_any();

 private:
  struct Fault {
    Place place;
    std::string text;
  };
  std::string file_;
  std::vector<std::string> overrides_;
  std::vector<Fault> faults_;
  std::set<std::string> keys_;
};

// Which keys were given, and where. Items of lists: "temperature.program[0].rate".
using Given = std::map<std::string, Place>;

}  // namespace frit::config
