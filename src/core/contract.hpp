// Checks of our own assumptions: what a function expects, what must hold inside, what it ensures.
// On when FRIT_CHECKS is defined (presets dev, audit, asan-ubsan); a user's mistakes are InputError instead.
#pragma once

#include <string>

#include "core/error.hpp"

namespace frit::detail {
[[noreturn]] inline void broken_contract(const char* kind, const char* what, const char* file, int line) {
  throw ContractError(std::string(kind) + " broken: " + what + " (" + file + ":" + std::to_string(line) +
                      ")");
}
}  // namespace frit::detail

#ifdef FRIT_CHECKS
#define FRIT_CONTRACT_(kind, what) \
  ((what) ? void() : ::frit::detail::broken_contract(kind, #what, __FILE__, __LINE__))
#else
#define FRIT_CONTRACT_(kind, what) void()
#endif
#define FRIT_EXPECT(what) FRIT_CONTRACT_("expectation", what)
#define FRIT_ASSERT(what) FRIT_CONTRACT_("assertion", what)
#define FRIT_ENSURE(what) FRIT_CONTRACT_("promise", what)
