// What a comparison looks like: text for the terminal, CSV, a page in Markdown with plots.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analyze/comparison.hpp"

namespace frit::analyze {

// The few figures that most readers want, each as a table; which keys differ; or why there is nothing to
// compare.
std::string to_text(const Comparison& comparison);

// Writes compare.csv (all figures), compare.md and its plots (*.svg) into the folder, which is made where it
// is not there.
void write_comparison(const std::filesystem::path& folder, const Comparison& comparison,
                      const std::vector<Result>& results);

}  // namespace frit::analyze
