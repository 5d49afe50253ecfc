#include "python/session.hpp"

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "report/page.hpp"
#include "run/id_order.hpp"

namespace frit::python {

Session::Session(const config::Case& whole, std::optional<std::filesystem::path> folder)
    : folder_(std::move(folder)),
      setup_(std::make_shared<const run::Setup>(run::make_setup(whole))),
      simulation_(*setup_, clock_) {
  if (folder_) files_.emplace(*folder_);
  tell([&](auto listeners) { close(simulation_.start(listeners)); });
}

template <class Work>
void Session::tell(const Work& work) {
  std::vector<run::RunListener*> listeners{&rows_};
  if (files_) listeners.insert(listeners.begin(), &*files_);
  work(std::span<run::RunListener* const>(listeners));
}

void Session::close(const std::optional<run::Ending>& ending) {
  ending_ = ending;
  if (!ending) return;
  files_.reset();  // nothing more is written: others may have the folder
  if (folder_ && setup_->whole.output.report && report::has_page())
    report::write_page(std::array{*folder_}, *folder_ / "report.html");
}

bool Session::step() {
  const std::lock_guard lock(busy_);
  if (ending_) return false;
  moment_.reset();
  tell([&](auto listeners) { close(simulation_.step(listeners)); });
  return !ending_;
}

void Session::stop(const run::Ending& ending) {
  const std::lock_guard lock(busy_);
  if (ending_) return;
  tell([&](auto listeners) { simulation_.stop(ending, listeners); });
  close(ending);
}

std::optional<run::Ending> Session::ending() const {
  const std::lock_guard lock(busy_);
  return ending_;
}

std::vector<observe::Row> Session::rows() const {
  const std::lock_guard lock(busy_);
  return rows_.rows;
}

std::size_t Session::row_count() const {
  const std::lock_guard lock(busy_);
  return rows_.rows.size();
}

run::Totals Session::totals() const {
  const std::lock_guard lock(busy_);
  return simulation_.totals();
}

std::shared_ptr<const Moment> Session::moment() const {
  const std::lock_guard lock(busy_);
  if (moment_) return moment_;
  auto made = std::make_shared<Moment>();
  made->state = run::in_id_order(simulation_.state());
  made->necks = run::necks_of(setup_->settings.law, made->state, setup_->furnace.delta_b(made->state.time));
  made->neck_ratios = observe::neck_ratios(made->state, made->necks.view());
  made->density = simulation_.density();
  made->setup = setup_;
  moment_ = made;
  return moment_;
}

}  // namespace frit::python
