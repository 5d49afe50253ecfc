#include "solve/dump.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace frit::solve {
namespace {

using nlohmann::json;

constexpr int dump_version = 3;
constexpr std::size_t numbers_per_edge = 19;

void check(bool good, const char* what) {
  if (!good) throw InputError(std::string("problem dump: ") + what);
}

// Walks over the bytes and stops at nesting that no dump has: the library's reader recurses.
class NestingGuard : public nlohmann::json_sax<json> {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return ++depth_ <= deepest; }
  bool key(string_t&) override { return true; }
  bool end_object() override { return --depth_ >= 0; }
  bool start_array(std::size_t) override { return ++depth_ <= deepest; }
  bool end_array() override { return --depth_ >= 0; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

 private:
  static constexpr int deepest = 4;
  int depth_ = 0;
};

std::vector<double> flat(const std::vector<Vec3>& values) {
  std::vector<double> numbers;
  for (const Vec3& value : values) numbers.insert(numbers.end(), {value.x(), value.y(), value.z()});
  return numbers;
}

std::vector<Vec3> vectors(const std::vector<double>& numbers) {
  check(numbers.size() % 3 == 0, "a list of vectors is cut short");
  std::vector<Vec3> values(numbers.size() / 3);
  for (std::size_t n = 0; n < values.size(); ++n)
    values[n] = {numbers[3 * n], numbers[3 * n + 1], numbers[3 * n + 2]};
  return values;
}

std::vector<double> edge_numbers(const Problem& problem) {
  std::vector<double> numbers;
  for (const Edge& e : problem.edges) {
    const NormalResponse& r = e.response;
    numbers.insert(numbers.end(),
                   {double(e.i), double(e.j), e.normal.x(), e.normal.y(), e.normal.z(), e.arm_i, e.arm_j,
                    e.approach_scale, r.viscosity, r.start, r.growth, r.floor, r.cap, r.pull, r.threshold,
                    r.limit, e.sliding, e.rolling, e.twisting});
  }
  return numbers;
}

std::vector<Edge> edges_of(const std::vector<double>& v) {
  check(v.size() % numbers_per_edge == 0, "the list of edges is cut short");
  std::vector<Edge> edges(v.size() / numbers_per_edge);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const double* n = v.data() + k * numbers_per_edge;
    Edge& e = edges[k];
    check(n[0] >= 0.0 && n[1] >= 0.0 && n[0] < 2147483648.0 && n[1] < 2147483648.0, "an edge joins no body");
    e.i = static_cast<std::int32_t>(n[0]);
    e.j = static_cast<std::int32_t>(n[1]);
    e.normal = {n[2], n[3], n[4]};
    e.arm_i = n[5];
    e.arm_j = n[6];
    e.approach_scale = n[7];
    e.response = {n[8], n[9], n[10], n[11], n[12], n[13], n[14], n[15], false};
    e.sliding = n[16];
    e.rolling = n[17];
    e.twisting = n[18];
  }
  return edges;
}

void check_sizes(const Dumped& dumped) {
  const Problem& p = dumped.problem;
  const std::size_t bodies = p.bodies();
  check(p.moment.size() == bodies && p.load.size() == bodies && p.torque.size() == bodies &&
            p.held.size() == bodies,
        "arrays of bodies differ in length");
  check(p.carried.empty() || p.carried.size() == bodies, "carried motions do not fit the bodies");
  check(p.position.empty() || p.position.size() == bodies, "positions do not fit the bodies");
  check(!p.has_axes || p.branch.size() == p.edges.size(), "branch vectors do not fit the edges");
  check(dumped.start.motion.size() == p.unknowns(), "start motion does not fit the bodies");
  check(dumped.start.multiplier.size() == p.edges.size(), "start multipliers do not fit the edges");
  for (const Edge& edge : p.edges) {
    check(edge.i >= 0 && edge.j >= 0 && static_cast<std::size_t>(std::max(edge.i, edge.j)) < bodies,
          "an edge joins a body that is not there");
  }
}

}  // namespace

std::vector<std::uint8_t> dump(const Problem& problem, const Solution& start) {
  std::vector<std::uint8_t> opens_freely;
  for (const Edge& edge : problem.edges) opens_freely.push_back(edge.response.opens_freely ? 1 : 0);
  json out;
  out["format"] = "frit problem";
  out["version"] = dump_version;
  out["mass"] = problem.mass;
  out["moment"] = problem.moment;
  out["load"] = flat(problem.load);
  out["torque"] = flat(problem.torque);
  out["carried"] = flat(problem.carried);
  out["position"] = flat(problem.position);
  out["held"] = problem.held;
  out["edges"] = edge_numbers(problem);
  out["opens_freely"] = opens_freely;
  out["branch"] = flat(problem.branch);
  out["has_axes"] = problem.has_axes;
  out["axis_load"] = flat({problem.axis_load});
  out["axis_held"] = problem.axis_held;
  out["force_unit"] = problem.force_unit;
  out["motion"] = start.motion;
  out["multiplier"] = start.multiplier;
  return json::to_cbor(out);
}

Dumped load_dump(std::span<const std::uint8_t> bytes) {
  Dumped dumped;
  try {
    NestingGuard guard;
    const auto cbor = json::input_format_t::cbor;
    check(json::sax_parse(bytes.begin(), bytes.end(), &guard, cbor),
          "these bytes are not CBOR, or nested too deeply");
    const json in = json::from_cbor(bytes.begin(), bytes.end());
    check(in.at("format") == "frit problem" && in.at("version") == dump_version, "unknown format or version");
    Problem& p = dumped.problem;
    p.mass = in.at("mass").get<std::vector<double>>();
    p.moment = in.at("moment").get<std::vector<double>>();
    p.load = vectors(in.at("load"));
    p.torque = vectors(in.at("torque"));
    p.carried = vectors(in.at("carried"));
    p.position = vectors(in.at("position"));
    p.held = in.at("held").get<std::vector<std::uint8_t>>();
    p.edges = edges_of(in.at("edges"));
    const auto opens_freely = in.at("opens_freely").get<std::vector<std::uint8_t>>();
    check(opens_freely.size() == p.edges.size(), "arrays of edges differ in length");
    for (std::size_t k = 0; k < p.edges.size(); ++k) p.edges[k].response.opens_freely = opens_freely[k] != 0;
    p.branch = vectors(in.at("branch"));
    p.has_axes = in.at("has_axes");
    p.axis_load = vectors(in.at("axis_load")).at(0);
    p.axis_held = in.at("axis_held").get<std::array<bool, 3>>();
    p.force_unit = in.at("force_unit");
    dumped.start.motion = in.at("motion").get<std::vector<double>>();
    dumped.start.multiplier = in.at("multiplier").get<std::vector<double>>();
  } catch (const json::exception& error) {
    throw InputError(std::string("problem dump: ") + error.what());
  } catch (const std::out_of_range&) {
    throw InputError("problem dump: a value is missing");
  }
  check_sizes(dumped);
  return dumped;
}

}  // namespace frit::solve
