// The packing of a case: read from its file or made by a generator, and the contacts it may bring.
#pragma once

#include <functional>
#include <optional>

#include "config/case.hpp"
#include "contact/detection.hpp"
#include "generate/packing.hpp"

namespace frit::run {

// Particles as the user ordered them (ids are rows), with their masses, held and loaded as [[particles]]
// says; positions inside a periodic cell. Throws InputError with the faults of the file, the generator's
// options and the groups. Random packings take long: `abandon` is asked meanwhile, and Abandoned thrown where
// it says so.
generate::Packing make_packing(const config::Case& whole, const std::function<bool()>& abandon = {});

// The contacts of `packing.contacts`, by rows of the packing; nothing without that key. Throws InputError.
std::optional<contact::GivenNecks> read_given_necks(const config::Case& whole, std::size_t particle_count);

}  // namespace frit::run
