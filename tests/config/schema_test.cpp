#include "config/schema.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace frit::config {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(Schema, KnowsItsSections) {
  for (const auto* path :
       {"packing", "material", "material.boundary_diffusion", "temperature.program", "particles"})
    EXPECT_TRUE(is_section(path)) << path;
  for (const auto* path : {"", "title", "pack", "packing.", "packing.file", "wall"})
    EXPECT_FALSE(is_section(path)) << path;
}

TEST(Schema, NamesEachSectionOnce) {
  const auto root = names_in("");
  EXPECT_EQ(root.front(), "title");
  for (const auto* name :
       {"packing", "cell", "material", "contact", "temperature", "method", "stop", "output"})
    EXPECT_EQ(std::count(root.begin(), root.end(), name), 1) << name;
  const auto material = names_in("material");
  EXPECT_TRUE(contains(material, "boundary_diffusion"));
  EXPECT_FALSE(contains(material, "prefactor"));
  EXPECT_TRUE(names_in("no such").empty());
}

TEST(Schema, ChoicesFollowTheirEnumerations) {
  const auto choice = [](std::string_view path, auto value) {
    return find_key(path)->choices.at(static_cast<std::size_t>(value)).name;
  };
  EXPECT_EQ(choice("packing.generate", Generator::random_dense), "random-dense");
  EXPECT_EQ(choice("packing.generate", Generator::simple_cubic), "simple-cubic");
  EXPECT_EQ(choice("packing.generate", Generator::body_centred_cubic), "body-centred-cubic");
  EXPECT_EQ(choice("packing.generate", Generator::face_centred_cubic), "face-centred-cubic");
  EXPECT_EQ(choice("packing.generate", Generator::random_sequential), "random-sequential");
  EXPECT_EQ(choice("packing.generate", Generator::gas_compacted), "gas-compacted");
  EXPECT_EQ(choice("packing.generate", Generator::deposit), "deposit");
  EXPECT_EQ(choice("cell.kind", CellKind::periodic), "periodic");
  EXPECT_EQ(choice("contact.attraction", Attraction::parhami_mcmeeking), "parhami-mcmeeking");
  EXPECT_EQ(choice("contact.pull", Pull::unilateral), "unilateral");
  EXPECT_EQ(choice("contact.closing", Closing::rigid), "rigid");
  EXPECT_EQ(choice("contact.spins", Spins::blocked), "blocked");
  EXPECT_EQ(choice("contact.equilibrium_radius", EquilibriumRadius::smaller), "smaller");
  EXPECT_EQ(choice("method.name", MethodName::quasi_static), "quasi-static");
  EXPECT_EQ(choice("method.name", MethodName::verlet), "verlet");
  EXPECT_EQ(choice("method.name", MethodName::mean_field), "mean-field");
  EXPECT_EQ(choice("method.inertia", Inertia::dynamic), "dynamic");
  EXPECT_EQ(choice("method.solver", Solver::conjugate_gradients), "conjugate-gradients");
  EXPECT_EQ(choice("method.solver", Solver::gauss_seidel), "gauss-seidel");
}

TEST(Schema, SaysRangesInWords) {
  const auto allowed = [](std::optional<Bound> least, std::optional<Bound> most) {
    Key key;
    key.type = Type::quantity;
    key.quantity = Quantity::length;
    key.range = {least, most};
    return allowed_text(key);
  };
  EXPECT_EQ(allowed({}, {}), "");
  EXPECT_EQ(allowed(Bound{1}, {}), "at least 1 m");
  EXPECT_EQ(allowed(Bound{1, Edge::excluded}, Bound{2}), "above 1 m, at most 2 m");
  EXPECT_EQ(allowed({}, Bound{0.5, Edge::excluded}), "below 0.5 m");
}

TEST(Schema, SaysWhereAutoIsAValue) {
  EXPECT_TRUE(type_text(*find_key("method.time_step")).ends_with(", or \"auto\""));
  EXPECT_EQ(type_text(*find_key("method.accuracy")).find("auto"), std::string::npos);
}

}  // namespace
}  // namespace frit::config
