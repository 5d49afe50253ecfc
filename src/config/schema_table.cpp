#include <span>
#include <vector>

#include "config/slots.hpp"
#include "core/constants.hpp"

namespace frit::config {
namespace {

constexpr Range positive{.least = Bound{0.0, Edge::excluded}};
constexpr Range not_negative{.least = Bound{0.0}};
constexpr Range whole_from_one{.least = Bound{1}, .most = Bound{2147483647}};
constexpr Range open_fraction{.least = Bound{0.0, Edge::excluded}, .most = Bound{1.0, Edge::excluded}};
constexpr auto not_yet = Status::not_available_yet;

const ListAccess temperature_steps{
    [](const Case& whole) { return whole.temperature.program.size(); },
    [](Case& whole) { whole.temperature.program.emplace_back(); },
    [](Case& whole, std::size_t n) { return Target{.whole = whole, .step = &whole.temperature.program[n]}; }};
const ListAccess particle_groups{
    [](const Case& whole) { return whole.particles.size(); },
    [](Case& whole) { whole.particles.emplace_back(); },
    [](Case& whole, std::size_t n) { return Target{.whole = whole, .group = &whole.particles[n]}; }};

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Key> packing_keys() {
  return {
      {.path = "title",
       .type = Type::text,
       .slot = in_case<&Case::title>(),
       .fallback = "\"\"",
       .sentence = "A line about the case, shown in reports."},
      {.path = "packing.file",
       .type = Type::path,
       .slot = in_case<&Case::packing, &Packing::file>(),
       .sentence =
           "Packing to read: a table with the columns x, y, z and radius, units in brackets (\"x [um]\"), "
           "else SI; relative to the case file. Either this or packing.generate."},
      {.path = "packing.contacts",
       .type = Type::path,
       .slot = in_case<&Case::packing, &Packing::contacts>(),
       .applies = Applies::file_packing,
       .sentence = "First contacts to read: columns i and j (zero-based rows of the packing) and, if wanted, "
                   "neck_radius. Without it contacts follow from the geometry."},
      {.path = "packing.generate",
       .type = Type::choice,
       .slot = in_case<&Case::packing, &Packing::generate>(),
       .choices = {{"random-dense"},
                   {"simple-cubic"},
                   {"body-centred-cubic"},
                   {"face-centred-cubic"},
                   {"random-sequential", not_yet},
                   {"gas-compacted", not_yet},
                   {"deposit", not_yet}},
       .sentence = "Packing to make. Either this or packing.file."},
      {.path = "packing.count",
       .type = Type::integer,
       .slot = in_case<&Case::packing, &Packing::count>(),
       .fallback = "4000",
       .range = whole_from_one,
       .applies = Applies::generated_packing,
       .sentence = "Number of particles; lattices take the largest cube of unit cells not above it."},
      {.path = "packing.radius",
       .type = Type::quantity,
       .quantity = Quantity::length,
       .slot = in_case<&Case::packing, &Packing::radius>(),
       .fallback = "5 um",
       .range = positive,
       .applies = Applies::generated_packing,
       .sentence = "Mean radius of the particles."},
      {.path = "packing.radius_spread",
       .type = Type::quantity,
       .slot = in_case<&Case::packing, &Packing::radius_spread>(),
       .fallback = "0.0",
       .range = {.least = Bound{0.0}, .most = Bound{1.0, Edge::excluded}},
       .applies = Applies::random_dense,
       .sentence = "Relative standard deviation of the radii, which are log-normal."},
      {.path = "packing.relative_density",
       .type = Type::quantity,
       .slot = in_case<&Case::packing, &Packing::relative_density>(),
       .fallback = "0.64",
       .range = {.least = Bound{0.60}, .most = Bound{0.66}},
       .applies = Applies::random_dense,
       .sentence = "Share of the volume that the spheres fill. A contact network needs 0.63 or more."},
      {.path = "packing.seed",
       .type = Type::integer,
       .slot = in_case<&Case::packing, &Packing::seed>(),
       .fallback = "1",
       .range = not_negative,
       .sentence = "Start of the random numbers; the same seed gives the same packing."},
  };
}

std::vector<Key> cell_keys() {
  return {
      {.path = "cell.kind",
       .type = Type::choice,
       .slot = in_case<&Case::cell, &CellSettings::kind>(),
       .fallback = "free",
       .choices = {{"free"}, {"periodic"}},
       .sentence = "A body in free space, or a cell repeated in all directions."},
      {.path = "cell.size",
       .type = Type::vector,
       .quantity = Quantity::length,
       .slot = in_case<&Case::cell, &CellSettings::size>(),
       .range = positive,
       .applies = Applies::periodic_file,
       .sentence =
           "Edges of the periodic cell; needed with packing.file, brought along by generated packings."},
      {.path = "cell.stress",
       .type = Type::scalar_or_vector,
       .quantity = Quantity::stress,
       .slot = in_case<&Case::cell, &CellSettings::stress>(),
       .fallback = "0 Pa",
       .applies = Applies::periodic,
       .sentence =
           "Stress on the cell, tension positive, held while the cell changes its size. Not together with "
           "cell.strain_rate."},
      {.path = "cell.strain_rate",
       .type = Type::vector,
       .quantity = Quantity::strain_rate,
       .slot = in_case<&Case::cell, &CellSettings::strain_rate>(),
       .applies = Applies::periodic,
       .sentence = "Rate of the cell's logarithmic strain along x, y and z, extension positive, instead of a "
                   "stress."},
  };
}

std::vector<Key> material_keys() {
  return {
      {.path = "material.use",
       .type = Type::text,
       .slot = in_case<&Case::material, &Material::use>(),
       .sentence = "Built-in material (frit materials lists them); keys given beside it override its values. "
                   "Without it every property below is needed."},
      {.path = "material.density",
       .type = Type::quantity,
       .quantity = Quantity::density,
       .slot = in_case<&Case::material, &Material::density>(),
       .range = positive,
       .sentence = "Density of the solid."},
      {.path = "material.surface_energy",
       .type = Type::quantity,
       .quantity = Quantity::surface_energy,
       .slot = in_case<&Case::material, &Material::surface_energy>(),
       .range = positive,
       .sentence = "Surface energy gamma."},
      {.path = "material.dihedral_angle",
       .type = Type::quantity,
       .quantity = Quantity::angle,
       .slot = in_case<&Case::material, &Material::dihedral_angle>(),
       .range = {.least = Bound{0.0, Edge::excluded}, .most = Bound{pi}},
       .sentence = "Dihedral angle psi between the surfaces at a neck; necks stop growing at sin(psi/2)."},
      {.path = "material.atomic_volume",
       .type = Type::quantity,
       .quantity = Quantity::volume,
       .slot = in_case<&Case::material, &Material::atomic_volume>(),
       .range = positive,
       .sentence = "Volume Omega of an atom (for compounds, of the slowest species)."},
      {.path = "material.melting_temperature",
       .type = Type::quantity,
       .quantity = Quantity::temperature,
       .slot = in_case<&Case::material, &Material::melting_temperature>(),
       .range = positive,
       .sentence =
           "Temperature at which the solid melts; a furnace that passes it is warned of. Not needed."},
      {.path = "material.boundary_diffusion.prefactor",
       .type = Type::quantity,
       .quantity = Quantity::boundary_diffusion,
       .slot = in_case<&Case::material, &Material::boundary_diffusion, &BoundaryDiffusion::prefactor>(),
       .range = positive,
       .sentence = "Thickness times diffusion coefficient of the grain boundary at infinite temperature."},
      {.path = "material.boundary_diffusion.activation_energy",
       .type = Type::quantity,
       .quantity = Quantity::molar_energy,
       .slot =
           in_case<&Case::material, &Material::boundary_diffusion, &BoundaryDiffusion::activation_energy>(),
       .range = not_negative,
       .sentence = "Activation energy Q of grain boundary diffusion."},
  };
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Key> contact_keys() {
  return {
      {.path = "contact.attraction",
       .type = Type::choice,
       .slot = in_case<&Case::contact, &ContactSettings::attraction>(),
       .fallback = "bouvard-mcmeeking",
       .choices = {{"bouvard-mcmeeking"}, {"parhami-mcmeeking"}},
       .sentence =
           "Sintering attraction: (9/8) pi R gamma, or pi gamma [4 R (1 - cos(psi/2)) + r sin(psi/2)]. "
           "A diffusivity fitted with one is wrong by about 3 with the other."},
      {.path = "contact.pull",
       .type = Type::choice,
       .slot = in_case<&Case::contact, &ContactSettings::pull>(),
       .fallback = "bilateral",
       .choices = {{"bilateral"}, {"unilateral"}},
       .sentence =
           "A neck pulled harder than its attraction stretches viscously (bilateral) or opens (unilateral)."},
      {.path = "contact.closing",
       .type = Type::choice,
       .slot = in_case<&Case::contact, &ContactSettings::closing>(),
       .fallback = "viscous",
       .choices = {{"viscous"}, {"rigid"}},
       .sentence =
           "How a gap that closes within a step resists: like the neck that is born there, which also "
           "attracts for the rest of the step (viscous), or rigidly until the next step (rigid)."},
      {.path = "contact.sliding_resistance",
       .type = Type::quantity,
       .slot = in_case<&Case::contact, &ContactSettings::sliding_resistance>(),
       .fallback = "0.01",
       .range = {.least = Bound{0.0}, .most = Bound{0.5, Edge::excluded}},
       .sentence = "Factor eta of the resistance to sliding at a neck."},
      {.path = "contact.neck_bending",
       .type = Type::boolean,
       .slot = in_case<&Case::contact, &ContactSettings::neck_bending>(),
       .fallback = "false",
       .sentence = "Whether necks resist rolling and twisting."},
      {.path = "contact.spins",
       .type = Type::choice,
       .slot = in_case<&Case::contact, &ContactSettings::spins>(),
       .fallback = "free",
       .choices = {{"free"}, {"blocked"}},
       .sentence = "Whether particles may rotate."},
      {.path = "contact.equilibrium_radius",
       .type = Type::choice,
       .slot = in_case<&Case::contact, &ContactSettings::equilibrium_radius>(),
       .fallback = "equivalent",
       .choices = {{"equivalent"}, {"smaller"}},
       .sentence = "Neck radius at which growth ends: min(R sin(psi/2), R1, R2) or min(R1, R2) sin(psi/2)."},
      {.path = "contact.birth_neck_ratio",
       .type = Type::quantity,
       .slot = in_case<&Case::contact, &ContactSettings::birth_neck_ratio>(),
       .fallback = "0.03",
       .range = open_fraction,
       .sentence = "Least neck radius over R of a neck born during the run."},
      {.path = "contact.initial_neck_ratio",
       .type = Type::quantity,
       .slot = in_case<&Case::contact, &ContactSettings::initial_neck_ratio>(),
       .fallback = "0.0",
       .range = {.least = Bound{0.0}, .most = Bound{1.0, Edge::excluded}},
       .sentence =
           "Least neck radius over R of the first contacts; the neck of the overlap counts where it is "
           "larger, contact.birth_neck_ratio where both are zero."},
  };
}

std::vector<Key> temperature_keys() {
  return {
      {.path = "temperature.start",
       .type = Type::quantity,
       .quantity = Quantity::temperature,
       .slot = in_case<&Case::temperature, &TemperatureProgram::start>(),
       .fallback = "1050 degC",
       .range = positive,
       .sentence = "Temperature at the start of the run."},
      {.path = "temperature.program",
       .type = Type::table_list,
       .slot = temperature_steps,
       .fallback = "[]",
       .sentence =
           "Ramps { rate, to } and holds { hold }, one after the other; the last temperature holds on."},
      {.path = "temperature.program.rate",
       .type = Type::quantity,
       .quantity = Quantity::temperature_rate,
       .slot = in_step<&TemperatureStep::rate>(),
       .sentence = "Rate of a ramp; a positive rate also cools where `to` is lower."},
      {.path = "temperature.program.to",
       .type = Type::quantity,
       .quantity = Quantity::temperature,
       .slot = in_step<&TemperatureStep::to>(),
       .range = positive,
       .sentence = "Temperature at the end of a ramp."},
      {.path = "temperature.program.hold",
       .type = Type::quantity,
       .quantity = Quantity::time,
       .slot = in_step<&TemperatureStep::hold>(),
       .range = positive,
       .sentence = "How long the temperature is held."},
  };
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Key> method_keys() {
  return {
      {.path = "method.name",
       .type = Type::choice,
       .slot = in_case<&Case::method, &Method::name>(),
       .fallback = "contact-dynamics",
       .choices = {{"contact-dynamics"}, {"quasi-static"}, {"verlet"}, {"mean-field"}},
       .sentence = "How particles move: implicit contact dynamics with the real mass, the same without mass, "
                   "explicit dynamics with a multiplied density, or all with the macroscopic strain."},
      {.path = "method.inertia",
       .type = Type::choice,
       .slot = in_case<&Case::method, &Method::inertia>(),
       .fallback = "overdamped",
       .choices = {{"overdamped"}, {"dynamic"}},
       .applies = Applies::implicit,
       .sentence = "Each step starts from rest, with the true mass, or keeps its velocities."},
      {.path = "method.solver",
       .type = Type::choice,
       .slot = in_case<&Case::method, &Method::solver>(),
       .fallback = "auto",
       .choices = {{"auto"}, {"conjugate-gradients"}, {"gauss-seidel"}},
       .applies = Applies::implicit,
       .sentence =
           "What solves the problem of a step; gauss-seidel is the independent check for small cases."},
      {.path = "method.time_step",
       .type = Type::quantity,
       .quantity = Quantity::time,
       .slot = in_case<&Case::method, &Method::time_step>(),
       .fallback = "auto",
       .range = positive,
       .automatic = Automatic::accepted,
       .sentence = "A fixed time step; auto: controlled by method.accuracy, or a share of the limit of "
                   "stability (verlet)."},
      {.path = "method.accuracy",
       .type = Type::quantity,
       .slot = in_case<&Case::method, &Method::accuracy>(),
       .fallback = "0.01",
       .range = open_fraction,
       .applies = Applies::implicit,
       .sentence = "Largest accepted relative error of density and necks over the run, estimated; for "
                   "automatic steps."},
      {.path = "method.tolerance",
       .type = Type::quantity,
       .slot = in_case<&Case::method, &Method::tolerance>(),
       .fallback = "auto",
       .range = open_fraction,
       .automatic = Automatic::accepted,
       .applies = Applies::implicit,
       .sentence = "Relative force residual at which the problem of a step counts as solved; auto: 5e-3 of "
                   "method.accuracy, 5e-5 at most."},
      {.path = "method.largest_step",
       .type = Type::quantity,
       .quantity = Quantity::time,
       .slot = in_case<&Case::method, &Method::largest_step>(),
       .fallback = "auto",
       .range = positive,
       .automatic = Automatic::accepted,
       .applies = Applies::implicit,
       .sentence = "Largest time step that the error control may take."},
      {.path = "method.smallest_step",
       .type = Type::quantity,
       .quantity = Quantity::time,
       .slot = in_case<&Case::method, &Method::smallest_step>(),
       .fallback = "auto",
       .range = positive,
       .automatic = Automatic::accepted,
       .applies = Applies::implicit,
       .sentence = "Time step below which a run gives up."},
      {.path = "method.density_factor",
       .type = Type::quantity,
       .slot = in_case<&Case::method, &Method::density_factor>(),
       .fallback = "1",
       .range = {.least = Bound{1.0}},
       .applies = Applies::verlet,
       .sentence = "Factor on the particles' mass and moment of inertia, for longer steps."},
      {.path = "method.cell_inertia",
       .type = Type::quantity,
       .slot = in_case<&Case::method, &Method::cell_inertia>(),
       .fallback = "1",
       .range = positive,
       .applies = Applies::verlet,
       .sentence = "Inertia of a periodic cell under stress, over that of the particles' (multiplied) mass "
                   "spread evenly over it."},
  };
}

std::vector<Key> stop_keys() {
  return {
      {.path = "stop.time",
       .type = Type::quantity,
       .quantity = Quantity::time,
       .slot = in_case<&Case::stop, &Stop::time>(),
       .range = positive,
       .sentence =
           "Time at which the run ends, reached exactly. At least one key of [stop] is needed; the first "
           "that is reached ends the run."},
      {.path = "stop.relative_density",
       .type = Type::quantity,
       .slot = in_case<&Case::stop, &Stop::relative_density>(),
       .range = {.least = Bound{0.0, Edge::excluded}, .most = Bound{1.0}},
       .sentence = "Relative density at which the run ends, reached exactly."},
  };
}

std::vector<Key> output_keys() {
  return {
      {.path = "output.every_density",
       .type = Type::quantity,
       .slot = in_case<&Case::output, &Output::every_density>(),
       .fallback = "0.01",
       .range = open_fraction,
       .sentence = "An output at each such change of the relative density. The default holds while neither "
                   "output.every_time nor output.every_steps is given; several may be given."},
      {.path = "output.every_time",
       .type = Type::quantity,
       .quantity = Quantity::time,
       .slot = in_case<&Case::output, &Output::every_time>(),
       .range = positive,
       .sentence = "An output at each multiple of this time, which is hit exactly."},
      {.path = "output.every_steps",
       .type = Type::integer,
       .slot = in_case<&Case::output, &Output::every_steps>(),
       .range = whole_from_one,
       .sentence = "An output each time so many steps are done."},
      {.path = "output.snapshots",
       .type = Type::boolean,
       .slot = in_case<&Case::output, &Output::snapshots>(),
       .fallback = "true",
       .sentence = "Whether each output also writes particles and contacts."},
      {.path = "output.formats",
       .type = Type::choice_list,
       .slot = in_case<&Case::output, &Output::formats>(),
       .fallback = "[\"vtp\"]",
       .choices = {{"vtp"}, {"xyz"}, {"lammps"}},
       .sentence =
           "Files of each snapshot: VTP with a ParaView collection (particles and contacts; reports and "
           "frit analyze need it), extended XYZ, LAMMPS dump (particles)."},
      {.path = "output.report",
       .type = Type::boolean,
       .slot = in_case<&Case::output, &Output::report>(),
       .fallback = "true",
       .sentence = "Whether the run ends with report.html, which shows it in a browser."},
      {.path = "output.checkpoint_every_steps",
       .type = Type::integer,
       .slot = in_case<&Case::output, &Output::checkpoint_every_steps>(),
       .fallback = "0",
       .range = not_negative,
       .sentence =
           "Steps between checkpoints, from which frit resume goes on; 0: by wall clock, every 5 minutes."},
  };
}

std::vector<Key> particle_keys() {
  return {
      {.path = "particles",
       .type = Type::table_list,
       .slot = particle_groups,
       .fallback = "[]",
       .sentence = "Groups of particles that are held or loaded."},
      {.path = "particles.ids",
       .type = Type::integer_list,
       .slot = in_group<&ParticleGroup::ids>(),
       .range = not_negative,
       .sentence = "The group's particles, as zero-based rows of the packing; needed."},
      {.path = "particles.fixed",
       .type = Type::boolean,
       .slot = in_group<&ParticleGroup::fixed>(),
       .fallback = "false",
       .sentence = "Whether they neither move nor rotate."},
      {.path = "particles.force",
       .type = Type::vector,
       .quantity = Quantity::force,
       .slot = in_group<&ParticleGroup::force>(),
       .fallback = "[0, 0, 0]",
       .sentence = "Force on each of them."},
      {.path = "particles.inert",
       .type = Type::boolean,
       .status = not_yet,
       .sentence = "Whether they touch rigidly, without sintering."},
      {.path = "particles.material",
       .type = Type::text,
       .status = not_yet,
       .sentence = "Another material for them."},
  };
}

std::vector<Key> loading_keys() {
  return {
      {.path = "wall",
       .type = Type::table_list,
       .status = not_yet,
       .sentence = "Plane walls: dies, substrates, punches."},
      {.path = "load", .type = Type::table, .status = not_yet, .sentence = "Gravity and loads on walls."},
  };
}

}  // namespace

std::span<const Key> schema() {
  static const std::vector<Key> keys = [] {
    std::vector<Key> all;
    for (const auto& section :
         {packing_keys(), cell_keys(), material_keys(), contact_keys(), temperature_keys(), method_keys(),
          stop_keys(), output_keys(), particle_keys(), loading_keys()})
      all.insert(all.end(), section.begin(), section.end());
    return all;
  }();
  return keys;
}

}  // namespace frit::config
