// How large a trace gets, known before its first row.
#pragma once
#include <functional>
#include <string>

#include "mariotte/hybrid/options.hpp"
#include "mariotte/model/chain/chain.hpp"
#include "trace_choice.hpp"

namespace mariotte::command {

struct TraceSize {
  double duration = 0;  ///< of the run, or of what was looked at of it [s]
  double rows = 0;
  double bytes = 0;        ///< about
  const char* bound = "";  ///< "at most " if nothing was simulated, "at least " if the run was not finished

  bool is_large() const { return bytes > 1e7; }
  bool is_absurd() const { return bytes > 1e9; }
};

/// Nothing is simulated where --every and the limit of time make the trace small in any case. Else the run is
/// followed without writing, until it ends, is `interrupted`, or its trace is absurd.
TraceSize measure(const RunningTrace& trace, const model::Chain& chain, const hybrid::Options& options,
                  const std::function<bool()>& interrupted);

/// "2674 rows over 2.67 ms, about 48 MB", after its bound
std::string text(const TraceSize& size);

}  // namespace mariotte::command
