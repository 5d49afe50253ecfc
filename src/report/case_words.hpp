// A case in a few sentences, for people who did not write it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "config/case.hpp"

namespace frit::report {

// What was sintered, how, and until when; a sentence each.
std::vector<std::string> case_in_words(const config::Case& whole, std::size_t particles);

// {"name", "source", "properties": [[name, value with unit], ...]}. The source is that of the built-in
// material, with the properties that the case sets otherwise named.
nlohmann::json material_of(const config::Case& whole);

// A number with few digits and a length, time or temperature in the unit that suits its size: "5 um", "2.5
// h", "1050 degC".
std::string short_length(double metres);
std::string short_time(double seconds);
std::string short_temperature(double kelvin);

}  // namespace frit::report
