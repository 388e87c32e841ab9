// How large a trace gets, known before its first row.
#pragma once
#include <string>

#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/watch/observers.hpp"
#include "mariotte/model/chain/chain.hpp"
#include "trace_choice.hpp"

namespace mariotte::command {

struct TraceSize {
  double duration = 0;  ///< of the run [s]
  double rows = 0;
  double bytes = 0;  ///< about

  bool is_large() const { return bytes > 1e7; }
  bool is_absurd() const { return bytes > 1e9; }
};

/// By following the run without writing; `observers` may hold no samplings.
TraceSize measure(const RunningTrace& trace, const model::Chain& chain, const hybrid::Options& options,
                  impact::RunObserver observers);

/// "2674 rows over 2.67 ms, about 48 MB"
std::string text(const TraceSize& size);

}  // namespace mariotte::command
