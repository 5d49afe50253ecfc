// A long piece of work that nobody waits for any more, before there is anything that could be kept.
#pragma once

#include <stdexcept>

namespace frit {

// Thrown where whoever asked for the work says so. No fault of anybody; caught where signals and limits are
// known.
class Abandoned : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace frit
