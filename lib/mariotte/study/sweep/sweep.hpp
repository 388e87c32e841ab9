// Carries out a design on all cores.
//
//     each worker, until none is left or it is told to stop:
//       take neighbouring points, as many as some milliseconds of work
//       evaluate them, write their rows as text, append these to the journal
#pragma once
#include <functional>
#include <string>

#include "mariotte/study/journal/journal.hpp"
#include "mariotte/study/sweep/batch.hpp"

namespace mariotte::study {

/// What is done at every point.
struct Sweep {
  const scene::Document& document;
  const Design& design;
  std::size_t columns = 0;                                      ///< of an evaluation
  std::function<EvaluatePoint()> make_evaluate;                 ///< once per thread
  std::function<void(const Batch&, std::string&)> append_rows;  ///< as text; called by several threads
};

/// How far it is; times are processor time, summed over the threads.
struct Progress {
  Index done = 0;         ///< points of this process, in the journal
  double evaluating = 0;  ///< setting and solving scenes [s]
  double writing = 0;     ///< text and journal [s]
};

/// Computes the points the dealer has, on so many threads. `watch` is called on this thread, several times a
/// second and at the end; it returns false to stop, after the points that are under way. The journal is
/// flushed at least every second. Throws what a worker threw.
Progress run(const Sweep& sweep, Dealer dealer, int threads, Journal& journal,
             const std::function<bool(const Progress&)>& watch);

}  // namespace mariotte::study
