// Many chains at once: arrays in, arrays out.
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "arrays.hpp"
#include "bindings.hpp"
#include "errors.hpp"
#include "interruption.hpp"
#include "mariotte/contact/named_laws.hpp"
#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain/chain_batch.hpp"
#include "mariotte/scene/fault.hpp"
#include "mariotte/study/sweep/sweep.hpp"

namespace mariotte::python {
namespace {

/// Rows of the same length, all the same if there is one.
struct Rows {
  const double* first;
  Index length;
  Index step;  ///< from one row to the next, 0 if there is one

  explicit Rows(const Numbers& array)
      : first(array.data()), length(array.shape(1)), step(array.shape(0) == 1 ? 0 : length) {}
  std::span<const double> at(Index row) const {
    return {first + row * step, static_cast<std::size_t>(length)};
  }
};

struct Chains {
  Rows mass, stiffness, velocity, gap, damping;
  const contact::NamedLaw& law;
  double exponent;
  hybrid::Options options;

  void put(Index row, model::Chain& chain) const {
    const auto assign = [](auto& to, std::span<const double> from) { to.assign(from.begin(), from.end()); };
    assign(chain.mass, mass.at(row));
    assign(chain.velocity, velocity.at(row));
    assign(chain.gap, gap.at(row));
    const auto k = stiffness.at(row), c = damping.at(row);
    chain.law.clear();
    for (std::size_t j = 0; j < k.size(); ++j)
      chain.law.push_back(law.make({.stiffness = k[j], .exponent = exponent, .damping = c[j]}));
  }
};

struct Results {
  std::vector<double> velocity, impulse, time, estimate;
  std::vector<std::uint8_t> ending;

  Results(Index rows, Index balls)
      : velocity(static_cast<std::size_t>(rows * balls)),
        impulse(static_cast<std::size_t>(rows * (balls - 1))),
        time(static_cast<std::size_t>(rows)),
        estimate(static_cast<std::size_t>(rows)),
        ending(static_cast<std::size_t>(rows)) {}

  /// Numbers of a run that could not go on mean nothing.
  void keep(Index row, const impact::BriefImpact& impact) {
    using hybrid::Ending;
    const bool counts = impact.ending != Ending::failed && impact.ending != Ending::unsure &&
                        impact.ending != Ending::invalid;
    const double factor = counts ? 1 : std::numeric_limits<double>::quiet_NaN();
    const auto put = [&](const auto& from, auto& to) {
      std::transform(from.begin(), from.end(), to.begin() + row * std::ssize(from),
                     [=](double number) { return factor * number; });
    };
    put(impact.velocity, velocity);
    put(impact.impulse, impulse);
    time[static_cast<std::size_t>(row)] = impact.time;
    estimate[static_cast<std::size_t>(row)] =
        factor * impact.estimated_accuracy.value_or(std::numeric_limits<double>::quiet_NaN());
    ending[static_cast<std::size_t>(row)] = static_cast<std::uint8_t>(impact.ending);
  }
};

void solve_row(const Chains& chains, Index row, model::Chain& chain, impact::ChainBatch& batch) try {
  chains.put(row, chain);
  batch.put(row, chain, chains.options);
} catch (const InvalidParameter& error) {
  const auto place = "row " + std::to_string(row);
  throw WrongOption(InvalidParameter(place + ": " + error.what(), error.fault), "", place);
}

/// Threads that take rows until none is left; the calling one waits, and looks for Ctrl-C.
class Crew {
 public:
  Crew(const Chains& chains, Index rows, Results& results)
      : chains_(chains), rows_(rows), results_(results) {}

  void run(int threads) {
    try {
      study::expect_threads(threads, "chains need");
    } catch (const InvalidParameter& error) {
      throw WrongOption(error, "threads");
    }
    working_ = threads;
    std::vector<std::jthread> workers;
    for (int i = 0; i < threads; ++i) workers.emplace_back([this] { work(); });
    wait();
    workers.clear();
    if (problem_) std::rethrow_exception(problem_);
  }

 private:
  static constexpr Index at_once = 256;  // many times the cost of taking them

  void work() {
    try {
      impact::ChainBatch batch(
          [this](Index row, const auto&, const impact::BriefImpact& impact) { results_.keep(row, impact); });
      model::Chain chain;
      for (Index first; (first = next_.fetch_add(at_once)) < rows_; batch.finish())
        for (Index row = first; row < std::min(first + at_once, rows_); ++row)
          solve_row(chains_, row, chain, batch);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!problem_) problem_ = std::current_exception();
      next_ = rows_;
    }
    const std::lock_guard lock(mutex_);
    --working_;
    finished_.notify_all();
  }

  void wait() {
    Interruption interruption;
    std::unique_lock lock(mutex_);
    while (!finished_.wait_for(lock, std::chrono::milliseconds(100), [&] { return working_ == 0; })) {
      lock.unlock();
      try {
        interruption();
      } catch (...) {
        next_ = rows_;
        throw;  // the threads are joined on the way
      }
      lock.lock();
    }
  }

  const Chains& chains_;
  const Index rows_;
  Results& results_;
  std::atomic<Index> next_ = 0;
  std::mutex mutex_;
  std::condition_variable finished_;
  int working_ = 0;
  std::exception_ptr problem_;
};

/// Whether arrays say all that the law needs.
bool takes(const contact::NamedLaw& law) {
  constexpr std::array<std::string_view, 3> given{"stiffness", "exponent", "damping"};
  return !law.keys.empty() && std::ranges::all_of(law.keys, [&](const contact::LawKey& key) {
    return std::ranges::find(given, key.key) != given.end();
  });
}

const contact::NamedLaw& law_of(const std::string& name) {
  std::string known;
  for (const auto& law : contact::named_laws) {
    if (!takes(law)) continue;
    if (law.name == name) return law;
    known += (known.empty() ? "" : ", ") + std::string(law.name);
  }
  throw InvalidParameter("solve has no law '" + name + "' (" + known + ")", fault::unknown_word);
}

double exponent_of(const contact::NamedLaw& law, std::optional<double> given) {
  const double own = law.exponent.value_or(contact::LawNumbers{}.exponent);
  if (given && given != own && !law.find("exponent"))
    throw InvalidParameter("'" + std::string(law.name) + "' has its own exponent (viscoelastic has any)",
                           fault::misplaced);
  return given.value_or(own);
}

void expect_damper(const contact::NamedLaw& law, const Numbers& damping) {
  if (law.damping()) return;
  if (std::all_of(damping.data(), damping.data() + damping.size(), [](double c) { return c == 0; })) return;
  throw InvalidParameter(
      "'" + std::string(law.name) + "' has no damping; take " + contact::names_of_damped_laws(),
      fault::misplaced);
}

py::tuple solve(Index rows, const Numbers& mass, const Numbers& stiffness, const Numbers& velocity,
                const Numbers& gap, const Numbers& damping, const std::string& law,
                std::optional<double> exponent, double accuracy, int threads) {
  const contact::NamedLaw* named = nullptr;
  double power = 0;
  of_option("law", [&] { named = &law_of(law); });
  of_option("exponent", [&] { power = exponent_of(*named, exponent); });
  of_option("damping", [&] { expect_damper(*named, damping); });
  const Chains chains{Rows(mass),    Rows(stiffness), Rows(velocity), Rows(gap),
                      Rows(damping), *named,          power,          {.accuracy = accuracy}};
  const Index balls = chains.mass.length;
  Results results(rows, balls);
  {
    const py::gil_scoped_release unlocked;
    of_option("accuracy", [&] { validate(chains.options); });
    Crew(chains, rows, results).run(threads);
  }
  return py::make_tuple(owned(std::move(results.velocity), {rows, balls}),
                        owned(std::move(results.impulse), {rows, balls - 1}),
                        owned(std::move(results.time), {rows}), owned(std::move(results.ending), {rows}),
                        owned(std::move(results.estimate), {rows}));
}

}  // namespace

void add_solve(py::module_& module) {
  module.def("solve", &solve, py::arg("rows"), py::arg("mass"), py::arg("stiffness"), py::arg("velocity"),
             py::arg("gap"), py::arg("damping"), py::arg("law"), py::arg("exponent"), py::arg("accuracy"),
             py::arg("threads"));
}

}  // namespace mariotte::python
