// A case as the program runs it: what a case file says, in SI, with every default filled in.
// Made by load_case or parse_case (case_reader.hpp); a Case built by hand starts blank, without defaults.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/vec.hpp"

namespace frit::config {

enum class Generator : std::uint8_t {
  random_dense,
  simple_cubic,
  body_centred_cubic,
  face_centred_cubic,
  random_sequential,
  gas_compacted,
  deposit,
};

// Either `file` or `generate` is set, never both; the other members up to `seed` belong to `generate`.
struct Packing {
  std::optional<std::filesystem::path> file;      // absolute
  std::optional<std::filesystem::path> contacts;  // absolute; only with `file`
  std::optional<Generator> generate;
  std::int64_t count = 0;
  double radius = 0.0;            // [m], mean
  double radius_spread = 0.0;     // relative standard deviation, log-normal
  double relative_density = 0.0;  // of a random-dense packing
  std::int64_t seed = 0;
};

enum class CellKind : std::uint8_t { free, periodic };

struct CellSettings {
  CellKind kind = CellKind::free;
  std::optional<Vec3> size;         // [m], edges; set for a periodic packing from a file
  std::optional<Vec3> stress;       // [Pa], tension positive; set for a periodic cell that is not strained
  std::optional<Vec3> strain_rate;  // [1/s], extension positive; set for a periodic cell strained at a rate
};

struct BoundaryDiffusion {
  double prefactor = 0.0;          // [m^3/s], of delta_b D_b
  double activation_energy = 0.0;  // [J/mol]
};

struct Material {
  std::string use;              // the built-in material started from; empty: every property was given
  double density = 0.0;         // [kg/m^3]
  double surface_energy = 0.0;  // [J/m^2]
  double dihedral_angle = 0.0;  // [rad]
  double atomic_volume = 0.0;   // [m^3]
  std::optional<double> melting_temperature;  // [K]; unset: not known
  BoundaryDiffusion boundary_diffusion;
};

enum class Attraction : std::uint8_t { bouvard_mcmeeking, parhami_mcmeeking };
enum class Pull : std::uint8_t { bilateral, unilateral };
enum class Closing : std::uint8_t { viscous, rigid };
enum class Spins : std::uint8_t { free, blocked };
enum class EquilibriumRadius : std::uint8_t { equivalent, smaller };

struct ContactSettings {
  Attraction attraction = Attraction::bouvard_mcmeeking;
  Pull pull = Pull::bilateral;
  Closing closing = Closing::viscous;
  double sliding_resistance = 0.0;  // eta
  bool neck_bending = false;        // rolling and twisting resistance
  Spins spins = Spins::free;
  EquilibriumRadius equilibrium_radius = EquilibriumRadius::equivalent;
  double birth_neck_ratio = 0.0;    // x
  double initial_neck_ratio = 0.0;  // x
};

// A ramp (`rate` and `to` set) or a hold (`hold` set).
struct TemperatureStep {
  std::optional<double> rate;  // [K/s], never zero, its sign that of the change towards `to`
  std::optional<double> to;    // [K]
  std::optional<double> hold;  // [s]
};

struct TemperatureProgram {
  double start = 0.0;                    // [K]
  std::vector<TemperatureStep> program;  // the last temperature holds on
};

enum class MethodName : std::uint8_t { contact_dynamics, quasi_static, verlet, mean_field };
enum class Inertia : std::uint8_t { overdamped, dynamic };
enum class Solver : std::uint8_t { automatic, conjugate_gradients, gauss_seidel };

// An unset time or tolerance is "auto".
struct Method {
  MethodName name = MethodName::contact_dynamics;
  Inertia inertia = Inertia::overdamped;
  Solver solver = Solver::automatic;
  std::optional<double> time_step;      // [s], fixed; unset: by `accuracy`, or the limit of stability
  double accuracy = 0.0;                // largest relative error of density and necks over the run
  std::optional<double> tolerance;      // relative force residual at which a step counts as solved
  std::optional<double> largest_step;   // [s]
  std::optional<double> smallest_step;  // [s]
  double density_factor = 0.0;          // on the mass, explicit dynamics only
  double cell_inertia = 0.0;            // over M L^2/12, explicit dynamics only
};

// At least one is set; whichever comes first ends the run.
struct Stop {
  std::optional<double> time;  // [s]
  std::optional<double> relative_density;
};

enum class SnapshotFormat : std::uint8_t { vtp, extended_xyz, lammps_dump };

// At least one interval is set; an output is written when any of them is due.
struct Output {
  std::optional<double> every_density;
  std::optional<double> every_time;  // [s]
  std::optional<std::int64_t> every_steps;
  bool snapshots = false;
  std::vector<SnapshotFormat> formats;  // of the snapshots, each once
  bool report = false;
  std::int64_t checkpoint_every_steps = 0;  // 0: by wall clock
};

struct ParticleGroup {
  std::vector<std::int64_t> ids;  // zero-based rows of the packing; no id is in two groups
  bool fixed = false;             // neither moves nor spins
  Vec3 force = Vec3::Zero();      // [N], external, on each particle
};

struct Case {
  std::string title;
  Packing packing;
  CellSettings cell;
  Material material;
  ContactSettings contact;
  TemperatureProgram temperature;
  Method method;
  Stop stop;
  Output output;
  std::vector<ParticleGroup> particles;
};

}  // namespace frit::config
