#include <fmt/core.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "app/commands.hpp"
#include "core/error.hpp"
#include "io/text.hpp"
#include "solve/dump.hpp"
#include "solve/gauss_seidel.hpp"
#include "solve/gradient.hpp"
#include "solve/newton.hpp"

namespace frit::app {
namespace {

enum class Solver { conjugate_gradients, gauss_seidel };

struct ReplayOptions {
  std::filesystem::path problem;
  Solver solver = Solver::conjugate_gradients;
  double tolerance = 1e-6;
};

solve::Dumped load(const std::filesystem::path& path) {
  const std::string text = io::read_file_whole(path);
  try {
    return solve::load_dump({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("{}: {}; wanted is the failed_problem.cbor of a run", path.string(), error.what()));
  }
}

int replay(const ReplayOptions& options) {
  const solve::Dumped dumped = load(options.problem);
  solve::Solution solution = dumped.start;
  solve::Options settings;
  settings.tolerance = options.tolerance;
  const solve::Report report = options.solver == Solver::gauss_seidel
                                   ? solve::solve_gauss_seidel(dumped.problem, settings, solution)
                                   : solve::solve_newton(dumped.problem, settings, solution);
  const solve::Residual residual = solve::judge(dumped.problem, solution);
  fmt::print("bodies             {}\nedges              {}\n", dumped.problem.bodies(),
             dumped.problem.edges.size());
  fmt::print("newton iterations  {}\nlinear iterations  {}\n", report.newton_iterations,
             report.linear_iterations);
  fmt::print("residual           {:.6g} (forces {:.6g}, admissible sets {:.6g}), asked {:.6g}\n",
             residual.worst(), residual.force, residual.admissible, options.tolerance);
  fmt::print("{}\n", report.converged ? "converged" : "did not converge");
  return report.converged ? 0 : 3;
}

}  // namespace

void add_replay(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("replay", "solves the problem of a step that a run wrote to a file");
  const auto options = std::make_shared<ReplayOptions>();
  const std::map<std::string, Solver> solvers{{"auto", Solver::conjugate_gradients},
                                              {"conjugate-gradients", Solver::conjugate_gradients},
                                              {"gauss-seidel", Solver::gauss_seidel}};
  command->add_option("PROBLEM", options->problem, "problem dump (failed_problem.cbor)")->required();
  command->add_option("--solver", options->solver, "auto, conjugate-gradients or gauss-seidel")
      ->transform(CLI::CheckedTransformer(solvers).description("NAME"));
  command->add_option("--tolerance", options->tolerance, "residual that counts as solved")
      ->check(CLI::PositiveNumber);
  command->callback([options, &chosen] { chosen = [options] { return replay(*options); }; });
}

}  // namespace frit::app
