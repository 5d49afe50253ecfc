// What can go wrong, by whose fault it is. The program's exit codes follow (docs/interface in the README).
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace frit {

// The user's input is wrong (exit code 2). All faults found together, each naming its file, line or key.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<std::string> faults)
      : std::runtime_error(join(faults)), faults_(std::move(faults)) {}
  explicit InputError(const std::string& fault) : InputError(std::vector<std::string>{fault}) {}
  const std::vector<std::string>& faults() const { return faults_; }

 private:
  static std::string join(const std::vector<std::string>& faults) {
    std::string text;
    for (const auto& fault : faults) text += (text.empty() ? "" : "\n") + fault;
    return text;
  }
  std::vector<std::string> faults_;
};

// The machine failed us: disk, memory, a file that cannot be written (exit code 1).
class MachineError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A broken assumption of our own (exit code 5). Thrown by the macros of contract.hpp.
class ContractError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace frit
