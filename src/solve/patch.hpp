// Small parts of a problem, solved on their own while everything around them is held.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solve/incidence.hpp"
#include "solve/problem.hpp"

namespace frit::solve {

struct Patch {
  Problem problem;
  std::size_t active = 0;             // its first bodies are free to move, the others held
  std::vector<std::uint32_t> bodies;  // of the whole, for every body of the patch
  std::vector<std::uint32_t> edges;   // of the whole, for every edge of the patch
};

class PatchMaker {
 public:
  // The problem must outlive the maker; blocks: of its edges.
  PatchMaker(const Problem& problem, const EdgeBlocks& blocks);

  // Free to move: the seeds and what `rings` edges lead to.
  Patch around(std::span<const std::uint32_t> seeds, int rings);

 private:
  void add_neighbours(std::size_t begin, Patch& patch);
  void visit(std::uint32_t body, Patch& patch);
  void copy_bodies(Patch& patch) const;
  void copy_edges(Patch& patch) const;

  const Problem& problem_;
  Incidence incidence_;
  std::vector<std::int32_t> place_;  // in the present patch; -1: not in it
};

// Motion and multipliers of a patch within those of the whole, and back.
Solution taken_from(const Solution& whole, const Patch& patch);
void put_back(const Solution& part, const Patch& patch, Solution& whole);

// Norm of the unbalanced forces and moments that is left without some bodies.
struct Rest {
  double wanted, acceptable;
};

// The fewest bodies without which no more than the rest is left; empty when these would be many. gradient: 6
// per body.
std::vector<std::uint32_t> unbalanced_few(std::span<const double> gradient, std::size_t bodies, Rest rest);

}  // namespace frit::solve
