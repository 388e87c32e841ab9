// Carries out a design on all cores.
//
//     each worker, until none is left or it is told to stop:
//       take neighbouring points, as many as some milliseconds of work
//       evaluate them, keep what came out: in memory, or as text in the journal
#pragma once
#include <functional>
#include <string>

#include "mariotte/study/journal/journal.hpp"
#include "mariotte/study/sweep/batch.hpp"

namespace mariotte::study {

/// Takes the results of some points; each thread has one.
using Keep = std::function<void(const Batch&)>;
/// Appends them as text; called by several threads.
using AppendRows = std::function<void(const Batch&, std::string&)>;

/// How far it is; times are processor time, summed over the threads.
struct Progress {
  Index done = 0;         ///< points of this process that are kept
  double evaluating = 0;  ///< setting and solving scenes [s]
  double writing = 0;     ///< keeping their results: text and journal [s]
};

/// Returns false to stop, after the points that are under way.
using Watch = std::function<bool(const Progress&)>;

/// Throws InvalidParameter, "WHO at least one thread" or "WHO at most 4096 threads".
void expect_threads(int threads, const std::string& who);

/// Computes the points the dealer has, on so many threads. `watch` is called on this thread, several times a
/// second and at the end. Throws what a worker threw.
Progress run(const SweepPlan& plan, Dealer dealer, int threads, const std::function<Keep()>& make_keep,
             const Watch& watch);

/// The same into a journal, which is flushed at least every second.
Progress run(const SweepPlan& plan, Dealer dealer, int threads, const AppendRows& append_rows,
             Journal& journal, const Watch& watch);

}  // namespace mariotte::study
