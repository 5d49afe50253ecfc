// Observables again, or anew: from stored snapshots or measured centres, against any reference.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analyze/centres.hpp"
#include "observe/reference.hpp"
#include "observe/row.hpp"

namespace frit::analyze {

// What is found at one time.
struct Findings {
  observe::Row row;              // as in series.csv
  observe::Row network;          // network_row.hpp
  nlohmann::json distributions;  // histogram of each quantity
};

// Against the reference; the same particles.
Findings look_at(const observe::Reference& reference, const Moment& moment);

// All snapshots of a result, one after another. `reference` is empty (the first snapshot), the number of a
// snapshot, or a file of particles. InputError where files are missing, cannot be understood, or hold other
// particles.
std::vector<Findings> analyze_result(const std::filesystem::path& folder, const std::string& reference);

// Measured particles. `reference` is empty (the first time) or the number of a time, from 0.
std::vector<Findings> analyze_centres(const Centres& centres, const std::string& reference);

// Writes series.csv, network.csv and distributions.json into the folder, which is made where it is not there.
void write_findings(const std::filesystem::path& folder, const std::vector<Findings>& findings);

}  // namespace frit::analyze
