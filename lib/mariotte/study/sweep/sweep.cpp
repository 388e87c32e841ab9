#include "mariotte/study/sweep/sweep.hpp"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <thread>

namespace mariotte::study {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double chunk_time = 0.01;  ///< [s] of work: many times the cost of a line, little to lose to a kill
constexpr Index largest_chunk = 4096;
constexpr Index growth = 8;  ///< from one chunk to the next, while points turn out cheap
constexpr auto watch_interval = std::chrono::milliseconds(100);
constexpr auto flush_interval = std::chrono::milliseconds(500);

/// Processor time of the calling thread [s]: what a point costs, however busy the machine is.
double processor_time() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// What the workers share.
struct Crew {
  explicit Crew(Dealer all) : dealer(std::move(all)) {}

  std::mutex mutex;
  std::condition_variable finished;
  Dealer dealer;
  Progress progress;
  int working = 0;
  std::exception_ptr problem;
  std::atomic<bool> stop = false;
};

class Worker {
 public:
  Worker(const SweepPlan& plan, const std::optional<Slots>& slots, Keep keep, Crew& crew)
      : columns_(plan.columns.size()),
        variation_(plan.document, plan.design, slots),
        evaluation_(plan),
        keep_(std::move(keep)),
        crew_(crew) {}

  void work() {
    Index size = 1;
    for (PointRange chunk; !crew_.stop && (chunk = take(size)).count > 0;) {
      const auto start = Clock::now();
      const double taken = processor_time();
      evaluate(variation_, evaluation_, columns_, chunk.first, chunk.count, batch_);
      const double evaluated = processor_time();
      keep_(batch_);
      report(evaluated - taken, processor_time() - evaluated);
      size = next_size(chunk.count, std::chrono::duration<double>(Clock::now() - start).count());
    }
  }

 private:
  PointRange take(Index size) {
    const std::lock_guard lock(crew_.mutex);
    return crew_.dealer.take(size);
  }

  void report(double evaluating, double writing) {
    const std::lock_guard lock(crew_.mutex);
    crew_.progress.done += batch_.count();
    crew_.progress.evaluating += evaluating;
    crew_.progress.writing += writing;
  }

  static Index next_size(Index size, double taken) {
    const double wanted = chunk_time * static_cast<double>(size) / std::max(taken, 1e-9);
    return std::clamp<Index>(static_cast<Index>(std::min(wanted, 1e9)), 1,
                             std::min(growth * size, largest_chunk));
  }

  const std::size_t columns_;
  Variation variation_;
  PointEvaluation evaluation_;
  Keep keep_;
  Crew& crew_;
  Batch batch_;
};

void work(const SweepPlan& plan, const std::optional<Slots>& slots, const std::function<Keep()>& make_keep,
          Crew& crew) {
  std::exception_ptr problem;
  try {
    Worker(plan, slots, make_keep(), crew).work();
  } catch (...) {
    problem = std::current_exception();
    crew.stop = true;
  }
  const std::lock_guard lock(crew.mutex);
  if (problem && !crew.problem) crew.problem = problem;
  --crew.working;
  crew.finished.notify_all();
}

/// Until all workers are gone.
void supervise(Crew& crew, const Watch& watch) {
  std::unique_lock lock(crew.mutex);
  while (!crew.finished.wait_for(lock, watch_interval, [&] { return crew.working == 0; })) {
    const auto progress = crew.progress;
    lock.unlock();
    if (!watch(progress)) crew.stop = true;
    lock.lock();
  }
}

/// Rows for a journal, in memory that is reused.
Keep make_rows(const AppendRows& append_rows, Journal& journal) {
  return [&append_rows, &journal, rows = Rows()](const Batch& batch) mutable {
    rows.first = batch.first;
    rows.count = batch.count();
    rows.failed = batch.failed();
    rows.text.clear();
    append_rows(batch, rows.text);
    journal.append(rows);
  };
}

}  // namespace

void expect_threads(int threads, const std::string& who) {
  constexpr int most = 4096;
  if (threads < 1) throw InvalidParameter(who + " at least one thread", fault::out_of_range);
  if (threads > most)
    throw InvalidParameter(fmt::format("{} at most {} threads", who, most), fault::out_of_range);
}

Progress run(const SweepPlan& plan, Dealer dealer, int threads, const std::function<Keep()>& make_keep,
             const Watch& watch) {
  expect_threads(threads, "a sweep needs");
  const auto slots = find_slots(plan.document, plan.design);
  Crew crew(std::move(dealer));
  crew.working = threads;
  std::vector<std::jthread> workers;
  for (int i = 0; i < threads; ++i) workers.emplace_back([&] { work(plan, slots, make_keep, crew); });
  try {
    supervise(crew, watch);
  } catch (...) {
    crew.stop = true;
    throw;  // the threads are joined on the way
  }
  workers.clear();
  if (crew.problem) std::rethrow_exception(crew.problem);
  watch(crew.progress);
  return crew.progress;
}

Progress run(const SweepPlan& plan, Dealer dealer, int threads, const AppendRows& append_rows,
             Journal& journal, const Watch& watch) {
  auto flushed = Clock::now();
  const auto watch_and_flush = [&](const Progress& progress) {
    if (Clock::now() - flushed >= flush_interval) {
      journal.flush();
      flushed = Clock::now();
    }
    return watch(progress);
  };
  const auto progress = run(
      plan, std::move(dealer), threads, [&] { return make_rows(append_rows, journal); }, watch_and_flush);
  journal.flush();
  return progress;
}

}  // namespace mariotte::study
