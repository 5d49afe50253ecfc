#include "config/faults.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <tuple>

#include "core/error.hpp"

namespace frit::config {

void Faults::add(Place place, const std::string& key, const std::string& what) {
  std::string text = file_ + ": ";
  if (place.override_index != Place::in_file) {
    text = "--set " + overrides_.at(static_cast<std::size_t>(place.override_index)) + ": ";
  } else if (place.line > 0) {
    text = fmt::format("{}:{}: ", file_, place.line);
  }
  if (!key.empty()) text += key + ": ";
  faults_.push_back({place, text + what});
  keys_.insert(key);
}

void Faults::throw_if_any() {
  if (faults_.empty()) return;
  std::stable_sort(faults_.begin(), faults_.end(), [](const Fault& a, const Fault& b) {
    return std::tie(a.place.override_index, a.place.line) < std::tie(b.place.override_index, b.place.line);
  });
  std::vector<std::string> texts;
  for (const Fault& fault : faults_) texts.push_back(fault.text);
  throw InputError(std::move(texts));
}

}  // namespace frit::config
