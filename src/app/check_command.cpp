#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "app/case_options.hpp"
#include "app/commands.hpp"
#include "config/case_writer.hpp"
#include "contact/sintering_law.hpp"
#include "run/machine.hpp"
#include "run/neck_law.hpp"
#include "run/setup.hpp"

namespace frit::app {
namespace {

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void print_counts(const run::Setup& setup) {
  const auto particles = static_cast<double>(setup.state.particles.size());
  const auto contacts = static_cast<double>(setup.state.contacts.size());
  fmt::print("particles                {}\n", setup.state.particles.size());
  fmt::print("contacts                 {}\n", setup.state.contacts.size());
  fmt::print("coordination             {:.4g}\n", 2.0 * contacts / particles);
  fmt::print("relative density         {}\n",
             std::isnan(setup.density) ? "none: fewer than 50 particles in the core of the free body"
                                       : fmt::format("{:.6g}", setup.density));
  fmt::print("mean radius              {:.6g} m\n", setup.reference.mean_radius);
  fmt::print("mean mass                {:.6g} kg\n", mean_of(setup.state.particles.mass));
}

void print_scales(const run::Setup& setup) {
  const contact::SinteringLaw& law = setup.settings.law;
  const double R = setup.reference.mean_radius;
  const auto scale_at = [&](double T) {
    const double delta_b = setup.heating.diffusion.delta_b(T);
    return fmt::format("{:.6g} s at {:.6g} K (Delta_b {:.6g} m^5/(N s))",
                       run::time_scale_of(R, law.surface_energy, delta_b), T, delta_b);
  };
  fmt::print("time scale R^4/(gamma Delta_b)\n  at the start           {}\n", scale_at(setup.heating.start));
  fmt::print("  at the hottest         {}\n", scale_at(setup.heating.hottest));
  if (setup.state.contacts.size() == 0) return;
  const double delta_b = setup.heating.diffusion.delta_b(setup.heating.hottest);
  const double neck = mean_of(run::necks_of(law, setup.state, delta_b).neck_radius);
  const contact::Pairing pair(R, R);
  fmt::print("mean neck radius         {:.6g} m (neck ratio {:.4g})\n", neck, neck / R);
  fmt::print("attraction f_a           {:.6g} N at the mean radius and neck\n",
             contact::attraction_force(law, pair, neck));
  const double viscosity = contact::resistances(law, pair, neck * neck, delta_b).normal;
  fmt::print("m/c_n                    {:.6g} s at the mean neck, at the hottest\n",
             mean_of(setup.state.particles.mass) / viscosity);
}

int check(const CaseOptions& options) {
  const run::Setup setup = run::make_setup(options.load());
  fmt::print("{}\n", config::write_case(setup.whole, run::version()));
  print_counts(setup);
  print_scales(setup);
  for (const std::string& warning : setup.warnings) fmt::print("warning: {}\n", warning);
  return 0;
}

}  // namespace

void add_check(CLI::App& app, Command& chosen) {
  CLI::App* command =
      app.add_subcommand("check", "every fault of a case, or the resolved case and what follows from it");
  const auto options = std::make_shared<CaseOptions>();
  options->add_to(*command);
  command->callback([options, &chosen] { chosen = [options] { return check(*options); }; });
}

}  // namespace frit::app
