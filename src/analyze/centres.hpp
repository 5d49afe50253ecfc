// Measured particles, e.g. from tomography: tables of centres and radii at two or more times.
#pragma once

#include <filesystem>
#include <vector>

#include "analyze/moment.hpp"

namespace frit::analyze {

struct Centres {
  std::vector<std::filesystem::path> files;  // particles at each time, any format that frit reads
  std::vector<std::filesystem::path>
      contacts;               // tables i, j [, neck_radius], one a file; none: from the distances
  std::vector<double> times;  // [s], one a file; none: not known
  double gap = 0.0;           // in mean radii: pairs nearer than this are in contact
  bool common_only = false;   // leave out particles that are not in every file
};

// The moments in the order of the files, ids matched by the column id (or rows). InputError with all faults:
// files, numbers of files that do not fit, ids that are not in all of them.
std::vector<Moment> read_centres(const Centres& centres);

}  // namespace frit::analyze
