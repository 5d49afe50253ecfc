// Every reader of files under one signature: for the fuzzer (target.cpp) and for the cases it has found
// (seeds_test.cpp).
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace frit::fuzz {

// Takes any bytes, as if they were a file's: an answer or an InputError, nothing else. Readers of files get a
// copy on disk.
using Reader = std::function<void(std::string_view)>;

const std::map<std::string, Reader>& readers();

}  // namespace frit::fuzz
