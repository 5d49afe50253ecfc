// A run that goes on from a checkpoint has the bits of one that was never interrupted.
#include "run/checkpoint.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <limits>

#include "run/result_folder.hpp"
#include "run/samples.hpp"

namespace frit::run {
namespace {

using io::bytes_of;
using samples::Interrupter;
using samples::periodic_case;

const std::vector<std::string> result_names{"series.csv", "snapshots.pvd", "case.toml", "checkpoint.cbor"};

// Name and bytes of every file that does not tell the clock.
std::vector<std::pair<std::string, std::string>> results_in(const std::filesystem::path& folder) {
  std::vector<std::pair<std::string, std::string>> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).string();
    if (entry.is_regular_file() && name != "summary.json") found.emplace_back(name, bytes_of(entry.path()));
  }
  std::ranges::sort(found);
  return found;
}

// As long as it takes, or so many steps.
struct After {
  int steps = std::numeric_limits<int>::max();
};

Ending run_into(const std::filesystem::path& folder, const config::Case& whole, Requests requests,
                std::vector<RunListener*> others = {}) {
  ResultFolder files(folder);
  others.insert(others.begin(), &files);
  return run_case(whole, others, std::move(requests));
}

Ending run_into(const std::filesystem::path& folder, const config::Case& whole, After after = {}) {
  Interrupter interrupter(after.steps);
  return run_into(folder, whole, interrupter.requests(), {&interrupter});
}

Ending resume_in(const std::filesystem::path& folder, Requests requests,
                 const std::vector<std::string>& overrides = {}, std::vector<RunListener*> others = {}) {
  FolderLock lock(folder);
  Interrupted run = load_interrupted(folder, overrides);
  ResultFolder files(folder, std::move(lock), run.checkpoint.series);
  others.insert(others.begin(), &files);
  return resume_case(run, others, std::move(requests));
}

Ending resume_in(const std::filesystem::path& folder, After after = {},
                 const std::vector<std::string>& overrides = {}) {
  Interrupter interrupter(after.steps);
  return resume_in(folder, interrupter.requests(), overrides, {&interrupter});
}

struct Sample {
  const char* name;
  std::vector<std::string> overrides;
  int every = 1;  // interrupted after each so many steps
};

class Interruptions : public testing::TestWithParam<Sample> {};

// Straight through; and interrupted again and again, a few steps each time.
TEST_P(Interruptions, LeaveNoTrace) {
  const io::TemporaryFolder folder;
  const auto whole = periodic_case(folder, "random-dense", 60, GetParam().overrides);
  ASSERT_EQ(run_into(folder / "straight", whole).code, 0);
  Ending ending = run_into(folder / "torn", whole, After{GetParam().every});
  int interruptions = 0;
  for (; ending.code != 0 && interruptions < 500; ++interruptions) {
    ASSERT_EQ(ending.code, 128 + SIGTERM) << ending.reason;
    ending = resume_in(folder / "torn", After{GetParam().every});
  }
  EXPECT_GT(interruptions, 3);
  const auto straight = results_in(folder / "straight"), torn = results_in(folder / "torn");
  ASSERT_EQ(straight.size(), torn.size());
  for (std::size_t n = 0; n < straight.size(); ++n) {
    EXPECT_EQ(straight[n].first, torn[n].first);
    EXPECT_TRUE(straight[n].second == torn[n].second) << straight[n].first << " differs";
  }
}

// The same within steps: asked to end at the n-th question, in the middle of a solve or of a fit to a
// density. The run gets on because n grows until a step is made.
TEST_P(Interruptions, WithinAStepLeaveNoTrace) {
  const io::TemporaryFolder folder;
  const auto whole = periodic_case(folder, "random-dense", 60, GetParam().overrides);
  ASSERT_EQ(run_into(folder / "straight", whole).code, 0);
  const auto at_question = [](int number) {
    return Requests{.interrupt = [asked = 0, number]() mutable { return ++asked > number ? SIGTERM : 0; }};
  };
  // Not by its questions: those asked while the packing is made would end it before there is a checkpoint.
  Ending ending = run_into(folder / "torn", whole, After{1});
  int given_up = 0;
  for (int number = 1, runs = 0; ending.code != 0 && runs < 1000; ++runs) {
    ASSERT_EQ(ending.code, 128 + SIGTERM) << ending.reason;
    const std::string before = bytes_of(folder / "torn" / checkpoint_name);
    ending = resume_in(folder / "torn", at_question(number));
    const bool has_moved = bytes_of(folder / "torn" / checkpoint_name) != before;
    given_up += has_moved ? 0 : 1;
    number = has_moved ? 1 + number / 3 : 2 * number + 7;
  }
  EXPECT_EQ(ending.code, 0);
  EXPECT_GT(given_up, 0);
  EXPECT_TRUE(results_in(folder / "straight") == results_in(folder / "torn"));
}

INSTANTIATE_TEST_SUITE_P(
    Cases, Interruptions,
    testing::Values(
        Sample{"contact_dynamics", {"stop.relative_density=0.7"}},
        Sample{"under_stress",
               {"cell.stress=-1 MPa", "stop.relative_density=0.7", "packing.radius_spread=0.1"}},
        Sample{"strain_rate",
               {"cell.strain_rate=[0.002, 0.002, -0.001]", "stop.time=20", "stop.relative_density=0.9"}},
        Sample{"dynamic", {"method.inertia=dynamic", "stop.relative_density=0.67"}},
        Sample{"unilateral",
               {"contact.pull=unilateral", "contact.sliding_resistance=0", "stop.relative_density=0.68"}},
        Sample{"free_body", {"cell.kind=free", "packing.count=150", "stop.time=200"}},
        Sample{"programme",
               {"temperature.start=700 degC",
                "temperature.program=[{rate = 1, to = \"1050 degC\"}, {hold = 100}]", "stop.time=420",
                "output.every_time=30"}},
        Sample{"mean_field", {"method.name=mean-field", "stop.relative_density=0.7"}},
        Sample{"quasi_static", {"method.name=quasi-static", "stop.relative_density=0.68"}},
        Sample{"fixed_step", {"method.time_step=0.7", "stop.time=20", "output.every_steps=3"}},
        Sample{"verlet",
               {"method.name=verlet", "method.density_factor=1e14", "stop.time=20", "output.every_steps=50"},
               5}),
    [](const auto& sample) { return sample.param.name; });

// A listener whose failure ends a run as a kill does, without a last checkpoint.
class Killer : public RunListener {
 public:
  void step_made(const StepView& view) override {
    if (view.totals.steps == 6) throw std::runtime_error("killed");
  }
};

TEST(Checkpoint, AskedForWithinAStepIsOfTheStateBeforeIt) {
  const io::TemporaryFolder folder;
  const auto whole = periodic_case(folder, "random-dense", 60, {"stop.relative_density=0.7"});
  run_into(folder / "straight", whole);
  {
    ResultFolder files(folder / "torn");
    Killer killer;
    const auto every_fifth = [asked = 0]() mutable { return ++asked % 5 == 0; };
    EXPECT_THROW(run_case(whole, {&files, &killer}, {.asks_checkpoint = every_fifth}), std::runtime_error);
  }
  std::vector<std::string> notes;
  EXPECT_EQ(load_checkpoint(folder / "torn", notes).progress.totals.steps, 5);
  EXPECT_EQ(resume_in(folder / "torn").code, 0);
  EXPECT_TRUE(results_in(folder / "straight") == results_in(folder / "torn"));
}

TEST(Checkpoint, IsTakenEverySoManyStepsAndChangesNothing) {
  const io::TemporaryFolder folder;
  const auto run_with = [&](const std::string& name, const std::string& every) {
    return run_into(folder / name,
                    periodic_case(folder, "simple-cubic", 8,
                                  {"stop.relative_density=0.6", "output.checkpoint_every_steps=" + every}));
  };
  run_with("never", "0");
  run_with("always", "1");
  EXPECT_EQ(bytes_of(folder / "never" / "series.csv"), bytes_of(folder / "always" / "series.csv"));
}

TEST(Checkpoint, OfAFinishedRunTakesAnotherStop) {
  const io::TemporaryFolder folder;
  const auto out = folder / "out";
  run_into(out, samples::pair_case(folder, {"stop.time=10", "output.every_time=5"}));
  const std::string short_series = bytes_of(out / "series.csv");
  EXPECT_TRUE(how_it_ended(load_interrupted(out, {})));
  EXPECT_FALSE(how_it_ended(load_interrupted(out, {"stop.time=20"})));
  EXPECT_EQ(resume_in(out, After{}, {"stop.time=20"}).code, 0);
  EXPECT_TRUE(bytes_of(out / "series.csv").starts_with(short_series));
  EXPECT_EQ(io::read_series(out / "series.csv").values.at(0), (std::vector<double>{0, 5, 10, 15, 20}));
  EXPECT_NE(bytes_of(out / "case.toml").find("time = 20"), std::string::npos);
}

std::string fault_of(const std::filesystem::path& out, const std::vector<std::string>& overrides = {}) {
  return io::message_of<InputError>([&] { load_interrupted(out, overrides); });
}

TEST(Checkpoint, OnlyStopsMayChange) {
  const io::TemporaryFolder folder;
  const auto out = folder / "out";
  run_into(out, samples::pair_case(folder), After{3});
  EXPECT_NE(fault_of(out, {"contact.pull=unilateral"}).find("keeps its case; allowed: keys of [stop]"),
            std::string::npos);
  const std::string text = bytes_of(out / "case.toml");
  const auto edit = [&](const std::string& from, const std::string& to) {
    std::string edited = text;
    const auto at = edited.find(from);
    ASSERT_NE(at, edited.npos) << from;
    folder.write("out/case.toml", edited.replace(at, from.size(), to));
  };
  edit("sliding_resistance = 0.01", "sliding_resistance = 0.02");
  EXPECT_NE(fault_of(out).find("has been changed since the run: 'sliding_resistance = 0.02'"),
            std::string::npos)
      << fault_of(out);
  edit("time = 60", "time = 70");
  EXPECT_EQ(load_interrupted(out, {}).setup.whole.stop.time, 70.0);
  std::filesystem::remove(out / "case.toml");
  EXPECT_EQ(load_interrupted(out, {}).setup.whole.stop.time, 60.0);
}

TEST(Checkpoint, WhatCannotBeResumedSaysWhy) {
  const io::TemporaryFolder folder;
  EXPECT_NE(fault_of(folder / "x").find("holds no checkpoint"), std::string::npos);
  run_into(folder / "out", samples::pair_case(folder), After{3});
  const std::string good = bytes_of(folder / "out" / "checkpoint.cbor");
  folder.write("out/checkpoint.cbor", "something else that is longer than a header");
  EXPECT_NE(fault_of(folder / "out").find("is no checkpoint of frit"), std::string::npos);
  std::string newer(io::seal_bytes, '\0');
  io::seal(newer, {checkpoint_kind.name, checkpoint_kind.version + 1});
  folder.write("out/checkpoint.cbor", newer);
  EXPECT_NE(fault_of(folder / "out").find("version 2 of the format, this program reads version 1"),
            std::string::npos);
  folder.write("out/checkpoint.cbor", good);
  std::string series = bytes_of(folder / "out" / "series.csv");
  series[series.find('\n') + 1] = '7';
  folder.write("out/series.csv", series);
  EXPECT_NE(
      io::message_of<InputError>([&] { resume_in(folder / "out"); }).find("they are not those of this run"),
      std::string::npos);
  folder.write("out/series.csv", "");
  EXPECT_NE(io::message_of<InputError>([&] {
              resume_in(folder / "out");
            }).find(":1: the header is not that of this run"),
            std::string::npos);
}

TEST(Checkpoint, TwoRunsInOneFolderAreRefused) {
  const io::TemporaryFolder folder;
  run_into(folder / "out", samples::pair_case(folder), After{3});
  const FolderLock lock(folder / "out");
  EXPECT_NE(io::message_of<InputError>([&] { resume_in(folder / "out"); }).find("another frit is at work"),
            std::string::npos);
}

// Every byte of a checkpoint changed, and every length of it: told, and the one before is taken.
TEST(Checkpoint, EveryDamageIsSeen) {
  const io::TemporaryFolder folder;
  const auto out = folder / "out";
  run_into(out, samples::pair_case(folder, {"output.checkpoint_every_steps=1"}), After{5});
  const std::string good = bytes_of(out / checkpoint_name);
  for (std::size_t n = 0; n < good.size(); ++n) {
    std::string damaged = good;
    damaged[n] = static_cast<char>(damaged[n] ^ (1 << (n % 8)));
    EXPECT_NE(io::unseal(damaged, checkpoint_kind).state, io::SealState::intact) << n;
    EXPECT_NE(io::unseal(good.substr(0, n), checkpoint_kind).state, io::SealState::intact) << n;
  }
}

TEST(Checkpoint, TheOneBeforeStandsInForADamagedOne) {
  const io::TemporaryFolder folder;
  const auto whole = samples::pair_case(folder, {"output.checkpoint_every_steps=2", "output.every_steps=1"});
  run_into(folder / "straight", whole);
  run_into(folder / "out", whole, After{5});
  std::string damaged = bytes_of(folder / "out" / checkpoint_name);
  damaged[damaged.size() / 2] ^= 1;
  folder.write("out/checkpoint.cbor", damaged);
  std::vector<std::string> notes;
  const Checkpoint found = load_checkpoint(folder / "out", notes);
  EXPECT_EQ(found.progress.totals.steps, 4);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("is damaged: its checksum does not fit"), std::string::npos);
  EXPECT_EQ(resume_in(folder / "out").code, 0);
  EXPECT_TRUE(results_in(folder / "straight") == results_in(folder / "out"));
}

// Contents that are sealed well but make no sense: told, never followed.
TEST(Checkpoint, ContentsThatLeadAstrayAreRefused) {
  const io::TemporaryFolder folder;
  run_into(folder / "out", samples::pair_case(folder), After{3});
  const std::string bytes = bytes_of(folder / "out" / checkpoint_name);
  const std::string_view contents = std::string_view(bytes).substr(io::seal_bytes);
  EXPECT_NO_THROW(parse_checkpoint(contents));
  int refused = 0;
  for (std::size_t n = 0; n < contents.size(); ++n) {
    for (const int bit : {0, 3, 7}) {
      std::string wrong(contents);
      wrong[n] = static_cast<char>(wrong[n] ^ (1 << bit));
      try {
        parse_checkpoint(wrong);
      } catch (const InputError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_THROW(parse_checkpoint(std::string(100000, '\x81')), InputError);  // lists within lists
  EXPECT_THROW(parse_checkpoint(std::string("\xbb\xff\xff\xff\xff\xff\xff\xff\xff", 9)), InputError);
}

}  // namespace
}  // namespace frit::run
